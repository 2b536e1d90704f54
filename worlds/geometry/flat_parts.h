// Cuts flat outlines with holes into convex parts, and joins outlines that touch. Pure functions; any thread may call
// them.
#pragma once

#include <cstddef>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

using Ring = std::vector<Vec2>;

// An outline with more corners than this is neither cut nor joined.
inline constexpr std::size_t kMostCorners = 4000;

double signed_area(const Ring& ring);
// True if `at` is inside the rings by the even-odd rule.
bool inside(const std::vector<Ring>& rings, const Vec2& at);
// Returns counter-clockwise convex polygons that together cover what is inside the rings by the even-odd rule. Rings
// may have either direction, touch and cross. A single convex ring is kept unchanged. Other rings are cut into
// trapezoids between lines parallel to the y axis; trapezoids are then joined where their union is convex. Cost: O(n
// squared) for n corners. Returns nothing for more than kMostCorners.
std::vector<Ring> convex_parts(const std::vector<Ring>& rings);

// Returns the same area, by the even-odd rule, without the borders along which two rings touch: adjacent pieces become
// one outline. Outlines run counter-clockwise, holes clockwise; the largest ring is first. Corners within a millimetre
// of each other are treated as one. Cost: O(n squared) for n corners. Rings with more than kMostCorners in total are
// returned unchanged.
std::vector<Ring> joined_rings(const std::vector<Ring>& rings);

}  // namespace handrail
