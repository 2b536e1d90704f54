#include "app/core/world/walker.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/human_measures.h"

namespace handrail::core {
namespace {

constexpr double kGroundReach_m = 0.02;  // ground within this distance below the soles carries the walker
constexpr double kTerminalSpeed_m_per_s = 50.0;
// Height by which a walker placed inside a solid is lifted each time, at most kLifts times.
constexpr double kLift_m = 0.02;
constexpr int kLifts = 25;

double horizontal_length(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

// A walker that is too wide for its place overlaps solids at its sides, and can walk out of them. But its centre must
// not be inside the ground. A piece that contains the centre is ignored, so the walker would fall through the ground.
// Therefore the walker is lifted until its centre is free.
Vec3 on_top_of_m(const WalkerWorld& world, const Vec3& feet_m, double height_m) {
    const WalkerShape middle{0.0, height_m};
    // Starts twice the contact gap above the feet. Ground at the height of the feet carries the walker, so it must not
    // count as an overlap.
    const Vec3 above = feet_m + Vec3(0.0, 0.0, 2.0 * WalkerWorld::kContactGap_m);
    for (int i = 0; i <= kLifts; ++i)
        if (const Vec3 lifted = above + Vec3(0.0, 0.0, i * kLift_m); !world.blocked(lifted, middle)) return lifted;
    return above;
}

}  // namespace

WalkerSize walker_size(const Scene& scene, double radius_m) {
    contract_pre(radius_m > 0.0);
    WalkerSize size;
    size.radius_m = radius_m;
    if (scene.game_map) {
        size.height_m = 1.7;
        size.step_up_m = 0.57;
        size.eye_height_m = 1.5;
    }
    return size;
}

TraceHit Walker::ground_below(const Vec3& feet_m, double depth_m) const {
    return world_.trace(feet_m, feet_m - Vec3(0.0, 0.0, depth_m), shape());
}

bool Walker::stands_on_stairs(const Vec3& feet_m) const {
    if (!world_.has_stairs()) return false;
    const TraceHit ground = ground_below(feet_m, kGroundReach_m);
    return ground.hit && world_.is_stairs(ground.piece);
}

Walker::Slide Walker::slide(const Vec3& from_m, Vec3 motion_m) const {
    Slide result{from_m, std::nullopt};
    Vec3 normals[4];
    int met = 0;
    while (met < 4 && glm::length(motion_m) > 1e-9) {
        const TraceHit hit = world_.trace(result.end_m, result.end_m + motion_m, shape());
        result.end_m = hit.end_m;
        if (!hit.hit) break;
        if (hit.normal.z < kWalkableNormalZ && !result.first_wall) result.first_wall = hit;
        normals[met++] = hit.normal;
        Vec3 rest = motion_m * (1.0 - hit.fraction);
        // The remaining motion must not lead into any surface met before. First try motion along one surface, then
        // along the edge between two surfaces, then no motion.
        Vec3 clipped{0.0};
        bool found = false;
        for (int i = met - 1; i >= 0 && !found; --i) {
            clipped = rest - normals[i] * std::min(0.0, glm::dot(rest, normals[i]));
            found = std::all_of(normals, normals + met, [&](const Vec3& n) { return glm::dot(clipped, n) >= -1e-12; });
        }
        if (!found && met == 2) {
            const Vec3 crease = glm::cross(normals[0], normals[1]);
            const double length2 = glm::dot(crease, crease);
            if (length2 > 1e-12) {
                clipped = crease * (glm::dot(rest, crease) / length2);
                found = true;
            }
        }
        if (!found) break;
        motion_m = clipped;
    }
    return result;
}

void Walker::place(const Vec3& feet_m) {
    contract_pre(is_finite(feet_m));
    state_ = {};
    state_.feet_m = feet_m;
    for (int i = 1; i <= kLifts && world_.blocked(state_.feet_m, shape()); ++i)
        state_.feet_m = feet_m + Vec3(0.0, 0.0, i * kLift_m);
    if (world_.blocked(state_.feet_m, shape())) state_.feet_m = on_top_of_m(world_, feet_m, size_.height_m);
    const TraceHit ground = ground_below(state_.feet_m, size_.step_up_m + 0.5);
    if (ground.hit && ground.normal.z >= kWalkableNormalZ) {
        state_.feet_m = ground.end_m;
        state_.on_ground = true;
    }
    fall_from_z_ = state_.feet_m.z;
}

WalkResult Walker::tick(const Vec3& intended_m_per_s, double dt_s) {
    contract_pre(is_finite(intended_m_per_s));
    contract_pre(dt_s >= 0.0 && dt_s <= 0.1 + 1e-9);
    WalkResult result;
    const Vec3 start = state_.feet_m;
    const bool stood = state_.on_ground;
    Vec3 motion{intended_m_per_s.x * dt_s, intended_m_per_s.y * dt_s, 0.0};
    const double intended = horizontal_length(motion);
    if (!stood) {
        state_.fall_speed_m_per_s =
            std::min(kTerminalSpeed_m_per_s, state_.fall_speed_m_per_s + kGravity_m_per_s2 * dt_s);
        motion.z = -state_.fall_speed_m_per_s * dt_s;
    }

    Slide way = slide(start, motion);
    if (stood && way.first_wall && intended > 0.0) {
        // Tries to go one step up, forward, and down again. Stores the result if it leads farther and ends on walkable
        // ground. Under a low lintel, a high step would push the head into the lintel, so the function tries lower
        // steps after that.
        const bool stairs = world_.is_stairs(way.first_wall->piece) || stands_on_stairs(start);
        const double step_m = stairs ? StairRule::step_m(size_.step_up_m) : size_.step_up_m;
        for (const double part : {1.0, 0.75, 0.5, 0.25, 0.1}) {
            const double lift_m = part * step_m;
            const TraceHit up = world_.trace(start, start + Vec3(0.0, 0.0, lift_m), shape());
            const Slide high = slide(up.end_m, motion);
            const TraceHit down = world_.trace(high.end_m, high.end_m - Vec3(0.0, 0.0, up.end_m.z - start.z), shape());
            const double low_path = horizontal_length(way.end_m - start),
                         high_path = horizontal_length(down.end_m - start);
            if (!down.hit || down.normal.z < kWalkableNormalZ || high_path <= low_path + 1e-9) continue;
            result.climbed_m = std::max(0.0, down.end_m.z - start.z);
            way.end_m = down.end_m;
            way.first_wall = high.first_wall;
            break;
        }
    }
    state_.feet_m = way.end_m;
    result.walked_m = horizontal_length(state_.feet_m - start);
    if (way.first_wall && intended > 0.0) {
        result.met = way.first_wall;
        const double into = -glm::dot(way.first_wall->normal, motion) / intended;
        if (into > 0.5 || result.walked_m < 0.5 * intended) result.bump = way.first_wall;
    }

    // On stairs and slopes that lead down, the walker follows the ground for up to one step. A larger drop is a fall.
    const double reach = stood ? size_.step_up_m + kGroundReach_m : kGroundReach_m;
    TraceHit ground = ground_below(state_.feet_m, reach);
    if (stood && !ground.hit && world_.has_stairs()) {
        ground = ground_below(state_.feet_m, StairRule::step_m(size_.step_up_m) + kGroundReach_m);
        ground.hit = ground.hit && (world_.is_stairs(ground.piece) || stands_on_stairs(start));
    }
    const bool carries = ground.hit && ground.normal.z >= kWalkableNormalZ;
    if (carries && state_.fall_speed_m_per_s >= 0.0) {
        state_.feet_m = ground.end_m;
        // The surface under the walker's centre gives the ground its name. At a border between two surfaces, it is the
        // eastern or northern one (see WalkerWorld::trace).
        const TraceHit under = world_.trace(state_.feet_m + Vec3(0.0, 0.0, 0.05), state_.feet_m - Vec3(0.0, 0.0, 0.05),
                                            WalkerShape{}, true);
        result.ground = under.hit ? under.feature : ground.feature;
        result.ground_material = under.hit ? under.material : ground.material;
        if (!stood) {
            result.fell_m = fall_from_z_ - state_.feet_m.z;
            result.landed = result.fell_m > size_.step_up_m;
        }
        state_.on_ground = true;
        state_.fall_speed_m_per_s = 0.0;
        fall_from_z_ = state_.feet_m.z;
    } else {
        if (stood) fall_from_z_ = start.z;
        state_.on_ground = false;
    }
    return result;
}

}  // namespace handrail::core
