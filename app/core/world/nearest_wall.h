// Finds the wall nearest to a walker. A pure function over an immutable world, for the app thread. It costs 32 rays.
#pragma once

#include <optional>

#include "app/core/world/walker_world.h"

namespace handrail::core {

struct NearestWall {
    FeatureId feature = kNoFeature;
    double distance_m = 0.0;   // distance from the walker's centre to the wall, at the height of the waist
    double bearing_rad = 0.0;  // direction perpendicular to the wall
};

// Returns the nearest upright surface within `reach_m`, or no value if there is none.
std::optional<NearestWall> nearest_wall(const WalkerWorld& world, const Vec3& feet_m, double reach_m);

}  // namespace handrail::core
