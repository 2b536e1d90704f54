// Which rooms of a world nobody comes to on foot from its base: walled in, or beyond what the map's doors, lifts and
// teleporters join. A look over the finished graph; pure function; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail {

// Where one begins; null: the scene has no base.
const Start* base_of(const Scene& scene);

// Of each span those to which a drop, a lift or a teleporter leads from it.
std::vector<std::vector<std::uint32_t>> spans_led_to(const WalkSpace& space);
// The spans one comes to from this one on foot and by such links; itself among them.
std::vector<bool> spans_reached(const WalkSpace& space, std::uint32_t first);

// Where a route to a room leads: to the room's middle, or, if nobody comes there from that place, to the nearest place
// of the room that one does come to. The middle if there is none.
Vec3 goal_in_room(const Navigation& navigation, const RoomGraph& graph, std::uint32_t room, const Vec3& from_m);

struct RoomOutOfReach {
    std::string name;               // as it is told
    std::uint32_t room = kNothing;  // of the graph; kNothing: the map names a place where nobody can stand
    Vec3 at_m{0.0};
};
// Each of them, in the order of the graph, then of the map's names; see unreachable_rooms for which count.
std::vector<RoomOutOfReach> rooms_out_of_reach(const Scene& scene, const WalkSpace& space, const RoomGraph& graph);

// Their names as they are told, each once, in the order of the graph; locked doors count as ways. Liquids do not count,
// niches and what is smaller than a square metre only where the map names them; a name of the map in whose place nobody
// can stand counts too. Nothing where nobody can stand at the base.
std::vector<std::string> unreachable_rooms(const Scene& scene, const WalkSpace& space, const RoomGraph& graph);

// "Vault cannot be reached on foot."; empty where there is none. The first few by name.
std::string unreachable_words(const std::vector<std::string>& names);

}  // namespace handrail
