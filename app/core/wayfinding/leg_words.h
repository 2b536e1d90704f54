// A leg of a route for words as a sentence: what to do first, then how far, then to what and its state. "Turn left. 4
// steps, until you meet Living room door, shut. Open it." The form is all that somebody needs who follows it; the user
// guide tells it. Functions of what the context holds; app thread. World metres.
#pragma once

#include <string>

#include "app/core/context/session_context.h"
#include "app/core/wayfinding/word_ground.h"

namespace handrail {

struct SpokenLeg {
    int turn_notches = 0;  // clockwise, -7 to 8
    int steps = 0;         // where the stairs begin, for a flight; 0: at once
    PaceEnd end = PaceEnd::Steps;
    std::string to;          // what is met or come to, with its state; may be empty where steps are counted
    int risers = 0;          // of a flight; 0: a ramp, or there is none
    bool up = false;         // of a flight
    int to_stairs = 0;       // steps to where it begins, on a leg that goes over it and does not end with it
    bool open = false;       // a door there is to be opened by hand
    bool by_itself = false;  // or opens as one comes near
    std::string leaf;        // the door whose leaf stands open across it and is to be shut; empty: none does
    std::string clue;        // what tells beside steps that one is right; a sentence, may be empty
};
std::string leg_words(const SpokenLeg& leg, const DistanceWords& how);

// How a leg is walked from where one stands: `planned_from_m` is where it was planned from, `notch` where it leads,
// `goal` what to call its end where it is the last one.
struct LegAt {
    const WordLeg& leg;
    int notch = 0;
    Vec3 planned_from_m{0.0};
    std::string goal;
    Vec3 from_m{0.0};
    int from_notch = 0;
};
SpokenLeg spoken_leg(const SessionContext& context, const WordFloor& floor, const LegAt& at, const DoorsOpen& open);
// Nothing is left of it to be walked from there.
bool leg_is_over(const WordFloor& floor, const LegAt& at, const DoorsOpen& open);

}  // namespace handrail
