// Doors that a person has added to a world whose file has a wall there (worlds/scene/made_door.h). They are stored in
// the table [mended] of its side file, and cut when the world is read. Unless a function says otherwise, these are pure
// functions over plain values. App thread; kept_doors may run on any thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/made_door.h"

namespace handrail::core {

// In the order of the file. Entries without a place or with impossible measures are left out but stay in the file.
std::vector<MadeDoor> read_made_doors(const SideFile& file);
// Reads the file and changes nothing; any thread. See SideFile::peek.
std::vector<MadeDoor> kept_doors(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                 bool shipped, const settings::TomlReader& toml = settings::toml_of);
// From the text of a side file.
std::vector<MadeDoor> made_doors_in(const std::string& side_file);
// Adds a door, or removes the one at a place; in memory until the file is saved.
void keep_made_door(SideFile& file, const MadeDoor& door);
void drop_made_door(SideFile& file, const Vec3& place_m);

}  // namespace handrail::core
