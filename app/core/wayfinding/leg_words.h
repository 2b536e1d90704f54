// A leg of a route as a sentence: first what to do, then how far, then to what and its state. "Turn left. 4 steps,
// until you meet Living room door, shut. Open it." That is all a person needs to follow it; the user guide explains it.
// Functions of what the context contains; app thread. World metres.
#pragma once

#include <string>

#include "app/core/context/session_context.h"
#include "app/core/wayfinding/directions_ground.h"

namespace handrail::core {

struct SpokenLeg {
    int turn_notches = 0;  // clockwise, -7 to 8
    int steps = 0;         // to the beginning of the stairs, for a flight; 0: at once
    navigation::PaceEnd end = navigation::PaceEnd::Steps;
    std::string to;          // what is met or reached, with its state; may be empty if steps are counted
    int risers = 0;          // of a flight; 0: a ramp, or no flight
    bool up = false;         // direction of the flight
    int to_stairs = 0;       // steps to a flight that the leg crosses without ending there
    bool open = false;       // there is a door to open by hand
    bool by_itself = false;  // or one that opens automatically
    std::string leaf;        // the door whose open leaf blocks the leg and must be shut; empty: none
    std::string clue;        // a sentence with a sign, besides steps, that the leg is right; may be empty
};
std::string leg_words(const SpokenLeg& leg, const DistanceWords& how);

// A leg as walked from the person's present place. `planned_from_m`: where it was planned from. `notch`: its direction.
// `goal`: name of its end, if it is the last leg.
struct LegAt {
    const navigation::DirectionsLeg& leg;
    int notch = 0;
    Vec3 planned_from_m{0.0};
    std::string goal;
    Vec3 from_m{0.0};
    int from_notch = 0;
};
SpokenLeg spoken_leg(const SessionContext& context, const DirectionsFloor& floor, const LegAt& at,
                     const navigation::DoorsOpen& open);
// True if nothing of the leg remains to be walked from there.
bool leg_is_over(const DirectionsFloor& floor, const LegAt& at, const navigation::DoorsOpen& open);

}  // namespace handrail::core
