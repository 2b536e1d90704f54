#include "app/core/wayfinding/route_stage.h"

#include <algorithm>

#include "app/core/context/context_words.h"
#include "app/core/world/questions.h"
#include "worlds/navigation/route_place.h"

namespace handrail::core {

namespace {

bool is_of_lift(const SessionContext& context, FeatureId door) {
    const int mover = mover_of(context.world, door);
    return mover >= 0 && context.world.scene->movers[static_cast<std::size_t>(mover)].lift != kNoMover;
}

}  // namespace

bool has_legs(const SessionContext& context, navigation::PassageKind kind, FeatureId feature) {
    if (kind == navigation::PassageKind::Opening || kind == navigation::PassageKind::Stairs) return true;
    return kind == navigation::PassageKind::Door && lock_words(context, feature).empty() &&
           !is_of_lift(context, feature);
}

std::optional<navigation::RoutePassage> without_legs(const SessionContext& context, const navigation::Route& route) {
    const auto found = std::find_if(
        route.passages.begin(), route.passages.end(),
        [&](const navigation::RoutePassage& passage) { return !has_legs(context, passage.kind, passage.feature); });
    return found == route.passages.end() ? std::nullopt : std::optional(*found);
}

std::optional<RouteStage> first_stage(const SessionContext& context, const navigation::Route& route,
                                      const DirectionsEnd& end, const std::string& name) {
    // A walker nearer than kAtPassage_m is at the passage. The stage ends kBefore_m before it.
    constexpr double kAtPassage_m = 1.5, kBefore_m = 0.5;
    const auto passage = without_legs(context, route);
    if (!passage) return RouteStage{end, name};
    if (passage->at_m < kAtPassage_m) return std::nullopt;
    // The door of a lift is announced as the lift behind it.
    const auto shown =
        std::find_if(route.passages.begin(), route.passages.end(), [&](const navigation::RoutePassage& other) {
            return other.at_m >= passage->at_m &&
                   (other.kind == navigation::PassageKind::Lift || !is_of_lift(context, other.feature));
        });
    const navigation::RoutePassage& named = shown == route.passages.end() ? *passage : *shown;
    const Vec3 before_m = navigation::place_along(route.points_m, passage->at_m - kBefore_m);
    return RouteStage{{navigation::kNothing, before_m, true},
                      passage_now(context, named.kind, named.feature, named.rise_m)};
}

}  // namespace handrail::core
