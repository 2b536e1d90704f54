#include "app/core/world/trail.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"

namespace handrail::core {
namespace {

// If the z component of its normal is larger than this, a surface is ground, not a wall.
constexpr double kSteepest = 0.7;
constexpr double kFarthest_m = 4.0;  // largest distance at which a wall is searched for
// A wall within this distance on the requested side is preferred to a nearer wall elsewhere.
constexpr double kArm_m = 0.8;
constexpr double kWallEnds_m = 0.35;     // if the wall is farther from the walker's side than this, it has ended
constexpr double kStep_m = 0.05;         // distance between two probes past an opening
constexpr double kLeastRecess_m = 0.06;  // if the wall recedes by more than this, there is an opening
constexpr double kCornerCosine = 0.87;   // cosine of 30 degrees; a larger change of direction is a corner
constexpr double kProbe_m = 0.02;        // radius of the probe that names the wall
constexpr double kAlignedRad = 0.35;

WalkerShape shape_above_steps(const WalkerSize& body) { return {body.radius_m, body.height_m - body.step_up_m}; }
Vec3 above_steps(const Vec3& feet_m, const WalkerSize& body) { return feet_m + Vec3(0.0, 0.0, body.step_up_m); }
bool is_wall(const TraceHit& hit) { return hit.hit && std::abs(hit.normal.z) < kSteepest; }
Vec3 level(const Vec3& normal) {
    const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    return {normal.x / length, normal.y / length, 0.0};
}
double heading_of(const Vec3& way) { return std::atan2(way.x, way.y); }

// What is at one side: the distance that the walker can go in this direction before it meets a wall. side_of() returns
// no value if no wall is within `reach_m`.
struct Side {
    double distance_m = 0.0;
    Vec3 normal{0.0};
    FeatureId feature = kNoFeature;
};
std::optional<Side> side_of(const WalkerWorld& world, const Vec3& from_m, const Vec3& way, double reach_m,
                            const WalkerShape& shape) {
    const TraceHit hit = world.trace(from_m, from_m + way * reach_m, shape);
    if (!is_wall(hit)) return std::nullopt;
    return Side{hit.fraction * reach_m, level(hit.normal), hit.feature};
}

}  // namespace

Vec3 Trail::along() const {
    return side_ == TrailSide::Left ? Vec3(-normal_.y, normal_.x, 0.0) : Vec3(normal_.y, -normal_.x, 0.0);
}

double Trail::heading_rad() const { return heading_of(along()); }

bool Trail::start(const WalkerWorld& world, const Vec3& feet_m, double heading_rad, const WalkerSize& body,
                  TrailSide side) {
    contract_pre(is_finite(feet_m) && std::isfinite(heading_rad));
    contract_pre(body.radius_m > 0.0);
    *this = {};
    side_ = side;
    const Vec3 from = above_steps(feet_m, body);
    std::optional<Side> nearest;
    for (int i = 0; i < 16; ++i)
        if (const auto seen =
                side_of(world, from, forward_of_heading(i * kPi / 8.0), kFarthest_m, shape_above_steps(body)))
            if (!nearest || seen->distance_m < nearest->distance_m - 1e-6) nearest = seen;
    const double beside = heading_rad + (side == TrailSide::Left ? -0.5 : 0.5) * kPi;
    if (const auto wanted = side_of(world, from, forward_of_heading(beside), kArm_m, shape_above_steps(body)))
        nearest = wanted;
    if (!nearest) return false;
    normal_ = nearest->normal;
    wall_m_ = nearest->distance_m;
    wall_bearing_rad_ = heading_of(-normal_);
    active_ = true;
    return true;
}

void Trail::turn_round() {
    side_ = side_ == TrailSide::Left ? TrailSide::Right : TrailSide::Left;
    bridge_m_ = round_m_ = 0.0;
}

// Reports the thing at the walker's side if it is different from the previous one. It may be at any height from a step
// to the shoulders.
void Trail::name(const WalkerWorld& world, const Vec3& feet_m, const WalkerSize& body,
                 std::vector<TrailEvent>& events) {
    const Vec3 from = above_steps(feet_m, body);
    const WalkerShape probe{kProbe_m, body.height_m - body.step_up_m - 0.3};
    const TraceHit hit = world.trace(from, from - normal_ * (body.radius_m + kWallEnds_m), probe);
    if (!is_wall(hit) || !hit.feature) return;
    const Feature* feature = world.scene().find(hit.feature);
    const bool wall = feature != nullptr && feature->kind == FeatureKind::Wall;
    const Vec3 normal = level(hit.normal);
    const bool corner = wall && wall_ && glm::dot(normal, wall_normal_) < kCornerCosine;
    if (corner) events.push_back({TrailEvent::Kind::Corner, hit.feature, hit.end_m});
    else if (hit.feature != feature_) events.push_back({TrailEvent::Kind::Meets, hit.feature, hit.end_m});
    feature_ = hit.feature;
    if (!wall) return;
    wall_ = hit.feature;
    wall_normal_ = normal;
}

TrailMotion Trail::tick(const WalkerWorld& world, const Vec3& feet_m, double facing_rad, const WalkerSize& body,
                        double speed_m_per_s, double dt_s, std::vector<TrailEvent>& events) {
    const WalkerShape shape = shape_above_steps(body);
    const Vec3 from = above_steps(feet_m, body);
    const double stride = speed_m_per_s * dt_s;
    touching_ = false;
    TrailMotion way{Vec3(0.0), heading_of(along())};
    if (!active_) return way;

    // 1. Go to the wall.
    if (!near_) {
        const auto wall = side_of(world, from, -normal_, kFarthest_m + kWallEnds_m, shape);
        if (!wall) {
            active_ = false;
            events.push_back({TrailEvent::Kind::Ends, kNoFeature, feet_m});
            return way;
        }
        normal_ = wall->normal;
        way.heading_rad = heading_of(along());
        if (wall->distance_m > kGap_m + 0.01) {
            way.intended_m_per_s = -normal_ * std::min(speed_m_per_s, (wall->distance_m - kGap_m) / dt_s);
            return way;
        }
        near_ = true;
    }
    // 2. Check what is ahead: an inner corner of the walls, or a thing at the wall.
    if (const auto ahead = side_of(world, from, along(), stride + kGap_m, shape)) {
        if (glm::dot(ahead->normal, along()) < -0.2) {
            normal_ = ahead->normal;
            bridge_m_ = 0.0;
            round_m_ = 0.0;
            way.heading_rad = heading_of(along());
            name(world, feet_m, body, events);
            touching_ = true;
            return way;
        }
    }
    const double off = std::remainder(heading_of(along()) - facing_rad, 2.0 * kPi);
    if (std::abs(off) > kAlignedRad) return way;  // The walker must turn before it moves.

    // 3. Go past an opening.
    if (bridge_m_ > 0.0) {
        bridge_m_ -= stride;
        way.intended_m_per_s = along() * speed_m_per_s;
        return way;
    }
    // 4. Follow the wall.
    const double reach = kGap_m + kWallEnds_m;
    const auto beside = side_of(world, from, -normal_, reach, shape);
    const bool bends = beside && glm::dot(beside->normal, normal_) < 0.98;
    if (beside && (bends || beside->distance_m < kGap_m + kLeastRecess_m || round_m_ > 0.0)) {
        if (bends) normal_ = beside->normal;
        if (beside->distance_m < kGap_m + kLeastRecess_m) round_m_ = 0.0;
        else round_m_ = std::max(0.0, round_m_ - stride);
        way.heading_rad = heading_of(along());
        const double pull = std::clamp((beside->distance_m - kGap_m) / dt_s, -0.5 * speed_m_per_s, 0.5 * speed_m_per_s);
        way.intended_m_per_s = along() * speed_m_per_s - normal_ * pull;
        touching_ = true;
        name(world, feet_m, body, events);
        return way;
    }
    if (round_m_ > 0.0) {
        round_m_ -= stride;
        way.intended_m_per_s = along() * speed_m_per_s;
        if (round_m_ <= 0.0) {
            active_ = false;
            events.push_back({TrailEvent::Kind::Ends, kNoFeature, feet_m});
        }
        return way;
    }
    // 5. If the wall recedes, examine whether it continues farther on.
    for (double further = kStep_m; further <= kWidestOpening_m - 2.0 * body.radius_m; further += kStep_m) {
        if (world.trace(from, from + along() * further, shape).hit) break;
        const auto again = side_of(world, from + along() * further, -normal_, reach, shape);
        if (!again || glm::dot(again->normal, normal_) < 0.98 || again->distance_m > kGap_m + kLeastRecess_m) continue;
        bridge_m_ = further;
        const Vec3 middle = from + along() * (0.5 * further);
        const WalkerShape probe{kProbe_m, body.height_m - body.step_up_m - 0.3};
        const TraceHit inside = world.trace(middle, middle - normal_ * (body.radius_m + 2.0 * kWallEnds_m), probe);
        const bool shut = is_wall(inside) && inside.feature;
        if (shut) {
            feature_ = inside.feature;
            events.push_back({TrailEvent::Kind::Meets, inside.feature, inside.end_m});
        } else {
            events.push_back({TrailEvent::Kind::Opening, kNoFeature, middle - normal_ * body.radius_m,
                              further + 2.0 * body.radius_m});
        }
        way.intended_m_per_s = along() * speed_m_per_s;
        return way;
    }
    if (beside) {  // The wall recedes into a niche that is too wide to pass, so the walker enters the niche.
        round_m_ = reach;
        return way;
    }
    // 6. Go round an outer corner. The end of the wall faces in the direction of movement.
    normal_ = along();
    round_m_ = 2.0 * body.radius_m + kWallEnds_m + 0.3;
    way.heading_rad = heading_of(along());
    return way;
}

}  // namespace handrail::core
