// Floors and walls that a building needs and its file leaves out, made from the outlines of its spaces. Pure functions
// on an IfcBuilding whose parts and rooms were read; one reading thread.
#pragma once

#include "worlds/ifc/ifc_building.h"

namespace handrail {

// Adds a floor under each room that nothing lies under, open where stairs come up, but none if its name says that it is
// open below. Returns the places of those rooms.
std::vector<std::uint32_t> make_floors(IfcBuilding& building);

// Adds walls around all rooms, but only if the file gives spaces and no building around them. Returns how many rooms.
int make_walls(IfcBuilding& building);

}  // namespace handrail
