// Finds the doors of real buildings through which tests send bodies, proxies and sessions.
#pragma once

#include <optional>
#include <vector>

#include "tests/support/names.h"
#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"

namespace handrail::test {

// Returns the direction through a shut door leaf: horizontal, and perpendicular to the leaf's largest vertical face.
inline std::optional<Vec3> direction_through(const Scene& scene, FeatureId leaf) {
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
    const StatedPortal* portal = nullptr;  // the stated portal, which belongs to the scene
    Vec3 way{0.0};                         // horizontal direction through the door
};

// Returns the doors that the world file states as passable and that have a leaf with a vertical face. Doors that lead
// to no room are included only if the file states no rooms.
inline std::vector<DoorToPass> doors_to_pass(const Scene& scene) {
    std::vector<DoorToPass> doors;
    if (!scene.stated) return doors;
    for (const StatedPortal& portal : scene.stated->portals) {
        if (portal.kind != StatedPortalKind::Door || !portal.passable) continue;
        if (portal.rooms.empty() && !scene.stated->rooms.empty()) continue;
        if (const std::optional<Vec3> way = direction_through(scene, portal.feature)) doors.push_back({&portal, *way});
    }
    return doors;
}

}  // namespace handrail::test
