// Finds closest points of round solids in closed form: sphere, capsule, cylinder and cone. The contract is that of
// closest_point.h: the unit normal belongs to a plane that supports the whole shape, wherever the query point is.
// Directions are composed of the axis and a unit vector perpendicular to it. So they support the shape, except for
// rounding errors, even very close to the axis. On the axis all perpendicular directions are equally good, and the
// functions use any_perpendicular of the axis. A radius or height of zero is allowed and gives points, segments and
// discs. Pure functions in double precision; any thread; no allocation. The cost is in docs/results.md. Brute-force
// counterparts are in tests/unit/geometry_touch.
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
    Vec3 axis{0.0, 0.0, 1.0};  // unit length, from start_m to the other end of the segment
    double length_m = 0.0;     // length of the segment, without the round ends
    double radius_m = 0.0;
};

// A cylinder with flat caps and sharp rims.
struct CylinderShape {
    Vec3 bottom_m{0.0};        // middle of the bottom cap
    Vec3 axis{0.0, 0.0, 1.0};  // unit length, from the bottom to the top
    double height_m = 0.0;
    double radius_m = 0.0;
};

// A cone with a flat base, a sharp rim and a sharp apex.
struct ConeShape {
    Vec3 base_m{0.0};          // middle of the base
    Vec3 axis{0.0, 0.0, 1.0};  // unit length, from the base to the apex
    double height_m = 0.0;
    double radius_m = 0.0;  // radius of the base
    // slant_out and slant_up are the components of the side's normal: away from the axis and along it.
    double slant_out = 1.0;
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

// Returns the face of a solid of revolution that a supporting plane with this normal touches. The faces of a cylinder
// are side 0, bottom 1 and top 2; those of a cone are side 0 and base 1. If the plane touches a rim, the face whose own
// normal is nearer to `normal` is returned.
int face_towards(const CylinderShape& cylinder, const Vec3& normal) noexcept;
int face_towards(const ConeShape& cone, const Vec3& normal) noexcept;

}  // namespace handrail
