#include "app/core/context/thing_here.h"

#include "app/core/world/body_heights.h"
#include "app/core/world/surroundings.h"

namespace handrail::core {
namespace {

constexpr double kLookRange_m = 30.0;

}  // namespace

std::optional<ThingHere> thing_here(const SessionContext& context) {
    const servo::ToolState& tool = context.hands.tool;
    ThingHere here{kNoFeature};
    if (context.hands.answers() && tool.touches()) {
        here = {tool.touched(), tool.proxy_m};
    } else if (const auto seen = look(*context.world.solids, context.avatar.feet_m(), kWaist_m,
                                      context.avatar.heading_rad, kLookRange_m)) {
        here = {seen->feature, seen->point_m};
    }
    const Feature* feature = context.world.scene->find(here.id);
    if (!feature || feature->name.empty()) return std::nullopt;
    return here;
}

}  // namespace handrail::core
