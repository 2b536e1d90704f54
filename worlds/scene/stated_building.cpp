#include "worlds/scene/stated_building.h"

#include <algorithm>

#include "worlds/geometry/exposed_surface.h"

namespace handrail {

bool holds(const StatedRoom& room, const Vec3& at_m) {
    constexpr double kStep_m = 0.35;
    if (at_m.z < room.floor_m - kStep_m || at_m.z > room.floor_m + room.height_m) return false;
    bool inside = false;
    for (const std::vector<Vec2>& ring : room.rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Vec2 &a = ring[i], &b = ring[j];
            if ((a.y > at_m.y) != (b.y > at_m.y) && at_m.x < (b.x - a.x) * (at_m.y - a.y) / (b.y - a.y) + a.x)
                inside = !inside;
        }
    return inside;
}

bool is_oddly_named(const StatedRoom& room) {
    return room.holds_stairs && room.name.find("tair") == std::string::npos &&
           room.name.find("repp") == std::string::npos;
}

int largest_connected(const StatedBuilding& building) {
    DisjointSets groups(building.rooms.size());
    for (const StatedPortal& portal : building.portals)
        for (std::size_t i = 1; i < portal.rooms.size(); ++i) groups.join(portal.rooms[0], portal.rooms[i]);
    std::vector<int> size(building.rooms.size(), 0);
    int most = 0;
    for (std::uint32_t r = 0; r < size.size(); ++r) most = std::max(most, ++size[groups.find(r)]);
    return most;
}

}  // namespace handrail
