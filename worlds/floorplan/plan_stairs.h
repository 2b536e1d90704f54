// Finds a place for stairs within an outline. The stairs have two flights side by side with a landing at their far end,
// and a passage around them if there is space. Pure functions on plain values in metres.
#pragma once

#include <optional>
#include <span>

#include "worlds/geometry/flat_parts.h"

namespace handrail::floorplan {

// The rectangle that two flights fill. It extends from its open end, where people step on and off, to its far end. The
// first flight climbs on the right; the second comes back next to it.
struct StairWell {
    Vec2 from{0.0};   // middle of the open end
    Vec2 along{0.0};  // unit vector, from the open end to the far end
    double length_m = 0.0, width_m = 0.0;
    double landing_m = 0.0;    // length of the landing at the far end, which is at half of the height
    double step_rise_m = 0.0;  // greatest height of a step

    Vec2 at(double along_m, double left_m) const { return from + along * along_m + Vec2(-along.y, along.x) * left_m; }
    // Returns the rectangle between two distances along the well and two distances to the left of its centre line; its
    // corners run counter-clockwise.
    Ring box(double from_m, double to_m, double right_m, double left_m) const;
};

// The largest rectangle within the outline whose sides are parallel to `along`, which is the x axis of the rectangle.
// inner_box returns nothing if the outline is less than 0.3 metres long or wide. It tests 4,096 cells.
struct InnerBox {
    Vec2 origin{0.0}, along{1.0, 0.0};
    Vec2 least{0.0}, most{0.0};  // least and greatest corner, relative to the origin
};
std::optional<InnerBox> inner_box(const std::vector<Ring>& rings, const Vec2& along);
// Returns the direction of the outline's longest side.
Vec2 longest_side(const std::vector<Ring>& rings);

// Places stairs so that people can walk from as many doors as possible to the stairs. `doors` are points on the
// outline. `rise_m` is the greatest height that the two flights climb together. Returns nothing if the outline is too
// small for a walker.
std::optional<StairWell> lay_stairs(const std::vector<Ring>& rings, std::span<const Vec2> doors, double rise_m);

// Returns the number of steps that climb half of `rise_m`, none of them higher than `step_rise_m`.
int steps_of_half(double rise_m, double step_rise_m);

}  // namespace handrail::floorplan
