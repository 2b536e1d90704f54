// Adds lifts and stairs as mappers draw them: as one node within the rooms of several levels, or with an outline on
// each level.
#include <algorithm>
#include <array>
#include <numeric>

#include "worlds/base/language.h"
#include "worlds/osm/osm_levels.h"
#include "worlds/osm/osm_plan.h"
#include "worlds/osm/osm_words.h"

namespace handrail::osm {
namespace {

constexpr double kLift_m = 1.7, kRound_m = 0.3, kBeforeDoor_m = 1.2, kLiftDoor_m = 0.9;
// Offsets from the node at which a cabin is tried if walls are too close to the node itself.
const std::array<Vec2, 9> kAside_m{Vec2(0, 0),     Vec2(0, 1.2),    Vec2(1.2, 0),     Vec2(0, -1.2),  Vec2(-1.2, 0),
                                   Vec2(1.2, 1.2), Vec2(1.2, -1.2), Vec2(-1.2, -1.2), Vec2(-1.2, 1.2)};

Ring shaft(const Vec2& at, double half) {
    return {at + Vec2(-half, -half), at + Vec2(half, -half), at + Vec2(half, half), at + Vec2(-half, half)};
}

bool holds_square(const floorplan::PlanSpace& space, const Vec2& at) {
    const Ring round = shaft(at, 0.5 * kLift_m + kRound_m);
    for (std::size_t i = 0; i < 4; ++i)
        if (!inside(space.rings, round[i]) || !inside(space.rings, 0.5 * (round[i] + round[(i + 1) % 4]))) return false;
    return inside(space.rings, at);
}

}  // namespace

// Joins outlines of stairs and lifts that are above one another into one space, because mappers can draw them on each
// level separately.
void OsmPlan::stack_outlines() {
    std::vector<std::size_t> order(outlines_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return outlines_[a].levels.front() < outlines_[b].levels.front();
    });
    struct Stack {
        std::size_t outline = 0;
        std::string kind;
        std::vector<Ring> rings;
        Vec2 middle{0.0};
    };
    std::vector<Stack> stacks;
    std::vector<bool> stacked(outlines_.size(), false);
    for (const std::size_t i : order) {
        Outline& upper = outlines_[i];
        Stack made{i, kind_of_space(*upper.tags), in_degrees(upper.rings)};
        if (made.kind != "stairs" && made.kind != "lift") continue;
        for (const Vec2& p : made.rings[0]) made.middle += p / static_cast<double>(made.rings[0].size());
        const auto below = std::find_if(stacks.begin(), stacks.end(), [&](const Stack& stack) {
            const double step = upper.levels.front() - outlines_[stack.outline].levels.back();
            return stack.kind == made.kind && step > 0.0 && step <= 1.0 && inside(stack.rings, made.middle) &&
                   inside(made.rings, stack.middle);
        });
        if (below == stacks.end()) {
            stacks.push_back(std::move(made));
            continue;
        }
        std::vector<double>& levels = outlines_[below->outline].levels;
        levels.insert(levels.end(), upper.levels.begin(), upper.levels.end());
        stacked[i] = true;
    }
    std::size_t at = 0;
    std::erase_if(outlines_, [&](const Outline&) { return stacked[at++]; });
}

// Makes a cabin that has a door to the surrounding room on each level. Returns false if there is no space for it.
bool OsmPlan::add_lift_at(std::int64_t node, std::size_t rooms) {
    const OsmTags& tags = data_.nodes.at(node).tags;
    std::vector<std::size_t> levels;
    for (const double number : levels_of(tags["level"], tags["repeat_on"]).levels)
        if (const std::size_t level = level_at(number); level != kNone) levels.push_back(level);
    if (levels.size() < 2 || levels.back() - levels.front() + 1 != levels.size()) return false;
    const Vec2 middle = place_of(node);
    for (const Vec2& off : kAside_m) {
        const Vec2 at = middle + off;
        std::vector<std::size_t> around;  // the space that surrounds the lift on each level
        for (const std::size_t level : levels)
            for (std::size_t s = 0; s < rooms; ++s) {
                const floorplan::PlanSpace& space = plan_.spaces[s];
                const bool only_here =
                    std::includes(levels.begin(), levels.end(), space.levels.begin(), space.levels.end());
                if (!only_here || !std::binary_search(space.levels.begin(), space.levels.end(), level)) continue;
                if (!holds_square(space, at)) continue;
                around.push_back(s);
                break;
            }
        if (around.size() != levels.size()) continue;
        for (const Vec2& out : {Vec2(0, -1), Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0)}) {
            const Vec2 before = at + out * (0.5 * kLift_m + kBeforeDoor_m);
            if (!std::all_of(around.begin(), around.end(),
                             [&](std::size_t s) { return inside(plan_.spaces[s].rings, before); }))
                continue;
            floorplan::PlanSpace lift;
            lift.kind = floorplan::PlanSpaceKind::Lift;
            lift.name = name_of_space(tags);
            lift.number = tags["ref"];
            lift.id = phrase("osm.node", {{"id", std::to_string(node)}});
            lift.facts = facts_of(tags);
            lift.rings = {shaft(at, 0.5 * kLift_m)};
            lift.levels = levels;
            floorplan::PlanDoor door;
            door.kind = floorplan::PlanDoorKind::Sliding;
            door.at = at + out * (0.5 * kLift_m);
            door.along = Vec2(-out.y, out.x);
            door.width_m = kLiftDoor_m;
            door.by_itself = true;
            door.id = lift.id;
            door.levels = levels;
            for (const std::size_t s : around) door.spaces.push_back({s, plan_.spaces.size()});
            std::sort(around.begin(), around.end());
            around.erase(std::unique(around.begin(), around.end()), around.end());
            for (const std::size_t s : around) plan_.spaces[s].rings.push_back(lift.rings[0]);
            plan_.spaces.push_back(std::move(lift));
            plan_.doors.push_back(std::move(door));
            return true;
        }
    }
    return false;
}

void OsmPlan::add_lift_nodes() {
    const std::size_t rooms = plan_.spaces.size();
    int made = 0, without_space = 0;
    for (const std::int64_t n : data_.tagged_nodes) {
        if (!is_lift_node(n) || rooms == 0) continue;
        const bool indoors =
            std::any_of(plan_.spaces.begin(), plan_.spaces.end(), [&](const floorplan::PlanSpace& space) {
                return space.kind != floorplan::PlanSpaceKind::Lift && inside(space.rings, place_of(n));
            });
        if (!indoors) continue;
        (add_lift_at(n, rooms) ? made : without_space) += 1;
    }
    if (made > 0) plan_.guessed.push_back(phrase("osm.lift_nodes", {{"n", made}}));
    if (without_space > 0) plan_.left_out.push_back(phrase("osm.lifts_alone", {{"n", without_space}}));
}

}  // namespace handrail::osm
