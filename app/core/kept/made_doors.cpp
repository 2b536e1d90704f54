#include "app/core/kept/made_doors.h"

#include <algorithm>
#include <optional>

namespace handrail::core {
namespace {

constexpr const char* kMendedTable = "mended";
constexpr const char* kDoorList = "door";
constexpr double kSameDoor_m = 0.01;
constexpr double kLeastWidth_m = 0.5, kMostWidth_m = 3.0, kMostThrough_m = 1.5;

std::vector<SideTable> door_tables(const SideEntry& table) {
    const auto found = table.find(kDoorList);
    const auto* doors = found == table.end() ? nullptr : std::get_if<std::vector<SideTable>>(&found->second);
    return doors ? *doors : std::vector<SideTable>{};
}

std::optional<MadeDoor> made_door_from(const SideEntry& entry) {
    const std::optional<Vec3> place = place_of(entry);
    MadeDoor door;
    door.heading_rad = radians_from_degrees(number_of(entry, "heading_deg", 0.0));
    door.width_m = number_of(entry, "width_m", door.width_m);
    door.through_m = number_of(entry, "through_m", door.through_m);
    door.name = text_of(entry, "between");
    if (!place || !is_finite(*place) || !(door.width_m >= kLeastWidth_m) || !(door.width_m <= kMostWidth_m) ||
        !(door.through_m >= 0.0) || !(door.through_m <= kMostThrough_m))
        return std::nullopt;
    door.place_m = *place;
    return door;
}

std::vector<MadeDoor> doors_of_table(const SideEntry& table) {
    std::vector<MadeDoor> doors;
    for (const SideTable& one : door_tables(table))
        if (auto door = made_door_from(one.entry)) doors.push_back(std::move(*door));
    return doors;
}

void write_doors(SideFile& file, std::vector<SideTable> doors) {
    SideEntry table = file.table(kMendedTable);
    if (doors.empty()) table.erase(kDoorList);
    else table[kDoorList] = std::move(doors);
    file.set_table(kMendedTable, table);
}

}  // namespace

std::vector<MadeDoor> read_made_doors(const SideFile& file) { return doors_of_table(file.table(kMendedTable)); }

std::vector<MadeDoor> kept_doors(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                 bool shipped, const settings::TomlReader& toml) {
    return doors_of_table(SideFile::peek(world, data_folder, shipped, kMendedTable, toml));
}

std::vector<MadeDoor> made_doors_in(const std::string& side_file) {
    return doors_of_table(SideFile::table_of_text(side_file, kMendedTable));
}

void keep_made_door(SideFile& file, const MadeDoor& door) {
    std::vector<SideTable> doors = door_tables(file.table(kMendedTable));
    SideTable one;
    put_place(one.entry, door.place_m);
    one.entry["heading_deg"] = degrees_from_radians(door.heading_rad);
    one.entry["width_m"] = door.width_m;
    one.entry["through_m"] = door.through_m;
    one.entry["between"] = door.name;
    doors.push_back(std::move(one));
    write_doors(file, std::move(doors));
}

void drop_made_door(SideFile& file, const Vec3& place_m) {
    std::vector<SideTable> doors = door_tables(file.table(kMendedTable));
    std::erase_if(doors, [&](const SideTable& one) {
        const auto place = place_of(one.entry);
        return place && glm::length(*place - place_m) < kSameDoor_m;
    });
    write_doors(file, std::move(doors));
}

}  // namespace handrail::core
