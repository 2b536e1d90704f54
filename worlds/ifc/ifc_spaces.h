// Storeys and rooms of an IFC file. One reading thread.
#pragma once

#include "worlds/ifc/ifc_building.h"

namespace handrail {

// Fills storeys, rooms and room_of_id.
void read_spaces(IfcBuilding& building, IfcModel& model, const IfcRelations& relations, IfcShapes& shapes);

// Which room is at a place, of many. The rooms must outlive it and stay as they are.
class RoomsByPlace {
public:
    explicit RoomsByPlace(const std::vector<StatedRoom>& rooms);
    // The first in file order that holds the place; kNotStated: none.
    std::uint32_t first_at(const Vec3& at_m) const;
    // All that hold it, in file order.
    std::vector<std::uint32_t> all_at(const Vec3& at_m) const;
    // Whose boxes meet that one, in file order.
    std::vector<std::uint32_t> near(const Aabb& box) const;

private:
    const std::vector<StatedRoom>& rooms_;
    BoxIndex boxes_;
};

// The rooms on both sides of a gap, from 0.15 to 1.2 m away from its middle: first behind (-y), then before (+y);
// kNotStated where there is none.
std::array<std::uint32_t, 2> rooms_beside(const RoomsByPlace& rooms, const WallGap& gap);

}  // namespace handrail
