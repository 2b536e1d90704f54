// Determines which things are in which room, by the floor next to them. Pure functions over a room graph that has been
// found, for the app thread.
#pragma once

#include <vector>

#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Returns the room on whose floor the thing in `box_m` stands, or in which the thing hangs over the floor. Returns
// kNothing if no floor is near. Call it only after the rooms have been found.
std::uint32_t room_of(const Rooms& rooms, const Aabb& box_m);

// A door of the present room, and a place to stand in front of it.
struct RoomDoor {
    FeatureId feature = kNoFeature;
    Vec3 place_m{0.0};  // position of the doorway
    Vec3 feet_m{0.0};   // position in front of the doorway where there is room for the walker
};
// Returns the doors of the walker's room, in the order of its portals. Doors without room for a walker in front of them
// are left out. The list is empty if the rooms have not been found.
std::vector<RoomDoor> doors_of_room(const SessionContext& context, const Rooms& rooms);

}  // namespace handrail::core
