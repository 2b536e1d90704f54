// Which world is to be entered and how its file is read: the one way to ask for a world. The command line, the menu,
// the last place, lessons, recordings and tests make it. Plain data; any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace handrail {

struct WorldRequest {
    std::filesystem::path file = {};                  // absolute once it is entered; empty: it comes from no file
    std::optional<double> map_scale_m_per_unit = {};  // of a .map; none: the reader's own
    std::optional<double> unit_m = {};                // of a file that states none; none: the reader's own
    std::string building = {};                        // of a file with several; empty: the one with most rooms
    // What a lesson sets while one is in this world, on top of the settings that come with its file: key and value.
    std::vector<std::pair<std::string, std::string>> settings = {};

    bool operator==(const WorldRequest&) const = default;
};

}  // namespace handrail
