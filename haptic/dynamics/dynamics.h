// The truth about everything that is free to move: Bullet 3.24 in double precision behind plain values, stepped 240
// times a second. One owner; no thread, no clock; steps are always the same length, so the same calls give the same
// bits, also after restart(). World metres. A world without free bodies has none. What a step costs with how many
// bodies stands in docs/results.md; more than kMostAwake never move at once. Sources: Coumans, Bullet 3.24; Stewart &
// Trinkle, An implicit time-stepping scheme for rigid body dynamics with inelastic collisions and Coulomb friction,
// 1996.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "haptic/render/body_word.h"

namespace handrail {

class Dynamics {
public:
    static constexpr double kStep_s = 1.0 / 240.0;
    static constexpr std::size_t kMostAwake = 100;

    explicit Dynamics(std::shared_ptr<const DynamicsScene> scene);
    ~Dynamics();
    Dynamics(const Dynamics&) = delete;
    Dynamics& operator=(const Dynamics&) = delete;

    // From hand 0 or 1. Each push counts for the part of its tick that lies in a step; what comes late counts in the
    // next one. Pushes from before the last restart, of bodies that are not there or that are not finite are let go.
    void push(unsigned hand, const HandPush& push);
    // Wakes what the hand comes near, and says whose words are told first.
    void place_hand(unsigned hand, const HandPlace& place);
    // Where driven things are from the next step on; index as DynamicsScene::driven. More than half a metre or 60
    // degrees in a step is a jump, which pushes nothing.
    void drive(std::uint32_t thing, const Placement& at, bool present = true);
    // Somebody who walks here: an upright capsule that free bodies cannot enter. A height of 0: nobody.
    void walker(const Vec3& feet_m, double radius_m, double height_m);
    // The grip of the keyboard: draws a body's middle to a place with no more than this force, and keeps its direction
    // unless it is a ball. kNoBody, or 0 N: lets go.
    void lead(std::uint32_t body, const Vec3& to_m, double most_n, const Rotation& turn = {});

    // Somebody who walks pushes it along for so long: towards that speed, level, with no more than this force. Again
    // before that is over takes the place of what was said before.
    void shove(std::uint32_t body, const Vec3& speed_m_per_s, double most_n, double for_s);

    // One step of kStep_s. Events are added. `out` is all of the answer, whatever it held.
    void step(DynamicsFrame& out, std::vector<BodyEvent>& events);
    // Everything as at the start; time goes on. Builds Bullet's world anew, since what remains of a game in it would
    // make the next one another.
    void restart();

    double time_s() const;  // end of the last step
    // Time goes on without a step, and pushes that lie in it are let go: for whoever joins a clock that runs already,
    // or was held up.
    void skip(double seconds);
    const DynamicsScene& scene() const;
    // Where a body's frame is, and how it moves; for tests and for what is drawn.
    Placement middle(std::uint32_t body) const;
    Vec3 speed_m_per_s(std::uint32_t body) const;
    bool awake(std::uint32_t body) const;
    // A body is jammed before it, and it waits where it is.
    bool blocked(std::uint32_t thing) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail
