// When a moving sphere first touches a convex obstacle. The distance along a straight way is a convex function of it,
// so Newton's method comes to the first root from before it, never steps over it, and doubles its digits each time: two
// to four closest points, exact to rounding.
#pragma once

#include "tests/bench/compare/bench_world.h"

namespace handrail::bench {

inline constexpr double kNoHit = 2.0;

// Swept balls are kept this much farther out than their radius, or the edges of the next triangle of a plane would stop
// them at every seam; what is within twice that counts as touched, and a way that leads into it by less than a
// millionth of its length as a way along it.
inline constexpr double kSkin_m = 1e-8;
inline constexpr double kTouched_m = 2.0 * kSkin_m;
inline constexpr double kAlong = 1e-6;

// Part of the way (0 to 1) at which the sphere comes to its skin, or kNoHit. normal: of the contact.
inline double time_of_impact(const HapticScene& scene, std::uint32_t obstacle, const Vec3& from, const Vec3& way,
                             double radius_m, Vec3& normal) {
    constexpr double kReached_m = 1e-10;
    const double length = glm::length(way);
    double part = 0.0;
    for (int i = 0; i < 60; ++i) {
        const ClosestPoint closest = scene.closest(obstacle, from + way * part);
        const double slope = glm::dot(closest.normal, way), gap = closest.distance_m - radius_m;
        if (slope >= 0.0 || (part == 0.0 && gap < kTouched_m && slope > -kAlong * length)) return kNoHit;
        if (gap - kSkin_m <= kReached_m) {
            normal = closest.normal;
            return part;
        }
        part += (gap - kSkin_m) / -slope;
        if (part >= 1.0) return kNoHit;
    }
    return part;
}

}  // namespace handrail::bench
