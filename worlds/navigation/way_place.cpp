#include "worlds/navigation/way_place.h"

#include <algorithm>

#include "worlds/base/contract.h"

namespace handrail {

WayPlace nearest_on_way(std::span<const Vec3> points_m, const Vec3& from_m) {
    contract_pre(!points_m.empty());
    WayPlace nearest{points_m[0], glm::length(from_m - points_m[0]), 0.0, 0};
    double before_m = 0.0;
    for (std::size_t leg = 0; leg + 1 < points_m.size(); ++leg) {
        const Vec3 way = points_m[leg + 1] - points_m[leg];
        const double length2 = glm::dot(way, way);
        const double part = length2 > 0.0 ? std::clamp(glm::dot(from_m - points_m[leg], way) / length2, 0.0, 1.0) : 0.0;
        const Vec3 place = points_m[leg] + way * part;
        const double length_m = std::sqrt(length2), distance_m = glm::length(from_m - place);
        if (distance_m < nearest.distance_m) nearest = {place, distance_m, before_m + part * length_m, leg};
        before_m += length_m;
    }
    return nearest;
}

Vec3 place_along(std::span<const Vec3> points_m, double along_m) {
    contract_pre(!points_m.empty());
    if (!(along_m > 0.0)) return points_m.front();
    for (std::size_t leg = 0; leg + 1 < points_m.size(); ++leg) {
        const Vec3 way = points_m[leg + 1] - points_m[leg];
        const double length_m = glm::length(way);
        if (along_m <= length_m) return points_m[leg] + way * (along_m / length_m);
        along_m -= length_m;
    }
    return points_m.back();
}

}  // namespace handrail
