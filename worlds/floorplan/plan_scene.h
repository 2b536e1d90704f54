// Turns a drawn plan into a Scene with walls, floors, ceilings, doors, stairs and lifts, and with rooms and doors as
// the plan states them. Unknown heights are assumed and reported. Any thread may call it.
#pragma once

#include <functional>
#include <stop_token>

#include "worlds/floorplan/floor_plan.h"
#include "worlds/scene/scene.h"

namespace handrail::floorplan {

struct PlanOptions {
    std::string world_name;  // used if the plan has no name
    std::function<void(double fraction)> progress;
    std::stop_token stop;
};

// The same plan always gives the same Scene. Fails with one sentence if it contains nothing to touch, or too much.
Result<Scene> scene_of_plan(FloorPlan plan, const std::string& file_name, const PlanOptions& options);

}  // namespace handrail::floorplan
