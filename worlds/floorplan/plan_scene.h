// Turns a drawn plan into a Scene. It builds walls, floors, ceilings, doors, stairs and lifts, and keeps the rooms and
// doors as the plan states them. Unknown heights are assumed and reported. Any thread may call it.
#pragma once

#include <functional>
#include <stop_token>

#include "worlds/floorplan/floor_plan.h"
#include "worlds/scene/scene.h"

namespace handrail::floorplan {

struct PlanOptions {
    std::string world_name;  // name of the world if the plan has none
    std::function<void(double fraction)> progress;
    std::stop_token stop;
};

// Makes the Scene. The same plan always gives the same Scene. Fails with one sentence if the plan contains nothing to
// touch, or too much.
Result<Scene> scene_of_plan(FloorPlan plan, const std::string& file_name, const PlanOptions& options);

}  // namespace handrail::floorplan
