// What tells somebody with a cane that a counted leg is walked right and where it ends, where that is surer than steps:
// the doors that are passed, the floor that changes underfoot, a landmark at its end, the wall one trails. Functions of
// what the context holds; some rays for each step; app thread. World metres.
#pragma once

#include <string>

#include "app/core/wayfinding/leg_words.h"

namespace handrail {

// One sentence, the surest; empty: there is nothing of the kind. From `from_m` straight on to `to_m`, soles, in the
// direction of that notch; `door`: the one the leg leads to, among the doors of the floor, kNothing: none.
std::string leg_clue(const SessionContext& context, const WordFloor& floor, const Vec3& from_m, const Vec3& to_m,
                     int notch, std::uint32_t door);

}  // namespace handrail
