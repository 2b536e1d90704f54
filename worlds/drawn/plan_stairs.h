// Where stairs can go within an outline: two flights side by side with a landing at their far end, and room to walk
// round them where there is any. Pure functions; metres.
#pragma once

#include <optional>
#include <span>

#include "worlds/geometry/flat_parts.h"

namespace handrail {

// The well that the flights fill, from its open end (from) to its far end: one goes up on the right of it, and comes
// down beside.
struct StairWell {
    Vec2 from{0.0};   // middle of the open end
    Vec2 along{0.0};  // unit, from the open end to the far one
    double length_m = 0.0, width_m = 0.0;
    double landing_m = 0.0;    // of the length, at the far end, half way up
    double step_rise_m = 0.0;  // at most

    Vec2 at(double along_m, double left_m) const { return from + along * along_m + Vec2(-along.y, along.x) * left_m; }
    // Between two places along and two to the left of the middle line; counter-clockwise.
    Ring box(double from_m, double to_m, double right_m, double left_m) const;
};

// The largest upright rectangle in the outline along `along`, in its axes: x along. Nothing where there is none of 0.3
// metres. Costs a look at 4,096 places.
struct InnerBox {
    Vec2 origin{0.0}, along{1.0, 0.0};
    Vec2 least{0.0}, most{0.0};  // from the origin
};
std::optional<InnerBox> inner_box(const std::vector<Ring>& rings, const Vec2& along);
// The direction of the outline's longest side.
Vec2 longest_side(const std::vector<Ring>& rings);

// So that as many as possible of the doors (places on the outline) lead to the floor round the well. `rise_m`: the
// highest that a flight and its other half climb. Nothing where the outline is too small for a body.
std::optional<StairWell> lay_stairs(const std::vector<Ring>& rings, std::span<const Vec2> doors, double rise_m);

// Steps of half a storey, none higher than that.
int steps_of_half(double rise_m, double step_rise_m);

}  // namespace handrail
