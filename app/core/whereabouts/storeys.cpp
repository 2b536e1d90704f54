#include "app/core/whereabouts/storeys.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/core/dialogue/words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/scene/stated_building.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

bool is_room_of_storey(const Scene& scene, const navigation::Room& room) {
    if (scene.stated && !scene.stated->rooms.empty()) return !room.map_name.empty();
    return room.kind == navigation::RoomKind::Room;
}

}  // namespace

std::vector<StoreyOfRooms> storeys_of(const Scene& scene, const navigation::RoomGraph& graph) {
    std::map<int, StoreyOfRooms> by_level;
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r)
        if (is_room_of_storey(scene, graph.rooms[r])) by_level[graph.rooms[r].level].rooms.push_back(r);
    std::vector<StoreyOfRooms> storeys;
    for (auto& [level, storey] : by_level) {
        std::vector<double> floors;
        for (const std::uint32_t r : storey.rooms) floors.push_back(graph.rooms[r].floor_m);
        const auto middle = floors.begin() + static_cast<std::ptrdiff_t>(floors.size() / 2);
        std::nth_element(floors.begin(), middle, floors.end());
        storey.level = level;
        storey.floor_m = *middle;
        if (scene.stated) storey.file_name = stated_storey_around(*scene.stated, storey.floor_m);
        // If the file has the same name for two successive storeys, only the lower storey gets it.
        if (!storeys.empty() && storeys.back().file_name == storey.file_name) storey.file_name.clear();
        storeys.push_back(std::move(storey));
    }
    return storeys;
}

std::size_t storey_of_room(const std::vector<StoreyOfRooms>& storeys, const navigation::RoomGraph& graph,
                           std::uint32_t room) {
    if (room >= graph.rooms.size()) return storeys.size();
    const auto found = std::find_if(storeys.begin(), storeys.end(), [&](const StoreyOfRooms& storey) {
        return storey.level == graph.rooms[room].level;
    });
    return static_cast<std::size_t>(found - storeys.begin());
}

int storeys_up(const Scene& scene, const navigation::RoomGraph& graph, std::uint32_t from, std::uint32_t to) {
    const std::vector<StoreyOfRooms> storeys = storeys_of(scene, graph);
    const std::size_t own = storey_of_room(storeys, graph, from), other = storey_of_room(storeys, graph, to);
    if (own >= storeys.size() || other >= storeys.size()) return 0;
    return static_cast<int>(other) - static_cast<int>(own);
}

std::string storey_name(const std::vector<StoreyOfRooms>& storeys, std::size_t which) {
    contract_pre(which < storeys.size());
    if (!storeys[which].file_name.empty()) return sentence_case(storeys[which].file_name);
    return phrase("storeys.numbered", {{"number", which + 1}});
}

std::vector<std::vector<std::string>> kinds_of_rooms(const Scene& scene, const navigation::RoomGraph& graph) {
    const std::vector<StoreyOfRooms> storeys = storeys_of(scene, graph);
    std::vector<std::vector<std::string>> kinds;
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r) {
        const navigation::Room& room = graph.rooms[r];
        const bool named = room.given || !room.map_name.empty() || !room.made.thing.empty();
        kinds.push_back({phrase(room.is_way                                 ? "kinds.ways"
                                : room.kind == navigation::RoomKind::Stairs ? "kinds.stairs"
                                : room.kind == navigation::RoomKind::Liquid ? "kinds.water"
                                : named                                     ? "kinds.rooms"
                                                                            : "kinds.nameless")});
        const std::size_t storey = storey_of_room(storeys, graph, r);
        if (storeys.size() > 1)
            kinds.back().push_back(storey < storeys.size() ? storey_name(storeys, storey)
                                                           : phrase("kinds.between_storeys"));
    }
    return kinds;
}

std::string storey_sentence(const Scene& scene, const std::vector<StoreyOfRooms>& storeys, std::size_t which) {
    contract_pre(which < storeys.size());
    const StoreyOfRooms& storey = storeys[which];
    return phrase("storeys.entered", {{"world", sentence_case(spoken_name(scene))},
                                      {"named", storey.file_name.empty() ? "no" : "yes"},
                                      {"storey", storey.file_name},
                                      {"number", which + 1},
                                      {"count", storeys.size()},
                                      {"rooms", storey.rooms.size()}});
}

}  // namespace handrail::core
