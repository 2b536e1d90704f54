// Reads the storeys and rooms of an IFC file. Used on the reading thread only.
#pragma once

#include "worlds/ifc/ifc_building.h"

namespace handrail::ifc {

// Fills the members storeys, rooms and room_of_id of `building`.
void read_spaces(IfcBuilding& building, IfcModel& model, const IfcRelations& relations, IfcShapes& shapes);

// Finds the rooms at a place quickly. The rooms must outlive this object and must not change.
class RoomsByPlace {
public:
    explicit RoomsByPlace(const std::vector<StatedRoom>& rooms);
    // Returns the first room in file order that contains the place; kNotStated if there is none.
    std::uint32_t first_at(const Vec3& at_m) const;
    // Returns all rooms that contain the place, in file order.
    std::vector<std::uint32_t> all_at(const Vec3& at_m) const;
    // Returns the rooms whose boxes overlap or touch the given box, in file order.
    std::vector<std::uint32_t> near(const Aabb& box) const;

private:
    const std::vector<StatedRoom>& rooms_;
    BoxIndex boxes_;
};

// Returns the rooms on both sides of a gap: first the one behind the gap (-y), then the one in front of it (+y). Each
// is searched from 0.15 to 1.2 m from the middle of the gap, and is kNotStated if there is none.
std::array<std::uint32_t, 2> neighbouring_rooms(const RoomsByPlace& rooms, const WallGap& gap);

}  // namespace handrail::ifc
