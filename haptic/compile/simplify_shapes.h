// Shared by the plan of a simplification and the code that applies it: ranges along a direction, boxes around a
// doorway, and the test for walls. Only for simplify_scene and simplify_apply.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "worlds/geometry/clip.h"
#include "worlds/scene/scene.h"

namespace handrail::compile::doorway {

inline constexpr double kStep_m = 0.3;  // lower parts count as floor, and are neither cut nor in the way
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

// Six planes around these ranges: along `way`, to its left, and upwards.
std::vector<Plane> box_planes(const Vec3& way, const Range& s, const Range& t, const Range& z);
Aabb box_around(const Vec3& way, const Range& s, const Range& t, const Range& z);
// `around`: a box that contains the solid.
BuiltSolid built(std::span<const Plane> planes, const Aabb& around);
// The part of a solid behind all these planes; it has no faces if there is none.
ConvexSolid common(const ConvexSolid& solid, const std::vector<Plane>& planes);

bool is_kind(const Scene& scene, FeatureId id, FeatureKind kind);
bool is_leaf(const Scene& scene, const Solid& solid);
// Returns true for a thing that stands in the building; the rest is the building itself. Pieces of a wall between two
// doorways count as things elsewhere in the program, with a made name, but not here.
bool is_thing(const Scene& scene, FeatureId id);
// Returns true for a part of the building of which a piece can be removed.
bool is_wall(const Scene& scene, const Solid& solid);
// Returns true for a solid that stands still and stops the hand, except a door's leaf.
bool is_standing(const Scene& scene, const Solid& solid);

}  // namespace handrail::compile::doorway
