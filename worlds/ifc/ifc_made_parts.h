// Makes floors and walls that a building needs but that its file leaves out, from the outlines of its spaces. Pure
// functions on an IfcBuilding whose parts and rooms have been read. Used on the reading thread only.
#pragma once

#include "worlds/ifc/ifc_building.h"

namespace handrail::ifc {

// Adds a floor below each room that has nothing below it, with holes where stairs come up. Rooms whose name says that
// they are open below get none. Returns the indices of the rooms that got a floor.
std::vector<std::uint32_t> make_floors(IfcBuilding& building);

// Adds walls around all rooms if the file contains spaces but no building around them. Returns the number of rooms that
// got walls.
int make_walls(IfcBuilding& building);

}  // namespace handrail::ifc
