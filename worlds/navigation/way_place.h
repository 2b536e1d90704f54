// The nearest place of a way made of straight legs: how far off it somebody is, and how far along. Pure function; any thread; linear over the legs.
#pragma once

#include <cstddef>
#include <span>

#include "worlds/base/vec.h"

namespace handrail {

struct WayPlace {
    Vec3 place_m{0.0};        // on the way
    double distance_m = 0.0;  // from it
    double along_m = 0.0;     // from the way's first point to it
    std::size_t leg = 0;      // from points_m[leg] to the next
};

// Of several places as near, the first along the way. Legs without length are fine; one point is a way. Expects at least one point.
WayPlace nearest_on_way(std::span<const Vec3> points_m, const Vec3& from_m);

// The place so far along a way; its ends before and beyond them.
Vec3 place_along(std::span<const Vec3> points_m, double along_m);

}  // namespace handrail
