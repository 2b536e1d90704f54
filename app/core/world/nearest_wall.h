// Finds the wall nearest to a walker by rays. A pure function over an immutable world; app thread; 32 rays.
#pragma once

#include <optional>

#include "app/core/world/walker_world.h"

namespace handrail::core {

struct NearestWall {
    FeatureId feature = kNoFeature;
    double distance_m = 0.0;   // from the walker's centre, at waist height
    double bearing_rad = 0.0;  // square to the wall
};

// The nearest upright surface within `reach_m`; no value: there is none.
std::optional<NearestWall> nearest_wall(const WalkerWorld& world, const Vec3& feet_m, double reach_m);

}  // namespace handrail::core
