#include "worlds/navigation/stated_rooms.h"

#include <algorithm>
#include <cmath>

namespace handrail::navigation {

template <class Span>
std::vector<std::uint32_t> stated_rooms_of(const StatedBuilding& stated, const SpanGrid<Span>& grid) {
    std::vector<std::uint32_t> room_of(grid.spans.size(), kNothing);
    if (grid.width == 0 || grid.depth == 0) return room_of;
    for (std::uint32_t r = 0; r < stated.rooms.size(); ++r) {
        const StatedRoom& room = stated.rooms[r];
        Vec2 least{1e300}, most{-1e300};
        for (const std::vector<Vec2>& ring : room.rings)
            for (const Vec2& p : ring) least = glm::min(least, p), most = glm::max(most, p);
        const auto cell = [&](double at, double origin, std::uint32_t count) {
            return static_cast<std::uint32_t>(
                std::clamp(std::floor((at - origin) / grid.cell_m), 0.0, static_cast<double>(count) - 1.0));
        };
        if (room.rings.empty()) continue;
        for (std::uint32_t y = cell(least.y, grid.origin_m.y, grid.depth);
             y <= cell(most.y, grid.origin_m.y, grid.depth); ++y)
            for (std::uint32_t x = cell(least.x, grid.origin_m.x, grid.width);
                 x <= cell(most.x, grid.origin_m.x, grid.width); ++x) {
                const std::uint32_t at = y * grid.width + x;
                for (std::uint32_t s = grid.first[at]; s < grid.first[at + 1]; ++s)
                    if (room_of[s] == kNothing && holds(room, grid.place_m(s))) room_of[s] = r;
            }
    }
    return room_of;
}

const StatedRoom* stated_room_at(const Scene& scene, const Vec3& at_m) {
    if (!scene.stated) return nullptr;
    const std::vector<StatedRoom>& rooms = scene.stated->rooms;
    const auto found =
        std::find_if(rooms.begin(), rooms.end(), [&](const StatedRoom& room) { return holds(room, at_m); });
    return found == rooms.end() ? nullptr : &*found;
}

template std::vector<std::uint32_t> stated_rooms_of(const StatedBuilding&, const SpanGrid<WalkSpan>&);
template std::vector<std::uint32_t> stated_rooms_of(const StatedBuilding&, const SpanGrid<WallSpan>&);

}  // namespace handrail::navigation
