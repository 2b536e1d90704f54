// Determines which things are in which room, by the floor next to them. Pure functions over a room graph that has been
// found; app thread.
#pragma once

#include <vector>

#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Returns the room on whose floor the thing in this box stands, or in which it hangs over the floor. Returns kNothing
// if no floor is near. Requires that the rooms are found.
std::uint32_t room_of(const Rooms& rooms, const Aabb& box_m);

// A door of the present room, and a place to stand in front of it.
struct RoomDoor {
    FeatureId feature = kNoFeature;
    Vec3 place_m{0.0};  // place of the doorway
    Vec3 feet_m{0.0};   // place in front of the doorway where the walker has room
};
// Returns the doors of the walker's room, in the order of its portals. Doors without room for a walker in front of them
// are left out. Empty if the rooms are not found.
std::vector<RoomDoor> doors_of_room(const SessionContext& context, const Rooms& rooms);

}  // namespace handrail::core
