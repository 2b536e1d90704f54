// Finds the worlds that come with the program: next to an installed program, else in the source tree from which it was
// built.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/core/kept/routes_keeper.h"
#include "app/core/kept/world_request.h"
#include "app/import/import_world.h"
#include "settings/toml_value.h"

namespace handrail::program {

struct CommonArguments;

// HANDRAIL_WORLDS if set, else ../share/handrail/worlds relative to the program, else worlds/maps in the source tree.
std::filesystem::path world_folder();
// True if the world is one of these, or one of those that would be used without HANDRAIL_WORLDS or an installation. The
// path may be any one to it; links are followed.
bool is_shipped(const std::filesystem::path& world);
// The path under which the data kept about a world is found again. It is the path as given; for a world that comes with
// the program it is absolute with links followed.
std::filesystem::path kept_by(const std::filesystem::path& world);
// The world in world_folder() with this name ("house"), if no file here has that name; none if there is none.
std::optional<std::filesystem::path> world_by_name(const std::filesystem::path& name);
// The names of those worlds, such as "house".
std::vector<std::string> world_names();
// Finds the world that a command names: a file, or a name such as "house". If neither exists and the word may be a
// name, fails with the nearest one; a missing file is reported by the reader.
Result<std::filesystem::path> world_given(const std::filesystem::path& word);
// Calls import_world with the person's cache. Any thread except the app thread.
Result<importing::ImportedWorld> imported(const std::filesystem::path& world, const readers::ReadOptions& options);
// The same for scenarios, recordings and lessons; see WorldReader in app/core/scenario/read_request.h.
Result<Scene> imported_scene(const core::WorldRequest& request);
// Reads the TOML files next to a world, which somebody else may have written. Uses TomlApart, or this process if
// handrail-reader is missing. Any thread.
const settings::TomlReader& toml_beside_worlds();
// Keeps routes and rooms in the person's cache. Does nothing without a cache, or without handrail-reader, which unpacks
// them.
core::RoutesKeeper ways_in_cache();
// Adds the unit that a person has stated for this world before, if the request has none. See keep_unit. Any thread.
core::WorldRequest with_kept_unit(core::WorldRequest request, const CommonArguments& common);
// Adds the doors that a person has marked as missing. They come from the data folder of `common`, be it the user's or a
// learner's. Without any, the scene stays as it is. Any thread.
Scene mended(Scene scene, const std::filesystem::path& world, const CommonArguments& common);
// An imported world as commands use it: with the doors added, and valid by validate(). Any thread.
Result<Scene> mended_and_valid(Result<importing::ImportedWorld> read, const std::filesystem::path& world,
                               const CommonArguments& common);
// The world that the first start of the program explores.
std::filesystem::path first_world();

}  // namespace handrail::program
