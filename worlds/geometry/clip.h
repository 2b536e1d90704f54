// Cuts flat convex polygons, and turns planes into closed convex solids. Pure functions on plain values, any thread;
// world metres in double. The caller gives the tolerances as lengths, because it knows the unit of the file. `cut_m` is
// how near to a plane a point counts as on it; `merge_m` is how near to each other two corners count as one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "worlds/geometry/convex.h"

namespace handrail {

struct CutTolerance {
    double cut_m = 1e-6 / 32.0;
    double merge_m = 1e-4 / 32.0;
};

// The area vector: its length is the area. It points to the side from which the corners run counter-clockwise.
Vec3 area_vector_m2(std::span<const Vec3> points_m) noexcept;
inline double area_m2(std::span<const Vec3> points_m) noexcept { return glm::length(area_vector_m2(points_m)); }
inline double area_m2(const Polygon& polygon) noexcept { return area_m2(polygon.points_m); }
Aabb bounds_of(const Polygon& polygon) noexcept;
Vec3 centre_of(const Polygon& polygon) noexcept;  // mean of the corners
// The box with every side moved outwards by `by_m`.
Aabb grown(const Aabb& box, double by_m) noexcept;
bool overlap(const Aabb& a, const Aabb& b) noexcept;  // true also if they only touch

// On which side of a plane the points are.
enum class Side { Back, Front, On, Across };
Side side_of(std::span<const Vec3> points_m, const Plane& plane, double cut_m) noexcept;

// Splits a convex polygon into the parts behind and in front of a plane. A part with fewer than 3 points is no polygon.
// New corners on an axis-aligned plane get its coordinate exactly, so that neighbouring brushes meet bit for bit.
// O(corners).
void split(std::span<const Vec3> points_m, const Plane& plane, double cut_m, std::vector<Vec3>& back_m,
           std::vector<Vec3>& front_m);
void keep_back(std::vector<Vec3>& points_m, const Plane& plane, double cut_m, std::vector<Vec3>& scratch);
// Drops corners nearer than merge_m to the previous one. Clears a polygon that then has fewer than 3 corners or is
// narrower than merge_m.
void tidy(std::vector<Vec3>& points_m, double merge_m);

// Makes the plane through three points that run clockwise seen from outside, as in .map files. Returns false if they
// are on one line. Normals within 1e-12 of an axis become that axis.
bool plane_from_clockwise(const Vec3& p0_m, const Vec3& p1_m, const Vec3& p2_m, Plane& plane) noexcept;

enum class SolidFault { None, Empty, Open };

struct BuiltSolid {
    ConvexSolid solid;                       // only valid if fault is None
    std::vector<std::uint32_t> plane_index;  // for every kept plane, its index among the given ones
    SolidFault fault = SolidFault::None;
    bool was_inside_out = false;  // the solid was closed only after all normals were reversed, which was done
    int planes_without_face = 0;  // repeated planes, and planes whose faces are too small to keep
};

// Intersects the half-spaces behind the planes. `near_m` is any point near the solid, and `reach_m` the greatest
// distance of its corners from there: a solid that extends further counts as open. O(planes squared x corners).
BuiltSolid solid_from_planes(std::span<const Plane> planes, const Vec3& near_m, double reach_m,
                             const CutTolerance& tolerance = {});

}  // namespace handrail
