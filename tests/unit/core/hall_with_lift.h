// A building with a lift, for what rides it.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "worlds/drawn/plan_scene.h"

namespace handrail::test {

// A hall on three storeys, and north of it a lift with a door on each.
inline std::shared_ptr<const Scene> hall_with_lift() {
    FloorPlan plan;
    plan.name = "Hall";
    plan.format = "osm";
    for (const int level : {0, 1, 2})
        plan.levels.push_back({static_cast<double>(level), "Level " + std::to_string(level), 3.0 * level});
    PlanSpace hall;
    hall.name = "Hall";
    hall.rings = {{{0, 0}, {6, 0}, {6, 6}, {4, 6}, {3, 6}, {2, 6}, {0, 6}}};
    hall.levels = {0, 1, 2};
    PlanSpace lift;
    lift.kind = PlanSpaceKind::Lift;
    lift.name = "Lift";
    lift.rings = {{{2, 6}, {3, 6}, {4, 6}, {4, 8}, {2, 8}}};
    lift.levels = {0, 1, 2};
    plan.spaces = {hall, lift};
    PlanDoor door;
    door.at = {3, 6};
    door.levels = {0, 1, 2};
    door.spaces = {{0, 1}, {0, 1}, {0, 1}};
    plan.doors = {door};
    Result<Scene> scene = scene_of_plan(plan, "hall.osm", {});
    EXPECT_TRUE(scene) << scene.error().sentence();
    return std::make_shared<const Scene>(std::move(*scene));
}

}  // namespace handrail::test
