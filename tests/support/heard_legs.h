// What somebody understands who hears directions and knows nothing else: the form of legs in English and German, and of
// the shorter directions that are given where a route is not told leg by leg. Pure functions.
#pragma once

#include <map>
#include <optional>
#include <regex>
#include <string>

namespace handrail::test {

// What a leg asks for, by its words alone.
struct HeardLeg {
    int turn_notches = 0, steps = 0;  // clockwise, a sixteenth of a circle each
    enum class Until { Counted, Stopped, FlightOver } until = Until::Counted;
    bool use = false;  // a door at its end is to be opened or shut
};

// The words of one language that a walker must know.
struct LegForm {
    std::map<std::string, int> turns;
    std::regex counted, until, flight, use;
    std::string there, landed_up, landed_down;
};
LegForm english_legs();
LegForm german_legs();

// None: it does not have the form.
std::optional<HeardLeg> understood(const std::string& text, const LegForm& form);

// "5 steps, 30 degrees right", "12 steps to the left", "close by, ahead": the first that stands in a text.
struct Direction {
    int steps = 0;
    double right_deg = 0.0;
};
std::optional<Direction> direction_in(const std::string& text);

}  // namespace handrail::test
