// Stores what a person changes about the groups of a world: a group can be hidden from touch, or get another material.
// The changes are in the list `group` of the side file. Pure functions over plain values, unless a function says
// otherwise. Call them on the app thread. Any thread may call kept_groups.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

struct GroupChange {
    std::string name;  // name of the group in the world's file
    bool hidden = false;
    std::string material;  // name in the material library; empty: the materials of the file
    SideEntry kept = {};   // keys of the side file that this version does not know
};

// Returns the changes in the order of the file. Entries without a name stay in the file but are not returned. `faults`
// receives an error for each of them.
std::vector<GroupChange> read_groups(const SideFile& file, std::vector<Error>& faults);
// Reads the changes of a world from its side file and changes nothing. Any thread may call it. SideFile::peek explains
// the parameters.
std::vector<GroupChange> kept_groups(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                     bool shipped, const settings::TomlReader& toml = settings::toml_of);
// Returns the changes that are in the text of a side file.
std::vector<GroupChange> groups_in(const std::string& side_file);
// Replaces the change of the group with this name, or adds it. A change that changes nothing is removed. The owner
// saves `file` later.
void keep_group(SideFile& file, const GroupChange& change);

// Returns the scene with these changes. All groups with the same name change. Names that no group has are ignored.
Scene with_groups(Scene scene, const std::vector<GroupChange>& changes);

}  // namespace handrail::core
