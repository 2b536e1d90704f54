// Says whether a walker can reach a door. A pure function over the present state of the world, for the app thread.
#pragma once

#include <cstdint>

#include "app/core/world/questions.h"
#include "app/core/world/world_state.h"
#include "worlds/base/human_measures.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/scene/models.h"

namespace handrail::core {

// Returns true if a leaf of the mover's door is within arm's reach of a walker at `feet_m`, wherever the leaf is now.
inline bool leaf_in_reach(const WorldState& world, std::uint32_t mover, const Vec3& feet_m) {
    const Vec3 middle_m = feet_m + Vec3(0.0, 0.0, kLookHeight_m);
    for (std::uint32_t i = 0; i < world.movers.size(); ++i) {
        if (world.scene->movers[i].group != world.scene->movers[mover].group || world.thing_of_mover[i] < 0) continue;
        const Aabb& own_m = world.scene->placed[static_cast<std::size_t>(world.thing_of_mover[i])].model->bounds_m;
        if (distance_squared(placed_bounds(own_m, world.movers.at(i)), middle_m) < kArmsReach_m * kArmsReach_m)
            return true;
    }
    return false;
}

}  // namespace handrail::core
