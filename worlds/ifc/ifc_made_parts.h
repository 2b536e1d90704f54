// Makes floors and walls that a building needs but its file leaves out, from the outlines of its spaces. Pure functions
// on an IfcBuilding whose parts and rooms were read; one reading thread.
#pragma once

#include "worlds/ifc/ifc_building.h"

namespace handrail::ifc {

// Adds a floor under each room that has nothing under it, open where stairs come up. Rooms whose name says that they
// are open below get none. Returns the indices of the rooms.
std::vector<std::uint32_t> make_floors(IfcBuilding& building);

// Adds walls around all rooms, but only if the file contains spaces and no building around them. Returns the number of
// rooms.
int make_walls(IfcBuilding& building);

}  // namespace handrail::ifc
