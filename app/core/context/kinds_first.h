// Opens long lists by the kinds of their entries, because nobody reads hundreds of rooms to find one. App thread only.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/session_context.h"

namespace handrail::core {

// Lists of more entries than this begin with the kinds of the entries.
inline constexpr std::size_t kMostEntries = 50;

// Opens `list`. `kinds` holds, for each item of the list, the kinds that it belongs to, the coarsest first, for example
// "Rooms with a name", then "Level 1". If the list has more than kMostEntries items, a list of kinds opens instead,
// each with its number of items, and "Everything" at the end. A kind with too many items opens the list of its own
// kinds. Items without a kind and without an adjustable value come first. A typed name chooses its item in the list of
// kinds, too.
void open_kinds_first(const SessionContext& context, ListSpec list, const std::vector<std::vector<std::string>>& kinds,
                      double now_s);

}  // namespace handrail::core
