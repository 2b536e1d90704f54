// Computes boxes and outlines of a plan: the smallest box around an outline, whether a point is within an outline, and
// the thickness of an outline. Pure functions over plain values in world metres; any thread may call them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "worlds/plan/plan_cut.h"

namespace handrail::plan {

// A box in any orientation. `along` is the direction of its longer side and has length 1.
struct PlanBox {
    Vec2 middle_m{0.0};
    Vec2 along{1.0, 0.0};
    Vec2 half_m{0.0};  // half of the lengths along and across

    std::array<Vec2, 4> corners_m() const;  // returns the corners counter-clockwise
};

// Returns the smallest box around a convex outline.
PlanBox box_around(const PlanOutline& hull);
// True if `at` is inside a closed line, which need not be convex.
bool within_loop(const std::vector<Vec2>& loop, const Vec2& at);
// True if `at` is inside a convex outline or on its border.
bool within(const PlanOutline& outline, const Vec2& at);
// A wall whose mitred end has been made square. `outline` is the wall with the square end; `added` is the triangle that
// was added at that end. squared_wall() returns nothing if its argument has no mitred end.
struct SquaredWall {
    PlanOutline outline;
    std::array<Vec2, 3> added;
};
std::optional<SquaredWall> squared_wall(const PlanOutline& outline);
// Returns the least thickness of a convex outline.
double narrowest_m(const PlanOutline& outline);

}  // namespace handrail::plan
