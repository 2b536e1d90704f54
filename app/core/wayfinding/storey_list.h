// Lists the storeys of the world, each with its number of rooms. Use it on the app thread only.
#pragma once

#include <cstdint>
#include <functional>

#include "app/core/movers/doors.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Opens the list. It runs from the lowest storey up, and begins at the present storey, which is marked. If the rooms
// are not known yet, announces that instead. If the person chooses the present storey, its rooms are announced. If they
// choose another storey, the lift on which the walker stands goes there if it stops there. Otherwise `to_room` gets the
// room of that storey that is nearest on foot.
void open_storey_list(const SessionContext& context, Rooms& rooms, Doors& doors,
                      std::function<void(std::uint32_t room, double now_s)> to_room, double now_s);

}  // namespace handrail::core
