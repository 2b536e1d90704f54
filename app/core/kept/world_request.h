// Defines a request for a world: which world to enter and how to read its file. The command line, the menu, the last
// place, lessons, recordings and tests all use it. Plain data, which any thread may use.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace handrail::core {

struct WorldRequest {
    // Path of the world's file; absolute once the world is entered; empty: the world has no file.
    std::filesystem::path file = {};
    std::optional<double> map_scale_m_per_unit = {};  // only for a .map file; none: the reader's default
    std::optional<double> unit_m = {};                // only for a file that states no unit; none: the reader's default
    std::string building = {};  // only for a file with several buildings; empty: the building with the most rooms
    // Settings of a lesson, as key and value. They override the world's own settings while the session is in this
    // world.
    std::vector<std::pair<std::string, std::string>> settings = {};

    bool operator==(const WorldRequest&) const = default;
};

}  // namespace handrail::core
