// Finds where stairs fit within an outline: two flights side by side with a landing at their far end, and a passage
// around them if there is space. Pure functions; metres.
#pragma once

#include <optional>
#include <span>

#include "worlds/geometry/flat_parts.h"

namespace handrail::floorplan {

// The well that the two flights fill, from its open end (`from`) to its far end. The first flight climbs on the right;
// the second comes back next to it.
struct StairWell {
    Vec2 from{0.0};   // middle of the open end
    Vec2 along{0.0};  // unit vector, from the open end to the far end
    double length_m = 0.0, width_m = 0.0;
    double landing_m = 0.0;    // part of the length, at the far end, at half height
    double step_rise_m = 0.0;  // highest allowed step

    Vec2 at(double along_m, double left_m) const { return from + along * along_m + Vec2(-along.y, along.x) * left_m; }
    // The rectangle between two distances along the well and two distances to the left of its centre line;
    // counter-clockwise.
    Ring box(double from_m, double to_m, double right_m, double left_m) const;
};

// The largest rectangle in the outline with sides parallel to `along`, which is its x axis. Nothing if the outline has
// no room for 0.3 metres. Costs a test of 4,096 cells.
struct InnerBox {
    Vec2 origin{0.0}, along{1.0, 0.0};
    Vec2 least{0.0}, most{0.0};  // relative to the origin
};
std::optional<InnerBox> inner_box(const std::vector<Ring>& rings, const Vec2& along);
// The direction of the outline's longest side.
Vec2 longest_side(const std::vector<Ring>& rings);

// Lays stairs so that as many doors as possible, given as points on the outline, lead to the floor around the well.
// `rise_m`: the greatest height that the two flights climb together. Nothing if the outline is too small for a walker.
std::optional<StairWell> lay_stairs(const std::vector<Ring>& rings, std::span<const Vec2> doors, double rise_m);

// The number of steps for half of `rise_m`, none higher than `step_rise_m`.
int steps_of_half(double rise_m, double step_rise_m);

}  // namespace handrail::floorplan
