#include "app/core/wayfinding/leg.h"

#include <utility>

namespace handrail {

std::optional<Leg> next_leg(Route route, const Vec3& from_m, double least_m) {
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

}  // namespace handrail
