#include "worlds/geometry/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "worlds/geometry/half_space_projection.h"

namespace handrail {
namespace {

// A corner of a polygon is dropped if it is this close to the line between its neighbours.
constexpr double kStraight_m = 1e-9;
// A triangle whose height over its longest edge is below this is treated as a segment.
constexpr double kLowestTriangle_m = 1e-7;

Vec3 closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) noexcept {
    const Vec3 ab = b - a;
    const double length2 = glm::dot(ab, ab);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
    return t == 1.0 ? b : a + ab * t;
}

// Returns the corner as the point of the shape that is nearest to `p`. The normal leads from the corner to `p`; if the
// two coincide, it is `sideless`.
ClosestPoint from_corner(const Vec3& corner, const Vec3& p, const Vec3& sideless) noexcept {
    const Vec3 away = p - corner;
    const double distance = glm::length(away);
    return {corner, distance > kSideless_m ? away / distance : sideless, distance};
}

// Replaces a direction that differs from the face normal only by rounding with the face normal itself. This happens
// exactly over an edge. Otherwise, neighbouring triangles of one plane would give slightly different normals there.
void snap_to_face(ClosestPoint& closest, const Vec3& normal) noexcept {
    const double along = glm::dot(closest.normal, normal);
    if (std::abs(along) > 1.0 - 8.0 * std::numeric_limits<double>::epsilon())
        closest.normal = along > 0.0 ? normal : -normal;
}

}  // namespace

TriangleShape make_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m) noexcept {
    TriangleShape t{a_m, b_m, c_m};
    const auto length2 = [](const Vec3& v) { return glm::dot(v, v); };
    const double ab = length2(b_m - a_m), bc = length2(c_m - b_m), ca = length2(a_m - c_m);
    if (bc > ab && bc >= ca) {
        t.a_m = b_m, t.b_m = c_m, t.c_m = a_m;
    } else if (ca > ab) {
        t.a_m = c_m, t.b_m = a_m, t.c_m = b_m;
    }
    const Vec3 edge = t.b_m - t.a_m;
    const Vec3 area = glm::cross(edge, t.c_m - t.a_m);
    const double twice_area = glm::length(area), longest = glm::length(edge);
    t.degenerate = !(longest > 0.0 && twice_area / longest > kLowestTriangle_m);
    if (t.degenerate) return t;
    t.normal = area / twice_area;
    t.outward = {glm::cross(edge, t.normal), glm::cross(t.c_m - t.b_m, t.normal), glm::cross(t.a_m - t.c_m, t.normal)};
    return t;
}

ClosestPoint closest_point(const TriangleShape& t, const Vec3& p) noexcept {
    if (t.degenerate) return from_corner(closest_on_segment(t.a_m, t.b_m, p), p, any_perpendicular(t.b_m - t.a_m));
    const Vec3 pa = p - t.a_m;
    const double out_ab = glm::dot(pa, t.outward[0]);
    const double out_bc = glm::dot(p - t.b_m, t.outward[1]);
    const double out_ca = glm::dot(p - t.c_m, t.outward[2]);
    if (out_ab <= 0.0 && out_bc <= 0.0 && out_ca <= 0.0) {
        const double height = glm::dot(pa, t.normal);
        return {p - t.normal * height, height < 0.0 ? -t.normal : t.normal, std::abs(height)};
    }
    Vec3 best{0.0};
    double best2 = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Vec3& a, const Vec3& b) {
        const Vec3 q = closest_on_segment(a, b, p);
        const double d2 = glm::dot(p - q, p - q);
        if (d2 < best2) {
            best2 = d2;
            best = q;
        }
    };
    if (out_ab > 0.0) consider(t.a_m, t.b_m);
    if (out_bc > 0.0) consider(t.b_m, t.c_m);
    if (out_ca > 0.0) consider(t.c_m, t.a_m);
    ClosestPoint result = from_corner(best, p, t.normal);
    snap_to_face(result, t.normal);
    return result;
}

Vec3 make_polygon(std::span<const Vec3> points_m, std::vector<PolygonCorner>& corners) {
    std::size_t a = 0, b = 0;
    double longest2 = 0.0;
    for (std::size_t i = 0; i < points_m.size(); ++i)
        for (std::size_t j = i + 1; j < points_m.size(); ++j) {
            const Vec3 way = points_m[j] - points_m[i];
            if (glm::dot(way, way) <= longest2) continue;
            longest2 = glm::dot(way, way);
            a = i, b = j;
        }
    const Vec3 along = points_m[b] - points_m[a];
    double widest = 0.0;
    Vec3 area(0.0);
    for (std::size_t i = 0; i < points_m.size(); ++i) {
        const Vec3 from_a = points_m[i] - points_m[a];
        if (longest2 > 0.0) widest = std::max(widest, glm::length(glm::cross(along, from_a)) / std::sqrt(longest2));
        if (i + 1 < points_m.size()) area += glm::cross(points_m[i] - points_m[0], points_m[i + 1] - points_m[0]);
    }
    const double twice_area = glm::length(area);
    if (!(widest > kLowestTriangle_m && twice_area > 0.0)) {
        corners.push_back({points_m[a], Vec3(0.0)});
        corners.push_back({points_m[b], Vec3(0.0)});
        return Vec3(0.0);
    }
    const Vec3 normal = area / twice_area;
    // Starts at an end of the longest diagonal, which is certainly a corner of the outline. Drops a corner if it and
    // all corners dropped since the last kept one are on the line from the last kept one to the next.
    const std::size_t count = points_m.size(), first = corners.size();
    std::size_t kept = 0;
    const auto point = [&](std::size_t i) -> const Vec3& { return points_m[(a + i) % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 way = point(i + 1) - point(kept);
        const double length = glm::length(way);
        bool straight = i > 0;
        for (std::size_t k = kept + 1; k <= i && straight; ++k) {
            const Vec3 from = point(k) - point(kept);
            straight = length > 0.0 ? glm::length(glm::cross(way, from)) <= kStraight_m * length
                                    : glm::length(from) <= kStraight_m;
        }
        if (straight) continue;
        corners.push_back({point(i), Vec3(0.0)});
        kept = i;
    }
    const std::span<PolygonCorner> own = std::span(corners).subspan(first);
    for (std::size_t i = 0; i < own.size(); ++i)
        own[i].outward = glm::cross(own[(i + 1) % own.size()].at_m - own[i].at_m, normal);
    return normal;
}

ClosestPoint closest_point(const PolygonShape& polygon, const Vec3& p) noexcept {
    const std::span<const PolygonCorner> corners = polygon.corners;
    if (polygon.degenerate())
        return from_corner(closest_on_segment(corners[0].at_m, corners[1].at_m, p), p,
                           any_perpendicular(corners[1].at_m - corners[0].at_m));
    Vec3 best{0.0};
    double best2 = std::numeric_limits<double>::infinity();
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (glm::dot(p - corners[i].at_m, corners[i].outward) <= 0.0) continue;
        const Vec3 q = closest_on_segment(corners[i].at_m, corners[i + 1 < count ? i + 1 : 0].at_m, p);
        const double d2 = glm::dot(p - q, p - q);
        if (d2 < best2) {
            best2 = d2;
            best = q;
        }
    }
    if (best2 == std::numeric_limits<double>::infinity()) {
        const double height = glm::dot(p - corners[0].at_m, polygon.normal);
        return {p - polygon.normal * height, height < 0.0 ? -polygon.normal : polygon.normal, std::abs(height)};
    }
    ClosestPoint result = from_corner(best, p, polygon.normal);
    snap_to_face(result, polygon.normal);
    return result;
}

ClosestPoint closest_point_of_triangle(const Vec3& a_m, const Vec3& b_m, const Vec3& c_m, const Vec3& p) noexcept {
    // The corners relative to the query point.
    const Vec3 a = a_m - p, b = b_m - p, c = c_m - p;
    const Vec3 ab = b - a, bc = c - b, ca = a - c;
    const Vec3 area = glm::cross(ca, ab);
    const double area2 = glm::dot(area, area), ab2 = glm::dot(ab, ab), bc2 = glm::dot(bc, bc), ca2 = glm::dot(ca, ca);
    if (!(area2 > kLowestTriangle_m * kLowestTriangle_m * std::max({ab2, bc2, ca2})))
        return closest_point(make_triangle(a_m, b_m, c_m), p);
    Vec3 best{0.0};
    double best2 = std::numeric_limits<double>::infinity();
    // An edge matters only if the point is beyond it. The sign of the volume spanned by the edge, the point and the
    // normal says on which side of the edge the point is.
    const auto edge = [&](const Vec3& from, const Vec3& to, const Vec3& along, double length2) noexcept {
        if (glm::dot(area, glm::cross(from, to)) >= 0.0) return;
        const double t = -glm::dot(from, along);
        const Vec3 q = t <= 0.0 ? from : t >= length2 ? to : from + along * (t / length2);
        const double d2 = glm::dot(q, q);
        if (d2 >= best2) return;
        best2 = d2;
        best = q;
    };
    edge(a, b, ab, ab2);
    edge(b, c, bc, bc2);
    edge(c, a, ca, ca2);
    // If the point is exactly over an edge, or its side cannot be determined, the normal is the face's own, as for a
    // prepared triangle.
    const double height = -glm::dot(area, a);
    const bool over_face = best2 == std::numeric_limits<double>::infinity();
    const double along = -glm::dot(area, best);
    if (!over_face && best2 > kSideless_m * kSideless_m &&
        !(along * along > area2 * best2 * (1.0 - 16.0 * std::numeric_limits<double>::epsilon()))) {
        const double distance = std::sqrt(best2);
        return {p + best, best * (-1.0 / distance), distance};
    }
    const Vec3 normal = area / std::sqrt(area2);
    if (over_face) {
        const double distance = height / std::sqrt(area2);
        return {p - normal * distance, distance < 0.0 ? -normal : normal, std::abs(distance)};
    }
    return {p + best, best2 > kSideless_m * kSideless_m && along < 0.0 ? -normal : normal, std::sqrt(best2)};
}

ClosestPoint closest_point(const Aabb& box, const Vec3& p) noexcept {
    const Vec3 q = glm::clamp(p, box.min_m, box.max_m);
    if (q != p) {
        const Vec3 away = p - q;
        const double distance = glm::length(away);
        if (distance > kSideless_m) return {q, away / distance, distance};
    }
    // The point is inside, or too near to a face to compute a direction. So the face with the greatest (least negative)
    // signed distance determines the result.
    ClosestPoint best{q, Vec3(0, 0, 1), -std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const double distance = side < 0.0 ? box.min_m[axis] - p[axis] : p[axis] - box.max_m[axis];
            if (distance <= best.distance_m) continue;
            best.distance_m = distance;
            best.normal = Vec3(0.0);
            best.normal[axis] = side;
            best.point_m = p;
            best.point_m[axis] = side < 0.0 ? box.min_m[axis] : box.max_m[axis];
        }
    }
    return best;
}

ClosestPoint closest_point(const Aabb& box, double rounding_m, const Vec3& p) noexcept {
    const Vec3 core = glm::clamp(p, box.min_m + rounding_m, box.max_m - rounding_m);
    const Vec3 away = p - core;
    const int beyond =
        static_cast<int>(away.x != 0.0) + static_cast<int>(away.y != 0.0) + static_cast<int>(away.z != 0.0);
    const double distance = glm::length(away);
    if (beyond < 2 || distance <= kSideless_m) return closest_point(box, p);
    const Vec3 normal = away / distance;
    return {core + normal * rounding_m, normal, distance - rounding_m};
}

namespace {

template <bool kRounded>
ClosestPoint closest_of_planes(std::span<const Plane> solid, [[maybe_unused]] double rounding_m,
                               const Vec3& p) noexcept {
    const auto inwards = [&](double distance) {
        if constexpr (kRounded) return distance + rounding_m;
        else return distance;
    };
    double deepest = -std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < solid.size(); ++i) {
        const double distance = signed_distance(solid[i], p);
        if (distance > deepest) {
            deepest = distance;
            nearest = i;
        }
    }
    const ClosestPoint on_plane{p - solid[nearest].normal * deepest, solid[nearest].normal, deepest};
    if (inwards(deepest) <= kSideless_m) return on_plane;
    ProjectionBasis basis;
    const bool solved = project_on_half_spaces(
        Vec3(0.0), static_cast<int>(solid.size()),
        [&](int i) {
            const Plane& plane = solid[static_cast<std::size_t>(i)];
            return HalfSpace{-plane.normal, inwards(signed_distance(plane, p))};
        },
        basis);
    // Each plane of the solid supports the whole solid, so this fallback is correct, only less tight.
    if (!solved || basis.count == 0) return on_plane;
    if (basis.count == 1) {
        const Plane& plane = solid[static_cast<std::size_t>(basis.index[0])];
        const double distance = signed_distance(plane, p);
        return {p - plane.normal * distance, plane.normal, distance};
    }
    ClosestPoint corner = from_corner(p + basis.point_m, p, solid[nearest].normal);
    if constexpr (kRounded) {
        corner.point_m += corner.normal * rounding_m;
        corner.distance_m -= rounding_m;
    }
    return corner;
}

}  // namespace

ClosestPoint closest_point(std::span<const Plane> solid, const Vec3& p) noexcept {
    return closest_of_planes<false>(solid, 0.0, p);
}

ClosestPoint closest_point(std::span<const Plane> solid, double rounding_m, const Vec3& p) noexcept {
    return closest_of_planes<true>(solid, rounding_m, p);
}

}  // namespace handrail
