// Makes vertical solids over flat outlines, and subtracts outlines from each other. Pure functions on plain values in
// metres.
#pragma once

#include <optional>

#include "worlds/geometry/convex.h"
#include "worlds/geometry/flat_parts.h"

namespace handrail::floorplan {

inline double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
// Returns the vector turned to the left by 90 degrees.
inline Vec2 left_of(const Vec2& v) { return {-v.y, v.x}; }

// Returns the solid over a convex, counter-clockwise outline. Nothing if the solid has no volume.
std::optional<ConvexSolid> upright(const Ring& outline, double from_m, double to_m);
// Returns the rectangle around a line, counter-clockwise.
Ring strip(const Vec2& from, const Vec2& to, double half_width_m);
// Returns the part of `ring` outside `cutter` as convex, counter-clockwise outlines. Both arguments must be convex and
// counter-clockwise.
std::vector<Ring> without(const Ring& ring, const Ring& cutter);

// The point of the rings' edges that is nearest to a place.
struct NearestOfOutline {
    double distance_m = 1e300;  // 1e300 if the rings have no edges
    Vec2 at_m{0.0};
    Vec2 along{0.0};  // direction of the nearest edge, with length 1, or 0 for an edge without length
};
NearestOfOutline nearest_of_outline(const std::vector<Ring>& rings, const Vec2& at);
// Returns the distance from the point to the nearest edge of the rings, or 1e300 if they have no edges.
double distance_to_outline(const std::vector<Ring>& rings, const Vec2& at);

}  // namespace handrail::floorplan
