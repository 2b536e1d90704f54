// Makes office buildings of any size as the text of a .map. They have rooms of 5 by 5 metres on both sides of
// corridors, each with a door and furniture, and storeys joined by stairs. The same size and seed give the same text,
// byte for byte. Any thread.
#pragma once

#include <cstdint>
#include <string>

#include "tests/support/names.h"

namespace handrail::test {

struct OfficeSize {
    int storeys = 1;
    // Number of corridors on each storey, side by side. A hall joins their east ends, with stairs at every third
    // corridor.
    int corridors = 1;
    int rooms_along_corridor = 4;  // number of rooms on each side of a corridor
    // Number of brushes in all. Those that the building does not need become furniture. If there are too few, there is
    // no furniture.
    int brushes = 0;
    std::uint32_t seed = 1;
};

// Returns a size with about a square metre of floor per brush: 50,000 brushes give five storeys of 10,000 square metres
// with 1,600 rooms.
OfficeSize office_size(int brushes, std::uint32_t seed = 1);

struct OfficeWorld {
    std::string map;
    int brushes = 0, rooms = 0, doors = 0, things = 0, stairs = 0;
    double floor_m2 = 0.0;  // floor area of all storeys, including the area of walls and furniture
};

OfficeWorld office_world(const OfficeSize& size);

}  // namespace handrail::test
