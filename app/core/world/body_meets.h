// What stands in the way of a body, as wide and as high as it is. Pure functions; app thread.
#pragma once

#include <optional>

#include "app/core/world/surroundings.h"
#include "app/core/world/walker.h"

namespace handrail {

// What a body that walks that way bumps into first, above what it steps over; none: nothing within range.
std::optional<Seen> body_meets(const BodyWorld& world, const Vec3& feet_m, const BodySize& size, double bearing_rad,
                               double range_m = kSightRange_m);

}  // namespace handrail
