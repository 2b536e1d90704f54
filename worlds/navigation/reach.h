// Finds the rooms of a world that nobody can reach on foot from its base: walled in, or beyond everything that doors,
// lifts and teleporters connect. Works on the finished graph; pure functions; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail::navigation {

// The start at the base; null if the scene has no base.
const Start* base_of(const Scene& scene);

// For each span, the spans to which a drop, a lift or a teleporter leads from it.
std::vector<std::vector<std::uint32_t>> spans_led_to(const WalkSpace& space);
// The spans that can be reached from this one on foot and over such links, including itself.
std::vector<bool> spans_reached(const WalkSpace& space, std::uint32_t first);

// The end of a route to a room: its middle or, if that cannot be reached from `from_m`, the nearest place of the room
// that can. The middle if there is none.
Vec3 goal_in_room(const Navigation& navigation, const RoomGraph& graph, std::uint32_t room, const Vec3& from_m);

struct RoomOutOfReach {
    std::string name;  // as it is announced
    // Index in the graph. kNothing: the map names a place where nobody can stand.
    std::uint32_t room = kNothing;
    Vec3 at_m{0.0};
};
// All rooms out of reach, first in the order of the graph, then of the map's names. See unreachable_rooms for which
// rooms count.
std::vector<RoomOutOfReach> rooms_out_of_reach(const Scene& scene, const WalkSpace& space, const RoomGraph& graph);

// The names of the rooms out of reach as they are announced, each once, in the order of the graph. Locked doors count
// as passable. Liquids do not count. Niches, and rooms smaller than a square metre, count only if the map names them.
// Names of the map count too if nobody can stand in their place. Empty if nobody can stand at the base.
std::vector<std::string> unreachable_rooms(const Scene& scene, const WalkSpace& space, const RoomGraph& graph);

// "Vault cannot be reached on foot." Lists the first few by name; empty if there is none.
std::string unreachable_words(const std::vector<std::string>& names);

}  // namespace handrail::navigation
