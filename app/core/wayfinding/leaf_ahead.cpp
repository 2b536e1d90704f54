#include "app/core/wayfinding/leaf_ahead.h"

#include <algorithm>
#include <cmath>

#include "app/core/context/telling.h"
#include "app/core/world/body_meets.h"
#include "app/core/world/questions.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace {

constexpr double kBeyondEnd_m = 0.1;        // of the end of the stretch
constexpr double kShutLeafWithin_m = 0.25;  // from where the leaf is when it is shut
constexpr double kLeafLookEvery_m = 0.1;

// The stretch comes to where the leaf is when it is shut.
bool leads_through_door(const Aabb& shut_m, const Vec3& from_m, const Vec3& to_m) {
    const Vec3 way = to_m - from_m;
    const int looks = std::max(1, static_cast<int>(std::ceil(glm::length(way) / kLeafLookEvery_m)));
    for (int i = 0; i <= looks; ++i) {
        const Vec3 at = from_m + way * (static_cast<double>(i) / looks);
        const double x = std::max({shut_m.min_m.x - at.x, 0.0, at.x - shut_m.max_m.x}),
                     y = std::max({shut_m.min_m.y - at.y, 0.0, at.y - shut_m.max_m.y});
        if (std::hypot(x, y) < kShutLeafWithin_m) return true;
    }
    return false;
}

}  // namespace

std::string leaf_ahead(const SessionContext& context, const Vec3& from_m, const Vec3& to_m) {
    const Vec3 way = to_m - from_m;
    const double far_m = std::hypot(way.x, way.y) + kBeyondEnd_m;
    const auto met =
        body_meets(*context.world.solids, from_m, context.body.walker->size(), std::atan2(way.x, way.y), far_m);
    const int found = met ? mover_of(context.world, met->feature) : -1;
    if (found < 0) return {};
    const auto mover = static_cast<std::uint32_t>(found);
    const Scene& scene = *context.world.scene;
    const Feature* feature = scene.find(met->feature);
    if (!feature || feature->kind != FeatureKind::Door || !scene.movers[mover].by_hand ||
        context.world.thing_of_mover[mover] < 0 || shut(context.world, mover))
        return {};
    const PlacedModel& leaf = scene.placed[static_cast<std::size_t>(context.world.thing_of_mover[mover])];
    if (leads_through_door(placed_bounds(leaf.model->bounds_m, context.world.movers.at_rest(mover)), from_m, to_m))
        return {};
    return passage_name(context, PassageKind::Door, met->feature, 0.0);
}

}  // namespace handrail
