// Which rooms of a world nobody comes to on foot from its base: walled in, or beyond what the map's doors, lifts and
// teleporters join. A look over the finished graph; pure function; any thread.
#pragma once

#include <string>
#include <vector>

#include "worlds/navigation/rooms.h"

namespace handrail {

// Their names as they are told, each once, in the order of the graph; locked doors count as ways. Liquids do not count,
// niches and what is smaller than a square metre only where the map names them; a name of the map in whose place nobody
// can stand counts too. Nothing where nobody can stand at the base.
std::vector<std::string> unreachable_rooms(const Scene& scene, const WalkSpace& space, const RoomGraph& graph);

// "Vault cannot be reached on foot."; empty where there is none. The first few by name.
std::string unreachable_words(const std::vector<std::string>& names);

}  // namespace handrail
