// Doors that a person has added where the file of a world has only a wall (worlds/scene/made_door.h). The table
// [mended] of the side file stores them, and the program cuts them into the walls when it reads the world. Pure
// functions over plain values, unless a function says otherwise. App thread; kept_doors may run on any thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/made_door.h"

namespace handrail::core {

// Returns the doors in the order of the file. Entries without a place or with impossible measures stay in the file but
// are not returned.
std::vector<MadeDoor> read_made_doors(const SideFile& file);
// Reads the doors of a world from its side file and changes nothing; any thread. For the parameters see SideFile::peek.
std::vector<MadeDoor> kept_doors(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                 bool shipped, const settings::TomlReader& toml = settings::toml_of);
// Reads the doors from the text of a side file.
std::vector<MadeDoor> made_doors_in(const std::string& side_file);
// The first adds a door; the second removes the door at `place_m`. Both change only the memory, and the owner saves the
// file later.
void keep_made_door(SideFile& file, const MadeDoor& door);
void drop_made_door(SideFile& file, const Vec3& place_m);

}  // namespace handrail::core
