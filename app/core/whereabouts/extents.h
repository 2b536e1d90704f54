// Says how a corridor runs: its length, its direction, its doors and what is at its ends. Functions of the context and
// the room graph, for the app thread. Call them only after the rooms have been found.
#pragma once

#include <cstdint>
#include <string>

#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// Returns true for a room that is at least 6 metres long and at least three times as long as wide.
bool is_corridor(const navigation::Room& room);

// Returns "It runs 30 metres from west to east, with six doors. West end: front door. East end: lift.", or an empty
// text if the room is no corridor.
std::string extent_words(const SessionContext& context, const Rooms& rooms, std::uint32_t room);

}  // namespace handrail::core
