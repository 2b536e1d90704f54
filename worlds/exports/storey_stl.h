// A storey as a plate to be printed in plastic and read by both hands: walls 4 mm high, things and stairs 1.5 mm, the
// signs of rooms in braille. Pure functions; any thread.
//
// Numbers: plate 2 mm, walls at least 1.2 mm thick, 200 mm the longer side, as touch-mapper prints its maps; dots 1.6
// mm wide and 0.8 mm high, which 48 readers preferred in plastic. 1 mm is free between what is raised, for a printer.
#pragma once

#include <string>
#include <vector>

#include "worlds/exports/solid.h"
#include "worlds/exports/swell_sheet.h"

namespace handrail {

struct StoreyPlate {
    std::vector<SolidTriangle> triangles;
    double one_to = 0.0, wide_mm = 0.0, deep_mm = 0.0;
    std::vector<RoomSign> signs;
    std::vector<std::string> drawn;       // names of the things on it
    std::vector<std::string> simplified;  // sentences
};

// Fails with one sentence where the storey is too large, braille cannot be had, or what came out is not closed, which
// is checked each time.
Result<StoreyPlate> storey_plate(const Storey& storey, BrailleTable table, double longer_side_mm = 200.0);

}  // namespace handrail
