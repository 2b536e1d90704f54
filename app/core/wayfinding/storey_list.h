// The storeys of the world as a list, each with how many rooms it has. App thread only.
#pragma once

#include <cstdint>
#include <functional>

#include "app/core/movers/doors.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

// From the lowest up; one begins at one's own, which is told to be that, or says that the rooms are not known yet.
// Chosen, one's own is told with its rooms. To another one the lift goes that one stands on, where it stops there; else
// `to_room` is told which room of it is the nearest on foot.
void open_storey_list(const SessionContext& context, Rooms& rooms, Doors& doors,
                      std::function<void(std::uint32_t room, double now_s)> to_room, double now_s);

}  // namespace handrail
