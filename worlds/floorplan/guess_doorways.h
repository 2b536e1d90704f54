// Guesses doorways for rooms for which the plan states none. Pure function; any thread may call it.
#pragma once

#include "worlds/floorplan/floor_plan.h"

namespace handrail::floorplan {

// Gives each room, staircase and lift an open doorway on each level where no door of the plan touches it. The doorway
// is in the middle of the longest stretch of the space's outline that runs along a walkway. If there is no walkway, the
// doorway leads to a room that can be entered. Lifts get sliding doors. Returns how many spaces got a doorway. The cost
// is the number of the rooms' edges times the number of edges of nearby spaces on the same level.
int guess_doorways(FloorPlan& plan);

}  // namespace handrail::floorplan
