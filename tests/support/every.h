// Decides how many of very many similar cases a run of the tests tries, such as routes between all rooms of a building.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "tests/support/names.h"
#include "tests/support/scale.h"

namespace handrail::test {

// Returns the stride between tried cases. The stride is `usual` in a normal run, and `sanitized` under a sanitizer,
// which looks for memory faults and not for percentages. If HANDRAIL_ALL_ROUTES is set, every case is tried.
inline std::uint32_t every(std::uint32_t usual, std::uint32_t sanitized) {
    if (std::getenv("HANDRAIL_ALL_ROUTES")) return 1;
    return kSanitizerScale < 1.0 ? sanitized : usual;
}

// Returns true if at least `percent` of the cases are good. If there are more than three cases, one bad case is
// permitted even where the percentage permits none, except in a run that tries all cases.
inline bool enough(int good, int of, int percent) {
    const int allowed = of * (100 - percent) / 100, of_few = of > 3 && !std::getenv("HANDRAIL_ALL_ROUTES") ? 1 : 0;
    return of > 0 && of - good <= (allowed > of_few ? allowed : of_few);
}

}  // namespace handrail::test
