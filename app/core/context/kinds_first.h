// Opens long lists by the kinds of what is in them: nobody goes through hundreds of rooms to find one. App thread only.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/session_context.h"

namespace handrail {

// A list of more entries than this begins with their kinds.
inline constexpr std::size_t kMostEntries = 50;

// `kinds` has what each item of the list is, the coarsest kind first: "Rooms", then "Level 1". A list that is too long
// becomes a list of the first kinds that tell its items apart, each with how many there are, and of everything in the
// end; a kind that is still too long begins with its own kinds. Items without a kind stay in front. A typed name
// chooses its item from the list of kinds as well.
void open_kinds_first(const SessionContext& context, ListSpec list, std::vector<std::vector<std::string>> kinds,
                      double now_s);

}  // namespace handrail
