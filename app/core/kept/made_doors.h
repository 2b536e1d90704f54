// Stores the doors that a person has added where the file of a world has only a wall (worlds/scene/made_door.h). The
// doors are in the table [mended] of the side file, and the program cuts them into the walls when it reads the world.
// Pure functions over plain values, unless a function says otherwise. Call them on the app thread. Any thread may call
// kept_doors.
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
// Reads the doors of a world from its side file and changes nothing. Any thread may call it. SideFile::peek explains
// the parameters.
std::vector<MadeDoor> kept_doors(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                 bool shipped, const settings::TomlReader& toml = settings::toml_of);
// Returns the doors that are in the text of a side file.
std::vector<MadeDoor> made_doors_in(const std::string& side_file);
// keep_made_door() adds a door. drop_made_door() removes the door at `place_m`. Both change only the memory, and the
// owner saves `file` later.
void keep_made_door(SideFile& file, const MadeDoor& door);
void drop_made_door(SideFile& file, const Vec3& place_m);

}  // namespace handrail::core
