#include "worlds/drawn/guess_doorways.h"

#include <algorithm>

#include "worlds/drawn/upright.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail {
namespace {

constexpr double kBesideRoom_m = 0.3, kLeastDoorway_m = 0.9, kStretch_m = 0.3, kLongestEdge_m = 20'000.0;

struct Doorway {
    Vec2 at{0.0};
    double length_m = 0.0;
    std::size_t corridor = 0;
};

// Keeps the longest stretch of the edge that has the corridor next to it.
void look_along(const FloorPlan& plan, const Vec2& from, const Vec2& to, std::size_t corridor, Doorway& best) {
    const double length_m = glm::length(to - from);
    if (length_m < kLeastDoorway_m || length_m > kLongestEdge_m) return;
    const int places = std::clamp(static_cast<int>(length_m / kStretch_m), 2, 400);
    const auto at = [&](int place) { return from + (to - from) * (static_cast<double>(place) / places); };
    int begin = 0;
    for (int place = 0; place <= places + 1; ++place) {
        if (place <= places && distance_to_outline(plan.spaces[corridor].rings, at(place)) < kBesideRoom_m) continue;
        const double run_m = length_m * (place - 1 - begin) / places;
        if (place > begin && run_m > best.length_m) best = {0.5 * (at(begin) + at(place - 1)), run_m, corridor};
        begin = place + 1;
    }
}

Aabb box_of(const std::vector<Ring>& rings) {
    Aabb box;
    for (const Ring& ring : rings)
        for (const Vec2& p : ring) box.include(Vec3(p, 0.0));
    return box;
}

bool has_door(const FloorPlan& plan, std::size_t doors, const PlanSpace& room) {
    const auto first = plan.doors.begin(), last = first + static_cast<std::ptrdiff_t>(doors);
    return std::any_of(first, last, [&](const PlanDoor& door) {
        return std::find(door.levels.begin(), door.levels.end(), room.levels[0]) != door.levels.end() &&
               distance_to_outline(room.rings, door.at) < kBesideRoom_m;
    });
}

}  // namespace

int guess_doorways(FloorPlan& plan) {
    std::vector<Aabb> boxes;
    for (const PlanSpace& space : plan.spaces) boxes.push_back(grown(box_of(space.rings), kBesideRoom_m));
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    const std::size_t stated = plan.doors.size();
    for (std::size_t s = 0; s < plan.spaces.size(); ++s) {
        const PlanSpace& room = plan.spaces[s];
        if (room.kind != PlanSpaceKind::Room || room.levels.size() != 1 || has_door(plan, stated, room)) continue;
        Doorway best;
        index.find(boxes[s], near);
        std::sort(near.begin(), near.end());
        for (const std::uint32_t c : near) {
            const PlanSpace& corridor = plan.spaces[c];
            if (corridor.kind != PlanSpaceKind::Corridor || corridor.levels != room.levels) continue;
            for (const Ring& ring : room.rings)
                for (std::size_t i = 0; i < ring.size(); ++i)
                    look_along(plan, ring[i], ring[(i + 1) % ring.size()], c, best);
        }
        if (best.length_m < kLeastDoorway_m) continue;
        PlanDoor door;
        door.kind = PlanDoorKind::Opening;
        door.at = best.at;
        door.id = room.id;
        door.levels = room.levels;
        door.spaces = {{std::min(s, best.corridor), std::max(s, best.corridor)}};
        plan.doors.push_back(std::move(door));
    }
    return static_cast<int>(plan.doors.size() - stated);
}

}  // namespace handrail
