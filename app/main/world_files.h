// Finds the worlds that are shipped with the program: next to the installed program, or else in the source tree from
// which it was built.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/core/kept/routes_keeper.h"
#include "app/core/kept/side_file.h"
#include "app/core/kept/world_request.h"
#include "app/import/import_world.h"
#include "settings/toml_value.h"

namespace handrail::program {

// Returns the folder of the files that are installed with the program; empty if it is unknown.
std::filesystem::path shared_folder();

struct CommonArguments;

// Returns HANDRAIL_WORLDS if it is set, else ../share/handrail/worlds relative to the program, else worlds/maps in the
// source tree.
std::filesystem::path world_folder();
// Returns true if the world is in world_folder(), or in the folder that would be used without HANDRAIL_WORLDS or
// without an installation. `world` may be any path to it; links are followed.
bool is_shipped(const std::filesystem::path& world);
// Returns the path under which data about `world` are stored and found again. If the world is shipped with the program,
// it is the absolute path with links followed. Otherwise it is `world` as given.
std::filesystem::path kept_by(const std::filesystem::path& world);
// Returns the world in world_folder() with this name, such as "house". Returns nothing if there is no such world, or if
// a file in the current folder has that name.
std::optional<std::filesystem::path> world_by_name(const std::filesystem::path& name);
// Returns the names of the worlds in world_folder(), such as "house".
std::vector<std::string> world_names();
// Finds the world that a command names: a file, or a name such as "house". If neither exists, and `word` may be a name,
// fails and suggests the nearest name. If `word` is a path, returns that path, and the reader then reports the missing
// file.
Result<std::filesystem::path> world_given(const std::filesystem::path& word);
// Calls import_world with the person's cache. Any thread except the app thread may call it.
Result<importing::ImportedWorld> imported(const std::filesystem::path& world, const readers::ReadOptions& options);
// Imports a world for scenarios, recordings and lessons; see WorldReader in app/core/scenario/read_request.h.
Result<Scene> imported_scene(const core::WorldRequest& request);
// Returns a reader for the TOML files next to a world, which somebody else may have written. It parses them in a
// separate process with TomlApart, or in this process if handrail-reader is missing. Any thread may use it.
const settings::TomlReader& toml_next_to_worlds();
// Returns an object that keeps routes and rooms in the person's cache. The object does nothing if there is no cache. It
// also does nothing if handrail-reader is missing, because handrail-reader unpacks routes and rooms.
core::RoutesKeeper navigation_in_cache();
// If the request contains no unit, returns it with the unit that a person has stated for this world before. See
// keep_unit. Any thread may call it.
core::WorldRequest with_kept_unit(core::WorldRequest request, const CommonArguments& common);
// Returns the scene with the doors that a person has marked as missing from the world's file, and with the labels that
// a person has given to things. They are in the data folder of `common`, which is the user's or a learner's. Without
// them, the scene does not change. Any thread may call it.
Scene mended(Scene scene, const std::filesystem::path& world, const CommonArguments& common);
// Returns the imported world `read` in the form that commands need: with the missing doors added, and checked by
// validate(). Any thread may call it.
Result<Scene> mended_and_valid(Result<importing::ImportedWorld> read, const std::filesystem::path& world,
                               const CommonArguments& common);
// Returns the person's additions to the world. Those of a learner are in the learner's own folder, and begin as a copy
// of the additions in the user's folder. Any thread may call it.
core::SideFile additions_to(const std::filesystem::path& world, const CommonArguments& common);
// Returns the world that the program explores if the person names none.
std::filesystem::path first_world();

}  // namespace handrail::program
