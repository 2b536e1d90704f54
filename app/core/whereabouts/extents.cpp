#include "app/core/whereabouts/extents.h"

#include <algorithm>
#include <cmath>

#include "app/core/context/context_words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kLeastLength_m = 6.0, kLeastRatio = 3.0;
constexpr double kAtEnd_m = 1.5;  // an exit this near to the end of a corridor is at its end

bool runs_north(const navigation::Room& room) {
    const Vec3 size_m = room.bounds_m.size_m();
    return size_m.y > size_m.x;
}

// Returns the exit nearest to an end of the corridor, or "no exit". `end` is 0 for the west or south end, and 1 for the
// east or north end.
std::string end_words(const SessionContext& context, const navigation::RoomGraph& graph, std::uint32_t room, int end) {
    const navigation::Room& is = graph.rooms[room];
    const auto along_m = [north = runs_north(is)](const Vec3& at_m) { return north ? at_m.y : at_m.x; };
    const double end_m = along_m(end == 0 ? is.bounds_m.min_m : is.bounds_m.max_m);
    const navigation::Portal* nearest = nullptr;
    for (const navigation::Portal& portal : graph.portals) {
        if (portal.rooms[0] != room && (portal.rooms[1] != room || portal.one_way)) continue;
        const double off_m = std::abs(along_m(portal.place_m) - end_m);
        if (off_m <= kAtEnd_m && (!nearest || off_m < std::abs(along_m(nearest->place_m) - end_m))) nearest = &portal;
    }
    if (!nearest) return phrase("extent.no_exit");
    const std::string what = passage_name(context, nearest->kind, nearest->feature, 0.0),
                      to = graph.rooms[nearest->rooms[nearest->rooms[0] == room ? 1 : 0]].name;
    return sentence_case(to) == sentence_case(what) ? what : phrase("describe.exit_to", {{"exit", what}, {"room", to}});
}

}  // namespace

bool is_corridor(const navigation::Room& room) {
    if (room.kind != navigation::RoomKind::Room || room.bounds_m.empty()) return false;
    const Vec3 size_m = room.bounds_m.size_m();
    const double length_m = std::max(size_m.x, size_m.y), width_m = std::min(size_m.x, size_m.y);
    return length_m >= kLeastLength_m && length_m >= kLeastRatio * width_m;
}

std::string extent_words(const SessionContext& context, const Rooms& rooms, std::uint32_t room) {
    const navigation::RoomGraph& graph = rooms.graph();
    contract_pre(room < graph.rooms.size());
    const navigation::Room& is = graph.rooms[room];
    if (!is_corridor(is)) return {};
    const Vec3 size_m = is.bounds_m.size_m();
    const auto doors = std::count_if(graph.portals.begin(), graph.portals.end(), [&](const navigation::Portal& portal) {
        return portal.kind == navigation::PassageKind::Door && (portal.rooms[0] == room || portal.rooms[1] == room);
    });
    return phrase("extent.runs", {{"distance", distance_words(std::max(size_m.x, size_m.y), distances(context))},
                                  {"axis", runs_north(is) ? "north" : "east"},
                                  {"doors", static_cast<std::size_t>(doors)},
                                  {"first", end_words(context, graph, room, 0)},
                                  {"second", end_words(context, graph, room, 1)}});
}

}  // namespace handrail::core
