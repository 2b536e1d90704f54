#include "worlds/scene/building_bounds.h"

#include <algorithm>
#include <cmath>

#include "worlds/geometry/clip.h"
#include "worlds/scene/outer_ground.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace {

constexpr double kAtRoom_m = 0.6;  // a wall within this distance of a room belongs to the building

// Parts lower than this do not belong to the building. Walls and columns are higher; paths and lawns are lower.
constexpr double kUpright_m = 1.0;

// True for sloping solids such as roofs, which may extend beyond the walls.
bool slopes(const Solid& solid) {
    constexpr double kUpright = 0.1, kLevel = 0.95;
    return std::any_of(solid.shape.planes.begin(), solid.shape.planes.end(), [](const Plane& plane) {
        return std::abs(plane.normal.z) > kUpright && std::abs(plane.normal.z) < kLevel;
    });
}

// Returns the bounds of everything except the ground that a reader added.
Aabb all_but_ground(const Scene& scene) {
    if (std::none_of(scene.features.begin(), scene.features.end(), is_outer_ground)) return scene.bounds_m;
    Aabb all;
    for (const Feature& feature : scene.features)
        if (!feature.bounds_m.empty() && !is_outer_ground(feature) && feature.kind != FeatureKind::Trigger)
            all.include(feature.bounds_m);
    for (const Solid& solid : scene.solids) {
        const Feature* feature = scene.find(solid.feature);
        if ((solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) &&
            !(feature && is_outer_ground(*feature)))
            all.include(solid.shape.bounds_m);
    }
    return all;
}

}  // namespace

Aabb building_bounds_m(const Scene& scene) {
    Aabb rooms;
    if (scene.stated)
        for (const StatedRoom& room : scene.stated->rooms)
            for (const std::vector<Vec2>& ring : room.rings)
                for (const Vec2& p : ring) {
                    rooms.include(Vec3(p, room.floor_m));
                    rooms.include(Vec3(p, room.floor_m + room.height_m));
                }
    if (rooms.empty()) return all_but_ground(scene);
    const Aabb near = grown(rooms, kAtRoom_m);
    Aabb building = rooms;
    const auto take = [&](const Aabb& box) {
        if (box.empty() || box.size_m().z < kUpright_m) return;
        // Includes only the part of `box` near the rooms, because a garden wall that continues from the house does not
        // belong to the building.
        const Aabb part{glm::max(box.min_m, near.min_m), glm::min(box.max_m, near.max_m)};
        if (!part.empty()) building.include(part);
    };
    for (const Solid& solid : scene.solids)
        if (!slopes(solid)) take(solid.shape.bounds_m);
    for (const Feature& feature : scene.features)
        if (feature.kind == FeatureKind::Wall || feature.kind == FeatureKind::Door) take(feature.bounds_m);
    // Extends the bounds upwards and downwards, to include roofs and cellars.
    Aabb high = building;
    for (const Feature& feature : scene.features) {
        const Aabb& box = feature.bounds_m;
        if (box.empty() || is_outer_ground(feature) || box.max_m.x <= building.min_m.x ||
            box.min_m.x >= building.max_m.x || box.max_m.y <= building.min_m.y || box.min_m.y >= building.max_m.y)
            continue;
        high.min_m.z = std::min(high.min_m.z, box.min_m.z);
        high.max_m.z = std::max(high.max_m.z, box.max_m.z);
    }
    return high;
}

Aabb labyrinth_table_m(const Scene& scene) {
    Aabb table;
    if (!scene.labyrinth.there()) return table;
    for (const FeatureId border : scene.labyrinth.borders) table.include(scene.features[border.value].bounds_m);
    for (const auto* places : {&scene.labyrinth.holes, &scene.labyrinth.goals})
        for (const LabyrinthPlan::Place& place : *places) table.include(place.box_m);
    return table;
}

}  // namespace handrail
