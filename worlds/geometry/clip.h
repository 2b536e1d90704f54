// Cuts flat convex polygons, and turns planes into closed convex solids. Pure functions on plain values in world
// metres, double precision. Any thread may call them. The caller gives the tolerances as lengths, because it knows the
// unit of the file. A point nearer to a plane than `cut_m` is treated as on the plane. Two corners nearer to each other
// than `merge_m` are treated as one.
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

// Returns the area vector of a polygon. Its length is the area, and it points to the side from which the corners run
// counter-clockwise.
Vec3 area_vector_m2(std::span<const Vec3> points_m) noexcept;
inline double area_m2(std::span<const Vec3> points_m) noexcept { return glm::length(area_vector_m2(points_m)); }
inline double area_m2(const Polygon& polygon) noexcept { return area_m2(polygon.points_m); }
Aabb bounds_of(const Polygon& polygon) noexcept;
Vec3 centre_of(const Polygon& polygon) noexcept;  // returns the mean of the corners
// Returns the box with every side moved outwards by `by_m`.
Aabb grown(const Aabb& box, double by_m) noexcept;
bool overlap(const Aabb& a, const Aabb& b) noexcept;  // true also if they only touch

// Position of points relative to a plane. Across: there are points on both sides.
enum class Side { Back, Front, On, Across };
Side side_of(std::span<const Vec3> points_m, const Plane& plane, double cut_m) noexcept;

// Splits a convex polygon into the part behind a plane and the part in front of it. If a part has fewer than 3 points,
// there is nothing on that side. On an axis-aligned plane, new corners get the plane's coordinate exactly, so that
// neighbouring brushes meet bit for bit. Cost: O(corners).
void split(std::span<const Vec3> points_m, const Plane& plane, double cut_m, std::vector<Vec3>& back_m,
           std::vector<Vec3>& front_m);
void keep_back(std::vector<Vec3>& points_m, const Plane& plane, double cut_m, std::vector<Vec3>& scratch);
// Removes corners that are nearer than merge_m to the previous one. Clears the polygon if it then has fewer than 3
// corners or is narrower than merge_m.
void tidy(std::vector<Vec3>& points_m, double merge_m);

// Makes the plane through three points that run clockwise seen from outside, as in .map files. Returns false if the
// points are on one line. A normal within 1e-12 of an axis becomes that axis.
bool plane_from_clockwise(const Vec3& p0_m, const Vec3& p1_m, const Vec3& p2_m, Plane& plane) noexcept;

enum class SolidFault { None, Empty, Open };

struct BuiltSolid {
    ConvexSolid solid;                       // only valid if fault is None
    std::vector<std::uint32_t> plane_index;  // for each plane that was kept, its index in the `planes` passed in
    SolidFault fault = SolidFault::None;
    // True if the planes enclose a solid only after all normals are reversed; solid_from_planes has reversed them.
    bool was_inside_out = false;
    int planes_without_face = 0;  // number of repeated planes and of planes whose faces were too small to keep
};

// Intersects the half-spaces behind the planes. `near_m` is any point near the solid. `reach_m` is the greatest
// distance of a corner from `near_m`; a solid that extends farther is reported as open. Cost: O(planes squared x
// corners).
BuiltSolid solid_from_planes(std::span<const Plane> planes, const Vec3& near_m, double reach_m,
                             const CutTolerance& tolerance = {});

}  // namespace handrail
