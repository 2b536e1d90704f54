#include "app/core/kept/kept_groups.h"

#include <algorithm>

#include "worlds/base/language.h"
#include "worlds/scene/groups.h"

namespace handrail::core {
namespace {

constexpr const char* kGroupList = "group";

Result<GroupChange> change_from(const SideEntry& entry) {
    const auto name = good_name(text_of(entry, "name"));
    if (!name) return fail(phrase("groups.no_name"));
    const auto hidden = entry.find("hidden");
    const bool* flag = hidden == entry.end() ? nullptr : std::get_if<bool>(&hidden->second);
    const MaterialSpec* material = find_material(text_of(entry, "material"));
    return GroupChange{*name, flag && *flag, material ? std::string(material->name) : std::string(),
                       without(entry, {"name", "hidden", "material"})};
}

SideEntry group_entry(const GroupChange& change) {
    SideEntry entry = change.kept;
    entry["name"] = change.name;
    entry["hidden"] = change.hidden;
    if (!change.material.empty()) entry["material"] = change.material;
    return entry;
}

std::vector<GroupChange> changes_of(const std::vector<SideEntry>& entries) {
    std::vector<GroupChange> changes;
    for (const SideEntry& entry : entries)
        if (auto change = change_from(entry)) changes.push_back(std::move(*change));
    return changes;
}

}  // namespace

std::vector<GroupChange> read_groups(const SideFile& file, std::vector<Error>& faults) {
    return read_list(file, kGroupList, change_from, faults);
}

std::vector<GroupChange> kept_groups(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                     bool shipped, const settings::TomlReader& toml) {
    return changes_of(SideFile::peek_entries(world, data_folder, shipped, kGroupList, toml));
}

std::vector<GroupChange> groups_in(const std::string& side_file) {
    return changes_of(SideFile::entries_of_text(side_file, kGroupList));
}

void keep_group(SideFile& file, const GroupChange& change) {
    std::vector<Error> faults;
    std::vector<GroupChange> all = read_groups(file, faults);
    std::erase_if(all, [&](const GroupChange& other) { return other.name == change.name; });
    if (change.hidden || !change.material.empty() || !change.kept.empty()) all.push_back(change);
    write_list(file, kGroupList, all, group_entry, change_from);
}

Scene with_groups(Scene scene, const std::vector<GroupChange>& changes) {
    for (const GroupChange& change : changes)
        for (std::uint32_t i = 0; i < scene.groups.size(); ++i) {
            if (scene.groups[i].name != change.name) continue;
            scene.groups[i].hidden = change.hidden;
            if (!change.material.empty()) give_material_to_group(scene, i, *find_material(change.material));
        }
    return scene;
}

}  // namespace handrail::core
