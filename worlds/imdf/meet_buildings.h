// Finds how far each building of a venue has to be shifted up or down, because the buildings may count their levels
// from different floors. Afterwards the floors on both sides of a shared door have the same height, and no building
// floats above the ground. Pure function over plain values in metres.
#pragma once

#include <string>
#include <vector>

#include "worlds/geometry/flat_parts.h"

namespace handrail::imdf {

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

// Returns the shift to add to the ordinals of each building, mostly 0:
// - Building 0 stands for levels of several buildings or of none. It stays as it is, and so does the building with
//   the most units.
// - A building that shares doors with a settled building is shifted by the amount that most of these doors require.
// - A building that shares no doors, and begins above the ground with nothing below it, is put on the ground.
std::vector<double> shifts_of_buildings(std::size_t buildings, const std::vector<VenueUnit>& units,
                                        const std::vector<VenueDoor>& doors);

}  // namespace handrail::imdf
