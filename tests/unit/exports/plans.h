// Provides the storeys of bundled and of real worlds for tests of printed sheets. Reads each world once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "worlds/plan/storey.h"

namespace handrail::test {

struct NamedStoreys {
    std::string world;
    std::vector<Storey> storeys;
};
// Returns the storeys of a world; null if the file is absent. "house.map", "school.map" and "small_house.ifc" are in
// this repository. Other files must be among the real worlds.
const NamedStoreys* storeys_of(const std::string& file);

// Returns a room of 6 by 4 m with a table. A door of 1 m leads to a second room of 3 by 4 m. See plans.cpp.
Storey two_rooms();

}  // namespace handrail::test
