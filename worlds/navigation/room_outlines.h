// The outlines of rooms seen from above, for drawing. They follow the cells where a walker's centre can be, so they are
// a walker's radius inside the walls, and those of neighbours do not hide each other. Pure functions; any thread; costs
// one look at each span.
#pragma once

#include <vector>

#include "worlds/navigation/rooms.h"

namespace handrail::navigation {

struct RoomOutline {
    double lowest_m = 0.0, highest_m = 0.0;  // of the room's floor
    std::vector<std::vector<Vec2>>
        loops_m;  // closed, counter-clockwise seen from above, corners only; one for each piece
};

// One outline for each room of the graph. Free-standing objects in a room make no loop, and neither do pieces too small
// to be seen.
std::vector<RoomOutline> room_outlines(const RoomGraph& graph, const WalkSpace& space);

}  // namespace handrail::navigation
