// The outlines of rooms seen from above, for drawing: along the cells where the middle of a body can be, so they lie a
// body's radius inside the walls, and those of neighbours do not hide each other. Pure functions; any thread; costs one
// look at each span.
#pragma once

#include <vector>

#include "worlds/navigation/rooms.h"

namespace handrail {

struct RoomOutline {
    double lowest_m = 0.0, highest_m = 0.0;  // of its floor
    std::vector<std::vector<Vec2>>
        loops_m;  // closed, counter-clockwise seen from above, corners only; one for each piece
};

// Of each room of the graph. What stands free in a room makes no loop, nor does a piece too small to be seen.
std::vector<RoomOutline> room_outlines(const RoomGraph& graph, const WalkSpace& space);

}  // namespace handrail
