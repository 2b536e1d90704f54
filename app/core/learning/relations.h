// Questions about how things of a room lie to each other, the last part of learning a place: as one stands at its base
// and faces north. Pure functions over a graph that has been found; app thread; world metres.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/core/whereabouts/rooms.h"

namespace handrail {

// Clockwise, as a list offers them.
enum class Quarter : std::uint8_t { Ahead, Right, Behind, Left };
std::string side_words(Quarter side);

struct RelationQuestion {
    std::string thing;
    Quarter right = Quarter::Ahead;
    double distance_m = 0.0;  // from the base
};
// At most three, of things and doors with names of their own that lie clearly to one side: 1.5 m from the base or more,
// within 30 degrees of its direction. The same room gives the same questions.
std::vector<RelationQuestion> relation_questions(const SessionContext& context, const Rooms& rooms, std::uint32_t room,
                                                 const Vec3& base_m);

}  // namespace handrail
