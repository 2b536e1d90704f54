#include "app/core/hand/touch_view.h"

#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/context/device_settings.h"
#include "app/core/world/world_now.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/render/free_place.h"
#include "haptic/render/validate_scene.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/scene/lint.h"

namespace handrail::core {

void TouchView::enter_world(std::shared_ptr<const render::HapticScene> sharp, double now_s) {
    felt_.give_up();
    ++edits_;
    ordered_.reset();
    announced_.clear();
    plan_ = {};
    rounded_m_ = mesh_tolerance_m_ = 0.0;
    own_rounding_ = {};
    coarser_.clear();
    haptic_ = sharp ? std::move(sharp) : compile::compile_haptic(*world_.scene, compile::exploring(0.0));
    retune();
    adapt();
    world_.felt = haptic_->world;
    world_.things.enter(*world_.scene, *haptic_, plan_, now_s);
}

void TouchView::change_world(double now_s) {
    felt_.give_up();
    ++edits_;
    retune();
    // After a change, the hand feels dense meshes without simplification. The background task that simplifies them
    // again takes seconds.
    mesh_tolerance_m_ = 0.0;
    coarser_.clear();
    compile::CompileOptions options = compile::exploring(rounded_m_, haptic_->world);
    options.own_rounding = own_rounding_;
    haptic_ = plan_.changes_nothing() ? compile::compile_haptic(*world_.scene, options)
                                      : compile::compile_haptic(compile::simplified(*world_.scene, plan_), options);
    contract_valid(validate(*world_.scene));
    contract_valid(validate(*haptic_));
    world_.things.enter(*world_.scene, *haptic_, plan_, now_s);
    world_.movers.follow(world_.scene->movers);
    rebuild_solids(world_, avatar_);
    adapt();
}

void TouchView::adapt() {
    if (!stale()) return;
    ordered_ = order();
    felt_.begin(
        [order = *ordered_, before = FeltWorld{nullptr, plan_, {}, rounded_m_, mesh_tolerance_m_, own_rounding_, {}}](
            const std::stop_token& stop) { return make_felt(order, before, stop); });
}

void TouchView::retune() {
    const settings::Settings& settings = context_.settings;
    servo::ServoTuning& tuning = hands_.tuning;
    tuning.touch = render::TouchTuning{};
    tuning.touch.world_m_per_hand_m = scale(context_);
    tuning.touch.radius_m =
        proxy_radius_m(*world_.scene, settings.haptic.ball_diameter_mm * 1e-3, scale(context_), plan_);
    tuning.touch.default_stiffness_fraction = settings.haptic.stiffness_fraction;
    tuning.touch.damping_ns_per_m = settings.haptic.damping_ns_per_m;
    tuning.button_to_feel = settings.haptic.button_to_feel;
    // The guard acts only on surfaces with too little damping, so it is always on.
    tuning.touch.passivity_guard = true;
    tuning.touch.default_friction_static = tuning.touch.default_friction_kinetic = settings.haptic.friction_mu;

    if (hands_.right.present) tuning.touch.rated_stiffness_n_per_m = hands_.right.spec.rated_stiffness_n_per_m;
    tuning.force_ceiling_n = ceiling_n(settings, hands_.right);
    tuning.personal_space = settings.desk.use && hands_.right.present;
    tuning.workspace.rim = settings.workspace.rim;
    tuning.workspace.rim_open_behind = tuning.personal_space;
    // If the hand feels only while the first button is held, that button cannot also grab the world.
    const int button = settings.workspace.grab_button;
    tuning.workspace.grab_buttons =
        button == 0 || (button == 1 && settings.haptic.button_to_feel) ? 0U : 1U << (button - 1);
    tuning.workspace.limits_m = world_.scene->bounds_m;
    tuning.bodies.strength_n = settings.dynamics.strength_n;
    tuning.bodies.grip_buttons = settings.haptic.button_to_feel ? 0U : 1U;
}

servo::ServoTuning TouchView::left_tuning() const {
    servo::ServoTuning tuning = hands_.tuning;
    tuning.touch.rated_stiffness_n_per_m = hands_.left.spec.rated_stiffness_n_per_m;
    tuning.force_ceiling_n = ceiling_n(context_.settings, hands_.left);
    tuning.bodies.hold = hands_.left_bodies.hold;
    tuning.bodies.quarters = hands_.left_bodies.quarters;
    // The grab key moves only the right hand's workspace. Each hand has its own grab button.
    tuning.workspace.grab_key = false;
    tuning.workspace.push_hand_m_per_s = Vec3(0.0);
    tuning.personal_space = tuning.workspace.rim_open_behind = false;  // Only the right hand can be at the desk.
    return tuning;
}

// Returns how the present scale requires the world to be simplified.
TouchView::FeltRequest TouchView::felt_request() {
    openings_awaited_ = false;
    if (!hands_.right.present || !context_.settings.haptic.simplify) return {};
    FeltRequest felt_request;
    compile::SimplifyOptions& options = felt_request.simplify.emplace();
    options.world_m_per_hand_m = scale(context_);
    for (const Mark& mark : world_.marks) options.kept_m.push_back(mark.place_m);
    if (openings && needs_openings(scale(context_), context_.settings.walk.body_radius_m)) {
        KnownOpenings known = openings();
        openings_awaited_ = known.awaited;
        felt_request.portals = std::move(known.portals);
        options.openings_m = felt_request.portals.places_m;
    }
    return felt_request;
}

FeltOrder TouchView::order() {
    FeltRequest requested = felt_request();
    FeltOrder order;
    order.scene = world_.scene;
    order.edit = edits_;
    order.simplify = std::move(requested.simplify);
    order.portals = std::move(requested.portals);
    order.world_m_per_hand_m = scale(context_);
    order.proxy_diameter_hand_m = context_.settings.haptic.ball_diameter_mm * 1e-3;
    // Without a hand, nobody feels the edges, so they are not rounded.
    order.edge_rounding_hand_mm = hands_.right.present ? context_.settings.haptic.edge_rounding_mm : 0.0;
    if (hands_.right.present && context_.settings.haptic.simplify)
        order.mesh_tolerance_hand_mm = context_.settings.haptic.mesh_tolerance_mm;
    order.world = haptic_->world;
    return order;
}

bool TouchView::stale() { return !ordered_ || !ordered_->same_as(order()); }

bool TouchView::take_made(double now_s) {
    std::optional<FeltWorld> felt = felt_.take();
    if (!felt) return false;
    portals_ = std::move(felt->portals);
    if (!felt->haptic) return false;
    plan_ = std::move(felt->plan);
    rounded_m_ = felt->rounding_m;
    own_rounding_ = felt->own_rounding;
    mesh_tolerance_m_ = felt->mesh_tolerance_m;
    coarser_ = std::move(felt->coarser);
    haptic_ = std::move(felt->haptic);
    retune();
    world_.things.feel_as(*world_.scene, *haptic_, plan_, now_s);
    return true;
}

void TouchView::widen_openings(bool rooms_known) {
    if (!openings_awaited_ || !rooms_known) return;
    retune();
    adapt();
}

std::string TouchView::news() {
    std::string sentence = simplified_sentence(plan_, coarser_.size());
    if (sentence == std::exchange(announced_, sentence)) return {};
    return sentence.empty() ? phrase("simplify.nothing") : sentence;
}

double TouchView::farthest_m() const {
    return 10.0 + (world_.scene->bounds_m.empty() ? 0.0 : glm::length(world_.scene->bounds_m.size_m()));
}

Vec3 TouchView::out_of_solids_m(const Vec3& hand_m) const {
    // Share of the proxy's radius that must be free. It is less than 1, so that a proxy resting on a surface fits.
    constexpr double kTouching = 0.999;
    const auto poses = world_.things.frame().poses();
    const double radius_m = hands_.tuning.touch.radius_m;
    const double room_m = render::surrounding_of(*haptic_, poses, hand_m, radius_m).distance_m;
    if (room_m >= kTouching * radius_m) return Vec3(0.0);
    const auto free =
        render::nearest_free_place(*haptic_, poses, hand_m, (room_m > 0.0 ? 1.0 : 1.2) * radius_m, farthest_m());
    return free ? *free - hand_m : Vec3(0.0);
}

// The two hands share one workspace, so freeing one hand may push the other into a solid. Therefore the hands are freed
// alternately. If no place fits both hands, the right hand is freed, and the left hand passes through its solid until
// it is out.
Vec3 TouchView::out_of_solids_m(const Vec3& right_m, const Vec3& left_m) const {
    constexpr int kTurns = 6;
    const Vec3 alone_m = out_of_solids_m(right_m);
    if (!hands_.two() || hands_.left_tool.ticks == 0) return alone_m;
    Vec3 both_m = alone_m;
    for (int turn = 0; turn < kTurns; ++turn) {
        const Vec3 more_m = out_of_solids_m((turn % 2 == 0 ? left_m : right_m) + both_m);
        if (more_m == Vec3(0.0)) return both_m;
        both_m += more_m;
    }
    return alone_m;
}

}  // namespace handrail::core
