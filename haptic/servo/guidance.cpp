#include "haptic/servo/guidance.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_assert.h"
#include "haptic/servo/vectors.h"

namespace handrail::servo {
namespace {

constexpr double kVelocityPole_s = 0.020;
constexpr int kMostCornersATick = 8;

}  // namespace

void Guidance::begin(const GuidancePath& path, const Vec3& hand_m) noexcept {
    state_ = {};
    state_.number = path.number;
    fade_ = 0.0;
    if (path.number == 0 || path.count == 0 || path.count > GuidancePath::kMostPoints ||
        !(path.strength >= 0.0 && path.strength <= 1.0))
        return;
    for (std::uint32_t i = 0; i < path.count; ++i)
        if (!is_finite(path.points_m[i])) return;
    state_.phase = GuidancePhase::Acts;
    // The pulling point starts at the hand, so that the force does not jump.
    point_m_ = hand_before_m_ = hand_m;
    next_ = 0;
    velocity_m_per_s_ = Vec3(0.0);
    acted_s_ = against_s_ = 0.0;
}

void Guidance::end(GuidancePhase phase) noexcept {
    state_.phase = phase;
    state_.counter_n = 0.0;
    last_n_ = state_.force_n;
    fade_ = 1.0;
}

// Moves the pulling point along the path. It advances at its own speed while the hand keeps up, and as fast as the hand
// if the hand is ahead.
void Guidance::go_on(const GuidancePath& path, const Vec3& hand_m, double scale, double dt_s) noexcept {
    const double own_m = kPointSpeed_m_per_s * dt_s * scale;
    double left_m = std::max(own_m, length(hand_m - hand_before_m_));
    double own_left_m = own_m;
    // A tick passes at most kMostCornersATick corners. Without this limit, the loop would never end if rounding leaves
    // tiny steps.
    for (int pass = 0; pass < kMostCornersATick && next_ < path.count && left_m > 0.0; ++pass) {
        const Vec3 leg = path.points_m[next_] - point_m_;
        const double leg_m = length(leg);
        if (leg_m < 1e-9 * scale) {
            ++next_;
            continue;
        }
        const double ahead_m = glm::dot(hand_m - point_m_, leg) / leg_m;
        const bool waits = length(point_m_ - hand_m) >= kLead_m * scale;
        const double step_m = std::min({left_m, leg_m,
                                        ahead_m > 0.0 ? std::max(ahead_m, waits ? 0.0 : own_left_m)
                                        : waits       ? 0.0
                                                      : own_left_m});
        if (!(step_m > 1e-9 * scale)) return;
        point_m_ += leg * (step_m / leg_m);
        left_m -= step_m;
        own_left_m = std::max(0.0, own_left_m - step_m);
        if (step_m >= leg_m) {
            point_m_ = path.points_m[next_];
            ++next_;
        }
    }
}

Vec3 Guidance::pull(const GuidancePath& path, const Vec3& hand_m, double scale, double most_n, double dt_s) noexcept {
    go_on(path, hand_m, scale, dt_s);
    const Vec3 away = (point_m_ - hand_m) / scale;
    const double away_m = length(away);
    state_.counter_n = kStiffness_n_per_m * away_m;
    against_s_ = most_n > 0.0 && state_.counter_n > kLetGo_n ? against_s_ + dt_s : 0.0;
    if (!(away_m > 0.0)) return Vec3(0.0);
    const Vec3 way = away / away_m;
    // The sideways speed is included; otherwise a hand that turns a corner would move faster than either leg of the
    // path allows. If the hand moves away from the pulling point, the full force acts.
    const double along = glm::dot(velocity_m_per_s_, way);
    const double aside = length(velocity_m_per_s_ - way * along);
    const double slower = std::clamp(1.0 - (along + aside) / kFastest_m_per_s, 0.0, 1.0);
    return way * (std::min(state_.counter_n, most_n) * slower);
}

// The force of each line is -F (u/w)(1 - (u/w)^2)^2, the slope of a potential that ends with zero slope and curvature.
Vec3 Guidance::lines(const GuidancePath& path, const Vec3& hand_m, double scale, double most_n) const noexcept {
    constexpr double kPeakOfLaw = 0.28621670111997307;  // greatest value of the law, at u/w = 1/sqrt(5)
    const double share = most_n / kMostForce_n;
    Vec3 force(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double u = (path.points_m[0][axis] - hand_m[axis]) / (scale * kLineHalfWidth_m);
        const double rest = 1.0 - u * u;
        if (rest > 0.0) force[axis] = (kLine_n * share / kPeakOfLaw) * u * rest * rest;
    }
    return force;
}

namespace {

// Returns the nearest point of a trench, the vertical strip below the line from `a` to `b`. The strip is convex, so the
// squared distance to it is smooth everywhere.
Vec3 nearest_in_trench(const Vec3& a, const Vec3& b, const Vec3& p) noexcept {
    const double x = b.x - a.x, y = b.y - a.y, length = std::sqrt(x * x + y * y);
    if (!(length > 1e-9)) return {a.x, a.y, std::min(p.z, std::max(a.z, b.z))};
    const double slope = (b.z - a.z) / length;
    const double along = ((p.x - a.x) * x + (p.y - a.y) * y) / length;
    double s = std::clamp(along, 0.0, length);
    double z = p.z;
    if (p.z > a.z + slope * s) {  // the point is above the trench, so the nearest point is on its upper edge
        s = std::clamp((along + slope * (p.z - a.z)) / (1.0 + slope * slope), 0.0, length);
        z = a.z + slope * s;
    }
    return {a.x + x * (s / length), a.y + y * (s / length), z};
}

Vec3 nearest_on_leg(const Vec3& a, const Vec3& b, const Vec3& p) noexcept {
    const Vec3 way = b - a;
    const double length2 = glm::dot(way, way);
    return length2 > 1e-18 ? a + way * std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : a;
}

}  // namespace

// The potential is A times the product of 1 - f over all legs of the path, with f = (1 - (d/w)^2)^3 for a leg nearer
// than w. The potential is zero on every leg and A far from all of them. It is smooth in between, even where legs meet,
// because d^2 is smooth. The force is the negative slope of the potential.
Vec3 Guidance::grooves(const GuidancePath& path, const Vec3& hand_m, double scale, double most_n) noexcept {
    constexpr double kPeakOfLaw = 1.7173003580037202;  // greatest value of 6 u (1 - u^2)^2, at u = 1/sqrt(5)
    std::array<Vec3, GuidancePath::kMostPoints / 2> slopes;
    std::array<double, GuidancePath::kMostPoints / 2> left;
    std::size_t near = 0;
    const double width_m = scale * kGrooveHalfWidth_m;
    const bool lines = path.kind == GuidanceKind::PathLines;
    for (std::uint32_t i = 0; i + 1 < path.count; i += 2) {
        const Vec3 &a = path.points_m[i], &b = path.points_m[i + 1];
        // Most legs are far away. Comparing the hand with their box excludes them at a tenth of the cost.
        if (hand_m.x < std::min(a.x, b.x) - width_m || hand_m.x > std::max(a.x, b.x) + width_m ||
            hand_m.y < std::min(a.y, b.y) - width_m || hand_m.y > std::max(a.y, b.y) + width_m ||
            hand_m.z > std::max(a.z, b.z) + width_m)
            continue;
        const Vec3 off = (hand_m - (lines ? nearest_on_leg(a, b, hand_m) : nearest_in_trench(a, b, hand_m))) / width_m;
        const double rest = 1.0 - glm::dot(off, off);
        if (!(rest > 0.0)) continue;
        slopes[near] = off * (-6.0 * rest * rest);
        left[near++] = 1.0 - rest * rest * rest;
    }
    Vec3 force(0.0);
    for (std::size_t i = 0; i < near; ++i) {
        Vec3 part = slopes[i];
        for (std::size_t k = 0; k < near; ++k)
            if (k != i) part *= left[k];
        force += part;
    }
    return force * (kGroove_n / kPeakOfLaw * most_n / kMostForce_n);
}

Vec3 Guidance::tick(const GuidancePath& path, const Vec3& hand_m, double scale, double peak_force_n, bool allowed,
                    double dt_s) noexcept {
    tick_assert(scale > 0.0 && dt_s > 0.0);
    // 1. Another path is requested, or force is not permitted: the current guidance fades out before the next begins.
    if (state_.phase == GuidancePhase::Acts && (path.number != state_.number || !allowed)) end(GuidancePhase::Ended);
    if (path.number != state_.number && fade_ <= 0.0) {
        begin(path, hand_m);
        if (!allowed && state_.phase == GuidancePhase::Acts) end(GuidancePhase::Ended);
    }
    // 2. After guidance has ended, its force fades out.
    if (state_.phase != GuidancePhase::Acts) {
        state_.force_n = Vec3(0.0);
        if (fade_ > 0.0) {
            fade_ -= dt_s / kFade_s;
            if (fade_ > 0.0) state_.force_n = last_n_ * fade_;
        }
        return state_.force_n;
    }
    // 3. Computes the force. begin() has refused a path with bad values, and a path changes only with its number.
    tick_assert(path.count > 0 && path.count <= GuidancePath::kMostPoints);
    tick_assert(path.strength >= 0.0 && path.strength <= 1.0);
    const Vec3 velocity = (hand_m - hand_before_m_) / (scale * dt_s);
    velocity_m_per_s_ += (velocity - velocity_m_per_s_) * (dt_s / (kVelocityPole_s + dt_s));
    acted_s_ += dt_s;
    const double most_n = path.strength * std::min(kMostForce_n, kMostShare * peak_force_n);
    const double ramp = std::min(1.0, acted_s_ / kRamp_s);
    const Vec3 full_n = path.kind == GuidanceKind::Pull         ? pull(path, hand_m, scale, most_n, dt_s)
                        : path.kind == GuidanceKind::CrossLines ? lines(path, hand_m, scale, most_n)
                                                                : grooves(path, hand_m, scale, most_n);
    state_.force_n = at_most(full_n * ramp, most_n);
    tick_assert(glm::length(state_.force_n) <= kMostForce_n * (1.0 + 1e-9));
    hand_before_m_ = hand_m;
    // 4. Checks the conditions that end a pull.
    if (path.kind != GuidanceKind::Pull) return state_.force_n;
    if (against_s_ >= kLetGo_s) end(GuidancePhase::LetGo);
    else if ((next_ + 1 >= path.count || path.strength == 0.0) &&
             length(hand_m - path.points_m[path.count - 1]) <= kArrived_m * scale)
        end(GuidancePhase::Arrived);
    return state_.force_n;
}

}  // namespace handrail::servo
