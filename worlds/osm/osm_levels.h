// Parses levels as OpenStreetMap writes them: "0;1", "0-3", "-1-3", "-2;-1", "0.5". Pure functions.
#pragma once

#include <string_view>
#include <vector>

namespace handrail::osm {

// Levels in rising order without repetition, from -100 to 300, at most 200 of them. Empty if the text states no level.
// `damaged` is true if part of the text was not understood.
struct OsmLevels {
    std::vector<double> levels;
    bool damaged = false;
};
OsmLevels levels_of(std::string_view level, std::string_view repeat_on = {});

}  // namespace handrail::osm
