// Flat outlines with holes, cut into convex parts. Pure functions.
#pragma once

#include <cstddef>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

using Ring = std::vector<Vec2>;

// Of an outline that is cut into parts.
inline constexpr std::size_t kMostCorners = 4000;

double signed_area(const Ring& ring);
// Inside by the even-odd rule.
bool inside(const std::vector<Ring>& rings, const Vec2& at);
// Convex polygons, counter-clockwise, that together are what lies inside by the even-odd rule; rings may have either
// direction, touch and cross. One convex ring stays as it is. Trapezoids between upright lines, joined where their
// union is convex. O(n squared) for n corners; nothing for more than kMostCorners.
std::vector<Ring> convex_parts(const std::vector<Ring>& rings);

// The same area by the even-odd rule, with no border along which two rings lie against each other: pieces side by side
// become one outline. Outlines run counter-clockwise, holes clockwise; the largest ring is first. Corners within a
// millimetre are one. O(n squared) for n corners; more than kMostCorners stay as they are.
std::vector<Ring> joined_rings(const std::vector<Ring>& rings);

}  // namespace handrail
