// Checks that a walk space and its rooms are consistent. Route planning and room names rely on this consistency without
// checking it. Tests use these functions, and the preset debug calls them after each search for rooms. Any thread may
// call them. Each call visits every span once. The messages are for developers.
#pragma once

#include "worlds/base/result.h"
#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// Checks the space: columns are in order, floors rise and are below their ceilings, neighbours are in the next column,
// and links join existing spans.
Result<void> validate(const WalkSpace& space);
// Checks the graph: every room number exists, portals join two rooms, and sizes are possible.
Result<void> validate(const RoomGraph& graph, const WalkSpace& space);

}  // namespace handrail::navigation
