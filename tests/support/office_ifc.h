// Makes office buildings of any size as the text of an IFC file. They have storeys with corridors, and rooms of 5 by 5
// metres on both sides of the corridors, each with a door and a window. A hall with stairs joins the corridors. The
// same size always gives the same text. Any thread.
#pragma once

#include <string>

#include "tests/support/names.h"

namespace handrail::test {

struct OfficeIfcSize {
    int storeys = 1;
    int corridors = 1;    // number of corridors on each storey
    int rooms_along = 4;  // number of rooms on each side of a corridor
    // Number of triangles of the closed, non-convex furniture in each room. Such furniture makes real files large.
    int facets_of_furniture = 0;
};

struct OfficeIfc {
    std::string text;
    int rooms = 0, doors = 0, windows = 0, flights = 0;
    double floor_m2 = 0.0;
};

OfficeIfc office_ifc(const OfficeIfcSize& size);

}  // namespace handrail::test
