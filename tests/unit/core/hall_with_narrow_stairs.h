// A building whose stairs are too small to be drawn step by step, for what takes them in one go.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "worlds/drawn/plan_scene.h"

namespace handrail::test {

// A hall on two storeys, and north of it stairs of 1.6 by 1.6 m behind a door on each.
inline std::shared_ptr<const Scene> hall_with_narrow_stairs() {
    FloorPlan plan;
    plan.name = "Hall";
    plan.format = "osm";
    for (const int level : {0, 1})
        plan.levels.push_back({static_cast<double>(level), "Level " + std::to_string(level), 3.0 * level});
    PlanSpace hall;
    hall.name = "Hall";
    hall.rings = {{{0, 0}, {6, 0}, {6, 6}, {3.8, 6}, {3, 6}, {2.2, 6}, {0, 6}}};
    hall.levels = {0, 1};
    PlanSpace stairs;
    stairs.kind = PlanSpaceKind::Stairs;
    stairs.name = "Spiral stairs";
    stairs.rings = {{{2.2, 6}, {3, 6}, {3.8, 6}, {3.8, 7.6}, {2.2, 7.6}}};
    stairs.levels = {0, 1};
    plan.spaces = {hall, stairs};
    PlanDoor door;
    door.at = {3, 6};
    door.levels = {0, 1};
    door.spaces = {{0, 1}, {0, 1}};
    plan.doors = {door};
    Result<Scene> scene = scene_of_plan(plan, "hall.osm", {});
    EXPECT_TRUE(scene) << scene.error().sentence();
    return std::make_shared<const Scene>(std::move(*scene));
}

}  // namespace handrail::test
