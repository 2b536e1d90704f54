#include "app/core/world/hazards.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"

namespace handrail::core {
namespace {

constexpr double kSample_m = 0.05;
constexpr double kDeepest_m = 30.0;
constexpr double kAboveStep_m = 0.01;
constexpr double kLeastRiser_m = 0.08;
constexpr double kMostTread_m = 0.9;
constexpr int kLeastRisers = 3, kMostRisers = 99;
constexpr double kHeadroom_m = 1.2;  // free height that must be above each step of the examined path

// Returns the height of the ground under a point, or no value if there is none. The search begins a step above `z_m`
// and ends `depth_m` below it.
std::optional<double> ground_z(const WalkerWorld& world, double x, double y, double z_m, double step_m,
                               double depth_m) {
    const TraceHit hit = world.trace({x, y, z_m + step_m + kAboveStep_m}, {x, y, z_m - depth_m}, WalkerShape{});
    if (!hit.hit) return std::nullopt;
    return hit.end_m.z;
}

// The walker stands at an edge with its centre beyond the edge. Returns true if the walker, one body width farther on,
// stands on ground or meets an obstacle.
bool spanned(const WalkerWorld& world, const Vec3& edge_m, const Vec3& way, const GroundRules& rules) {
    const WalkerShape body{rules.body.radius_m, rules.body.height_m};
    const Vec3 high = edge_m + Vec3(0.0, 0.0, 0.02);
    const TraceHit along = world.trace(high, high + way * (rules.body.radius_m + 2.0 * kSample_m), body);
    if (along.hit) return true;  // An obstacle stops the walker before the walker can fall.
    return world.trace(along.end_m, along.end_m - Vec3(0.0, 0.0, rules.drop_m), body).hit;
}

}  // namespace

GroundRules ground_rules(const Scene& scene, const WalkerSize& body) {
    return {body, scene.game_map ? 2.0 * body.step_up_m + 0.06 : body.step_up_m + 0.15};
}

GroundAhead ground_ahead(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad, const GroundRules& rules,
                         double range_m) {
    contract_pre(is_finite(feet_m) && std::isfinite(bearing_rad));
    contract_pre(range_m > 0.0);
    GroundAhead found;
    const Vec3 way = forward_of_heading(bearing_rad);
    const double step_m = rules.body.step_up_m;
    double z = feet_m.z;
    if (const auto under = ground_z(world, feet_m.x, feet_m.y, feet_m.z, 0.05, rules.drop_m)) z = *under;
    StairsAhead run;
    double last_riser_m = 0.0;
    const auto end_run = [&] {
        if (run.risers >= kLeastRisers && !found.stairs) found.stairs = run;
        run = {};
    };
    for (double at = kSample_m; at <= range_m + 1e-9 || run.risers > 0; at += kSample_m) {
        if (run.risers > 0 && at - last_riser_m > kMostTread_m) {
            end_run();
            if (found.stairs || at > range_m) break;
        }
        const Vec3 before = feet_m + way * (at - kSample_m), here = feet_m + way * at;
        // This ray is at the height at which ground_z() begins its search. So ground_z() finds everything below the
        // ray.
        const double eye_z = z + step_m + kAboveStep_m;
        if (world.trace({before.x, before.y, eye_z}, {here.x, here.y, eye_z}, WalkerShape{0.0, kHeadroom_m}).hit) {
            run.whole = false;
            break;
        }
        const auto next = ground_z(world, here.x, here.y, z, step_m, kDeepest_m);
        const double rise = next ? *next - z : -kDeepest_m;
        if (rise < -rules.drop_m) {
            const Vec3 edge(before.x, before.y, z);
            if (!spanned(world, edge, way, rules)) {
                run = {};  // The line has left the stairs at their side, so the risers until now are forgotten.
                if (at <= range_m + kSample_m)
                    found.drop = DropAhead{at - kSample_m, next ? std::optional(-rise) : std::nullopt, edge};
                break;
            }
            continue;  // The ground continues at the same height, so this is a gap that the walker steps over.
        }
        if (std::abs(rise) >= kLeastRiser_m) {
            const bool up = rise > 0.0;
            if (run.risers > 0 && run.up != up) end_run();
            if (run.risers == 0) {
                if (found.stairs || at > range_m) break;
                run = {up, 0, true, at - 0.5 * kSample_m, 0.0, Vec3(here.x, here.y, z)};
            }
            if (++run.risers > kMostRisers) break;
            run.height_m += rise;
            last_riser_m = at;
        }
        z = *next;
    }
    end_run();
    return found;
}

std::optional<DropAhead> over_drop(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad,
                                   const GroundRules& rules) {
    contract_pre(is_finite(feet_m) && std::isfinite(bearing_rad));
    const auto under = ground_z(world, feet_m.x, feet_m.y, feet_m.z, 0.05, kDeepest_m);
    if (under && feet_m.z - *under <= rules.drop_m) return std::nullopt;
    if (spanned(world, feet_m, forward_of_heading(bearing_rad), rules)) return std::nullopt;
    return DropAhead{0.0, under ? std::optional(feet_m.z - *under) : std::nullopt, feet_m};
}

double ground_slope(const WalkerWorld& world, const Vec3& feet_m, double bearing_rad) {
    contract_pre(is_finite(feet_m) && std::isfinite(bearing_rad));
    const TraceHit under = world.trace(feet_m + Vec3(0.0, 0.0, 0.05), feet_m - Vec3(0.0, 0.0, 0.3), WalkerShape{});
    if (!under.hit || under.normal.z < 0.5) return 0.0;
    return -glm::dot(under.normal, forward_of_heading(bearing_rad)) / under.normal.z;
}

double drop_beat_s(double distance_m) {
    contract_pre(std::isfinite(distance_m));
    return 0.12 + 0.68 * std::clamp(distance_m / kDropWarning_m, 0.0, 1.0);
}

}  // namespace handrail::core
