#include "haptic/render/touch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptic/render/passivity_guard.h"
#include "haptic/render/proxy_solver.h"

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

// Liquids: a point dragged behind the hand by a spring; it yields as fast as the liquid lets it (a Maxwell element), so no speed is measured.
constexpr double kDragStiffness_n_per_m = 400.0;
constexpr double kLargestDrag_n = 4.0;
constexpr double kImmersion_hand_m = 0.01;  // half the depth over which a liquid's surface sets in

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

// exp(-u) for u >= 0 from plain arithmetic, the same on every machine: within 0.4 % for u <= 1, falling for every u.
double decay(double u) noexcept { return 1.0 / (1.0 + u * (1.0 + u * (0.5 + u * (1.0 / 6.0 + u * (1.0 / 24.0))))); }

double smooth_step(double u) noexcept {
    u = std::clamp(u, 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

// How deep a point lies below the surface of a liquid: its exposed faces where it has any. Negative outside.
double depth_in(const LiquidVolume& liquid, const Vec3& local_m, bool& inside) noexcept {
    double exposed = -std::numeric_limits<double>::infinity(), all = exposed;
    for (std::size_t i = 0; i < liquid.planes.size(); ++i) {
        const double out = signed_distance(liquid.planes[i], local_m);
        all = std::max(all, out);
        if (!liquid.hidden[i]) exposed = std::max(exposed, out);
    }
    inside = all <= 0.0;
    // Beside or beyond a covered face the liquid is not there, however deep the point is below the exposed ones.
    const bool any_exposed = exposed > -std::numeric_limits<double>::infinity();
    return any_exposed && inside ? -exposed : -all;
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
    Vec3 drag_offset_hand_m{0.0};  // dragged point minus hand
    PassivityGuard guard;

    TouchResult tick(const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m, double dt_s, const Vec3& carried_m,
                     const BodyPoses& bodies) noexcept;
    Vec3 liquid_force(const HapticScene& scene, const TouchTuning& tuning, const Vec3& hand_step_m, double dt_s, FeatureId& in) noexcept;
};

// Drag in hand units: p <- p + (x - p) a with a = u / (1 + u), u = K T / c. This share, unlike 1 - exp(-u), makes the steady force exactly c v at every
// tick length. The point only ever moves along its own force, so the liquid never gives energy.
Vec3 TouchState::Impl::liquid_force(const HapticScene& scene, const TouchTuning& tuning, const Vec3& hand_step_m, double dt_s, FeatureId& in) noexcept {
    in = kNoFeature;
    if (scene.liquids.empty()) return Vec3(0.0);
    const double reach = kImmersion_hand_m * tuning.world_m_per_hand_m;
    const Vec3 at = solver.local_m();
    // Of overlapping volumes the last one listed rules; where it thins out towards its own surface the next takes the rest, so neighbours
    // of one pool make one pool.
    constexpr std::size_t kMost = 8;
    struct Wet {
        std::uint32_t volume;
        double share;
    };
    std::array<Wet, kMost> wet;
    std::size_t count = 0;
    std::uint32_t inside_of = 0;
    bool inside_any = false;
    scene.liquid_bvh.within(at, reach, [&](std::uint32_t item, double&) {
        bool inside = false;
        const double depth = depth_in(scene.liquids[item], at, inside);
        if (inside && (!inside_any || item > inside_of)) {
            inside_any = true;
            inside_of = item;
        }
        const double share = smooth_step((depth + reach) / (2.0 * reach));
        if (share <= 0.0 || count == kMost) return;
        std::size_t place = count++;
        for (; place > 0 && wet[place - 1].volume < item; --place) wet[place] = wet[place - 1];
        wet[place] = {item, share};
    });
    if (inside_any) in = scene.liquids[inside_of].feature;
    double left = 1.0, viscosity = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = std::min(left, wet[i].share);
        viscosity += share * scene.liquids[wet[i].volume].viscosity_ns_per_m;
        left -= share;
    }
    if (viscosity <= 0.0) {
        drag_offset_hand_m = Vec3(0.0);
        return Vec3(0.0);
    }
    const double u = kDragStiffness_n_per_m * dt_s / viscosity;
    drag_offset_hand_m = (drag_offset_hand_m - hand_step_m) * (1.0 / (1.0 + u));
    const double length = glm::length(drag_offset_hand_m), longest = kLargestDrag_n / kDragStiffness_n_per_m;
    if (length > longest) drag_offset_hand_m *= longest / length;
    return drag_offset_hand_m * kDragStiffness_n_per_m;
}

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

    // 5. Liquids.
    force += liquid_force(scene, tuning, hand_step, dt_s, result.liquid);
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
    impl_->drag_offset_hand_m = Vec3(0.0);
}

const ProxySolver& TouchState::solver() const noexcept { return impl_->solver; }

TouchResult touch_tick(TouchState& state, const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal_m, double dt_s, const Vec3& carried_m,
                       const BodyPoses& bodies) noexcept {
    return state.impl().tick(scene, tuning, goal_m, dt_s, carried_m, bodies);
}

}  // namespace handrail
