// Finds the rooms of a world that nobody can reach on foot from its base. Such rooms are walled in, or no door, lift or
// teleporter connects them with the base. The functions use the finished room graph. Pure functions; any thread may
// call them.
#pragma once

#include <string>
#include <vector>

#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail::navigation {

// Returns the start that is the base; null if the scene has no base.
const Start* base_of(const Scene& scene);

// Returns, for each span, the spans to which a drop, a lift or a teleporter leads from it.
std::vector<std::vector<std::uint32_t>> spans_led_to(const WalkSpace& space);
// Returns, for each span, whether a walker can get there from span `first` on foot and by drops, lifts and teleporters.
// True for `first` itself.
std::vector<bool> spans_reached(const WalkSpace& space, std::uint32_t first);

// Returns the end of a route to a room. This is the middle of the room if it can be reached from `from_m`, otherwise
// the nearest place in the room that can. If no place in the room can be reached, it is the middle.
Vec3 goal_in_room(const Navigation& navigation, const RoomGraph& graph, std::uint32_t room, const Vec3& from_m);

struct RoomOutOfReach {
    std::string name;  // the name that the program announces
    // Index of the room in the graph. kNothing: the map names a place where nobody can stand.
    std::uint32_t room = kNothing;
    Vec3 at_m{0.0};
};
// Returns all rooms out of reach, first those of the graph in its order, then those that only the map names. It leaves
// out the same rooms as unreachable_rooms.
std::vector<RoomOutOfReach> rooms_out_of_reach(const Scene& scene, const WalkSpace& space, const RoomGraph& graph);

// Returns the names of the rooms out of reach as the program announces them, each once, in the order of the graph.
// Locked doors are passable for this purpose. Liquids are left out. Niches, and rooms smaller than a square metre, are
// included only if the map names them. If the map names a place where nobody can stand, that name is included too.
// Empty if nobody can stand at the base.
std::vector<std::string> unreachable_rooms(const Scene& scene, const WalkSpace& space, const RoomGraph& graph);

// Returns a sentence such as "Vault cannot be reached on foot." It lists the first few names. Empty if `names` is
// empty.
std::string unreachable_words(const std::vector<std::string>& names);

}  // namespace handrail::navigation
