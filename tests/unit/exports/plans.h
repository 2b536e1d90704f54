// Storeys of our own worlds and of real ones, for tests of printed sheets; each world is read once.
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
// "house.map", "school.map" and "small_house.ifc" are ours; others are looked for among the real worlds. Null if the
// file is absent.
const NamedStoreys* storeys_of(const std::string& file);

// A room of 6 by 4 m with a door of 1 m to a second room of 3 by 4 m, and a table in the first: see plans.cpp.
Storey two_rooms();

}  // namespace handrail::test
