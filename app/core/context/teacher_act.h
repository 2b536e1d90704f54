// What a teacher does to a session: the same value from a lesson file and from a person at the desk, through
// session_input.h. It reaches neither forces nor speech nor sound directly. Plain data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::core {

struct TeacherActed {
    enum class Kind : std::uint8_t {
        Begin,  // begins a lesson; text: its title
        // Offers lessons; items: their spoken names. The session requests the chosen one from the owner by number.
        Offer,
        Task,     // text: the task, announced now and whenever the person asks for it
        Ask,      // text: a question to answer by typing
        Order,    // text: a question; items: to be put in order
        Point,    // text: what to point at, by facing it or by moving the hand towards it
        Lead,     // items and places_m: stops of a route; number: amount of guidance from 0 to 1, 0: none
        Leave,    // ends the guidance along the route
        Block,    // text: a door; number: its feature. It is shut, stays shut, and routes avoid it
        Open,     // ends the blocking of a door; text and number as for Block
        Note,     // text: a note of the teacher; kept, not announced
        Result,   // text: measurements of a task in JSON; kept, not announced
        Summary,  // text: the present results; kept, not announced
        End,      // ends the lesson: nothing is blocked, guided or asked any more
        // Opens a list of learners. text: who is here; items: name and description of each who can be; number: which of
        // them is here. The session requests the chosen one from the owner by number.
        Learners,
    };
    Kind kind = Kind::Task;
    std::string text = {};
    std::vector<std::string> items = {};
    std::vector<Vec3> places_m = {};
    double number = 0.0;
};

}  // namespace handrail::core
