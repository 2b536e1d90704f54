// Computes the force on the hand from the hand's position in the world. One tick includes candidates, proxy, friction,
// damping, liquids and effects. The servo, the `touch` replay, tests and benchmarks all use this code. Double
// precision; noexcept; never allocates, locks or reads a clock. The servo checks samples before the tick and passes the
// force through ForceLimiter after it. Source of the proxy: the free-cell proxy described in docs/architecture.md;
// Zilles & Salisbury 1995, Ruspini et al. 1997.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "haptic/render/haptic_scene.h"
#include "haptic/render/passivity_guard.h"
#include "haptic/render/tick_features.h"
#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"

namespace handrail::render {

class ProxySolver;

// Settings of the renderer that depend on the person, the device and the scale. Plain values; the app publishes new
// ones when a setting changes.
struct TouchTuning {
    double radius_m = 0.005;                  // radius of the proxy, world metres; 0 is replaced by 1e-5
    double world_m_per_hand_m = 1.0;          // scale S of the world
    double rated_stiffness_n_per_m = 1000.0;  // stiffness at fraction 1.0, per hand metre
    double default_stiffness_fraction = 0.8;  // for surfaces without a stiffness of their own
    double damping_ns_per_m = 0.0;  // damping of the hand's velocity along the normal, filtered by one pole at 50 Hz
    double default_friction_static = 0.0;  // for surfaces without a friction of their own
    double default_friction_kinetic = 0.0;
    // Longest path of the proxy in a tick. The limit is twice the goal's step if that is longer.
    double slide_cap_hand_m = 0.5e-3;
    int most_rounds = 64;  // rounds of the solver; with fewer the proxy is as safe but lags (ProxySolver::Request)
    double override_stiffness_n_per_m = -1.0;  // >= 0: stiffness of every surface, in N per hand metre
    double override_damping_ns_per_m = -1.0;   // >= 0: damping of every surface
    double override_friction_static = -1.0;    // >= 0: static friction of every surface
    double override_friction_kinetic = -1.0;
    bool held = true;  // false: nobody holds the device, so no vibration, wind or current may drive it
    // Adds damping if the loop gives the hand energy, on surfaces with damping below 2 Ns/m.
    bool passivity_guard = false;
    // For the passivity guard: delay from computing a force until the hand feels it, without the time for which the
    // force is held.
    double force_delay_s = 0.0;
};

struct Contact {
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    Vec3 normal{0.0};    // unit vector, from the obstacle to the proxy
    double share = 0.0;  // the contact's share of the whole press, 0 to 1 (multipliers normalised to a sum of 1)
};

// The surfaces that hold the proxy in this tick: 0 to 3.
struct ContactSet {
    std::array<Contact, 3> contacts{};
    std::uint8_t count = 0;
    std::uint8_t strongest = 0;  // index of the contact with the largest multiplier; meaningless if count is 0
    std::uint16_t iterations = 0;
    bool converged = true;   // every active cut touches its obstacle
    bool truncated = false;  // there were too many candidates, and only the nearest were kept
    bool capped = false;     // the speed cap of the slide cut the path short
    bool waits = false;  // the tick had more work than its budget, so the proxy or a body lags (ProxySolver::kMostWork)
    bool ghosted = false;  // true if at least one solid is not felt, because the hand started inside it
};

struct TouchResult {
    Vec3 proxy_m{0.0};          // centre of the proxy in the world
    Vec3 force_n{0.0};          // force on the hand in world axes, before any limit
    Vec3 contact_force_n{0.0};  // part of the force that comes from surfaces
    Vec3 slide_m{0.0};          // displacement of the proxy in this tick, in the world
    ContactSet contacts;
    // Liquid volume that contains the proxy. If several volumes contain it, the last one listed.
    FeatureId liquid = kNoFeature;
    // Current radius of the proxy; less than normal after a start in a narrow place, then growing.
    double radius_m = 0.0;
    FeatureId soft = kNoFeature;  // the soft patch that the proxy presses
    MaterialId soft_material = kDefaultMaterial;
    Vec3 soft_force_n{0.0};          // part of the force that comes from soft patches
    bool effects_truncated = false;  // true if the hand is in more effects than can act at once
};

// All state of the renderer that lasts from tick to tick. It is created off the servo thread, because it allocates its
// fixed arrays once. Afterwards one thread owns it.
class TouchState {
public:
    TouchState();
    ~TouchState();
    TouchState(TouchState&&) noexcept;
    TouchState& operator=(TouchState&&) noexcept;

    // Forgets contact, friction and filters. The next touch_tick() starts the proxy at its goal, with ghosts and a
    // radius that grows, as at a fresh start.
    void reset() noexcept;
    // Forgets only velocities, after a fault. The proxy keeps its history.
    void reset_filters() noexcept;
    // When the walker moves the hand's frame without a teleport, the goal simply moves, so reset() is not needed.

    // For checks: the proxy of the last tick. SolverProbe (tests) shows its path, candidates and gatherings.
    const ProxySolver& solver() const noexcept;

    struct Impl;
    Impl& impl() noexcept { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

// Computes one tick, compiled for AllFeatures or for PlainFeatures. The latter is correct only if touch_tick() chooses
// it (tick_features.h).
template <class Has>
TouchResult touch_tick_with(TouchState& state, const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m,
                            double dt_s, const Vec3& carried_m, const BodyPoses& bodies) noexcept;

// Computes one tick.
// - goal_m: the HIP (haptic interface point) in world metres, finite and within 1e6 m.
// - dt_s: time since the last tick, > 0.
// - scene: if its address or generation differs from last time, candidates are gathered again around the old proxy.
// - carried_m: how far the walker carried the workspace since the last tick, in world metres. The proxy and liquids use
//   the whole motion. Damping and the passivity guard use only the hand's own motion; otherwise every step of the
//   walker would knock in the hand (test: walking_*).
// - bodies: poses of the scene's bodies in this tick; if omitted, each body has its pose from the scene.
inline TouchResult touch_tick(TouchState& state, const HapticScene& scene, const TouchTuning& tuning,
                              const Vec3& goal_m, double dt_s, const Vec3& carried_m = Vec3(0.0),
                              const BodyPoses& bodies = {}) noexcept {
    return scene.plain ? touch_tick_with<PlainFeatures>(state, scene, tuning, goal_m, dt_s, carried_m, bodies)
                       : touch_tick_with<AllFeatures>(state, scene, tuning, goal_m, dt_s, carried_m, bodies);
}

}  // namespace handrail::render
