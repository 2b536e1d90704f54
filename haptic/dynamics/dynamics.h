// Holds the authoritative state of all free bodies of a world, computed by Bullet 3.24 in double precision, 240 steps a
// second. Dynamics has one owner, and no thread or clock of its own. All steps have the same length, so the same calls
// give bit-identical results, also after restart(). World metres. A world without free bodies has no Dynamics. The cost
// of a step for different numbers of bodies is in docs/results.md; at most kMostAwake bodies move at once. Sources:
// Coumans, Bullet 3.24; Stewart & Trinkle, An implicit time-stepping scheme for rigid body dynamics with inelastic
// collisions and Coulomb friction, 1996.
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

    // Adds a push of hand 0 or 1. Each step applies the part of the push that falls within it; a late push acts in the
    // next step. Ignores a push that is not finite, belongs to a body that does not exist, or was made before the last
    // restart.
    void push(unsigned hand, const render::HandPush& push);
    // Sets the position of a hand. The engine wakes the bodies that the hand approaches, and reports the bodies near it
    // first.
    void place_hand(unsigned hand, const render::HandPlace& place);
    // Sets the pose of a driven thing from the next step on. `thing` is an index of DynamicsScene::driven. If the pose
    // changes by more than half a metre or 60 degrees in a step, the thing jumps and pushes no bodies.
    void drive(std::uint32_t thing, const Placement& at, bool present = true);
    // Places the walker, an upright capsule that free bodies cannot enter. A height of 0 removes the walker.
    void walker(const Vec3& feet_m, double radius_m, double height_m);
    // Grips a body with the keyboard: pulls its centre to `to_m` with a force of at most `most_n`. The body keeps the
    // orientation `turn` unless it is a ball. kNoBody or 0 N releases it.
    void lead(std::uint32_t body, const Vec3& to_m, double most_n, const Rotation& turn = {});

    // Makes the walker push a body for `for_s` seconds, towards the horizontal velocity `speed_m_per_s`, with a force
    // of at most `most_n`. A later call for the same body replaces the push.
    void shove(std::uint32_t body, const Vec3& speed_m_per_s, double most_n, double for_s);

    // Computes one step of kStep_s. Overwrites `out` and appends to `events`.
    void step(render::DynamicsFrame& out, std::vector<render::BodyEvent>& events);
    // Puts all bodies back to their start, while the time continues. Builds Bullet's world again, because the internal
    // state of the old one would otherwise influence the next steps.
    void restart();

    double time_s() const;  // end time of the last step
    // Lets time pass without a step, and drops the pushes in that time. Used to start at the time of a running clock,
    // or after a stall.
    void skip(double seconds);
    const render::DynamicsScene& scene() const;
    // Return the pose and the velocity of a body's frame; for tests and for drawing.
    Placement middle(std::uint32_t body) const;
    Vec3 speed_m_per_s(std::uint32_t body) const;
    bool awake(std::uint32_t body) const;
    // Returns true if a body is jammed in front of the driven thing, so that the thing waits.
    bool blocked(std::uint32_t thing) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::dynamics
