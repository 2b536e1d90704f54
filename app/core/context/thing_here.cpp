#include "app/core/context/thing_here.h"

#include "app/core/world/questions.h"

namespace handrail::core {
namespace {

constexpr double kLookRange_m = 30.0;

}  // namespace

std::optional<ThingHere> thing_here(const SessionContext& context) {
    const servo::ToolState& tool = context.hands.tool;
    const auto named = [&](FeatureId id) {
        const Feature* feature = context.world.scene->find(id);
        return feature && !feature->name.empty();
    };
    if (context.hands.answers() && tool.touches())
        return named(tool.touched()) ? std::optional(ThingHere{tool.touched(), tool.proxy_m}) : std::nullopt;
    const double heading_rad = context.avatar.heading_rad;
    const std::vector<Sight> sights = look_towards(
        {*context.world.solids, context.avatar.feet_m(), heading_rad, context.avatar.walker->size()}, heading_rad);
    for (const bool surface : {false, true})
        for (const Sight& sight : sights)
            if (sight.surface == surface && sight.seen.distance_m <= kLookRange_m && named(sight.seen.feature))
                return ThingHere{sight.seen.feature, sight.seen.point_m};
    return std::nullopt;
}

}  // namespace handrail::core
