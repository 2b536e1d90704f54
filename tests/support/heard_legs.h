// Understands directions like a person who hears only them. The texts are the legs of a route in English and German,
// and the shorter directions that are given if a route is not announced leg by leg. Pure functions.
#pragma once

#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

// The meaning of a leg of a route, taken only from its text.
struct HeardLeg {
    int turn_notches = 0, steps = 0;  // turn, clockwise, in sixteenths of a circle; number of steps
    enum class Until { Counted, Stopped, FlightOver } until = Until::Counted;
    bool use = false;  // the walker must open or shut a door at the end of the leg
};

// The words of one language that a walker must know.
struct LegForm {
    std::map<std::string, int> turns;
    std::regex counted, until, flight, use;
    std::regex in_all;  // the length of the route, which is announced before the first leg
    std::string there, landed_up, landed_down;
};
LegForm english_legs();
LegForm german_legs();

// Returns the meaning of a leg, or nothing if the text does not have the form.
std::optional<HeardLeg> understood(const std::string& text, const LegForm& form);
// Returns the legs in the announcement of the rest of a route, one text each. A leg begins with a turn.
std::vector<std::string> legs_in(const std::string& text, const LegForm& form);

// The first direction in a text, for example "5 steps, 30 degrees right", "12 steps to the left" or "close by, ahead".
struct Direction {
    int steps = 0;
    double right_deg = 0.0;
};
std::optional<Direction> direction_in(const std::string& text);

}  // namespace handrail::test
