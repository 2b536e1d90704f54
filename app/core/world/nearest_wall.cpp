#include "app/core/world/nearest_wall.h"

#include <cmath>

#include "app/core/world/body_heights.h"
#include "worlds/base/contract.h"

namespace handrail::core {

std::optional<NearestWall> nearest_wall(const WalkerWorld& world, const Vec3& feet_m, double reach_m) {
    contract_pre(is_finite(feet_m));
    contract_pre(reach_m > 0.0);
    constexpr int kLooks = 32;
    constexpr double kUpright = 0.3;  // a surface is upright if the z component of its normal is at most this
    std::optional<NearestWall> nearest;
    const Vec3 eye = feet_m + Vec3(0.0, 0.0, kWaist_m);
    for (int i = 0; i < kLooks; ++i) {
        const TraceHit hit =
            world.trace(eye, eye + forward_of_heading(i * 2.0 * kPi / kLooks) * reach_m, WalkerShape{}, true);
        if (!hit.hit || std::abs(hit.normal.z) > kUpright) continue;
        const double distance_m = hit.fraction * reach_m;
        if (nearest && distance_m >= nearest->distance_m) continue;
        nearest = NearestWall{hit.feature, distance_m, std::atan2(-hit.normal.x, -hit.normal.y)};
    }
    return nearest;
}

}  // namespace handrail::core
