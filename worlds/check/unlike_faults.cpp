#include <algorithm>

#include "worlds/base/language.h"
#include "worlds/check/examined.h"
#include "worlds/scene/stated_building.h"

namespace handrail::check {
namespace {

// Greatest distance from the file's position of a room to a place where a person can stand in it.
constexpr double kSamePlace_m = 0.6;

// True if a person can walk between the rooms, directly or through one flight or corner between them.
bool joined_on_foot(const navigation::RoomGraph& graph, std::uint32_t a, std::uint32_t b) {
    const auto beside = [&](std::uint32_t room) {
        std::vector<std::uint32_t> others;
        for (const navigation::Portal& portal : graph.portals)
            if (portal.rooms[0] == room || portal.rooms[1] == room)
                others.push_back(portal.rooms[0] == room ? portal.rooms[1] : portal.rooms[0]);
        return others;
    };
    for (const std::uint32_t other : beside(a)) {
        if (other == b) return true;
        if (graph.rooms[other].kind == navigation::RoomKind::Room) continue;
        const std::vector<std::uint32_t> further = beside(other);
        if (std::find(further.begin(), further.end(), b) != further.end()) return true;
    }
    return false;
}

}  // namespace

// Finds doors and openings that the file states between two rooms and that a body can pass, although no route leads
// there from one room to the other. Stairs and rooms with stairs are left out, because Handrail divides them into rooms
// differently from the file.
void find_unlike_faults(const Examined& world, std::vector<WorldFault>& faults) {
    if (!world.scene.stated || !world.space) return;
    const StatedBuilding& stated = *world.scene.stated;
    std::vector<std::uint32_t> found;  // indexed by stated room: the room of the graph that corresponds to it
    for (const StatedRoom& room : stated.rooms) {
        const std::uint32_t span = world.space->nearest(room.at_m, kSamePlace_m, kSamePlace_m, kSamePlace_m);
        found.push_back(span == navigation::kNothing ? navigation::kNothing : world.graph->room_of_span[span]);
    }
    for (const StatedPortal& portal : stated.portals) {
        if (portal.kind != StatedPortalKind::Door && portal.kind != StatedPortalKind::Opening) continue;
        if (portal.rooms.size() != 2 || !portal.passable) continue;
        const StatedRoom &one = stated.rooms[portal.rooms[0]], &other = stated.rooms[portal.rooms[1]];
        const std::uint32_t a = found[portal.rooms[0]], b = found[portal.rooms[1]];
        if (one.holds_stairs || other.holds_stairs || a == navigation::kNothing || b == navigation::kNothing ||
            a == b || joined_on_foot(*world.graph, a, b))
            continue;
        WorldFault fault{FaultKind::UnlikeFile, portal.place_m, portal.source};
        fault.feature = portal.feature;
        fault.name = one.name.empty() ? one.number : one.name;
        fault.other = other.name.empty() ? other.number : other.name;
        fault.room = a;
        faults.push_back(std::move(fault));
    }
}

}  // namespace handrail::check
