// Finds closest points of convex shapes for the haptic renderer. With each point comes the unit normal of a plane that
// supports the shape there: the whole shape is behind that plane, wherever the query point is. Pure functions in double
// precision; any thread; no allocation. Cost on a 2.5 GHz core: about 10 to 60 ns each. Every function has a
// brute-force counterpart in tests/unit/geometry_touch.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"

namespace handrail {

// If the query point is nearer than this, the direction to it is only rounding error.
inline constexpr double kSideless_m = 1e-12;

struct ClosestPoint {
    Vec3 point_m{0.0};  // the nearest point on the surface of the shape
    // Unit length, pointing away from the shape: dot(normal, o) <= dot(normal, point_m) for every point o of the shape.
    Vec3 normal{0.0, 0.0, 1.0};
    double distance_m = 0.0;  // distance from the query point to the surface; negative inside solids
};

// A triangle prepared for queries. It is a two-sided sheet. If its height over the longest edge is less than 1e-7 m,
// the triangle is treated as that edge. So triangles without area, needles and points are allowed too (error at most
// 1e-7 m).
struct TriangleShape {
    Vec3 a_m{0.0}, b_m{0.0}, c_m{0.0};  // corners; ab is the longest edge
    Vec3 normal{0.0};                   // zero if the triangle is degenerate
    // Directions in the plane that point outwards from the edges ab, bc and ca; not of unit length.
    std::array<Vec3, 3> outward{};
    bool degenerate = true;
};
TriangleShape make_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m) noexcept;

// Finds a plane that supports a triangle and is perpendicular to the line from the triangle's middle to `point_m`. This
// costs a quarter of closest_point and is nearly as tight if the point is far away. Returns the distance of the point
// in front of the plane, which is at most its distance from the triangle. Returns 0 and sets no normal if the plane
// does not separate the point from the triangle.
inline double support_towards(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const Vec3& point_m,
                              Vec3& normal) noexcept {
    const Vec3 away = 3.0 * point_m - (a_m + b_m + c_m);
    const double gap =
        std::min({glm::dot(point_m - a_m, away), glm::dot(point_m - b_m, away), glm::dot(point_m - c_m, away)});
    if (!(gap > 0.0)) return 0.0;
    const double per_length = 1.0 / std::sqrt(glm::dot(away, away));
    normal = away * per_length;
    return gap * per_length;
}

// A corner of a flat convex polygon, with the outward direction of the edge to the next corner. That direction is in
// the polygon's plane and not of unit length.
struct PolygonCorner {
    Vec3 at_m{0.0};
    Vec3 outward{0.0};
};

// A flat convex polygon prepared for queries. It is a view: the corners are stored elsewhere. The polygon is a
// two-sided sheet; its front is the side that its normal points to. If its height over the longest diagonal is less
// than 1e-7 m, the polygon is treated as that diagonal, with two corners and a zero normal.
struct PolygonShape {
    Vec3 normal{0.0};
    std::span<const PolygonCorner> corners;

    bool degenerate() const noexcept { return normal == Vec3(0.0); }
};

// Prepares a polygon: appends its corners to `corners` and returns its normal. Expects 2 or more points of a convex
// polygon, counter-clockwise seen from the front. Points that repeat, or are within 1e-9 m of an edge, are left out.
// Otherwise a query point over one part of such an edge could seem to be beyond the other part. If the points are not
// quite in one plane, the error of every answer is up to their distance from the plane.
Vec3 make_polygon(std::span<const Vec3> points_m, std::vector<PolygonCorner>& corners);

// Returns the point of the triangle nearest to `point_m`. If the two are less than 1e-12 m apart, the side cannot be
// determined, and the normal is the triangle's own.
ClosestPoint closest_point(const TriangleShape& triangle, const Vec3& point_m) noexcept;
// Like closest_point, for a triangle that was not prepared. Use it to test many triangles once each.
ClosestPoint closest_point_of_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const Vec3& point_m) noexcept;
// Like closest_point for a triangle. The cost grows with the number of edges.
ClosestPoint closest_point(const PolygonShape& polygon, const Vec3& point_m) noexcept;
// Returns the point of an axis-aligned box nearest to `point_m`. If `point_m` is inside, the nearest face determines
// the result.
ClosestPoint closest_point(const Aabb& box, const Vec3& point_m) noexcept;
// Returns the point of a bounded convex solid that is nearest to `point_m`. The planes (at least 4) define the solid.
// If `point_m` is inside, the nearest plane determines the result.
ClosestPoint closest_point(std::span<const Plane> solid, const Vec3& point_m) noexcept;
// Like closest_point, for the same solids with rounded edges and corners. The rounded solid consists of all points
// within rounding_m of the solid that remains if each face moves inwards by rounding_m. Over a face the result is
// bit-identical to that of the sharp solid. Expects that every face still has an area after it has moved.
ClosestPoint closest_point(const Aabb& box, double rounding_m, const Vec3& point_m) noexcept;
ClosestPoint closest_point(std::span<const Plane> solid, double rounding_m, const Vec3& point_m) noexcept;

// Returns the squared distance from a point to a box; 0 if the point is inside.
inline double distance_squared(const Aabb& box, const Vec3& p) noexcept {
    const Vec3 d = glm::max(glm::max(box.min_m - p, p - box.max_m), Vec3(0.0));
    return glm::dot(d, d);
}

}  // namespace handrail
