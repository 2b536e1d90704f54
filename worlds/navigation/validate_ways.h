// Checks the consistency of a walk space and of the rooms made from it, which route planning and room names rely on
// without checking. For tests and the preset debug, after each search for rooms; any thread. Looks at every span once.
// The messages are for developers.
#pragma once

#include "worlds/base/result.h"
#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// Checks that columns are in order, floors rise and are below ceilings, neighbours are in the next column, and links
// join existing spans.
Result<void> validate(const WalkSpace& space);
// Checks that every room number exists, portals join two rooms, and sizes are possible.
Result<void> validate(const RoomGraph& graph, const WalkSpace& space);

}  // namespace handrail::navigation
