// Makes a building with one hall on each storey and, to the north, a lift or stairs that connect the storeys. Tests use
// it to ride a lift or climb stairs with one command.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "tests/support/names.h"
#include "worlds/floorplan/plan_scene.h"

namespace handrail::test {

// Makes the building. A space of this kind, width and depth connects the storeys, behind a door on each storey.
inline std::shared_ptr<const Scene> hall_with(PlanSpaceKind kind, const std::string& name, double wide_m, double deep_m,
                                              std::size_t storeys) {
    const double west = 3.0 - 0.5 * wide_m, east = 3.0 + 0.5 * wide_m, north = 6.0 + deep_m;
    FloorPlan plan;
    plan.name = "Hall";
    plan.format = "osm";
    PlanSpace hall, well;
    hall.name = "Hall";
    hall.rings = {{{0, 0}, {6, 0}, {6, 6}, {east, 6}, {3, 6}, {west, 6}, {0, 6}}};
    well.kind = kind;
    well.name = name;
    well.rings = {{{west, 6}, {3, 6}, {east, 6}, {east, north}, {west, north}}};
    PlanDoor door;
    door.at = {3, 6};
    for (std::size_t i = 0; i < storeys; ++i) {
        plan.levels.push_back({static_cast<double>(i), "Level " + std::to_string(i), 3.0 * static_cast<double>(i)});
        hall.levels.push_back(i);
        well.levels.push_back(i);
        door.levels.push_back(i);
        door.spaces.push_back({0, 1});
    }
    plan.spaces = {hall, well};
    plan.doors = {door};
    Result<Scene> scene = scene_of_plan(plan, "hall.osm", {});
    EXPECT_TRUE(scene) << scene.error().sentence();
    return std::make_shared<const Scene>(std::move(*scene));
}

inline std::shared_ptr<const Scene> hall_with_lift() { return hall_with(PlanSpaceKind::Lift, "Lift", 2.0, 2.0, 3); }
// Makes a building with stairs that are too narrow for separate steps.
inline std::shared_ptr<const Scene> hall_with_narrow_stairs() {
    return hall_with(PlanSpaceKind::Stairs, "Spiral stairs", 1.6, 1.6, 2);
}

}  // namespace handrail::test
