#include "app/core/world/cane_tip.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"

namespace handrail::core {
namespace {

// The grip of a long cane is in front of the navel.
constexpr double kGripHeight_m = 0.85, kGripAhead_m = 0.3;
constexpr double kTipGap_m = 0.02;     // height of a tip on level ground above the ground
constexpr double kLifted_m = 0.05;     // height of a lifted tip
constexpr double kTipRadius_m = 0.02;  // radius of the tip, which does not fall into narrower seams
constexpr double kLeastStep_m = 0.08;  // a smaller change of height is no step
constexpr double kTipDeepest_m = 30.0;
constexpr double kBehindFace_m = 0.05;  // how far behind the face of a riser its top is searched
constexpr double kWalkableZ = 0.5;      // a surface whose normal has a smaller z is a wall or riser

CaneTip met(CaneMeets meets, const TraceHit& hit) { return {meets, hit.end_m, {}, hit.feature, hit.material}; }

// Returns how much a surface rises per metre in the direction `way`.
double slope_along(const Vec3& normal, const Vec3& way) {
    return -glm::dot(normal, way) / std::max(normal.z, kWalkableZ);
}

}  // namespace

double cane_reach_m(double length_m) {
    contract_pre(length_m > kGripHeight_m);
    return kGripAhead_m + std::sqrt(length_m * length_m - kGripHeight_m * kGripHeight_m);
}

CaneTip put_cane(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad, double length_m,
                 const GroundRules& rules, bool lifted) {
    contract_pre(is_finite(feet_m) && std::isfinite(bearing_rad));
    const Vec3 way = forward_of_heading(bearing_rad);
    const double reach_m = cane_reach_m(length_m);
    const double slope_here = ground_slope(world, feet_m, bearing_rad);
    const Vec3 body = feet_m + Vec3(0.0, 0.0, kGripHeight_m), grip = body + way * kGripAhead_m;
    const Vec3 tip = feet_m + way * reach_m + Vec3(0.0, 0.0, lifted ? kLifted_m : kTipGap_m);
    // 1. Something may be between the body, the grip and the tip.
    TraceHit hit = world.trace(body, grip, WalkerShape{});
    if (!hit.hit) hit = world.trace(grip, tip, WalkerShape{});
    if (hit.hit) {
        if (hit.normal.z >= kWalkableZ) {
            const double rise_m = hit.end_m.z - feet_m.z;
            const double slope = std::max({0.0, slope_here, slope_along(hit.normal, way)});
            return met(rise_m < slope * reach_m + kLeastStep_m ? CaneMeets::Ground : CaneMeets::Higher, hit);
        }
        const Vec3 behind = hit.end_m + way * kBehindFace_m;
        const double top_z = feet_m.z + rules.body.step_up_m + kTipGap_m;
        if (hit.end_m.z < top_z) {
            const TraceHit top = world.trace({behind.x, behind.y, top_z}, {behind.x, behind.y, hit.end_m.z}, {});
            if (top.hit) return met(CaneMeets::Higher, hit);
        }
        return met(CaneMeets::Obstacle, hit);
    }
    if (lifted) return {CaneMeets::Ground, tip, {}, kNoFeature, kDefaultMaterial};
    // 2. The tip is free, so the ground is below it.
    const TraceHit below = world.trace(tip, {tip.x, tip.y, feet_m.z - kTipDeepest_m}, WalkerShape{kTipRadius_m, 0.0});
    if (!below.hit) return {CaneMeets::Drop, tip, {}, kNoFeature, kDefaultMaterial};
    const double fall_m = feet_m.z - below.end_m.z;
    const double slope = std::min({0.0, slope_here, slope_along(below.normal, way)});
    if (fall_m < kLeastStep_m - slope * reach_m) return met(CaneMeets::Ground, below);
    if (fall_m <= rules.drop_m) return met(CaneMeets::Lower, below);
    CaneTip drop = met(CaneMeets::Drop, below);
    drop.place_m.z = feet_m.z;
    drop.depth_m = fall_m;
    return drop;
}

}  // namespace handrail::core
