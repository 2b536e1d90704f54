// Closest points of convex shapes for the haptic renderer. Each comes with the unit normal of a plane that supports the
// shape there, so that the plane bounds the whole shape wherever the query point was. Pure functions, any thread, no
// allocation, double precision. Cost on a 2.5 GHz core: about 10 to 60 ns each. Every routine has a brute-force
// counterpart in tests/unit/geometry_touch.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"

namespace handrail {

// Nearer than this, the direction to the query point is only rounding error.
inline constexpr double kSideless_m = 1e-12;

struct ClosestPoint {
    Vec3 point_m{0.0};  // on the shape's surface
    // Unit length, away from the shape: dot(normal, o) <= dot(normal, point_m) for every point o of the shape.
    Vec3 normal{0.0, 0.0, 1.0};
    double distance_m = 0.0;  // negative inside solids
};

// A triangle prepared for queries: a two-sided sheet. If its height over the longest edge is less than 1e-7 m, it is
// treated as that edge. This also covers triangles without area, needles and points (error at most 1e-7 m).
struct TriangleShape {
    Vec3 a_m{0.0}, b_m{0.0}, c_m{0.0};  // ab is the longest edge
    Vec3 normal{0.0};                   // zero when degenerate
    std::array<Vec3, 3> outward{};      // in the plane, outwards from edges ab, bc, ca; not of unit length
    bool degenerate = true;
};
TriangleShape make_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m) noexcept;

// A plane that supports a triangle and is perpendicular to the line from the triangle's middle to a point. It costs a
// quarter of closest_point, and from afar is nearly as tight. Returns how far the point is in front of the plane, which
// is at most its distance from the triangle. Returns 0, and sets no normal, if the plane does not separate the two.
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

// A corner of a flat convex polygon, with the outward direction of the edge that leads to the next corner: in the
// plane, not of unit length.
struct PolygonCorner {
    Vec3 at_m{0.0};
    Vec3 outward{0.0};
};

// A flat convex polygon prepared for queries: a view of corners that are stored elsewhere. It is a two-sided sheet; its
// front is the side that its normal points to. If its height over the longest diagonal is less than 1e-7 m, it is
// treated as that diagonal: two corners and a zero normal.
struct PolygonShape {
    Vec3 normal{0.0};
    std::span<const PolygonCorner> corners;

    bool degenerate() const noexcept { return normal == Vec3(0.0); }
};

// Appends the prepared corners and returns the normal. Expects 2 or more points of a convex polygon, counter-clockwise
// seen from the front. Points may repeat or be within 1e-9 m of an edge; these are left out, because otherwise a query
// point over one part of the edge could seem to be beyond the other part. The distance of the points from a common
// plane is the error of every answer.
Vec3 make_polygon(std::span<const Vec3> points_m, std::vector<PolygonCorner>& corners);

// If the point is nearer than 1e-12 m, its side cannot be determined, and the triangle's own normal is returned.
ClosestPoint closest_point(const TriangleShape& triangle, const Vec3& point_m) noexcept;
// The same for a triangle that was not prepared. Use it to look at many triangles once each.
ClosestPoint closest_point_of_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const Vec3& point_m) noexcept;
// As for the triangle; scans the edges.
ClosestPoint closest_point(const PolygonShape& polygon, const Vec3& point_m) noexcept;
// An axis-aligned box. Inside, the nearest face counts.
ClosestPoint closest_point(const Aabb& box, const Vec3& point_m) noexcept;
// A bounded convex solid given by its planes (at least 4). Inside, the nearest plane counts.
ClosestPoint closest_point(std::span<const Plane> solid, const Vec3& point_m) noexcept;
// The same solids with every edge and corner rounded: all places within rounding_m of the solid that remains if each
// face moves inwards by rounding_m. Over a face the answer is bit-identical to that of the sharp solid. Expects that
// every face still has an area after it has moved.
ClosestPoint closest_point(const Aabb& box, double rounding_m, const Vec3& point_m) noexcept;
ClosestPoint closest_point(std::span<const Plane> solid, double rounding_m, const Vec3& point_m) noexcept;

// Squared distance from a point to a box; 0 if the point is inside.
inline double distance_squared(const Aabb& box, const Vec3& p) noexcept {
    const Vec3 d = glm::max(glm::max(box.min_m - p, p - box.max_m), Vec3(0.0));
    return glm::dot(d, d);
}

}  // namespace handrail
