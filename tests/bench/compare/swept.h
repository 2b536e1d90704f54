// Computes when a moving sphere first touches a convex obstacle. Along a straight path the distance to the obstacle is
// a convex function. Newton's method therefore approaches the first root from before it, never steps over it, and
// doubles the number of correct digits each time. With two to four closest-point queries the result is exact except for
// rounding.
#pragma once

#include "tests/bench/compare/bench_world.h"
#include "tests/support/names.h"

namespace handrail::bench {

inline constexpr double kNoHit = 2.0;

// Distance that swept spheres keep in addition to their radius. Without it, the edge of the next coplanar triangle
// would stop them at every seam. An obstacle within twice this distance is touched. If a path leads into an obstacle by
// less than a millionth of the path's length, it is treated as a path along the obstacle.
inline constexpr double kSkin_m = 1e-8;
inline constexpr double kTouched_m = 2.0 * kSkin_m;
inline constexpr double kAlong = 1e-6;

// Returns the fraction of the path (0 to 1) at which the sphere reaches the obstacle's skin, or kNoHit. Sets `normal`
// to the normal of the contact.
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
