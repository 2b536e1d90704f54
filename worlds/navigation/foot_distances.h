// Walking distances from one place to many others in a building. They run from doorway to doorway, in a straight line
// within each room. Plain values, world metres; any thread may use it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "worlds/navigation/rooms.h"

namespace handrail::navigation {

class FootDistances {
public:
    // Computes distances from `feet_m`, which is in `room`; kNothing: in no room, so nothing is reached. A stretch
    // between two storeys includes its rise. The time grows with the square of the doorways in a room. By Dijkstra,
    // 1959.
    FootDistances(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m);
    // Distance to a place in `room`, never longer than the shortest route made of straight stretches. Nothing if no
    // route is known.
    std::optional<double> to(std::uint32_t room, const Vec3& place_m) const;
    // Distance to a doorway, by index in RoomGraph::portals. Nothing if no route is known.
    std::optional<double> to_portal(std::uint32_t portal) const;

private:
    std::vector<Portal> portals_;
    std::uint32_t room_;
    Vec3 feet_m_;
    std::vector<std::vector<std::uint32_t>> portals_of_;  // of each room
    std::vector<double> portal_m_;                        // distance to each portal; infinity: not reached
};

}  // namespace handrail::navigation
