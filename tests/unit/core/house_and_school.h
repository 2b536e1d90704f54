// Lists the bundled maps for learning a building. Under a sanitizer, the house alone is enough, because the school runs
// the same code.
#pragma once

#include <vector>

#include "tests/support/names.h"
#include "tests/support/scale.h"

namespace handrail::test {

inline std::vector<const char*> house_and_school() {
    if (kSanitizerScale < 1.0) return {"house.map"};
    return {"house.map", "school.map"};
}

}  // namespace handrail::test
