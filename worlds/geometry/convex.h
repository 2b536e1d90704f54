// Defines planes, boxes, convex polygons and convex solids as plain values in world metres. Pure data and pure
// functions: any thread may use them.
#pragma once

#include <limits>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

// A plane: the points p with dot(normal, p) == offset_m. The normal has length 1 and points out of the solid that the
// plane bounds.
struct Plane {
    Vec3 normal{0.0, 0.0, 1.0};
    double offset_m = 0.0;
};

inline double signed_distance(const Plane& plane, const Vec3& point_m) noexcept {
    return glm::dot(plane.normal, point_m) - plane.offset_m;
}

// An axis-aligned box. It is empty (min > max) until a point is included.
struct Aabb {
    Vec3 min_m{std::numeric_limits<double>::infinity()};
    Vec3 max_m{-std::numeric_limits<double>::infinity()};

    bool empty() const noexcept { return !(min_m.x <= max_m.x); }
    void include(const Vec3& p) noexcept {
        min_m = glm::min(min_m, p);
        max_m = glm::max(max_m, p);
    }
    void include(const Aabb& b) noexcept {
        min_m = glm::min(min_m, b.min_m);
        max_m = glm::max(max_m, b.max_m);
    }
    Vec3 centre_m() const noexcept { return 0.5 * (min_m + max_m); }
    Vec3 size_m() const noexcept { return max_m - min_m; }
};

// A flat convex polygon with at least 3 points. They run counter-clockwise seen from the side that the normal of its
// plane points to.
struct Polygon {
    std::vector<Vec3> points_m;
};

// A bounded intersection of half-spaces. faces[i] is the polygon of planes[i]; both have the same size, and planes
// without a face are removed.
struct ConvexSolid {
    std::vector<Plane> planes;
    std::vector<Polygon> faces;
    Aabb bounds_m;
};

// True if the point is inside the solid after every plane is moved outwards by `grow_m`, or on its border.
bool contains(const ConvexSolid& solid, const Vec3& point_m, double grow_m = 0.0) noexcept;

}  // namespace handrail
