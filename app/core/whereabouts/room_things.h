// What stands in which room, by the floor beside it. Pure functions over a graph that has been found; app thread.
#pragma once

#include <vector>

#include "app/core/whereabouts/rooms.h"

namespace handrail {

// The room on whose floor something in that box stands or before which it hangs; kNothing: none is near. rooms: found.
std::uint32_t room_of(const Rooms& rooms, const Aabb& box_m);

// A door of the room one is in, with a place before it to stand at.
struct RoomDoor {
    FeatureId feature = kNoFeature;
    Vec3 place_m{0.0};  // of the doorway
    Vec3 feet_m{0.0};   // before it, where the body has room
};
// Of the room that the body is in, in the order of its portals; none where rooms are not found. A door before which
// there is no room for the body is left out.
std::vector<RoomDoor> doors_of_room(const SessionContext& context, const Rooms& rooms);

}  // namespace handrail
