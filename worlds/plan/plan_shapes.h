// Boxes and outlines of a plan: the smallest box around an outline, tests for points within, and thickness. Pure
// functions over plain values; any thread. World metres.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "worlds/plan/plan_cut.h"

namespace handrail::plan {

// A box in any orientation: `along` (length 1) is the direction of its longer side.
struct PlanBox {
    Vec2 middle_m{0.0};
    Vec2 along{1.0, 0.0};
    Vec2 half_m{0.0};  // half lengths along and across

    std::array<Vec2, 4> corners_m() const;  // counter-clockwise
};

// The smallest box around a convex outline.
PlanBox box_around(const PlanOutline& hull);
// True if a place is inside a closed line, which need not be convex.
bool within_loop(const std::vector<Vec2>& loop, const Vec2& at);
// True if a place is inside a convex outline or on its border.
bool within(const PlanOutline& outline, const Vec2& at);
// A wall with a mitred end, made square there; the corner that was added between the others, if `outline` is one.
struct SquaredWall {
    PlanOutline outline;
    std::array<Vec2, 3> added;
};
std::optional<SquaredWall> squared_wall(const PlanOutline& outline);
// How thin a convex outline is where it is thinnest.
double narrowest_m(const PlanOutline& outline);

}  // namespace handrail::plan
