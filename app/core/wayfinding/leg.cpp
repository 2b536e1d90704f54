#include "app/core/wayfinding/leg.h"

#include <algorithm>
#include <utility>

#include "worlds/navigation/route_place.h"

namespace handrail::core {

std::optional<Leg> next_leg(navigation::Route route, const Vec3& from_m, double least_m) {
    Leg leg;
    leg.route = std::move(route);
    const std::vector<Vec3>& points = leg.route.points_m;
    if (points.size() < 2) return std::nullopt;
    std::size_t corner = 1;
    while (corner + 1 < points.size() && glm::length(points[corner] - from_m) < least_m) ++corner;
    for (std::size_t i = 1; i <= corner; ++i) leg.along_m += glm::length(points[i] - points[i - 1]);
    leg.to_m = points[corner];
    return leg;
}

navigation::Route rest_of(const navigation::Route& route, double along_m) {
    navigation::Route rest = route;
    rest.points_m.assign(1, navigation::place_along(route.points_m, along_m));
    double at_m = 0.0;
    for (std::size_t i = 1; i < route.points_m.size(); ++i) {
        at_m += glm::length(route.points_m[i] - route.points_m[i - 1]);
        if (at_m > along_m) rest.points_m.push_back(route.points_m[i]);
    }
    std::erase_if(rest.passages, [&](const navigation::RoutePassage& passage) { return passage.at_m < along_m; });
    for (navigation::RoutePassage& passage : rest.passages) passage.at_m -= along_m;
    rest.length_m = std::max(0.0, route.length_m - along_m);
    return rest;
}

}  // namespace handrail::core
