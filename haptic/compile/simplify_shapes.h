// What the plan of a simplification and the scene it makes share: ranges along a way, boxes round a doorway, and what
// of a scene is a wall. For simplify_scene and simplify_apply only.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "worlds/geometry/clip.h"
#include "worlds/scene/scene.h"

namespace handrail::doorway {

inline constexpr double kStep_m = 0.3;  // what is lower is floor, and is neither cut nor in the way
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

// Six planes round what lies in these ranges: along `way`, to its left, upwards.
std::vector<Plane> box_planes(const Vec3& way, const Range& s, const Range& t, const Range& z);
Aabb box_around(const Vec3& way, const Range& s, const Range& t, const Range& z);
// `around`: a box that the solid lies in.
BuiltSolid built(std::span<const Plane> planes, const Aabb& around);
// What of a solid lies behind all these planes; no faces: nothing.
ConvexSolid common(const ConvexSolid& solid, const std::vector<Plane>& planes);

bool is_kind(const Scene& scene, FeatureId id, FeatureKind kind);
bool is_leaf(const Scene& scene, const Solid& solid);
// Stands in the building; the rest is the building. Pieces of a wall that stand alone between two doorways count as
// things elsewhere, with a made name.
bool is_thing(const Scene& scene, FeatureId id);
// Part of the building, of which a piece can be taken away.
bool is_wall(const Scene& scene, const Solid& solid);
// Stands and stops the hand, other than a door's leaf.
bool is_standing(const Scene& scene, const Solid& solid);

}  // namespace handrail::doorway
