// The wall that is nearest to a body, by looking. A pure function over an immutable world; app thread; 32 rays.
#pragma once

#include <optional>

#include "app/core/world/body_world.h"

namespace handrail {

struct NearestWall {
    FeatureId feature = kNoFeature;
    double distance_m = 0.0;   // from the middle of the body, at the height of the waist
    double bearing_rad = 0.0;  // square to it
};

// What stands upright within `reach_m`; none: nothing does.
std::optional<NearestWall> nearest_wall(const BodyWorld& world, const Vec3& feet_m, double reach_m);

}  // namespace handrail
