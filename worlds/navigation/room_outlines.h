// Makes the outlines of rooms as seen from above, for drawing. Outlines follow the cells where a walker's centre can
// be, so they are a walker's radius inside the walls, and outlines of neighbouring rooms do not hide each other. Pure
// functions; any thread may call them. The cost is one lookup for each span.
#pragma once

#include <vector>

#include "worlds/navigation/rooms.h"

namespace handrail::navigation {

struct RoomOutline {
    double lowest_m = 0.0, highest_m = 0.0;  // lowest and highest height of the room's floor
    std::vector<std::vector<Vec2>>
        loops_m;  // one closed loop for each piece of the room; corners only, counter-clockwise as seen from above
};

// Returns one outline for each room of the graph. Neither free-standing objects in a room nor pieces too small to be
// seen get a loop.
std::vector<RoomOutline> room_outlines(const RoomGraph& graph, const WalkSpace& space);

}  // namespace handrail::navigation
