// The way through a shut leaf of a door: level, square to its largest upright face. For tests of doors in real
// buildings.
#pragma once

#include <optional>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail::test {

inline std::optional<Vec3> way_through(const Scene& scene, FeatureId leaf) {
    std::optional<Vec3> way;
    double largest_m2 = 0.0;
    for (const Solid& solid : scene.solids) {
        if (solid.feature != leaf) continue;
        for (std::size_t f = 0; f < solid.shape.faces.size(); ++f) {
            const std::vector<Vec3>& p = solid.shape.faces[f].points_m;
            Vec3 area{0.0};
            for (std::size_t k = 1; k + 1 < p.size(); ++k) area += 0.5 * glm::cross(p[k] - p[0], p[k + 1] - p[0]);
            if (std::abs(solid.shape.planes[f].normal.z) > 0.1 || glm::length(area) <= largest_m2) continue;
            largest_m2 = glm::length(area);
            way = solid.shape.planes[f].normal;
        }
    }
    return way;
}

}  // namespace handrail::test
