// Makes questions about the directions of things in a room, for a person who stands at the base of the room and faces
// north. They are the last part of learning a place. Pure functions over a room graph that has been found, for the app
// thread, in world metres.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

// The sides are listed clockwise.
enum class Quarter : std::uint8_t { Ahead, Right, Behind, Left };
std::string side_words(Quarter side);

struct RelationQuestion {
    std::string thing;
    Quarter right = Quarter::Ahead;
    double distance_m = 0.0;  // distance of the thing from the base
};
// Returns at most three questions about things and doors. Each thing has a unique name and is clearly to one side: at
// least 1.5 m from the base and within 30 degrees of the direction of that side. The same room gives the same
// questions.
std::vector<RelationQuestion> relation_questions(const SessionContext& context, const Rooms& rooms, std::uint32_t room,
                                                 const Vec3& base_m);

}  // namespace handrail::core
