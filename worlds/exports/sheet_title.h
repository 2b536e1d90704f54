// Makes the title of a sheet, both in print and in the braille at the head of the sheet. Pure functions; any thread may
// call them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "worlds/exports/braille.h"
#include "worlds/plan/storey.h"

namespace handrail::exports {

// Returns the title: the name of the world, the file's name for the storey, and the number of the storey. `sheet`:
// number of the sheet if there are several.
std::string sheet_title(const plan::Storey& storey, std::optional<int> sheet);

// Returns one or two lines for the head of a page that is `page_mm` wide. A long name of the world is cut after its
// first words. The title always contains the storey, without its number if the storey has a name.
Result<std::vector<BrailleCells>> title_lines(const plan::Storey& storey, std::optional<int> sheet, BrailleTable table,
                                              double page_mm);

}  // namespace handrail::exports
