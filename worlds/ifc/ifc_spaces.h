// Storeys and rooms of an IFC file. One reading thread.
#pragma once

#include "worlds/ifc/ifc_building.h"

namespace handrail {

// Fills storeys, rooms and room_ids.
void read_spaces(IfcBuilding& building, IfcModel& model, const IfcRelations& relations, IfcShapes& shapes);
// The rooms on both sides of a gap, from 0.15 to 1.2 m away from its middle: first behind (-y), then before (+y);
// kNotStated where there is none.
std::array<std::uint32_t, 2> rooms_beside(const std::vector<StatedRoom>& rooms, const WallGap& gap);

}  // namespace handrail
