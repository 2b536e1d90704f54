// How many of very many similar cases, such as routes between all rooms of a building, a run of the tests tries.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "tests/support/names.h"
#include "tests/support/scale.h"

namespace handrail::test {

// The stride between tried cases: `usual` in a normal run, `sanitized` under a sanitizer, which looks for memory faults
// and not for percentages. With HANDRAIL_ALL_ROUTES set, every case is tried.
inline std::uint32_t every(std::uint32_t usual, std::uint32_t sanitized) {
    if (std::getenv("HANDRAIL_ALL_ROUTES")) return 1;
    return kSanitizerScale < 1.0 ? sanitized : usual;
}

// True if at least `percent` of the cases are good. If there are more than three cases but too few for the percentage
// to allow a miss, one miss is allowed, except if all cases are tried.
inline bool enough(int good, int of, int percent) {
    const int allowed = of * (100 - percent) / 100, of_few = of > 3 && !std::getenv("HANDRAIL_ALL_ROUTES") ? 1 : 0;
    return of > 0 && of - good <= (allowed > of_few ? allowed : of_few);
}

}  // namespace handrail::test
