// What somebody who teaches does to a session, a lesson file or a person at the desk alike: one value each, on the one
// way in (session_input.h). Nothing here reaches forces, speech or sound. Plain data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

struct TeacherActed {
    enum class Kind : std::uint8_t {
        Begin,     // a lesson: text, its title
        Offer,     // items: the lessons there are, as they are told; what is chosen is asked of the owner by number
        Task,      // text: what is to be done now, told and told again when asked for
        Ask,       // text: a question that is answered by typing
        Order,     // text: a question; items: to be put in order
        Point,     // text: towards what; answered by facing it, or by moving the hand towards it
        Lead,      // items and places_m: stops of a way; number: how much help, 0 to 1; nothing is led at 0
        Leave,     // the way that is led is over
        Block,     // text: a door; number: its feature. It is shut and stays so, and ways lead round it
        Open,      // likewise: not any more
        Note,      // text: of the one who teaches; kept, not told
        Result,    // text: what was measured of a task, in JSON; kept, not told
        Summary,   // text: how it stands; kept, not told
        End,       // of the lesson: nothing is blocked, led or asked any more
        Learners,  // text: who is here; items: who can be, each a name and what is told of them; number: which of them
                   // is here. Opened as a list; who is chosen is asked of the owner by number
    };
    Kind kind = Kind::Task;
    std::string text = {};
    std::vector<std::string> items = {};
    std::vector<Vec3> places_m = {};
    double number = 0.0;
};

}  // namespace handrail
