// Levels as OpenStreetMap writes them: "0;1", "0-3", "-1-3", "-2;-1", "0.5". Pure functions.
#pragma once

#include <string_view>
#include <vector>

namespace handrail {

// Rising, each once; empty where the text holds none. At most 200, from -100 to 300. `damaged`: part of it was not
// understood.
struct OsmLevels {
    std::vector<double> levels;
    bool damaged = false;
};
OsmLevels levels_of(std::string_view level, std::string_view repeat_on = {});

}  // namespace handrail
