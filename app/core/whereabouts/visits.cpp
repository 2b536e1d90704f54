#include "app/core/whereabouts/visits.h"

#include <cmath>

#include "app/core/world/questions.h"

namespace handrail::core {
namespace {

constexpr double kStands_m = 0.02, kStandsTurn_rad = 0.02;

}  // namespace

void Visits::enter_world() {
    last_ = kNoFeature;
    looked_ = false;
    since_s_ = context_.tick_s;
}

bool Visits::is_thing(FeatureId feature) const {
    if (!feature || feature.value >= context_.world.scene->features.size()) return false;
    switch (context_.world.scene->features[feature.value].kind) {
        case FeatureKind::Wall:
        case FeatureKind::Floor:
        case FeatureKind::Ceiling:
        case FeatureKind::Slope:
        case FeatureKind::Liquid:
        case FeatureKind::Trigger:
            return false;
        default:
            return true;
    }
}

void Visits::visit(FeatureId feature, VisitedBy by, double now_s) {
    const Vec3 feet_m = context_.avatar.feet_m();
    if (!is_thing(feature) || (feature == last_ && glm::length(feet_m - last_m_) < kLeft_m)) return;
    last_ = feature;
    last_m_ = feet_m;
    context_.events.report(ThingVisited{feature, by}, now_s);
}

// Returns the thing straight ahead at the height of the waist.
FeatureId Visits::faced() const {
    const Viewpoint viewpoint{*context_.world.solids, context_.avatar.feet_m(), context_.avatar.heading_rad,
                              context_.avatar.walker->size()};
    const auto sight = sight_along(viewpoint, context_.avatar.heading_rad);
    return sight && !sight->surface && sight->seen.distance_m <= kFaced_m ? sight->seen.feature : kNoFeature;
}

void Visits::tick(FeatureId queried_thing, double now_s) {
    const Vec3 feet_m = context_.avatar.feet_m();
    if (last_ && glm::length(feet_m - last_m_) >= kLeft_m) last_ = kNoFeature;
    if (glm::length(feet_m - stands_m_) > kStands_m ||
        std::abs(wrap_angle(context_.avatar.heading_rad - stands_rad_)) > kStandsTurn_rad) {
        stands_m_ = feet_m;
        stands_rad_ = context_.avatar.heading_rad;
        since_s_ = now_s;
        looked_ = false;
        return;
    }
    if (now_s - since_s_ < kStood_s) return;
    if (context_.hands.right.present) visit(context_.hands.tool.touched(), VisitedBy::Hand, now_s);
    if (context_.hands.left.present) visit(context_.hands.left_tool.touched(), VisitedBy::Hand, now_s);
    visit(queried_thing, VisitedBy::Query, now_s);
    if (looked_ || now_s - since_s_ < kFaced_s) return;
    looked_ = true;
    visit(faced(), VisitedBy::Facing, now_s);
}

}  // namespace handrail::core
