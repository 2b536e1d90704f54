// Finds the place at which a session starts, if the command line or a link names one. A link is a small TOML file with
// the extension .handrail that names a world and a place in it. Any thread may use these functions.
#pragma once

#include <filesystem>
#include <string>

#include "app/core/kept/routes_keeper.h"
#include "app/core/kept/side_file.h"
#include "app/core/session/session_input.h"
#include "settings/toml_value.h"
#include "worlds/base/result.h"

namespace handrail::program {

// The place that the person wants to start at, by its name, and the radius of the walker's body in metres.
struct WantedStart {
    std::string name;  // empty: the session starts at the base
    double body_radius_m = 0.0;
};

// Returns the place with this name in `scene`, which is the world as in its file. Understands what the list of routes
// and the list of things understand: names of rooms, also those that the person gave; starts, marks and things. The
// walker faces `heading_rad`. Searches for the rooms, which takes as long as in the session; `keeper` stores the result
// for the session. Fails with a sentence that names up to three places with similar names.
Result<core::Placed> start_place(const std::shared_ptr<const Scene>& scene, const WantedStart& wanted,
                                 const core::SideFile& additions, double heading_rad, core::RoutesKeeper keeper);

inline constexpr const char* kLinkExtension = ".handrail";

// What a link names. The file of the world is relative to the folder of the link, or the name of a world that is
// shipped with the program.
struct PlaceLink {
    std::filesystem::path world;
    std::string place;  // empty: the link names only a world
};
// Reads a link, with `toml` as the parser. Fails with a sentence that names the file, and the line if it is known.
Result<PlaceLink> read_link(const std::filesystem::path& file, const settings::TomlReader& toml);

}  // namespace handrail::program
