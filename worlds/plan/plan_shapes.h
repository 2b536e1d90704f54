// Boxes and outlines of a plan: the smallest box, what lies within, how thin something is. Pure functions over plain
// values; any thread. World metres.
#pragma once

#include <array>
#include <vector>

#include "worlds/plan/plan_cut.h"

namespace handrail {

// A box that may lie askew: `along` (length 1) is its longer side.
struct PlanBox {
    Vec2 middle_m{0.0};
    Vec2 along{1.0, 0.0};
    Vec2 half_m{0.0};  // along, across

    std::array<Vec2, 4> corners_m() const;  // counter-clockwise
};

// The smallest box around a convex outline.
PlanBox box_around(const PlanOutline& hull);
// Whether a place lies in a closed line, bent or not.
bool within_loop(const std::vector<Vec2>& loop, const Vec2& at);
// Whether a place lies in a convex outline, border included.
bool within(const PlanOutline& outline, const Vec2& at);
// How thin a convex outline is where it is thinnest.
double narrowest_m(const PlanOutline& outline);

}  // namespace handrail
