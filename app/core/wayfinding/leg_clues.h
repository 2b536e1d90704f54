// Clues that tell a person with a cane that a counted leg is walked correctly, and where it ends, if that is more
// reliable than counting steps: doors that are passed, a change of the floor, a landmark at the end, or a wall to
// trail. Functions of what the context contains; some rays for each step; app thread. World metres.
#pragma once

#include <string>

#include "app/core/wayfinding/leg_words.h"

namespace handrail::core {

// One sentence with the most reliable clue; empty: there is none. The leg leads from `from_m` straight to `to_m`, at
// floor level, in the direction of that notch. `door`: the one to which the leg leads, among the doors of the floor;
// kNothing: none.
std::string leg_clue(const SessionContext& context, const DirectionsFloor& floor, const Vec3& from_m, const Vec3& to_m,
                     int notch, std::uint32_t door);

}  // namespace handrail::core
