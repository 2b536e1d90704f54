// Office buildings of any size as the text of a .map: rooms of 5 by 5 metres on both sides of corridors, a door to
// each, furniture, storeys joined by stairs. The same size and seed make the same text, byte for byte. Any thread.
#pragma once

#include <cstdint>
#include <string>

namespace handrail::test {

struct OfficeSize {
    int storeys = 1;
    // Of each storey, side by side; at their east ends a hall joins them, with stairs at every third.
    int corridors = 1;
    int rooms_along_corridor = 4;  // on each side of it
    int brushes = 0;  // of all; furniture fills up what the building itself does not need. Too few: no furniture
    std::uint32_t seed = 1;
};

// About a square metre of floor for each brush: 50,000 brushes are five storeys of 10,000 square metres with 1,600
// rooms.
OfficeSize office_size(int brushes, std::uint32_t seed = 1);

struct OfficeWorld {
    std::string map;
    int brushes = 0, rooms = 0, doors = 0, things = 0, stairs = 0;
    double floor_m2 = 0.0;  // of all storeys, walls and furniture included
};

OfficeWorld office_world(const OfficeSize& size);

}  // namespace handrail::test
