#include "app/core/kept/room_names.h"

#include <algorithm>

#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr const char* kRoomNameTable = "room_name";

Result<RoomNameGiven> name_from(const SideEntry& entry) {
    return named_place_of(entry, "room_names.entry_name", "room_names.entry_place").map([&](NamedPlace named) {
        return RoomNameGiven{
            std::move(named.name),   named.place_m, std::max(0.0, number_of(entry, "area_m2", 0.0)),
            text_of(entry, "world"), true,          without(entry, {"name", "place_m", "area_m2", "world"})};
    });
}

SideEntry name_entry(const RoomNameGiven& given) {
    SideEntry entry = given.kept;
    entry["name"] = given.name;
    put_place(entry, given.at_m);
    if (given.area_m2 > 0.0) entry["area_m2"] = given.area_m2;
    if (!given.world.empty()) entry["world"] = given.world;
    return entry;
}

}  // namespace

std::vector<RoomNameGiven> read_room_names(const SideFile& file, std::vector<Error>& faults) {
    return read_list(file, kRoomNameTable, name_from, faults);
}

void write_room_names(SideFile& file, const std::vector<RoomNameGiven>& names) {
    write_list(file, kRoomNameTable, names, name_entry, name_from);
}

void lay_room_names(navigation::RoomGraph& graph, const navigation::WalkSpace& space, const SideFile& file,
                    std::vector<RoomNameGiven>& names) {
    std::vector<bool> taken(graph.rooms.size(), false);
    for (RoomNameGiven& given : names) {
        const std::uint32_t at = navigation::room_at(graph, space, given.at_m);
        given.fits = at != navigation::kNothing && !taken[at];
        if (given.fits && given.world != file.world_checksum() && given.area_m2 > 0.0) {
            const double now = graph.rooms[at].area_m2;
            given.fits = now <= kSameRoomArea * given.area_m2 && given.area_m2 <= kSameRoomArea * now;
        }
        if (!given.fits) continue;
        taken[at] = true;
        navigation::give_names(graph, space, {{given.at_m, given.name}});
    }
}

std::string unfit_sentence(const std::vector<RoomNameGiven>& names) {
    std::vector<std::string> unfit;
    for (const RoomNameGiven& given : names)
        if (!given.fits) unfit.push_back(given.name);
    return unfit_words("room_names.unfit", unfit, names.size());
}

std::uint32_t name_of_room(const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                           const std::vector<RoomNameGiven>& names, std::uint32_t room) {
    for (std::uint32_t i = 0; i < names.size(); ++i)
        if (names[i].fits && navigation::room_at(graph, space, names[i].at_m) == room) return i;
    return navigation::kNothing;
}

}  // namespace handrail::core
