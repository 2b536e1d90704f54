#include "app/main/start_place.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/dialogue.h"
#include "app/core/dialogue/words.h"
#include "app/core/kept/marks.h"
#include "app/core/kept/room_names.h"
#include "app/core/wayfinding/finding.h"
#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/walker.h"
#include "app/main/world_files.h"
#include "worlds/base/executor.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

constexpr std::size_t kMostNear = 3;         // similar names in the sentence about an unknown place
constexpr std::size_t kLargestLink = 65536;  // bytes; a link has two lines

struct FoundPlace {
    std::string name;
    Vec3 place_m{0.0};
};

// Names of places of one kind. The names are hidden entries, because nobody has seen the list, so a number is no
// number of an entry.
struct Names {
    core::ListSpec list;
    std::vector<Vec3> places_m;

    void add(std::string name, const Vec3& place_m) {
        list.hidden.push_back({std::move(name), {}});
        places_m.push_back(place_m);
    }
    FoundPlace entry(std::size_t i) const { return {list.hidden[i].name, places_m[i]}; }
};

Names rooms_in(const navigation::RoomGraph& graph) {
    Names rooms;
    for (const navigation::Room& room : graph.rooms) rooms.add(core::sentence_case(room.name), room.middle_m);
    return rooms;
}

Names things_in(const Scene& scene, const core::SideFile& additions) {
    Names things;
    std::vector<Error> faults;  // the session announces the same faults when it enters the world
    for (const core::Mark& mark : core::read_marks(additions, faults)) things.add(mark.name, mark.place_m);
    for (const Start& start : scene.starts)
        if (!start.name.empty()) things.add(core::sentence_case(start.name), start.feet_m);
    for (const core::NamedThing& thing : core::named_things(scene))
        things.add(core::sentence_case(thing.name), thing.bounds_m.centre_m());
    return things;
}

// Chooses as Session::choose does: a room with the complete name, else a thing with the complete name, else what begins
// with the name.
std::optional<FoundPlace> place_called(const Names& rooms, const Names& things, const std::string& name) {
    const auto room = core::entry_called(rooms.list, name), thing = core::entry_called(things.list, name);
    if (room && (core::is_called(rooms.list, *room, name) || !thing || !core::is_called(things.list, *thing, name)))
        return rooms.entry(*room);
    if (thing) return things.entry(*thing);
    return std::nullopt;
}

Error unknown_place(const Names& rooms, const Names& things, const std::string& name) {
    std::vector<std::string> names, near;
    for (const Names* each : {&rooms, &things})
        for (const core::ListItem& item : each->list.hidden)
            if (std::find(names.begin(), names.end(), item.name) == names.end()) names.push_back(item.name);
    while (near.size() < kMostNear && !names.empty()) {
        near.push_back(nearest_name(name, names));
        std::erase(names, near.back());
    }
    const auto at = [&](std::size_t i) { return i < near.size() ? near[i] : std::string(); };
    return {{},
            0,
            0,
            phrase("program.no_place",
                   {{"name", name}, {"count", near.size()}, {"first", at(0)}, {"second", at(1)}, {"third", at(2)}})};
}

}  // namespace

Result<core::Placed> start_place(const std::shared_ptr<const Scene>& scene, const WantedStart& wanted,
                                 const core::SideFile& additions, double heading_rad, core::RoutesKeeper keeper) {
    const core::WalkerSize size = core::walker_size(*scene, wanted.body_radius_m);
    core::RoomsOfWorld found(scene, navigation::walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m),
                             at_once(), std::move(keeper));
    Names rooms;
    if (found.ready() && found.found()) {
        std::vector<Error> faults;
        std::vector<core::RoomNameGiven> given = core::read_room_names(additions, faults);
        core::lay_room_names(found.graph(), found.navigation().space(), additions, given);
        rooms = rooms_in(found.graph());
    }
    const Names things = things_in(*scene, additions);
    std::optional<FoundPlace> place = place_called(rooms, things, wanted.name);
    if (!place) return tl::unexpected(unknown_place(rooms, things, wanted.name));
    const auto floor_m = found.found() ? found.navigation().nearest_place(place->place_m) : std::nullopt;
    return core::Placed{floor_m.value_or(place->place_m), heading_rad, std::move(place->name)};
}

Result<PlaceLink> read_link(const std::filesystem::path& file, const settings::TomlReader& toml) {
    const std::string name = file.filename().string();
    const auto text = read_whole_file(file, kLargestLink);
    if (!text) return tl::unexpected(text.error());
    const Result<settings::TomlValue> table = toml(*text);
    if (!table) return fail(table.error().message, name, table.error().line, table.error().column);
    const settings::TomlValue* world = table->find("world");
    const settings::TomlValue* place = table->find("place");
    if (!world || !world->text() || world->text()->empty() || (place && !place->text()))
        return fail(phrase("program.link_needs"), name);
    PlaceLink link{*world->text(), place ? *place->text() : std::string()};
    // A name of a shipped world has neither folder nor extension. Everything else is a path from the link's folder.
    if (link.world.has_parent_path() || link.world.has_extension()) {
        link.world = file.parent_path() / link.world;
    } else {
        Result<std::filesystem::path> named = world_given(link.world);
        if (!named) return fail(named.error().message, name, world->line);
        link.world = std::move(*named);
    }
    return link;
}

}  // namespace handrail::program
