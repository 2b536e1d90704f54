// Which world to enter and how to read its file. All requests for a world use this: the command line, the menu, the
// last place, lessons, recordings and tests. Plain data; any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace handrail::core {

struct WorldRequest {
    std::filesystem::path file = {};                  // absolute once the world is entered; empty: no file
    std::optional<double> map_scale_m_per_unit = {};  // for a .map; none: the reader's default
    std::optional<double> unit_m = {};                // for a file that states no unit; none: the reader's default
    std::string building = {};  // for a file with several buildings; empty: the one with most rooms
    // Settings of a lesson while the session is in this world, which override the world's own settings: key and value.
    std::vector<std::pair<std::string, std::string>> settings = {};

    bool operator==(const WorldRequest&) const = default;
};

}  // namespace handrail::core
