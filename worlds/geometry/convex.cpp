#include "worlds/geometry/convex.h"

namespace handrail {

bool contains(const ConvexSolid& solid, const Vec3& point_m, double grow_m) noexcept {
    for (const Plane& plane : solid.planes)
        if (signed_distance(plane, point_m) > grow_m) return false;
    return true;
}

}  // namespace handrail
