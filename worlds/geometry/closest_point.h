// Closest points of convex shapes, as the touch renderer needs them: with the unit normal of a plane that supports the
// shape there, so that the plane bounds the whole shape wherever the query point was. Pure functions, any thread, no
// allocation, double precision. Cost on a 2.5 GHz core: about 10 to 60 ns each. Every routine has a brute-force twin in
// tests/unit/geometry_touch.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"

namespace handrail {

inline constexpr double kSideless_m = 1e-12;  // nearer than this a direction to the query point is only rounding

struct ClosestPoint {
    Vec3 point_m{0.0};  // of the shape's surface
    Vec3 normal{
        0.0, 0.0,
        1.0};  // unit, away from the shape; dot(normal, o) <= dot(normal, point_m) for every point o of the shape
    double distance_m = 0.0;  // negative inside solids
};

// A triangle prepared for queries: a two-sided sheet. One that is lower than 1e-7 m over its longest edge is that edge,
// which also covers triangles of no area, needles and points (error at most 1e-7 m).
struct TriangleShape {
    Vec3 a_m{0.0}, b_m{0.0}, c_m{0.0};  // ab is the longest edge
    Vec3 normal{0.0};                   // zero when degenerate
    std::array<Vec3, 3> outward{};      // in the plane, out of edges ab, bc, ca; not of unit length
    bool degenerate = true;
};
TriangleShape make_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m) noexcept;

// The plane that supports a triangle square to the line from its middle to a point: a quarter of the work of
// closest_point, and from afar nearly as tight. Returns how far the point is in front of it, at most its distance from
// the triangle; 0, and no normal, where that plane does not keep it off.
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

// A corner of a flat convex polygon, with the direction out of the edge that leads to the next corner: in the plane,
// not of unit length.
struct PolygonCorner {
    Vec3 at_m{0.0};
    Vec3 outward{0.0};
};

// A flat convex polygon prepared for queries, a view of corners kept elsewhere: a two-sided sheet whose front is the
// side its normal points to. One that is lower than 1e-7 m over its longest diagonal is that diagonal: two corners and
// no normal.
struct PolygonShape {
    Vec3 normal{0.0};
    std::span<const PolygonCorner> corners;

    bool degenerate() const noexcept { return normal == Vec3(0.0); }
};

// Appends the prepared corners and returns the normal. Expects 2 or more points of a convex polygon, counter-clockwise
// seen from the front; points may repeat or lie on an edge (within 1e-9 m: they are left out, or a query point over the
// one part of an edge could seem to be beyond the other). How far they lie out of one plane is the error of every
// answer.
Vec3 make_polygon(std::span<const Vec3> points_m, std::vector<PolygonCorner>& corners);

// Nearer than 1e-12 m the side cannot be told: the triangle's own normal is given.
ClosestPoint closest_point(const TriangleShape& triangle, const Vec3& point_m) noexcept;
// The same for a triangle that was not prepared: what looks at many triangles once each needs.
ClosestPoint closest_point_of_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const Vec3& point_m) noexcept;
// As the triangle; a scan of the edges.
ClosestPoint closest_point(const PolygonShape& polygon, const Vec3& point_m) noexcept;
// Axis-aligned. Inside, the nearest face.
ClosestPoint closest_point(const Aabb& box, const Vec3& point_m) noexcept;
// A bounded convex solid given by its planes (at least 4). Inside, the nearest plane.
ClosestPoint closest_point(std::span<const Plane> solid, const Vec3& point_m) noexcept;
// The same solids with every edge and corner rounded: all places within rounding_m of what is left when each face moves
// in by as much. Over a face the answer is that of the sharp solid, bit for bit. Expects that every face still has an
// area when it has moved in.
ClosestPoint closest_point(const Aabb& box, double rounding_m, const Vec3& point_m) noexcept;
ClosestPoint closest_point(std::span<const Plane> solid, double rounding_m, const Vec3& point_m) noexcept;

// Squared distance from a point to a box; 0 inside.
inline double distance_squared(const Aabb& box, const Vec3& p) noexcept {
    const Vec3 d = glm::max(glm::max(box.min_m - p, p - box.max_m), Vec3(0.0));
    return glm::dot(d, d);
}

}  // namespace handrail
