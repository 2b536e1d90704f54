#include "worlds/geometry/round_shapes.h"

#include <algorithm>
#include <cmath>

namespace handrail {
namespace {

// A point relative to an axis: its position along the axis, its distance from the axis, and the direction of that
// distance.
struct AroundAxis {
    double along_m;
    double out_m;
    Vec3 outward;  // unit length, perpendicular to the axis
};

AroundAxis around_axis(const Vec3& origin, const Vec3& axis, const Vec3& p) noexcept {
    const Vec3 from = p - origin;
    const double along = glm::dot(from, axis);
    // Close to the axis, the first difference is mostly rounding error and may point along the axis. The second
    // subtraction removes that part.
    Vec3 out = from - axis * along;
    out -= axis * glm::dot(out, axis);
    const double length = glm::length(out);
    return length > kSideless_m ? AroundAxis{along, length, out / length}
                                : AroundAxis{along, 0.0, any_perpendicular(axis)};
}

// Returns the closest point if it is a corner of the profile. `out` and `along` lead from that corner to the query
// point. If the corner and the query point coincide, the normal is `sideless`.
ClosestPoint from_profile_corner(const Vec3& corner, double out, double along, const AroundAxis& at, const Vec3& axis,
                                 const Vec3& sideless) noexcept {
    const double distance = std::sqrt(out * out + along * along);
    if (distance <= kSideless_m) return {corner, sideless, distance};
    return {corner, at.outward * (out / distance) + axis * (along / distance), distance};
}

void include_disc(Aabb& box, const Vec3& centre, const Vec3& axis, double radius) noexcept {
    Vec3 half;
    for (int i = 0; i < 3; ++i) half[i] = radius * std::sqrt(std::max(0.0, 1.0 - axis[i] * axis[i]));
    box.include(centre - half);
    box.include(centre + half);
}

}  // namespace

ConeShape make_cone(const Vec3& base_m, const Vec3& axis, double height_m, double radius_m) noexcept {
    ConeShape cone{base_m, axis, height_m, radius_m};
    const double slant = std::sqrt(height_m * height_m + radius_m * radius_m);
    if (slant > 0.0) {
        cone.slant_out = height_m / slant;
        cone.slant_up = radius_m / slant;
    }
    return cone;
}

ClosestPoint closest_point(const SphereShape& sphere, const Vec3& p) noexcept {
    const Vec3 out = p - sphere.centre_m;
    const double length = glm::length(out);
    const Vec3 normal = length > kSideless_m ? out / length : Vec3(0, 0, 1);
    return {sphere.centre_m + normal * sphere.radius_m, normal, length - sphere.radius_m};
}

ClosestPoint closest_point(const CapsuleShape& capsule, const Vec3& p) noexcept {
    const AroundAxis at = around_axis(capsule.start_m, capsule.axis, p);
    const double along = std::clamp(at.along_m, 0.0, capsule.length_m);
    const double beyond = at.along_m - along;
    const Vec3 middle = capsule.start_m + capsule.axis * along;
    const ClosestPoint core = from_profile_corner(middle, at.out_m, beyond, at, capsule.axis, at.outward);
    return {middle + core.normal * capsule.radius_m, core.normal, core.distance_m - capsule.radius_m};
}

ClosestPoint closest_point(const CylinderShape& cylinder, const Vec3& p) noexcept {
    const AroundAxis at = around_axis(cylinder.bottom_m, cylinder.axis, p);
    const bool top = 2.0 * at.along_m >= cylinder.height_m;
    const double past_cap = top ? at.along_m - cylinder.height_m : -at.along_m;
    const double past_side = at.out_m - cylinder.radius_m;
    const double cap_along = top ? cylinder.height_m : 0.0;
    if (past_cap > 0.0 && past_side > 0.0)
        return from_profile_corner(cylinder.bottom_m + cylinder.axis * cap_along + at.outward * cylinder.radius_m,
                                   past_side, top ? past_cap : -past_cap, at, cylinder.axis, at.outward);
    if (past_cap > past_side)
        return {cylinder.bottom_m + cylinder.axis * cap_along + at.outward * at.out_m,
                top ? cylinder.axis : -cylinder.axis, past_cap};
    return {cylinder.bottom_m + cylinder.axis * at.along_m + at.outward * cylinder.radius_m, at.outward, past_side};
}

ClosestPoint closest_point(const ConeShape& cone, const Vec3& p) noexcept {
    const AroundAxis at = around_axis(cone.base_m, cone.axis, p);
    const double past_rim = at.out_m - cone.radius_m;
    if (at.along_m <= 0.0 && past_rim <= 0.0) return {cone.base_m + at.outward * at.out_m, -cone.axis, -at.along_m};
    const Vec3 slant = at.outward * cone.slant_out + cone.axis * cone.slant_up;
    const double past_slant = past_rim * cone.slant_out + at.along_m * cone.slant_up;
    // `up` is the distance from the rim up the side, `over` the distance past the apex. Each is measured from its own
    // corner, so that the normals there are exact except for rounding.
    const double up = at.along_m * cone.slant_out - past_rim * cone.slant_up;
    const double over = at.along_m - cone.height_m;
    const double past_apex = over * cone.slant_out - at.out_m * cone.slant_up;
    if (past_rim > 0.0 && up <= 0.0)
        return from_profile_corner(cone.base_m + at.outward * cone.radius_m, past_rim, at.along_m, at, cone.axis,
                                   slant);
    if (past_apex > 0.0)
        return from_profile_corner(cone.base_m + cone.axis * cone.height_m, at.out_m, over, at, cone.axis, slant);
    if (past_slant < -at.along_m) return {cone.base_m + at.outward * at.out_m, -cone.axis, -at.along_m};
    const double foot_out = at.out_m - past_slant * cone.slant_out,
                 foot_along = at.along_m - past_slant * cone.slant_up;
    return {cone.base_m + at.outward * foot_out + cone.axis * foot_along, slant, past_slant};
}

Aabb bounds_of(const SphereShape& sphere) noexcept {
    return {sphere.centre_m - Vec3(sphere.radius_m), sphere.centre_m + Vec3(sphere.radius_m)};
}

Aabb bounds_of(const CapsuleShape& capsule) noexcept {
    Aabb box = bounds_of(SphereShape{capsule.start_m, capsule.radius_m});
    box.include(bounds_of(SphereShape{capsule.start_m + capsule.axis * capsule.length_m, capsule.radius_m}));
    return box;
}

Aabb bounds_of(const CylinderShape& cylinder) noexcept {
    Aabb box;
    include_disc(box, cylinder.bottom_m, cylinder.axis, cylinder.radius_m);
    include_disc(box, cylinder.bottom_m + cylinder.axis * cylinder.height_m, cylinder.axis, cylinder.radius_m);
    return box;
}

Aabb bounds_of(const ConeShape& cone) noexcept {
    Aabb box;
    include_disc(box, cone.base_m, cone.axis, cone.radius_m);
    box.include(cone.base_m + cone.axis * cone.height_m);
    return box;
}

int face_towards(const CylinderShape& cylinder, const Vec3& normal) noexcept {
    const double up = glm::dot(cylinder.axis, normal);
    if (2.0 * up * up <= 1.0) return 0;
    return up < 0.0 ? 1 : 2;
}

int face_towards(const ConeShape& cone, const Vec3& normal) noexcept {
    const double up = glm::dot(cone.axis, normal);
    const double out = std::sqrt(std::max(0.0, 1.0 - up * up));
    return -up > out * cone.slant_out + up * cone.slant_up ? 1 : 0;
}

}  // namespace handrail
