// Puts a leg of a route into a sentence: first what to do, then how far, then the end of the leg and the state of what
// is there. "Turn left. 4 steps, until you meet Living room door, shut. Open it." This is all that a person needs to
// follow the leg. The user guide explains the sentence. Functions of the context for the app thread. Lengths are in
// world metres.
#pragma once

#include <span>
#include <string>

#include "app/core/context/session_context.h"
#include "app/core/wayfinding/directions_ground.h"

namespace handrail::core {

struct SpokenLeg {
    int turn_notches = 0;  // notches to turn clockwise, -7 to 8
    int steps = 0;         // for a flight of stairs: steps to its beginning; 0: it begins at once
    navigation::PaceEnd end = navigation::PaceEnd::Steps;
    std::string to;     // what the person meets or reaches, with its state; may be empty if the person counts steps
    int risers = 0;     // risers of the flight; 0: a ramp, or no flight
    bool up = false;    // true: the flight leads up
    int to_stairs = 0;  // steps to a flight of stairs that the leg crosses without ending there; 0: none
    bool open = false;  // true: there is a door that the person must open
    bool by_itself = false;       // true: there is a door that opens automatically
    std::string leaf = {};        // the door whose open leaf blocks the leg and must be shut; empty: none
    FeatureId uses = kNoFeature;  // the door that must be opened or shut on this leg
    std::string clue = {};        // a sentence with a clue that the leg is right; may be empty
};
std::string leg_words(const SpokenLeg& leg, const DistanceWords& how);
// Returns the length of a route as the person hears it in these legs: "13 steps and 17 stairs". The stairs are those of
// the flights at whose end a leg ends; the steps of other legs include the flights that they cross.
std::string total_words(std::span<const SpokenLeg> legs, const DistanceWords& how);

// A leg as the person walks it from the present place. `planned_from_m` is where the plan begins the leg, and `notch`
// is the direction of the leg. If it is the last leg, `goal` is the name of its end.
struct LegAt {
    const navigation::DirectionsLeg& leg;
    int notch = 0;
    Vec3 planned_from_m{0.0};
    std::string goal;
    Vec3 from_m{0.0};
    int from_notch = 0;
    bool at_passage = false;  // true: `goal` is a passage at the end of the leg, so its door is called by that name
};
SpokenLeg spoken_leg(const SessionContext& context, const DirectionsFloor& floor, const LegAt& at,
                     const navigation::DoorsOpen& open);
// Returns true if nothing of the leg remains to be walked from the present place.
bool leg_is_over(const DirectionsFloor& floor, const LegAt& at, const navigation::DoorsOpen& open);

}  // namespace handrail::core
