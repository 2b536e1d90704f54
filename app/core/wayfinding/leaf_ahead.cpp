#include "app/core/wayfinding/leaf_ahead.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/core/context/context_words.h"
#include "app/core/world/questions.h"
#include "app/core/world/walker_meets.h"
#include "worlds/scene/models.h"

namespace handrail::core {
namespace {

constexpr double kBeyondEnd_m = 0.1;        // a leaf this far beyond the end of a stretch still blocks the stretch
constexpr double kLeastStretch_m = 1e-3;    // a shorter stretch has no direction
constexpr double kShutLeafWithin_m = 0.25;  // a path this near to the place of the shut leaf leads through the door
constexpr double kLeafLookEvery_m = 0.1;
// Absolute cosine of the angle between the stretch and the leaf. If it is smaller, the walker meets the face of the
// leaf, otherwise its edge.
constexpr double kSquarely = 0.7;

// Returns true if the path comes near to where the leaf is when the door is shut.
bool leads_through_door(const Aabb& shut_m, std::span<const Vec3> path_m) {
    for (std::size_t leg = 1; leg < path_m.size(); ++leg) {
        const Vec3 way = path_m[leg] - path_m[leg - 1];
        const int looks = std::max(1, static_cast<int>(std::ceil(glm::length(way) / kLeafLookEvery_m)));
        for (int i = 0; i <= looks; ++i) {
            const Vec3 at = path_m[leg - 1] + way * (static_cast<double>(i) / looks);
            const double x = std::max({shut_m.min_m.x - at.x, 0.0, at.x - shut_m.max_m.x}),
                         y = std::max({shut_m.min_m.y - at.y, 0.0, at.y - shut_m.max_m.y});
            if (std::hypot(x, y) < kShutLeafWithin_m) return true;
        }
    }
    return false;
}

// Returns true if a walker on the stretch meets the face of a hinged leaf in its present position, not its edge.
bool meets_face(const WorldState& world, std::uint32_t mover, const Aabb& leaf_m, const Vec3& way) {
    if (world.scene->movers[mover].swing_rad == 0.0) return false;
    const PlacedFrame frame(world.movers.at(mover));
    const Vec3 along = frame.to_world(leaf_m.centre_m()) - frame.to_world(Vec3(0.0));
    const double lengths = std::hypot(along.x, along.y) * std::hypot(way.x, way.y);
    return lengths > 0.0 && std::abs(along.x * way.x + along.y * way.y) < kSquarely * lengths;
}

}  // namespace

std::optional<std::uint32_t> leaf_across(const WorldState& world, const WalkerSize& size,
                                         std::span<const Vec3> path_m) {
    for (std::size_t i = 1; i < path_m.size(); ++i) {
        const Vec3 &from_m = path_m[i - 1], &to_m = path_m[i];
        const Vec3 way = to_m - from_m;
        if (std::hypot(way.x, way.y) < kLeastStretch_m) continue;
        const double far_m = std::hypot(way.x, way.y) + kBeyondEnd_m;
        const auto met = walker_meets(*world.solids, from_m, size, std::atan2(way.x, way.y), far_m);
        const int found = met ? mover_of(world, met->feature) : -1;
        if (found < 0) continue;
        const auto mover = static_cast<std::uint32_t>(found);
        const Feature* feature = world.scene->find(met->feature);
        if (!feature || feature->kind != FeatureKind::Door || !world.scene->movers[mover].by_hand ||
            world.thing_of_mover[mover] < 0 || shut(world, mover))
            continue;
        const Aabb& leaf_m = world.scene->placed[static_cast<std::size_t>(world.thing_of_mover[mover])].model->bounds_m;
        // A walker who comes to the doorway from the side of the hinge meets the leaf before the doorway.
        const double free_m = std::max(0.0, met->distance_m - size.radius_m);
        const bool face = meets_face(world, mover, leaf_m, way);
        std::vector<Vec3> until_m(path_m.begin(), path_m.begin() + static_cast<std::ptrdiff_t>(i));
        if (face) until_m.push_back(from_m + way * (free_m / far_m));
        else until_m.insert(until_m.end(), path_m.begin() + static_cast<std::ptrdiff_t>(i), path_m.end());
        if (!leads_through_door(placed_bounds(leaf_m, world.scene->movers[mover].at(0.0)), until_m)) return mover;
    }
    return std::nullopt;
}

FeatureId leaf_ahead(const SessionContext& context, std::span<const Vec3> path_m) {
    const auto mover = leaf_across(context.world, context.avatar.walker->size(), path_m);
    return mover ? context.world.scene->movers[*mover].feature : kNoFeature;
}

std::string leaf_name(const SessionContext& context, FeatureId door) {
    return door ? passage_name(context, navigation::PassageKind::Door, door, 0.0) : std::string();
}

}  // namespace handrail::core
