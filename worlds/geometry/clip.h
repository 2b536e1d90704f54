// Cutting flat convex polygons and turning planes into closed convex solids. Pure functions on plain values, any
// thread; world metres in double. Tolerances are lengths given by the caller, who knows the unit of the file: `cut_m`
// is how near to a plane counts as on it, `merge_m` how near to each other two corners count as one.
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

// Area vector: its length is the area, its direction the side from which the corners run counter-clockwise.
Vec3 area_vector_m2(std::span<const Vec3> points_m) noexcept;
inline double area_m2(std::span<const Vec3> points_m) noexcept { return glm::length(area_vector_m2(points_m)); }
inline double area_m2(const Polygon& polygon) noexcept { return area_m2(polygon.points_m); }
Aabb bounds_of(const Polygon& polygon) noexcept;
Vec3 centre_of(const Polygon& polygon) noexcept;  // mean of the corners
// The box with every side moved out by `by_m`.
Aabb grown(const Aabb& box, double by_m) noexcept;
bool overlap(const Aabb& a, const Aabb& b) noexcept;  // borders count

// Where the points lie with respect to a plane.
enum class Side { Back, Front, On, Across };
Side side_of(std::span<const Vec3> points_m, const Plane& plane, double cut_m) noexcept;

// The parts of a convex polygon behind and in front of a plane; either may come out with fewer than 3 points and is
// then no polygon. New corners on an axis-aligned plane get its coordinate exactly, so that neighbouring brushes meet
// bit for bit. O(corners).
void split(std::span<const Vec3> points_m, const Plane& plane, double cut_m, std::vector<Vec3>& back_m,
           std::vector<Vec3>& front_m);
void keep_back(std::vector<Vec3>& points_m, const Plane& plane, double cut_m, std::vector<Vec3>& scratch);
// Drops corners nearer than merge_m to the one before; clears what has fewer than 3 left or is narrower than merge_m.
void tidy(std::vector<Vec3>& points_m, double merge_m);

// The plane through three points that run clockwise seen from outside (the order of .map files); false when they lie on
// one line. Normals within 1e-12 of an axis become that axis.
bool plane_from_clockwise(const Vec3& p0_m, const Vec3& p1_m, const Vec3& p2_m, Plane& plane) noexcept;

enum class SolidFault { None, Empty, Open };

struct BuiltSolid {
    ConvexSolid solid;                       // only meaningful while fault is None
    std::vector<std::uint32_t> plane_index;  // for every kept plane, which of the given ones it was
    SolidFault fault = SolidFault::None;
    bool was_inside_out = false;  // closed only after turning all normals round, which was done
    int planes_without_face = 0;  // repeated planes and faces too small to keep
};

// Intersects the half-spaces behind the planes. `near_m` is any point near the solid and `reach_m` how far its corners
// may be away: a solid that reaches further is open. O(planes squared x corners).
BuiltSolid solid_from_planes(std::span<const Plane> planes, const Vec3& near_m, double reach_m,
                             const CutTolerance& tolerance = {});

}  // namespace handrail
