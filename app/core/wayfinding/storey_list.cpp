#include "app/core/wayfinding/storey_list.h"

#include <algorithm>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/whereabouts/storeys.h"
#include "worlds/base/language.h"
#include "worlds/navigation/foot_distances.h"

namespace handrail::core {
namespace {

constexpr std::size_t kMostRoomsNamed = 8;
constexpr double kUnreached_m = 1e6;  // a distance larger than any distance on foot

// Returns "You are on Level 1. Its rooms: hall, kitchen and 3 more."
std::string own_storey_words(const navigation::RoomGraph& graph, const std::vector<StoreyOfRooms>& storeys,
                             std::size_t own) {
    std::string names;
    const std::vector<std::uint32_t>& rooms = storeys[own].rooms;
    for (std::size_t i = 0; i < std::min(kMostRoomsNamed, rooms.size()); ++i)
        names = joined(names, graph.rooms[rooms[i]].name);
    if (rooms.size() > kMostRoomsNamed)
        names = phrase("overview.and_more", {{"names", names}, {"more", rooms.size() - kMostRoomsNamed}});
    return phrase("storeys.here", {{"storey", storey_name(storeys, own)}, {"names", names}, {"count", rooms.size()}});
}

std::uint32_t nearest_room_of(const navigation::RoomGraph& graph, const std::vector<std::uint32_t>& among,
                              std::uint32_t here, const Vec3& feet_m) {
    const navigation::FootDistances on_foot(graph, here, feet_m);
    std::uint32_t nearest = among.front();
    double nearest_m = 1e300;
    for (const std::uint32_t room : among) {
        const Vec3& middle_m = graph.rooms[room].middle_m;
        const double far_m = on_foot.to(room, middle_m).value_or(kUnreached_m + glm::length(middle_m - feet_m));
        if (far_m < nearest_m) {
            nearest_m = far_m;
            nearest = room;
        }
    }
    return nearest;
}

}  // namespace

void open_storey_list(const SessionContext& context, Rooms& rooms, Doors& doors,
                      std::function<void(std::uint32_t room, double now_s)> to_room, double now_s) {
    if (!rooms.have(now_s)) return;
    const std::vector<StoreyOfRooms> storeys = storeys_of(*rooms.file_scene(), rooms.graph());
    if (storeys.empty()) return context.answer(phrase("rooms.nowhere"), now_s);
    const std::size_t own = storey_of_room(storeys, rooms.graph(), rooms.here());
    ListSpec list;
    list.title = phrase("storeys.title");
    for (std::size_t s = 0; s < storeys.size(); ++s) {
        const std::string count = phrase("overview.rooms", {{"rooms", storeys[s].rooms.size()}});
        list.items.push_back(
            {storey_name(storeys, s), s == own ? joined(count, phrase("describe.here")) : count, false});
    }
    list.at = own < storeys.size() ? own : 0;
    list.chosen = [&context, &rooms, &doors, to_room = std::move(to_room), storeys](std::size_t which) {
        const double then_s = context.tick_s;
        if (!rooms.found()) return;
        const navigation::RoomGraph& graph = rooms.graph();
        if (doors.ride_to(storeys[which].floor_m, storey_name(storeys, which), then_s)) return;
        if (which == storey_of_room(storeys, graph, rooms.here()))
            return context.answer(own_storey_words(graph, storeys, which), then_s);
        to_room(nearest_room_of(graph, storeys[which].rooms, rooms.here(), context.avatar.feet_m()), then_s);
    };
    context.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
