// Doors that a person has said to be where a world's file has a wall (worlds/scene/made_door.h): kept in the table
// [mended] of its side file, and cut when the world is read. Pure functions over plain values but where it is said;
// app thread, but kept_doors, which any thread may ask.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/made_door.h"

namespace handrail {

// In the order of the file. Entries that lack a place or whose measures are no door's are left out and stay in the
// file.
std::vector<MadeDoor> read_made_doors(const SideFile& file);
// Reads the file and changes nothing. See SideFile::peek.
std::vector<MadeDoor> kept_doors(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                 bool shipped, const TomlReader& toml = toml_of);
// Of the text of a side file.
std::vector<MadeDoor> made_doors_in(const std::string& side_file);
// One more, and one that is taken away again, by its place; in memory until the file is saved.
void keep_made_door(SideFile& file, const MadeDoor& door);
void drop_made_door(SideFile& file, const Vec3& place_m);

}  // namespace handrail
