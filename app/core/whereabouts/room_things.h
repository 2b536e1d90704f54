// Which things are in which room, determined by the floor next to them. Pure functions over a room graph that has been
// found; app thread.
#pragma once

#include <vector>

#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// The room on whose floor something in that box stands, or before which it hangs; kNothing: none is near. Requires that
// rooms are found.
std::uint32_t room_of(const Rooms& rooms, const Aabb& box_m);

// A door of the present room, with a place to stand before it.
struct RoomDoor {
    FeatureId feature = kNoFeature;
    Vec3 place_m{0.0};  // of the doorway
    Vec3 feet_m{0.0};   // before it, where a walker has room
};
// The doors of the walker's room, in the order of its portals; none if rooms are not found. A door with no room for a
// walker before it is left out.
std::vector<RoomDoor> doors_of_room(const SessionContext& context, const Rooms& rooms);

}  // namespace handrail::core
