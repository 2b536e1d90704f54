// Clues for a person with a cane who walks a leg by counting steps: they show that the leg is right and where it ends.
// They are used if they are more reliable than counting: doors that are passed, a change of the floor, a landmark at
// the end, or a wall to trail. Functions of the context; some rays for each step; app thread. World metres.
#pragma once

#include <string>

#include "app/core/wayfinding/leg_words.h"

namespace handrail::core {

// Returns a sentence with the most reliable clue, or an empty text. The leg leads straight from `from_m` to `to_m` at
// floor level, in the direction of `notch`. `door` is the index of the door to which the leg leads among the doors of
// the floor, or kNothing.
std::string leg_clue(const SessionContext& context, const DirectionsFloor& floor, const Vec3& from_m, const Vec3& to_m,
                     int notch, std::uint32_t door);

}  // namespace handrail::core
