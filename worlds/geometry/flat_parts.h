// Cuts flat outlines with holes into convex parts. Pure functions.
#pragma once

#include <cstddef>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

using Ring = std::vector<Vec2>;

// An outline with more corners is neither cut nor joined.
inline constexpr std::size_t kMostCorners = 4000;

double signed_area(const Ring& ring);
// True if the point is inside by the even-odd rule.
bool inside(const std::vector<Ring>& rings, const Vec2& at);
// Counter-clockwise convex polygons that together cover what is inside by the even-odd rule. Rings may have either
// direction, touch and cross. A single convex ring is kept as it is. Others are cut into trapezoids between upright
// lines, which are joined if their union is convex. O(n squared) for n corners; returns nothing for more than
// kMostCorners.
std::vector<Ring> convex_parts(const std::vector<Ring>& rings);

// The same area by the even-odd rule, but without borders along which two rings touch: adjacent pieces become one
// outline. Outlines run counter-clockwise, holes clockwise; the largest ring is first. Corners within a millimetre
// count as one. O(n squared) for n corners; rings with more than kMostCorners are returned unchanged.
std::vector<Ring> joined_rings(const std::vector<Ring>& rings);

}  // namespace handrail
