// A building from plans becomes a Scene with walls, floors, ceilings, doors, stairs and lifts, and with its rooms and
// doors as the plan states them. Heights are assumed and told. Any thread.
#pragma once

#include <functional>
#include <stop_token>

#include "worlds/drawn/floor_plan.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct PlanOptions {
    std::string world_name;  // where the plan has none
    std::function<void(double fraction)> progress;
    std::stop_token stop;
};

// The same plan gives the same Scene. Fails with one sentence where it holds nothing to touch, or too much.
Result<Scene> scene_of_plan(FloorPlan plan, const std::string& file_name, const PlanOptions& options);

}  // namespace handrail
