#include "worlds/readers/map_labyrinth.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "worlds/base/text.h"

namespace handrail::readers {
namespace {

constexpr NumberKey kLabyrinth{"labyrinth", 0.0, 9.0, "map.range"};
constexpr double kGapAbove_m = 1.0;  // greatest height above a hole at which the gap in the floor may be
constexpr double kLook_m = 0.01;

bool inside(const Solid& solid, const Vec3& at_m) {
    return std::all_of(solid.shape.planes.begin(), solid.shape.planes.end(),
                       [&](const Plane& plane) { return glm::dot(plane.normal, at_m) - plane.offset_m <= 0.0; });
}

// True if the floor has a gap above the hole: no part of the building is above the middle of the hole.
bool has_gap(const Scene& scene, const Aabb& hole_m) {
    const Vec3 middle = hole_m.centre_m();
    for (const Solid& solid : scene.solids) {
        const Aabb& box = solid.shape.bounds_m;
        if (solid.role != SolidRole::Solid || middle.x < box.min_m.x || middle.x > box.max_m.x ||
            middle.y < box.min_m.y || middle.y > box.max_m.y)
            continue;
        for (double z = std::max(hole_m.max_m.z, box.min_m.z); z < std::min(hole_m.max_m.z + kGapAbove_m, box.max_m.z);
             z += kLook_m)
            if (inside(solid, {middle.x, middle.y, z})) return false;
    }
    return true;
}

}  // namespace

void MapLabyrinth::note_world(const MapEntity& entity, const MapKeys& keys) {
    const MapKey* key = entity.find("labyrinth");
    if (!key) return;
    plan_.level = static_cast<int>(keys.number_of(entity, kLabyrinth).value_or(0.0));
    world_place_ = key->place;
}

bool MapLabyrinth::take_place(const MapEntity& entity, std::string_view class_name, int index,
                              const std::function<BuiltSolid(const MapBrush&)>& built) {
    const bool hole = class_name == "trigger_hole";
    if (!hole && class_name != "trigger_goal") return false;
    for (const MapBrush& brush : entity.brushes)
        if (const BuiltSolid solid = built(brush); solid.fault == SolidFault::None)
            (hole ? plan_.holes : plan_.goals).push_back({solid.solid.bounds_m, {brush.place.line, index}});
    return true;
}

void MapLabyrinth::note_role(const MapEntity& entity, FeatureId feature, bool free, Diagnostics& diagnostics) {
    const MapKey* key = entity.find("role");
    if (!key) return;
    const std::string role(entity.value("role"));
    static const std::vector<std::string> kRoles{"ball", "plank", "block", "border"};
    if (std::find(kRoles.begin(), kRoles.end(), role) == kRoles.end()) {
        diagnostics.warn(key->place, "map.then_key_left_out", "map.role_unknown",
                         {{"role", role}, {"nearest", nearest_name(role, kRoles)}});
    } else if (free != (role != "border")) {
        diagnostics.warn(key->place, "map.then_key_left_out", free ? "map.role_free" : "map.role_fixed",
                         {{"role", role}});
    } else if (role == "border") {
        plan_.borders.push_back(feature);
    } else if (role == "ball") {
        if (plan_.ball) diagnostics.warn(key->place, "map.then_key_left_out", "map.second_ball");
        else plan_.ball = feature;
    } else {
        (role == "plank" ? plan_.planks : plan_.blocks).push_back(feature);
    }
}

void MapLabyrinth::attach(Scene& scene, Diagnostics& diagnostics) {
    if (plan_.level == 0) {
        for (const std::vector<LabyrinthPlan::Place>* places : {&plan_.holes, &plan_.goals})
            if (!places->empty())
                diagnostics.warn({places->front().source.line, 0}, "map.then_no_game", "map.no_labyrinth");
        return;
    }
    if (!plan_.ball || plan_.goals.empty()) {
        diagnostics.warn(world_place_, "map.then_no_game",
                         plan_.ball ? "map.labyrinth_no_goal" : "map.labyrinth_no_ball");
        return;
    }
    std::erase_if(plan_.holes, [&](const LabyrinthPlan::Place& hole) {
        const bool gap = has_gap(scene, hole.box_m);
        if (!gap) diagnostics.warn({hole.source.line, 0}, "map.then_left_out", "map.hole_no_gap");
        return !gap;
    });
    scene.labyrinth = plan_;
}

}  // namespace handrail::readers
