// Buildings of one venue may count their levels from different floors. Finds by how much each must be moved so that the
// floors on the two sides of a shared door meet, and so that none floats above the ground. Pure function over plain
// values; metres.
#pragma once

#include <string>
#include <vector>

#include "worlds/geometry/flat_parts.h"

namespace handrail {

struct VenueUnit {
    std::size_t building = 0;
    double ordinal = 0.0;
    std::vector<Ring> rings;
};

struct VenueDoor {
    std::size_t building = 0;
    double ordinal = 0.0;
    Vec2 at{0.0};
};

// Of each building what to add to its ordinals, mostly 0. Building 0 stands for levels of several buildings or of none.
// It stays as it is, and so does the building with most units. One that shares doors with a building that stays is
// moved by what most of these doors say. One that shares none, and begins above the ground with nothing below it, is
// put on the ground.
std::vector<double> shifts_of_buildings(std::size_t buildings, const std::vector<VenueUnit>& units,
                                        const std::vector<VenueDoor>& doors);

}  // namespace handrail
