// Where the worlds that ship with the program lie: beside an installed program, else in the source tree it was built
// from.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/core/kept/ways_keeper.h"
#include "app/core/kept/world_request.h"
#include "app/import/import_world.h"
#include "settings/toml_value.h"

namespace handrail {

struct CommonArguments;

// HANDRAIL_WORLDS when set, else ../share/handrail/worlds from the program's own place, else the source tree's
// worlds/maps.
std::filesystem::path world_folder();
// The world is one of these, or of those that would be without HANDRAIL_WORLDS or an installation; by whatever path,
// links followed.
bool is_shipped(const std::filesystem::path& world);
// By which what is kept of a world is found again: the path as it is, of one of ours absolute and links followed.
std::filesystem::path kept_by(const std::filesystem::path& world);
// "house", where no file of that name is here: the world of world_folder() that is called so; none: there is none.
std::optional<std::filesystem::path> world_by_name(const std::filesystem::path& name);
// What those are called: "house".
std::vector<std::string> world_names();
// The world that a command was given: a file, or one of ours by its name, "house". Where there is neither and it may
// have been meant for a name, fails with the nearest one; a file that is not there is for the reader to tell.
Result<std::filesystem::path> world_given(const std::filesystem::path& word);
// As import_world, with the person's cache. Any thread but the app's.
Result<ImportedWorld> imported(const std::filesystem::path& world, const ReadOptions& options);
// The same for scenarios, recordings and lessons (WorldReader in app/core/scenario/read_request.h).
Result<Scene> imported_scene(const WorldRequest& request);
// Reads the TOML files that are next to a world, which somebody else may have written: by TomlApart, or in this process
// without handrail-reader. Any thread.
const TomlReader& toml_beside_worlds();
// Keeps ways and rooms in the person's cache; nothing without one, or without handrail-reader, which unpacks them.
WaysKeeper ways_in_cache();
// With the unit that a person has said of this world before, where the request says none. See keep_unit. Any thread.
WorldRequest with_kept_unit(WorldRequest request, const CommonArguments& common);
// With the doors that a person has said to be missing in it: of whoever keeps what they add in that folder. The same
// where there are none. Any thread.
Scene mended(Scene scene, const std::filesystem::path& world, const CommonArguments& common);
// What was imported as commands look at it: mended, and whole by validate(). Any thread.
Result<Scene> mended_and_valid(Result<ImportedWorld> read, const std::filesystem::path& world,
                               const CommonArguments& common);
// The world that a first start explores.
std::filesystem::path first_world();

}  // namespace handrail
