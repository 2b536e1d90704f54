// Makes a storey into a plate that is printed in plastic and read with both hands. Walls are 4 mm high, objects and
// stairs 1.5 mm, and the signs of rooms are in braille. Pure functions; any thread may call them.
//
// Numbers: the plate is 2 mm thick, walls at least 1.2 mm. The longer side is 200 mm, as on the maps that touch-mapper
// prints. Dots are 1.6 mm wide and 0.8 mm high, which 48 readers preferred in plastic. Raised parts are 1 mm apart, as
// a printer needs.
#pragma once

#include <string>
#include <vector>

#include "worlds/exports/solid.h"
#include "worlds/exports/swell_sheet.h"

namespace handrail::exports {

struct StoreyPlate {
    std::vector<SolidTriangle> triangles;
    double one_to = 0.0, wide_mm = 0.0, deep_mm = 0.0;
    std::vector<RoomSign> signs;
    std::vector<std::string> drawn;       // names of the objects on the plate
    std::vector<std::string> simplified;  // sentences for the report about what was simplified
};

// Makes the plate. Fails with one sentence if the storey is too large, if braille is not available, or if the solid is
// not closed, which the function checks for every plate.
Result<StoreyPlate> storey_plate(const plan::Storey& storey, BrailleTable table, double longer_side_mm = 200.0);

}  // namespace handrail::exports
