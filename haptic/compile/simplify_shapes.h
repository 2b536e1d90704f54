// Declares the helpers shared by simplify_scene.cpp, which plans a simplification, and simplify_apply.cpp, which
// applies it: ranges along a direction, boxes around a doorway, and the test for walls. No other file uses them.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "worlds/geometry/clip.h"
#include "worlds/scene/scene.h"

namespace handrail::compile::doorway {

// Greatest height of a part that is treated as floor. Such parts are not cut and do not limit widening.
inline constexpr double kStep_m = 0.3;
inline constexpr CutTolerance kTolerance{1e-7, 1e-6};

using Range = std::array<double, 2>;
inline constexpr Range kNoRange{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
void include(Range& range, double value);
void include(Range& range, const Range& other);
inline double length(const Range& range) { return range[1] - range[0]; }
inline bool overlap(const Range& a, const Range& b) { return a[0] <= b[1] && b[0] <= a[1]; }

Range along(const ConvexSolid& solid, const Vec3& way);
inline Vec3 left_of(const Vec3& way) { return {-way.y, way.x, 0.0}; }
inline Vec3 pointing_east(const Vec3& way) { return way.x < 0.0 || (way.x == 0.0 && way.y < 0.0) ? -way : way; }

// Returns the six planes of the box with these ranges: `s` along `way`, `t` to its left, and `z` upwards.
std::vector<Plane> box_planes(const Vec3& way, const Range& s, const Range& t, const Range& z);
Aabb box_around(const Vec3& way, const Range& s, const Range& t, const Range& z);
// Builds the solid behind these planes. `around` is a box that contains it.
BuiltSolid built(std::span<const Plane> planes, const Aabb& around);
// Returns the part of a solid behind all these planes. The result has no faces if there is no such part.
ConvexSolid common(const ConvexSolid& solid, const std::vector<Plane>& planes);

bool is_kind(const Scene& scene, FeatureId id, FeatureKind kind);
bool is_leaf(const Scene& scene, const Solid& solid);
// Returns true for a thing that is inside the building, false for a part of the building itself. Elsewhere in the
// program, a piece of wall between two doorways is a thing with a generated name, but here it is part of the building.
bool is_thing(const Scene& scene, FeatureId id);
// Returns true for a part of the building that may be cut.
bool is_wall(const Scene& scene, const Solid& solid);
// Returns true for a solid that does not move and stops the hand, except a door's leaf.
bool is_standing(const Scene& scene, const Solid& solid);

}  // namespace handrail::compile::doorway
