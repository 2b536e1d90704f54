#include "app/core/world/walker_meets.h"

#include <cmath>

#include "worlds/base/contract.h"

namespace handrail::core {

std::optional<Seen> walker_meets(const WalkerWorld& world, const Vec3& feet_m, const WalkerSize& size,
                                 double bearing_rad, double range_m) {
    contract_pre(is_finite(feet_m) && std::isfinite(bearing_rad));
    contract_pre(range_m > 0.0 && size.height_m > size.step_up_m);
    const Vec3 from = feet_m + Vec3(0.0, 0.0, size.step_up_m);
    const WalkerShape body{size.radius_m, size.height_m - size.step_up_m};
    const TraceHit hit = world.trace(from, from + forward_of_heading(bearing_rad) * range_m, body);
    if (!hit.hit) return std::nullopt;
    const Vec3 point = hit.end_m - hit.normal * size.radius_m;
    return Seen{bearing_rad, hit.fraction * range_m + size.radius_m, hit.feature, point};
}

}  // namespace handrail::core
