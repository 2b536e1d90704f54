#include "app/core/world/world_state.h"

#include <algorithm>
#include <cmath>

#include "worlds/geometry/closest_point.h"

namespace handrail::core {
namespace {

constexpr double kShut = 0.5;  // a door that has moved less than this share of its path counts as shut

}  // namespace

bool usable(const WorldState& world, std::size_t mover) {
    const Mover& found = world.scene->movers[mover];
    return !found.sets_going.empty() || (world.thing_of_mover[mover] >= 0 && !found.endless());
}

int mover_of(const WorldState& world, FeatureId feature) {
    for (std::size_t i = 0; i < world.scene->movers.size(); ++i)
        if (feature && world.scene->movers[i].feature == feature && usable(world, i)) return static_cast<int>(i);
    return -1;
}

bool locked(const WorldState& world, std::uint32_t mover) {
    const Mover& door = world.scene->movers[mover];
    return world.scene->features[door.feature.value].kind == FeatureKind::Door && !door.by_hand &&
           door.approach_m.empty();
}

bool shut(const WorldState& world, std::uint32_t mover) { return world.movers.part(mover) < kShut; }

std::optional<FeatureId> button_of(const WorldState& world, std::uint32_t mover, const Vec3& from_m) {
    std::optional<FeatureId> button;
    double nearest_m = 1e9;
    for (const Mover& other : world.scene->movers) {
        const auto opens = [&](std::uint32_t set_going) {
            return world.scene->movers[set_going].group == world.scene->movers[mover].group;
        };
        if (!other.by_hand || std::none_of(other.sets_going.begin(), other.sets_going.end(), opens)) continue;
        const double distance_m =
            std::sqrt(distance_squared(world.scene->features[other.feature.value].bounds_m, from_m));
        if (distance_m >= nearest_m) continue;
        nearest_m = distance_m;
        button = other.feature;
    }
    return button;
}

}  // namespace handrail::core
