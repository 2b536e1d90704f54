// Defines an act of a teacher that affects a session. A lesson file and a person at the desk send the same values,
// through session_input.h. An act never controls forces, speech or sound directly. Plain data.
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
        Task,      // text: the task, announced now and whenever the person asks for it
        Question,  // text: a question to answer by typing
        Order,     // text: an instruction; items: what the learner has to put in order
        Point,     // text: what to point at, by facing it or by moving the hand towards it
        Lead,    // items and places_m: stops of a route; number: how much guidance the learner gets, from 0 (none) to 1
        Leave,   // ends the guidance that Lead has begun
        Block,   // text: a door; number: its feature. The door is shut and stays shut, and routes avoid it
        Open,    // ends the blocking of a door; text and number as for Block
        Note,    // text: a note of the teacher; it is stored but not announced
        Result,  // text: measurements of a task in JSON; they are stored but not announced
        Summary,  // text: the results until now; they are stored but not announced
        End,      // ends the lesson with its blocked doors, guidance and questions
        // Opens a list of learners. text: the present learner's name; items: name and description of each learner;
        // number: index of the present learner. The session requests the chosen one from the owner by number.
        Learners,
    };
    Kind kind = Kind::Task;
    std::string text = {};
    std::vector<std::string> items = {};
    std::vector<Vec3> places_m = {};
    double number = 0.0;
};

}  // namespace handrail::core
