// Whether a walk space and the rooms cut from it hold together: what ways and room names rely on without looking. For
// tests and the preset debug, after each finding of rooms; any thread. Looks at every span once. The messages are for
// developers.
#pragma once

#include "worlds/base/result.h"
#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"

namespace handrail {

// Columns in order, floors below ceilings and rising, neighbours that stand in the next column, links between spans
// that are there.
Result<void> validate(const WalkSpace& space);
// A room for every number, portals that join two of them, sizes that can be.
Result<void> validate(const RoomGraph& graph, const WalkSpace& space);

}  // namespace handrail
