// Doors of real buildings that tests send bodies, balls and sessions through.
#pragma once

#include <optional>
#include <vector>

#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"

namespace handrail::test {

// The way through a shut leaf: level, square to its largest upright face.
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

struct DoorToPass {
    const StatedPortal* portal = nullptr;  // of the scene
    Vec3 way{0.0};                         // through it, level
};

// Those that the file says are doors one passes, with a leaf in a wall; a door to no room only where the file has none.
inline std::vector<DoorToPass> doors_to_pass(const Scene& scene) {
    std::vector<DoorToPass> doors;
    if (!scene.stated) return doors;
    for (const StatedPortal& portal : scene.stated->portals) {
        if (portal.kind != StatedPortalKind::Door || !portal.passable) continue;
        if (portal.rooms.empty() && !scene.stated->rooms.empty()) continue;
        if (const std::optional<Vec3> way = way_through(scene, portal.feature)) doors.push_back({&portal, *way});
    }
    return doors;
}

}  // namespace handrail::test
