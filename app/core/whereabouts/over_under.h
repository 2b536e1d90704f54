// Says which rooms are straight above or below the person or a room. Functions of the context and the room graph, for
// the app thread. Call them only after the rooms have been found. A room costs at most 400 lookups for each room over
// it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Returns "Above you: landing." or "No room is above you." `by` is 1 for above and -1 for below.
std::string over_person_words(const SessionContext& context, const Rooms& rooms, int by);
// Returns "Above kitchen: bedroom, landing." or "No room is above kitchen."
std::string over_room_words(const Rooms& rooms, std::uint32_t room, int by);

// Returns the next rooms over the floor of a room, the one that covers most of it first. Rooms over less than a
// twentieth of the floor are left out.
std::vector<std::uint32_t> rooms_over(const Rooms& rooms, std::uint32_t room, int by);

}  // namespace handrail::core
