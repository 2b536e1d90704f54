// The title of a sheet, in print and in the braille at its head. Pure functions; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "worlds/exports/braille.h"
#include "worlds/plan/storey.h"

namespace handrail {

// The world, what its file calls the storey, and which one that is of how many. `sheet`: which of several.
std::string sheet_title(const Storey& storey, std::optional<int> sheet);

// One or two lines for the head of a page that is so wide. A world with a long name keeps the first words of it, and
// the title always keeps its storey, without the number if the storey has a name.
Result<std::vector<BrailleCells>> title_lines(const Storey& storey, std::optional<int> sheet, BrailleTable table,
                                              double page_mm);

}  // namespace handrail
