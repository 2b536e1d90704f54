// Office buildings of any size as the text of an IFC file: storeys with corridors, rooms of 5 by 5 metres on both sides
// of them, a door and a window to each, a hall with stairs that joins the corridors. The same size makes the same text.
// Any thread.
#pragma once

#include <string>

namespace handrail::test {

struct OfficeIfcSize {
    int storeys = 1;
    int corridors = 1;            // of each storey
    int rooms_along = 4;          // on each side of a corridor
    int facets_of_furniture = 0;  // of the closed, not convex pieces in each room; what makes real files large
};

struct OfficeIfc {
    std::string text;
    int rooms = 0, doors = 0, windows = 0, flights = 0;
    double floor_m2 = 0.0;
};

OfficeIfc office_ifc(const OfficeIfcSize& size);

}  // namespace handrail::test
