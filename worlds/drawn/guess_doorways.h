// Doorways for the rooms of a plan that states none for them.
#pragma once

#include "worlds/drawn/floor_plan.h"

namespace handrail {

// Gives each room on one level that no door of the plan touches an open doorway: in the middle of the longest stretch
// of its outline that runs along a corridor. Returns how many. Costs the edges of rooms times those of corridors near
// them, on one level.
int guess_doorways(FloorPlan& plan);

}  // namespace handrail
