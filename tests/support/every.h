// Of very many that are alike, as ways between all rooms of a building, how many a run of the tests takes.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "tests/support/scale.h"

namespace handrail::test {

// Every how manyth: `usual` in each run of the tests, `sanitized` under a sanitizer, which is asked for faults of
// memory and not for shares; with HANDRAIL_ALL_ROUTES set each.
inline std::uint32_t every(std::uint32_t usual, std::uint32_t sanitized) {
    if (std::getenv("HANDRAIL_ALL_ROUTES")) return 1;
    return kSanitizerScale < 1.0 ? sanitized : usual;
}

// At least `percent` of them. Of so few that the share allows none, but more than three, one may be missed; not where
// all are taken.
inline bool enough(int good, int of, int percent) {
    const int allowed = of * (100 - percent) / 100, of_few = of > 3 && !std::getenv("HANDRAIL_ALL_ROUTES") ? 1 : 0;
    return of > 0 && of - good <= (allowed > of_few ? allowed : of_few);
}

}  // namespace handrail::test
