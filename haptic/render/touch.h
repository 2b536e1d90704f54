// Computes the force on the hand from its position in the world: candidates, proxy, friction, damping, liquids and
// effects of one tick. The servo, the `touch` replay, tests and benchmarks all share this one path. Double precision;
// noexcept; never allocates, locks or reads a clock. Sample checks come before it, ForceLimiter after it. Source of the
// proxy: the free-cell proxy described in docs/architecture.md; Zilles & Salisbury 1995, Ruspini et al. 1997.
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

// The settings of the renderer that follow from the person, the device and the scale. Plain values; the app publishes a
// new one when something changes.
struct TouchTuning {
    double radius_m = 0.005;                  // radius of the proxy, world metres; 0 counts as 1e-5
    double world_m_per_hand_m = 1.0;          // the scale S
    double rated_stiffness_n_per_m = 1000.0;  // per hand metre: the stiffness at fraction 1.0
    double default_stiffness_fraction = 0.8;  // for surfaces that specify none
    double damping_ns_per_m = 0.0;            // for hand speed, along the normal, one pole at 50 Hz
    double default_friction_static = 0.0;     // for surfaces that specify none
    double default_friction_kinetic = 0.0;
    double slide_cap_hand_m = 0.5e-3;  // longest proxy path per tick, or twice the goal's step if that is longer
    int most_rounds = 64;              // of the solver; fewer are as safe but lag (ProxySolver::Request)
    double override_stiffness_n_per_m = -1.0;  // >= 0: for every surface, in N per hand metre
    double override_damping_ns_per_m = -1.0;   // >= 0: for every surface
    double override_friction_static = -1.0;    // >= 0: for every surface
    double override_friction_kinetic = -1.0;
    bool held = true;              // false: nobody holds the device, so nothing may drive it (vibration, wind, stream)
    bool passivity_guard = false;  // adds damping if the loop gives energy, on surfaces damped by less than 2 Ns/m
    double force_delay_s = 0.0;  // delay from computing a force until the hand feels it, beyond the hold; for the guard
};

struct Contact {
    FeatureId feature = kNoFeature;
    MaterialId material = kDefaultMaterial;
    Vec3 normal{0.0};    // unit vector, from the obstacle to the proxy
    double share = 0.0;  // share of the whole press, 0 to 1 (multipliers normalised to 1)
};

// The surfaces that hold the proxy in this tick: 0 to 3.
struct ContactSet {
    std::array<Contact, 3> contacts{};
    std::uint8_t count = 0;
    std::uint8_t strongest = 0;  // index of the largest multiplier; meaningless if count is 0
    std::uint16_t iterations = 0;
    bool converged = true;   // every active cut touches its obstacle
    bool truncated = false;  // the candidate list was full; the nearest were kept
    bool capped = false;     // the slide-speed cap cut the path
    bool waits = false;      // the tick had more work than its budget: proxy or body lag (ProxySolver::kMostWork)
    bool ghosted = false;    // some solid is not felt because the hand started inside it
};

struct TouchResult {
    Vec3 proxy_m{0.0};          // centre of the proxy, world
    Vec3 force_n{0.0};          // on the hand, world axes, before any ceiling
    Vec3 contact_force_n{0.0};  // the part from surfaces
    Vec3 slide_m{0.0};          // how far the proxy moved in this tick, world
    ContactSet contacts;
    FeatureId liquid = kNoFeature;  // volume that the proxy is in; where volumes overlap, the last one listed
    double radius_m = 0.0;          // current radius of the proxy, which grows after a tight start
    FeatureId soft = kNoFeature;    // the soft patch that is pressed
    MaterialId soft_material = kDefaultMaterial;
    Vec3 soft_force_n{0.0};          // the part from soft patches
    bool effects_truncated = false;  // the hand is in more effects than can act at once
};

// All state that lasts from tick to tick. Created off the servo thread (it allocates its fixed arrays once), then owned
// by one thread.
class TouchState {
public:
    TouchState();
    ~TouchState();
    TouchState(TouchState&&) noexcept;
    TouchState& operator=(TouchState&&) noexcept;

    // Forgets contact, friction and filters. The next touch_tick starts at its goal, with growing proxy and ghosts as
    // for a fresh start.
    void reset() noexcept;
    // Forgets only speeds, after a fault; the proxy keeps its history.
    void reset_filters() noexcept;
    // Walking needs no call: if the hand's frame moves with everything in it (except by teleport), the goal simply
    // moves.

    // The proxy itself, for checks: its path, candidates and gatherings of the last tick.
    const ProxySolver& solver() const noexcept;

    struct Impl;
    Impl& impl() noexcept { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

// One tick, compiled for AllFeatures, or for PlainFeatures, which is correct only where touch_tick() chooses it
// (tick_features.h).
template <class Has>
TouchResult touch_tick_with(TouchState& state, const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m,
                            double dt_s, const Vec3& carried_m, const BodyPoses& bodies) noexcept;

// Computes one tick.
// - goal_m: the HIP (haptic interface point) in world metres, finite and within 1e6 m.
// - dt_s: time since the last tick, > 0.
// - scene: one with another address or generation than last time gets a fresh candidate set around the old proxy.
// - carried_m: how far the walker carried the workspace since the last tick, world metres. The proxy and liquids meet
//   the whole motion. Damping and the passivity guard use only the hand's own motion; otherwise every step of the
//   walker would knock in the hand (test: walking_*).
// - bodies: poses of the scene's bodies in this tick; if omitted, they stand as the scene has them.
inline TouchResult touch_tick(TouchState& state, const HapticScene& scene, const TouchTuning& tuning,
                              const Vec3& goal_m, double dt_s, const Vec3& carried_m = Vec3(0.0),
                              const BodyPoses& bodies = {}) noexcept {
    return scene.plain ? touch_tick_with<PlainFeatures>(state, scene, tuning, goal_m, dt_s, carried_m, bodies)
                       : touch_tick_with<AllFeatures>(state, scene, tuning, goal_m, dt_s, carried_m, bodies);
}

}  // namespace handrail::render
