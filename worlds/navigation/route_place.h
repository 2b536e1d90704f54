// The nearest place on a route made of straight legs: how far away it is, and how far along the route. Pure functions;
// any thread; time linear in the legs.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "worlds/base/vec.h"

namespace handrail::navigation {

struct RoutePlace {
    Vec3 place_m{0.0};        // on the route
    double distance_m = 0.0;  // from the place to the given position
    double along_m = 0.0;     // from the first point of the route to the place
    std::size_t leg = 0;      // the place is between points_m[leg] and the next point
};

// If several places are equally near, returns the first along the route. Legs may have no length; a single point is a
// route. Expects at least one point.
RoutePlace nearest_on_way(std::span<const Vec3> points_m, const Vec3& from_m);

// The same for a walker who was at `along_m` a moment ago. A route may pass near itself, so places far along from there
// count as farther away.
// `height_counts`: how much a metre up or down counts. For walkers it is one half, because a route over stairs is a
// straight line.
// `sees`: called for the places in order of distance until it returns true, because a route may also be near on the
// other side of a wall. If no place is seen that is hardly farther than the nearest one, returns the former place.
// Empty: all are seen.
inline constexpr double kFartherForEachMetreAlong_m = 0.05;
// If the visible place is farther away than this, the nearest one is behind something thin.
inline constexpr double kRoundCorner_m = 1.5;
inline constexpr double kHeightCountsForWalkers = 0.5;
RoutePlace near_on_way(std::span<const Vec3> points_m, const Vec3& from_m, double along_m,
                       double height_counts = kHeightCountsForWalkers,
                       const std::function<bool(const Vec3&)>& sees = {});

// The place at that distance along the route, or the nearer end if the distance is outside it.
Vec3 place_along(std::span<const Vec3> points_m, double along_m);

}  // namespace handrail::navigation
