// The authoritative state of all free bodies: Bullet 3.24 in double precision behind plain values, stepped 240 times a
// second. One owner; no thread, no clock. Steps always have the same length, so the same calls give bit-identical
// results, also after restart(). World metres. A world without free bodies has none. For the cost of a step by the
// number of bodies see docs/results.md; no more than kMostAwake move at once. Sources: Coumans, Bullet 3.24; Stewart &
// Trinkle, An implicit time-stepping scheme for rigid body dynamics with inelastic collisions and Coulomb friction,
// 1996.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "haptic/render/rigid_body_state.h"

namespace handrail::dynamics {

class Dynamics {
public:
    static constexpr double kStep_s = 1.0 / 240.0;
    static constexpr std::size_t kMostAwake = 100;

    explicit Dynamics(std::shared_ptr<const render::DynamicsScene> scene);
    ~Dynamics();
    Dynamics(const Dynamics&) = delete;
    Dynamics& operator=(const Dynamics&) = delete;

    // A push from hand 0 or 1. It counts for the part of its tick that is in a step; if it comes late, it counts in the
    // next step. Ignores pushes from before the last restart, of bodies that do not exist, or that are not finite.
    void push(unsigned hand, const render::HandPush& push);
    // Wakes the bodies that the hand approaches, and decides which bodies are reported first.
    void place_hand(unsigned hand, const render::HandPlace& place);
    // Sets the pose of a driven thing from the next step on; index as in DynamicsScene::driven. More than half a metre
    // or 60 degrees in a step is a jump, which pushes nothing.
    void drive(std::uint32_t thing, const Placement& at, bool present = true);
    // Sets the walker: an upright capsule that free bodies cannot enter. A height of 0: no walker.
    void walker(const Vec3& feet_m, double radius_m, double height_m);
    // The grip of the keyboard: pulls a body's centre to a place with at most this force, and keeps its orientation
    // unless it is a ball. kNoBody or 0 N: lets go.
    void lead(std::uint32_t body, const Vec3& to_m, double most_n, const Rotation& turn = {});

    // The walker pushes the body along for for_s seconds: towards that level speed, with at most this force. Another
    // call before the end replaces this one.
    void shove(std::uint32_t body, const Vec3& speed_m_per_s, double most_n, double for_s);

    // One step of kStep_s. Adds to events and overwrites `out`.
    void step(render::DynamicsFrame& out, std::vector<render::BodyEvent>& events);
    // Restores the start while time goes on. Builds Bullet's world again, because its internal state from the last game
    // would change the next one.
    void restart();

    double time_s() const;  // end of the last step
    // Lets time pass without a step, and drops the pushes in it. For joining a clock that runs already, or after a
    // stall.
    void skip(double seconds);
    const render::DynamicsScene& scene() const;
    // The pose of a body's frame, and its motion; for tests and for drawing.
    Placement middle(std::uint32_t body) const;
    Vec3 speed_m_per_s(std::uint32_t body) const;
    bool awake(std::uint32_t body) const;
    // A body is jammed in front of it, and it waits where it is.
    bool blocked(std::uint32_t thing) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::dynamics
