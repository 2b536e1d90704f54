// Office buildings of any size as the text of a .map: rooms of 5 by 5 metres on both sides of corridors, each with a
// door and furniture, and storeys joined by stairs. The same size and seed make the same text, byte for byte. Any
// thread.
#pragma once

#include <cstdint>
#include <string>

#include "tests/support/names.h"

namespace handrail::test {

struct OfficeSize {
    int storeys = 1;
    // On each storey, side by side. A hall joins their east ends, with stairs at every third.
    int corridors = 1;
    int rooms_along_corridor = 4;  // on each side of a corridor
    int brushes = 0;  // in all; those that the building does not need become furniture; too few: no furniture
    std::uint32_t seed = 1;
};

// Gives each brush about a square metre of floor: 50,000 brushes make five storeys of 10,000 square metres with 1,600
// rooms.
OfficeSize office_size(int brushes, std::uint32_t seed = 1);

struct OfficeWorld {
    std::string map;
    int brushes = 0, rooms = 0, doors = 0, things = 0, stairs = 0;
    double floor_m2 = 0.0;  // of all storeys, including the area of walls and furniture
};

OfficeWorld office_world(const OfficeSize& size);

}  // namespace handrail::test
