// Finds clues for a person with a cane who walks a leg by counting steps. A clue shows that the leg is right and where
// it ends: doors that are passed, a change of the floor, a landmark at the end, or a wall to trail. It is announced if
// it is more reliable than counting. Functions of the context for the app thread. Each step of the leg costs some rays.
// Lengths are in world metres.
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
