// Doorways for the rooms of a plan that states none for them.
#pragma once

#include "worlds/drawn/floor_plan.h"

namespace handrail {

// Gives each room, staircase and lift an open doorway on each level where no door of the plan touches it: in the middle
// of the longest stretch of its outline that runs along a walkway, else along a room that can be entered. Lifts get
// sliding doors. Returns how many spaces got one. Costs the edges of rooms times those of spaces near them, on one
// level.
int guess_doorways(FloorPlan& plan);

}  // namespace handrail
