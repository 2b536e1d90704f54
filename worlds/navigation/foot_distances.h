// How far the places of a building are on foot, told of many at once: from doorway to doorway through the rooms,
// straight within each. Plain values, world metres, any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "worlds/navigation/rooms.h"

namespace handrail {

class FootDistances {
public:
    // From feet_m, which is in `room`; kNothing: in none, and nothing is known to be reached. A stretch between two
    // storeys counts with its rise. Time grows with the square of a room's doorways. By Dijkstra, 1959.
    FootDistances(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m);
    // To that place in `room`, never longer than the shortest way of straight stretches; none: no way is known.
    std::optional<double> to(std::uint32_t room, const Vec3& place_m) const;
    // To a doorway, a number of RoomGraph::portals; none: no way is known.
    std::optional<double> to_portal(std::uint32_t portal) const;

private:
    std::vector<Portal> portals_;
    std::uint32_t room_;
    Vec3 feet_m_;
    std::vector<std::vector<std::uint32_t>> portals_of_;  // of each room
    std::vector<double> portal_m_;                        // to each portal; infinity: not reached
};

}  // namespace handrail
