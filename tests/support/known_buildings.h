// Lists buildings whose doors have names: the bundled worlds, and real buildings if they are present.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace handrail::test {

struct KnownBuilding {
    std::filesystem::path file;
    std::size_t doors = 0;  // number of doors that are in a wall; other doors are not included
    bool large = false;     // true if reading the building takes half a minute under a sanitizer
};

// Writes an office of two storeys into `folder` and returns it with the other buildings. Prints a line for each absent
// building, as with_real_worlds() does.
std::vector<KnownBuilding> known_buildings(const TemporaryFolder& folder);

}  // namespace handrail::test
