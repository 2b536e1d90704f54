// The storeys of the world as a list, each with its number of rooms. App thread only.
#pragma once

#include <cstdint>
#include <functional>

#include "app/core/movers/doors.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// From the lowest up, beginning at the present storey, which is marked; announces if the rooms are not known yet.
// Choosing the present storey announces its rooms. For another one, the lift under the walker goes there if it stops
// there; otherwise `to_room` gets that storey's nearest room on foot.
void open_storey_list(const SessionContext& context, Rooms& rooms, Doors& doors,
                      std::function<void(std::uint32_t room, double now_s)> to_room, double now_s);

}  // namespace handrail::core
