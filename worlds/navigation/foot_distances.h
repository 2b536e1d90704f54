// Computes walking distances from one place to many others in a building. The assumed routes run from doorway to
// doorway, in a straight line within each room. Plain values in world metres. Any thread may use them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "worlds/navigation/rooms.h"

namespace handrail::navigation {

class FootDistances {
public:
    // Computes distances from `feet_m`, which is in `room`. If `room` is kNothing, nothing can be reached. A straight
    // line between two storeys includes its rise. The time grows with the square of the number of doorways in a room.
    // Uses Dijkstra's algorithm of 1959.
    FootDistances(const RoomGraph& graph, std::uint32_t room, const Vec3& feet_m);
    // Returns the distance to a place in `room`. It is never longer than the shortest route made of straight stretches.
    // Returns nothing if no route is known.
    std::optional<double> to(std::uint32_t room, const Vec3& place_m) const;
    // Returns the distance to the doorway with this index in RoomGraph::portals. Returns nothing if no route is known.
    std::optional<double> to_portal(std::uint32_t portal) const;
    // Returns the portals on the shortest of these routes to a place in `room`, in order: indices in
    // RoomGraph::portals. Returns nothing if no route is known.
    std::vector<std::uint32_t> portals_to(std::uint32_t room, const Vec3& place_m) const;

private:
    std::vector<Portal> portals_;
    std::uint32_t room_;
    Vec3 feet_m_;
    std::vector<std::vector<std::uint32_t>> portals_of_;  // for each room: the indices of its portals
    std::vector<double> portal_m_;                        // distance to each portal; infinity: not reached
    std::vector<std::uint32_t> before_;                   // for each portal: the portal before it; kNothing: none
};

}  // namespace handrail::navigation
