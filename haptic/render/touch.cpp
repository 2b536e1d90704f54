#include "haptic/render/touch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptic/render/effects.h"
#include "haptic/render/liquids.h"
#include "haptic/render/passivity_guard.h"
#include "haptic/render/proxy_solver.h"
#include "haptic/render/soft_patch.h"
#include "haptic/render/surface_field.h"
#include "haptic/render/tick_features.h"
#include "haptic/render/tick_math.h"

namespace handrail::render {
namespace {

// Lengths and times of the touch law, for the hand. Every length is multiplied by the scale before the solver uses it.
constexpr double kCandidateMargin_hand_m = 0.02;
constexpr double kGrowth_hand_m_per_s = 0.02;
constexpr double kSlip_hand_m = 2e-3;      // slide distance over which static friction falls by a factor e
constexpr double kHealing_s = 0.3;         // time of rest after which static friction has recovered by 1 - 1/e
constexpr double kSpeedPole_hz = 50.0;     // pole of the filter for the hand speed that damping uses
constexpr double kSmallestForce_n = 1e-9;  // a smaller force is treated as a rounding error

// A wave has its full swing while a period takes at least 8 ticks. With faster hands it fades, and is level below 4
// ticks.
constexpr double kTicksOfFullWave = 8.0;
constexpr double kSwingChange_per_s = 50.0;
// Squared sine or determinant below which the normals of the holds are treated as parallel, so that they have no dual
// directions.
constexpr double kParallel = 1e-12;

// The combined properties of the surfaces that hold the proxy, each weighted by how hard it holds, so that the hand
// feels no click at a seam.
struct Feel {
    double stiffness_n_per_m = 0.0;
    double damping_ns_per_m = 0.0;
    double friction_static = 0.0;
    double friction_kinetic = 0.0;
};

Feel feel_of(const HapticMaterial& material, const TouchTuning& t) noexcept {
    const auto pick = [](double override_value, double own, double fallback) {
        return override_value >= 0.0 ? override_value : own >= 0.0 ? own : fallback;
    };
    Feel feel;
    feel.stiffness_n_per_m =
        t.override_stiffness_n_per_m >= 0.0
            ? t.override_stiffness_n_per_m
            : t.rated_stiffness_n_per_m *
                  (material.stiffness_fraction >= 0.0 ? material.stiffness_fraction : t.default_stiffness_fraction);
    feel.damping_ns_per_m = pick(t.override_damping_ns_per_m, material.damping_ns_per_m, t.damping_ns_per_m);
    feel.friction_kinetic = pick(t.override_friction_kinetic, material.friction_kinetic, t.default_friction_kinetic);
    feel.friction_static = std::max(
        feel.friction_kinetic, pick(t.override_friction_static, material.friction_static, t.default_friction_static));
    return feel;
}

}  // namespace

struct TouchState::Impl {
    ProxySolver solver;
    Vec3 last_goal_m{0.0};
    bool has_goal = false;         // false before the first tick and after reset()
    bool has_speed = false;        // false also after reset_filters()
    Vec3 hand_speed_m_per_s{0.0};  // filtered velocity of the hand
    double grip = 1.0;             // 1: static friction; 0: kinetic friction
    Feel feel;  // properties of the last contact; also used while the proxy returns to its goal after the contact
    LiquidState liquids;
    EffectState effects;
    SoftState soft;
    PassivityGuard guard;
    double swing = 1.0;  // amplitude factor of the waves of textures; 0 while the hand moves too fast for them

    // The press, corrected by the fields of the surfaces.
    struct FieldPress {
        Vec3 rest_m{0.0};  // from the hand to where the proxy would rest on the surfaces shifted by their fields
        Vec3 pull_m{0.0};  // force divided by stiffness: rest_m plus the part that comes from the slopes of the fields
        bool touching = false;  // false if the hand is above the bottom of a hollow, so that it touches nothing
        double friction = 1.0;
    };

    FieldPress field_press(const HapticScene& scene, const TouchTuning& tuning, const ProxySolver::Step& step,
                           const std::array<std::uint32_t, 3>& faces, double dt_s) noexcept;
    // Returns the force of liquids, effects and soft patches on the hand, with one limit for all together. Fills in
    // their part of the result.
    Vec3 media_n(const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m, const Vec3& goal_step_m,
                 double dt_s, const BodyPoses& bodies, TouchResult& result) noexcept;
    // goal_step_m() returns how far the goal moved since the last tick. path_cap_m() returns the longest path that the
    // proxy may take in this tick.
    Vec3 goal_step_m(const Vec3& goal_m) const noexcept { return has_goal ? goal_m - last_goal_m : Vec3(0.0); }
    static double path_cap_m(const TouchTuning& tuning, const Vec3& goal_step_m) noexcept {
        return std::max(tuning.slide_cap_hand_m * tuning.world_m_per_hand_m, 2.0 * glm::length(goal_step_m));
    }
    bool bodies_are_far(const HapticScene& scene, const TouchTuning& tuning, double path_cap_m,
                        const BodyPoses& bodies) noexcept {
        const double margin_m = kCandidateMargin_hand_m * tuning.world_m_per_hand_m;
        return solver.bodies_stay_far(scene, bodies, tuning.radius_m, margin_m, path_cap_m) ||
               sees_bodies_far(scene, tuning, margin_m, path_cap_m, bodies);
    }
    [[gnu::noinline]] bool sees_bodies_far(const HapticScene& scene, const TouchTuning& tuning, double margin_m,
                                           double path_cap_m, const BodyPoses& bodies) noexcept {
        ProxySolver::Request request;
        request.radius_m = tuning.radius_m;
        request.margin_m = margin_m;
        request.path_cap_m = path_cap_m;
        request.bodies = &bodies;
        return solver.bodies_are_far(scene, request);
    }
    template <class Has>
    [[gnu::always_inline]] inline TouchResult tick(const HapticScene& scene, const TouchTuning& tuning,
                                                   const Vec3& goal_m, const Vec3& goal_step, double path_cap_m,
                                                   double dt_s, const Vec3& carried_m,
                                                   const BodyPoses& bodies) noexcept;
};

// The shifts of the surfaces, weighted by how hard each surface holds the proxy, reduce the press P to P - s with s =
// sum(multiplier * shift) / P. This is a potential 1/2 K (P - s)^2 over the hand's position, which stays continuous
// when a surface begins or stops to hold. The pull is the potential's gradient: (P - s)(p + grad s), where p is the
// direction of the press. The gradients of the multipliers are the vectors dual to the normals. The alternative, to
// shift each surface and press against all of them again, was rejected. With it, the force would jump when the lowered
// proxy reaches a further surface.
TouchState::Impl::FieldPress TouchState::Impl::field_press(const HapticScene& scene, const TouchTuning& tuning,
                                                           const ProxySolver::Step& step,
                                                           const std::array<std::uint32_t, 3>& faces,
                                                           double dt_s) noexcept {
    FieldPress out;
    const Vec3 press = solver.press_m();
    const double press_length = glm::length(press);
    if (press_length <= 0.0) return out;
    const Vec3 towards = press / press_length;
    std::array<Vec3, 3> dual{};
    const auto normal = [&](std::size_t k) { return step.holds[k].normal; };
    if (step.count == 1) {
        dual[0] = normal(0);
    } else if (step.count == 2) {
        const double c = glm::dot(normal(0), normal(1)), sine2 = 1.0 - c * c;
        if (sine2 > kParallel)
            dual = {(normal(0) - normal(1) * c) / sine2, (normal(1) - normal(0) * c) / sine2, Vec3(0.0)};
    } else if (step.count == 3) {
        const double det = glm::dot(normal(0), glm::cross(normal(1), normal(2)));
        if (det * det > kParallel)
            dual = {glm::cross(normal(1), normal(2)) / det, glm::cross(normal(2), normal(0)) / det,
                    glm::cross(normal(0), normal(1)) / det};
    }
    FieldRequest request;
    const Vec3 proxy_m = scene.origin_m + solver.rest_m(), hand_m = proxy_m - press;
    request.swing = swing;
    double shift = 0.0, friction = 0.0, sum = 0.0, swing_gain = 0.0, shortest_period = 0.0;
    Vec3 gradient(0.0);
    for (int k = 0; k < step.count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const ProxySolver::Hold& hold = step.holds[at];
        const HapticScene& shape = ProxySolver::shape_of(scene, hold);
        const HapticMaterial& material = scene.material(shape.label(hold.obstacle, faces[at]).material);
        const double own = solver.own_scale(hold);  // world metres per metre of the shape's own frame
        request.obstacle = hold.obstacle;
        request.face = faces[at];
        request.normal = solver.turned_to_own(hold, hold.normal);
        request.hand_m = solver.to_own(scene, hold, hand_m);
        request.proxy_m = solver.to_own(scene, hold, proxy_m);
        request.press_m = glm::dot(hold.normal, press) / own;
        request.radius_m = solver.radius_m() / own;
        request.world_m_per_hand_m = tuning.world_m_per_hand_m / own;
        request.stiffness_n_per_m = feel_of(material, tuning).stiffness_n_per_m;
        SurfaceField field = surface_field(scene, shape, request);
        field.shift_m *= own;
        field.swing_to_shift *= own;
        field.gradient = solver.turned_from_own(hold, field.gradient);
        shift += hold.multiplier_m * field.shift_m;
        gradient += field.gradient * hold.multiplier_m - dual[at] * field.shift_m;
        friction += hold.multiplier_m * field.friction;
        swing_gain += hold.multiplier_m * field.swing_to_shift;
        sum += hold.multiplier_m;
        if (material.relief >= 0) {
            const double period = scene.reliefs[static_cast<std::size_t>(material.relief)].period_hand_m;
            shortest_period = shortest_period > 0.0 ? std::min(shortest_period, period) : period;
        }
    }
    shift /= press_length;
    const double left = press_length - shift;
    if (sum > 0.0) out.friction = friction / sum;
    if (left > 0.0) {
        out.touching = true;
        out.rest_m = towards * left;
        out.pull_m = (towards * (1.0 + shift / press_length) + gradient / press_length) * left;
    }
    // The swing of waves follows the hand's speed. It changes only in ticks in which the change lowers the surfaces,
    // because fading must not give the hand energy.
    if (shortest_period > 0.0) {
        const double per_period = glm::length(hand_speed_m_per_s) * dt_s * kTicksOfFullWave / shortest_period;
        const double wanted = std::clamp(2.0 - per_period, 0.0, 1.0);
        const double change = std::clamp(wanted - swing, -kSwingChange_per_s * dt_s, kSwingChange_per_s * dt_s);
        if (change * swing_gain >= 0.0 || !out.touching) swing += change;
    }
    return out;
}

Vec3 TouchState::Impl::media_n(const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m,
                               const Vec3& goal_step_m, double dt_s, const BodyPoses& bodies,
                               TouchResult& result) noexcept {
    HandMotion hand;
    hand.goal_m = goal_m;
    hand.step_m = goal_step_m / tuning.world_m_per_hand_m;
    hand.dt_s = dt_s;
    hand.scale = tuning.world_m_per_hand_m;
    hand.stiffest_n_per_m = tuning.rated_stiffness_n_per_m;
    hand.held = tuning.held;
    hand.bodies = &bodies;
    const SoftPatch* pressed = nullptr;
    result.soft_force_n = soft.force_n(scene, hand, result.proxy_m, tuning.radius_m, pressed);
    if (pressed) {
        result.soft = pressed->feature;
        result.soft_material = pressed->material;
    }
    const Vec3 media = liquids.force_n(scene, hand, solver.local_m(), result.liquid) + effects.force_n(scene, hand) +
                       result.soft_force_n;
    result.effects_truncated = effects.truncated();
    return shortened(media, kLargestEffect_n);
}

template <class Has>
TouchResult TouchState::Impl::tick(const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m,
                                   const Vec3& goal_step, double path_cap_m, double dt_s, const Vec3& carried_m,
                                   const BodyPoses& bodies) noexcept {
    const double scale = tuning.world_m_per_hand_m;
    // Movement of the hand itself, without the movement of a workspace that the walker carries.
    const Vec3 own_step = (goal_step - carried_m) / scale;
    last_goal_m = goal_m;
    has_goal = true;

    // 1. Moves the proxy.
    ProxySolver::Request request;
    request.goal_m = goal_m;
    request.radius_m = tuning.radius_m;
    request.path_cap_m = path_cap_m;
    request.margin_m = kCandidateMargin_hand_m * scale;
    request.growth_m = kGrowth_hand_m_per_s * scale * dt_s;
    request.most_rounds = tuning.most_rounds;
    request.bodies = &bodies;
    const ProxySolver::Step& step = solver.move<Has>(scene, request);

    TouchResult result;
    ContactSet& contacts = result.contacts;
    contacts.iterations = static_cast<std::uint16_t>(step.iterations);
    contacts.converged = step.converged;
    contacts.truncated = step.truncated;
    contacts.capped = step.capped;
    contacts.waits = step.waits;
    contacts.ghosted = step.ghosted;
    double sum = 0.0, hardest = -1.0;
    std::array<std::uint32_t, 3> faces{};
    for (int k = 0; k < step.count; ++k) {
        const ProxySolver::Hold& hold = step.holds[static_cast<std::size_t>(k)];
        sum += hold.multiplier_m;
        faces[static_cast<std::size_t>(k)] =
            Has::kBodies
                ? ProxySolver::shape_of(scene, hold).face(hold.obstacle, solver.turned_to_own(hold, hold.normal))
                : scene.face(hold.obstacle, hold.normal);
    }
    Vec3 press = solver.press_m();
    const bool has_fields = Has::kFields && scene.has_fields() && step.count > 0;
    FieldPress field;
    if (has_fields) {
        field = field_press(scene, tuning, step, faces, dt_s);
        field.pull_m -= press;
        press = field.rest_m;
    }
    Feel blend;
    for (int k = 0; k < step.count && !(has_fields && !field.touching); ++k) {
        const ProxySolver::Hold& hold = step.holds[static_cast<std::size_t>(k)];
        const HapticScene& shape = Has::kBodies ? ProxySolver::shape_of(scene, hold) : scene;
        const SurfaceLabel& label = shape.label(hold.obstacle, faces[static_cast<std::size_t>(k)]);
        const double share = sum > 0.0 ? hold.multiplier_m / sum : 1.0 / step.count;
        if (share > hardest) {
            hardest = share;
            contacts.strongest = contacts.count;
        }
        contacts.contacts[contacts.count++] = {label.feature, label.material, hold.normal, share};
        const Feel one = feel_of(scene.material(label.material), tuning);
        blend.stiffness_n_per_m += share * one.stiffness_n_per_m;
        blend.damping_ns_per_m += share * one.damping_ns_per_m;
        blend.friction_static += share * one.friction_static;
        blend.friction_kinetic += share * one.friction_kinetic;
    }

    // 2. Friction: Coulomb's cone applied to the proxy's path. Static friction weakens with the distance slid, so it
    //    never drops at once.
    const double press_length = glm::length(press);
    if (contacts.count > 0) {
        feel = blend;
        const double mu =
            (feel.friction_kinetic + (feel.friction_static - feel.friction_kinetic) * grip) * field.friction;
        if (mu > 0.0) {
            solver.hold_back<Has>(scene, mu * press_length);
            contacts.waits = step.waits;
            if (Has::kBodies) solver.ride(step.holds[contacts.strongest].body);
        }
    }
    result.slide_m = solver.slide_m();
    const double slid = glm::length(solver.rubbed_m());
    if (contacts.count > 0 && slid > 0.0) {
        grip *= decay(slid / (kSlip_hand_m * scale));
    } else {
        grip += (1.0 - grip) * (1.0 - decay(dt_s / kHealing_s));
    }

    // 3. Computes the force of the coupling, per metre of hand travel.
    Vec3 offset = solver.offset_m();
    const bool together = offset == Vec3(0.0);
    result.proxy_m = together ? goal_m : solver.world_m();
    if (has_fields) {
        result.proxy_m += press - solver.press_m();
        offset += field.pull_m;
    }
    result.radius_m = solver.radius_m();
    Vec3 force = offset * (feel.stiffness_n_per_m / scale);

    // 4. Adds damping and the passivity guard, along the normal only. Neither ever pulls the hand into the surface.
    if (has_speed) {
        const double u = 2.0 * kPi * kSpeedPole_hz * dt_s;
        hand_speed_m_per_s += (own_step / dt_s - hand_speed_m_per_s) * (u / (1.0 + u));
    } else {
        hand_speed_m_per_s = Vec3(0.0);
        has_speed = true;
    }
    const bool touching = contacts.count > 0 && press_length > 0.0;
    const bool guarding = tuning.passivity_guard && feel.damping_ns_per_m < PassivityGuard::kNotNeeded_ns_per_m;
    if (touching) {
        const Vec3 normal = press / press_length;
        const double normal_force = glm::dot(force, normal);
        double damping = feel.damping_ns_per_m;
        if (guarding) damping += guard.watch(own_step, dt_s, tuning.force_delay_s);
        // The damping force is at most as large as the spring's force in both directions. A hand that arrives fast thus
        // feels no step of damping times speed, and a hand that leaves is not held back.
        if (normal_force > 0.0)
            force += normal * std::clamp(-damping * glm::dot(hand_speed_m_per_s, normal), -normal_force, normal_force);
    }
    if (guarding && !touching) guard.reset();
    if (glm::dot(force, force) < kSmallestForce_n * kSmallestForce_n) force = Vec3(0.0);
    result.contact_force_n = force;
    if (guarding) guard.given(force);

    // 5. Adds the forces of liquids, effects and soft patches.
    if (scene.media && (Has::kMedia || !liquids.surely_dry(scene, solver.local_m(), scale))) {
        force += media_n(scene, tuning, goal_m, goal_step, dt_s, bodies, result);
        if (glm::dot(force, force) < kSmallestForce_n * kSmallestForce_n) force = Vec3(0.0);
    }
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
    impl_->grip = impl_->swing = 1.0;
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

template <class Has>
TouchResult touch_tick_with(TouchState& state, const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m,
                            double dt_s, const Vec3& carried_m, const BodyPoses& bodies) noexcept {
    TouchState::Impl& impl = state.impl();
    const Vec3 goal_step_m = impl.goal_step_m(goal_m);
    const double path_cap_m = impl.path_cap_m(tuning, goal_step_m);
    if constexpr (Has::kBodies) {
        // Movable bodies that are far away cost only the check that they are far.
        if (scene.plain_afar && impl.bodies_are_far(scene, tuning, path_cap_m, bodies))
            return impl.tick<PlainFeatures>(scene, tuning, goal_m, goal_step_m, path_cap_m, dt_s, carried_m, bodies);
    }
    return impl.tick<Has>(scene, tuning, goal_m, goal_step_m, path_cap_m, dt_s, carried_m, bodies);
}
template TouchResult touch_tick_with<PlainFeatures>(TouchState&, const HapticScene&, const TouchTuning&, const Vec3&,
                                                    double, const Vec3&, const BodyPoses&) noexcept;
template TouchResult touch_tick_with<AllFeatures>(TouchState&, const HapticScene&, const TouchTuning&, const Vec3&,
                                                  double, const Vec3&, const BodyPoses&) noexcept;

}  // namespace handrail::render
