// Closest points of round solids in closed form: sphere, capsule, cylinder and cone. The contract is that of
// closest_point.h: the unit normal belongs to a plane that supports the whole shape, wherever the query point is.
// Directions are composed of the axis and a unit vector perpendicular to it, so they support the shape to rounding even
// very close to the axis. On the axis, where all directions are equally good, any_perpendicular of the axis is used.
// Zero radius and zero height are allowed: points, segments, discs. Pure functions, any thread, no allocation, double
// precision. Cost: see docs/results.md. Brute-force counterparts in tests/unit/geometry_touch.
#pragma once

#include <variant>

#include "worlds/base/vec.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/geometry/convex.h"

namespace handrail {

struct SphereShape {
    Vec3 centre_m{0.0};
    double radius_m = 0.0;
};

// All points within the radius of a segment.
struct CapsuleShape {
    Vec3 start_m{0.0};
    Vec3 axis{0.0, 0.0, 1.0};  // unit, from start to the other end of the segment
    double length_m = 0.0;     // of the segment, without the round ends
    double radius_m = 0.0;
};

// Flat caps and a sharp rim.
struct CylinderShape {
    Vec3 bottom_m{0.0};        // middle of the bottom cap
    Vec3 axis{0.0, 0.0, 1.0};  // unit, from bottom to top
    double height_m = 0.0;
    double radius_m = 0.0;
};

// Flat base, sharp rim, sharp apex.
struct ConeShape {
    Vec3 base_m{0.0};          // middle of the base
    Vec3 axis{0.0, 0.0, 1.0};  // unit, from base to apex
    double height_m = 0.0;
    double radius_m = 0.0;   // of the base
    double slant_out = 1.0;  // parts of the side's normal: slant_out away from the axis, slant_up along it
    double slant_up = 0.0;
};
// One of these shapes, or none.
using RoundShape = std::variant<std::monostate, SphereShape, CapsuleShape, CylinderShape, ConeShape>;

ConeShape make_cone(const Vec3& base_m, const Vec3& axis, double height_m, double radius_m) noexcept;

ClosestPoint closest_point(const SphereShape& sphere, const Vec3& point_m) noexcept;
ClosestPoint closest_point(const CapsuleShape& capsule, const Vec3& point_m) noexcept;
ClosestPoint closest_point(const CylinderShape& cylinder, const Vec3& point_m) noexcept;
ClosestPoint closest_point(const ConeShape& cone, const Vec3& point_m) noexcept;

Aabb bounds_of(const SphereShape& sphere) noexcept;
Aabb bounds_of(const CapsuleShape& capsule) noexcept;
Aabb bounds_of(const CylinderShape& cylinder) noexcept;
Aabb bounds_of(const ConeShape& cone) noexcept;

// The face of a solid of revolution that a supporting plane with this normal touches. Cylinder: side 0, bottom 1, top
// 2; cone: side 0, base 1. On a rim it is the face that faces more in that direction.
int face_towards(const CylinderShape& cylinder, const Vec3& normal) noexcept;
int face_towards(const ConeShape& cone, const Vec3& normal) noexcept;

}  // namespace handrail
