#include "worlds/floorplan/guess_doorways.h"

#include <algorithm>
#include <set>

#include "worlds/floorplan/upright.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail::floorplan {
namespace {

constexpr double kNextToRoom_m = 0.3, kLeastDoorway_m = 0.9, kStretch_m = 0.3, kLongestEdge_m = 20'000.0;
constexpr int kMostRounds = 20;

struct Doorway {
    Vec2 at{0.0};
    double length_m = 0.0;
    std::size_t corridor = 0;
};

// Finds the longest stretch of the edge that runs along the corridor. If it is longer than `best`, replaces `best` with
// it.
void look_along(const FloorPlan& plan, const Vec2& from, const Vec2& to, std::size_t corridor, Doorway& best) {
    const double length_m = glm::length(to - from);
    if (length_m < kLeastDoorway_m || length_m > kLongestEdge_m) return;
    const int places = std::clamp(static_cast<int>(length_m / kStretch_m), 2, 400);
    const auto at = [&](int place) { return from + (to - from) * (static_cast<double>(place) / places); };
    int begin = 0;
    for (int place = 0; place <= places + 1; ++place) {
        if (place <= places && distance_to_outline(plan.spaces[corridor].rings, at(place)) < kNextToRoom_m) continue;
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

bool has_door(const FloorPlan& plan, const PlanSpace& room, std::size_t level) {
    return std::any_of(plan.doors.begin(), plan.doors.end(), [&](const PlanDoor& door) {
        return std::find(door.levels.begin(), door.levels.end(), level) != door.levels.end() &&
               distance_to_outline(room.rings, door.at) < kNextToRoom_m;
    });
}

bool is_walkway(const PlanSpace& space) {
    return space.kind == PlanSpaceKind::Corridor || space.kind == PlanSpaceKind::Area;
}

PlanDoor doorway(const FloorPlan& plan, std::size_t space, std::size_t level, const Doorway& found) {
    const PlanSpace& room = plan.spaces[space];
    PlanDoor door;
    // A lift gets a closed door, so that nobody falls into the shaft.
    const bool lift = room.kind == PlanSpaceKind::Lift || plan.spaces[found.corridor].kind == PlanSpaceKind::Lift;
    door.kind = lift ? PlanDoorKind::Sliding : PlanDoorKind::Opening;
    door.by_itself = lift;
    door.guessed = true;
    door.at = found.at;
    door.id = room.id;
    door.levels = {level};
    door.spaces = {{std::min(space, found.corridor), std::max(space, found.corridor)}};
    return door;
}

}  // namespace

// First opens spaces to adjoining walkways. Then opens the remaining spaces to adjoining rooms that have a door by
// then, and repeats this until no further space gets one.
int guess_doorways(FloorPlan& plan) {
    std::vector<Aabb> boxes;
    for (const PlanSpace& space : plan.spaces) boxes.push_back(grown(box_of(space.rings), kNextToRoom_m));
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    std::set<std::pair<std::size_t, std::size_t>> shut;  // spaces without a door, each with the level
    for (std::size_t s = 0; s < plan.spaces.size(); ++s)
        for (const std::size_t level : plan.spaces[s].levels)
            if (!is_walkway(plan.spaces[s]) && !has_door(plan, plan.spaces[s], level)) shut.emplace(s, level);
    std::set<std::size_t> guessed;
    bool any = true;
    for (int round = 0; round < kMostRounds && (round < 2 || any); ++round) {
        const bool walkways = round == 0;
        std::vector<PlanDoor> made;
        std::vector<std::pair<std::size_t, std::size_t>> opened;
        for (const auto& [s, level] : shut) {
            const PlanSpace& room = plan.spaces[s];
            Doorway best;
            index.find(boxes[s], near);
            for (const std::uint32_t c : near) {
                const PlanSpace& other = plan.spaces[c];
                const bool there = std::find(other.levels.begin(), other.levels.end(), level) != other.levels.end();
                const bool leads_on =
                    walkways ? is_walkway(other) : other.kind == PlanSpaceKind::Room && !shut.contains({c, level});
                if (c == s || !there || !leads_on) continue;
                for (const Ring& ring : room.rings)
                    for (std::size_t i = 0; i < ring.size(); ++i)
                        look_along(plan, ring[i], ring[(i + 1) % ring.size()], c, best);
            }
            if (best.length_m < kLeastDoorway_m) continue;
            made.push_back(doorway(plan, s, level, best));
            opened.emplace_back(s, level);
            guessed.insert(s);
        }
        for (const auto& one : opened) shut.erase(one);
        plan.doors.insert(plan.doors.end(), made.begin(), made.end());
        any = !made.empty();
    }
    return static_cast<int>(guessed.size());
}

}  // namespace handrail::floorplan
