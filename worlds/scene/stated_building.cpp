#include "worlds/scene/stated_building.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "worlds/base/text.h"
#include "worlds/geometry/exposed_surface.h"

namespace handrail {

bool holds(const StatedRoom& room, const Vec3& at_m) {
    // A place is in the room from this far below its floor to this far below its ceiling, so that a room as high as its
    // storey does not contain the floor above.
    constexpr double kStep_m = 0.35;
    const double top_m = room.floor_m + std::max(0.5 * room.height_m, room.height_m - kStep_m);
    if (at_m.z < room.floor_m - kStep_m || at_m.z >= top_m) return false;
    bool inside = false;
    for (const std::vector<Vec2>& ring : room.rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Vec2 &a = ring[i], &b = ring[j];
            if ((a.y > at_m.y) != (b.y > at_m.y) && at_m.x < (b.x - a.x) * (at_m.y - a.y) / (b.y - a.y) + a.x)
                inside = !inside;
        }
    return inside;
}

std::string stated_storey_name(const StatedBuilding& building, double floor_m) {
    // The floors of one storey's rooms may differ in height by a few steps.
    constexpr double kSameFloor_m = 0.6;
    std::string name;
    double nearest_m = kSameFloor_m;
    for (const StatedStorey& storey : building.storeys)
        if (const double off_m = std::abs(storey.floor_m - floor_m); storey.rooms > 0 && off_m < nearest_m) {
            nearest_m = off_m;
            name = one_line(storey.name);
        }
    return name;
}

std::string stated_storey_around(const StatedBuilding& building, double floor_m) {
    if (std::string name = stated_storey_name(building, floor_m); !name.empty()) return name;
    const StatedStorey* around = nullptr;
    for (const StatedStorey& storey : building.storeys)
        if (storey.rooms > 0 && (!around || storey.floor_m <= floor_m)) around = &storey;
    return around ? one_line(around->name) : std::string();
}

Vec2 outline_size_m(const StatedRoom& room) {
    const std::vector<Vec2>& ring = room.rings.front();
    Vec2 size(0.0);
    double least_m2 = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        Vec2 along = ring[i] - ring[j];
        if (glm::length(along) < 1e-6) continue;
        along = along / glm::length(along);
        // Chooses the side of the rectangle that runs more from west to east.
        if (std::abs(along.y) > std::abs(along.x)) along = Vec2(along.y, -along.x);
        Vec2 from(std::numeric_limits<double>::infinity()), to(-std::numeric_limits<double>::infinity());
        for (const Vec2& p : ring) {
            const Vec2 at(glm::dot(p, along), p.y * along.x - p.x * along.y);
            from = glm::min(from, at), to = glm::max(to, at);
        }
        const Vec2 here = to - from;
        if (here.x * here.y >= least_m2 - 1e-9) continue;
        least_m2 = here.x * here.y;
        size = here;
    }
    return size;
}

bool is_oddly_named(const StatedRoom& room) {
    return room.holds_stairs && room.name.find("tair") == std::string::npos &&
           room.name.find("repp") == std::string::npos;
}

int largest_connected(const StatedBuilding& building) {
    const auto outside = static_cast<std::uint32_t>(building.rooms.size());
    DisjointSets groups(building.rooms.size() + 1);
    for (const StatedPortal& portal : building.portals) {
        for (std::size_t i = 1; i < portal.rooms.size(); ++i) groups.join(portal.rooms[0], portal.rooms[i]);
        if (portal.outside && portal.passable && !portal.rooms.empty()) groups.join(portal.rooms[0], outside);
    }
    std::vector<int> size(building.rooms.size(), 0);
    int most = 0;
    for (std::uint32_t r = 0; r < size.size(); ++r) most = std::max(most, ++size[groups.find(r)]);
    return most;
}

}  // namespace handrail
