// Finds the place on a route of straight legs that is nearest to a position, with its distance from that position and
// its distance along the route. Pure functions; any thread may call them. The time is linear in the number of legs.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "worlds/base/vec.h"

namespace handrail::navigation {

struct RoutePlace {
    Vec3 place_m{0.0};        // the place on the route
    double distance_m = 0.0;  // distance from the place to the given position
    double along_m = 0.0;     // distance along the route from its first point to the place
    std::size_t leg = 0;      // the place is between points_m[leg] and the next point
};

// Returns the nearest place. If several are equally near, it returns the first along the route. Legs may have no
// length, and a single point is a route. Expects at least one point.
RoutePlace nearest_on_path(std::span<const Vec3> points_m, const Vec3& from_m);

// Returns the nearest place for a walker who was at `along_m` a moment ago. A route may pass close to itself, so the
// distance of a place grows with its distance along the route from `along_m`. `height_counts`: factor for differences
// in height. For walkers it is one half, because a route over stairs is a straight line. `sees`: called for the places
// in order of distance until it returns true, because the route may also be near on the other side of a wall. Without
// `sees`, the walker sees all places. If the nearest visible place is much farther than the nearest one, returns the
// former place.
inline constexpr double kFartherForEachMetreAlong_m = 0.05;
// If the nearest visible place is farther away than this, a thin obstacle hides the nearest place.
inline constexpr double kRoundCorner_m = 1.5;
inline constexpr double kHeightCountsForWalkers = 0.5;
RoutePlace near_on_path(std::span<const Vec3> points_m, const Vec3& from_m, double along_m,
                        double height_counts = kHeightCountsForWalkers,
                        const std::function<bool(const Vec3&)>& sees = {});

// Returns the place at that distance along the route. If the distance is outside the route, returns the nearer end.
Vec3 place_along(std::span<const Vec3> points_m, double along_m);

}  // namespace handrail::navigation
