#include "haptic/render/touch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptic/render/effects.h"
#include "haptic/render/liquids.h"
#include "haptic/render/passivity_guard.h"
#include "haptic/render/proxy_solver.h"
#include "haptic/render/tick_math.h"

namespace handrail {
namespace {

// Hand lengths and times of the touch law; every length is multiplied by the scale before the solver sees it.
constexpr double kCandidateMargin_hand_m = 0.02;
constexpr double kGrowth_hand_m_per_s = 0.02;
constexpr double kGhostExit_hand_m = 1e-3;
constexpr double kSlip_hand_m = 2e-3;      // slide over which static friction weakens by 1/e
constexpr double kHealing_s = 0.3;         // rest in which it comes back by 1 - 1/e
constexpr double kSpeedPole_hz = 50.0;     // of the hand speed that damping uses
constexpr double kSmallestForce_n = 1e-9;  // below it a force is rounding

// What the surfaces that hold the ball are like together, blended by how hard each holds, so that seams do not click.
struct Feel {
    double stiffness_n_per_m = 0.0;
    double damping_ns_per_m = 0.0;
    double friction_static = 0.0;
    double friction_kinetic = 0.0;
};

Feel feel_of(const HapticMaterial& material, const TouchTuning& t) noexcept {
    const auto pick = [](double override_value, double own, double fallback) { return override_value >= 0.0 ? override_value : own >= 0.0 ? own : fallback; };
    Feel feel;
    feel.stiffness_n_per_m =
        t.override_stiffness_n_per_m >= 0.0
            ? t.override_stiffness_n_per_m
            : t.rated_stiffness_n_per_m * (material.stiffness_fraction >= 0.0 ? material.stiffness_fraction : t.default_stiffness_fraction);
    feel.damping_ns_per_m = t.override_damping_ns_per_m >= 0.0 ? t.override_damping_ns_per_m : t.damping_ns_per_m;
    feel.friction_kinetic = pick(t.override_friction_kinetic, material.friction_kinetic, t.default_friction_kinetic);
    feel.friction_static = std::max(feel.friction_kinetic, pick(t.override_friction_static, material.friction_static, t.default_friction_static));
    return feel;
}

}  // namespace

struct TouchState::Impl {
    ProxySolver solver;
    Vec3 last_goal_m{0.0};
    bool has_goal = false;         // false before the first tick and after reset()
    bool has_speed = false;        // false also after reset_filters()
    Vec3 hand_speed_m_per_s{0.0};  // filtered
    double grip = 1.0;             // 1: static friction, 0: kinetic
    Feel feel;                     // of the last contact; also for the way back to a goal that slipped off
    LiquidState liquids;
    EffectState effects;
    PassivityGuard guard;

    TouchResult tick(const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m, double dt_s, const Vec3& carried_m,
                     const BodyPoses& bodies) noexcept;
};

TouchResult TouchState::Impl::tick(const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m, double dt_s, const Vec3& carried_m,
                                   const BodyPoses& bodies) noexcept {
    const double scale = tuning.world_m_per_hand_m;
    const Vec3 goal_step = has_goal ? goal_m - last_goal_m : Vec3(0.0);
    const Vec3 hand_step = goal_step / scale;               // through the world
    const Vec3 own_step = (goal_step - carried_m) / scale;  // of the hand itself, not of a workspace that walks with the body
    last_goal_m = goal_m;
    has_goal = true;

    // 1. The ball.
    ProxySolver::Request request;
    request.goal_m = goal_m;
    request.radius_m = tuning.radius_m;
    request.path_cap_m = std::max(tuning.slide_cap_hand_m * scale, 2.0 * glm::length(goal_step));
    request.margin_m = kCandidateMargin_hand_m * scale;
    request.growth_m = kGrowth_hand_m_per_s * scale * dt_s;
    request.ghost_exit_m = kGhostExit_hand_m * scale;
    request.most_rounds = tuning.most_rounds;
    request.bodies = bodies.poses;
    request.bodies_number = bodies.number;
    const ProxySolver::Step& step = solver.move(scene, request);

    TouchResult result;
    ContactSet& contacts = result.contacts;
    contacts.count = static_cast<std::uint8_t>(step.count);
    contacts.iterations = static_cast<std::uint16_t>(step.iterations);
    contacts.converged = step.converged;
    contacts.truncated = step.truncated;
    contacts.capped = step.capped;
    contacts.ghosted = step.ghosted;
    double sum = 0.0, hardest = -1.0;
    for (int k = 0; k < step.count; ++k) sum += step.holds[static_cast<std::size_t>(k)].multiplier_m;
    Feel blend;
    for (int k = 0; k < step.count; ++k) {
        const ProxySolver::Hold& hold = step.holds[static_cast<std::size_t>(k)];
        const SurfaceLabel& label = ProxySolver::shape_of(scene, hold).surface(hold.obstacle, solver.turned_to_own(hold, hold.normal));
        const double share = sum > 0.0 ? hold.multiplier_m / sum : 1.0 / step.count;
        contacts.contacts[static_cast<std::size_t>(k)] = {label.feature, label.material, hold.normal, share};
        if (share > hardest) {
            hardest = share;
            contacts.strongest = static_cast<std::uint8_t>(k);
        }
        const Feel one = feel_of(scene.material(label.material), tuning);
        blend.stiffness_n_per_m += share * one.stiffness_n_per_m;
        blend.damping_ns_per_m += share * one.damping_ns_per_m;
        blend.friction_static += share * one.friction_static;
        blend.friction_kinetic += share * one.friction_kinetic;
    }

    // 2. Friction: Coulomb's cone on the ball's path. Static friction weakens with the way slid, so it never drops at once.
    const Vec3 press = solver.press_m();
    const double press_length = glm::length(press);
    if (step.count > 0) {
        feel = blend;
        const double mu = feel.friction_kinetic + (feel.friction_static - feel.friction_kinetic) * grip;
        if (mu > 0.0) {
            solver.hold_back(scene, mu * press_length);
            solver.ride(step.holds[contacts.strongest].body);
        }
    }
    result.slide_m = solver.slide_m();
    const double slid = glm::length(result.slide_m);
    if (step.count > 0 && slid > 0.0) {
        grip *= decay(slid / (kSlip_hand_m * scale));
    } else {
        grip += (1.0 - grip) * (1.0 - decay(dt_s / kHealing_s));
    }

    // 3. Force of the coupling, per metre of hand travel.
    const Vec3 offset = solver.offset_m();
    const bool together = offset == Vec3(0.0);
    result.proxy_m = together ? goal_m : solver.world_m();
    result.radius_m = solver.radius_m();
    Vec3 force = offset * (feel.stiffness_n_per_m / scale);

    // 4. Damping and passivity guard, along the normal only and never pulling into the surface.
    if (has_speed) {
        const double u = 2.0 * kPi * kSpeedPole_hz * dt_s;
        hand_speed_m_per_s += (own_step / dt_s - hand_speed_m_per_s) * (u / (1.0 + u));
    } else {
        hand_speed_m_per_s = Vec3(0.0);
        has_speed = true;
    }
    const bool touching = step.count > 0 && press_length > 0.0;
    const bool guarding = tuning.passivity_guard && feel.damping_ns_per_m < PassivityGuard::kNotNeeded_ns_per_m;
    if (touching) {
        const Vec3 normal = press / press_length;
        const double normal_force = glm::dot(force, normal);
        double damping = feel.damping_ns_per_m;
        if (guarding) damping += guard.watch(own_step, dt_s, tuning.force_delay_s);
        // Bounded by the spring on both sides: a hand that arrives fast meets no step of damping times speed, and one that leaves is not held.
        if (normal_force > 0.0) force += normal * std::clamp(-damping * glm::dot(hand_speed_m_per_s, normal), -normal_force, normal_force);
    }
    if (guarding && !touching) guard.reset();
    if (glm::dot(force, force) < kSmallestForce_n * kSmallestForce_n) force = Vec3(0.0);
    result.contact_force_n = force;
    if (guarding) guard.given(force);

    // 5. Liquids and effects.
    if (!scene.liquids.empty() || !scene.effects.empty()) {
        HandMotion hand;
        hand.goal_m = goal_m;
        hand.step_m = hand_step;
        hand.dt_s = dt_s;
        hand.scale = scale;
        hand.stiffest_n_per_m = tuning.rated_stiffness_n_per_m;
        hand.held = tuning.held;
        hand.bodies = bodies.poses;
        const Vec3 media = liquids.force_n(scene, hand, solver.local_m(), result.liquid) + effects.force_n(scene, hand);
        result.effects_truncated = effects.truncated();
        force += shortened(media, kLargestEffect_n);
    }
    if (glm::dot(force, force) < kSmallestForce_n * kSmallestForce_n) force = Vec3(0.0);
    result.force_n = force;
    return result;
}

TouchState::TouchState() : impl_(std::make_unique<Impl>()) {}
TouchState::~TouchState() = default;
TouchState::TouchState(TouchState&&) noexcept = default;
TouchState& TouchState::operator=(TouchState&&) noexcept = default;

void TouchState::reset() noexcept {
    impl_->solver.reset();
    impl_->has_goal = false;
    impl_->grip = 1.0;
    impl_->guard = {};
    reset_filters();
}

void TouchState::reset_filters() noexcept {
    impl_->has_speed = false;
    impl_->hand_speed_m_per_s = Vec3(0.0);
    impl_->liquids.reset();
    impl_->effects.reset();
}

const ProxySolver& TouchState::solver() const noexcept { return impl_->solver; }

TouchResult touch_tick(TouchState& state, const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m, double dt_s, const Vec3& carried_m,
                       const BodyPoses& bodies) noexcept {
    return state.impl().tick(scene, tuning, goal_m, dt_s, carried_m, bodies);
}

}  // namespace handrail
