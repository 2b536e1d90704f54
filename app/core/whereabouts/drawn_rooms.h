// Makes the rooms for the plan in the window. Pure function; app thread. It costs one ray for each room and a pass over
// all cells of the walkable area.
#pragma once

#include <vector>

#include "app/core/context/view.h"
#include "app/core/world/walker_world.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

// Returns the rooms in the order of the graph. A room is outside if it is on ground that a reader laid around the
// building, or if it is under the open sky while most rooms of its storey have a ceiling. `scene` is the scene of the
// file, `solids` the present ones.
std::vector<DrawnRoom> drawn_rooms(const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                                   const Scene& scene, const WalkerWorld& solids);

}  // namespace handrail::core
