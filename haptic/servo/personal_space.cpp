#include "haptic/servo/personal_space.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_assert.h"

namespace handrail::servo {

PersonalWall personal_wall_of(const device::DeviceSpec& spec, double ceiling_n, double wall_n_per_m) noexcept {
    PersonalWall wall;
    wall.at_m = kPersonalWallAt * spec.workspace_radius_m;
    wall.stiffness_n_per_m = std::min(kPersonalWallStiffest_n_per_m, wall_n_per_m);
    if (!(wall.stiffness_n_per_m > 0.0)) return {wall.at_m, 0.0, 0.5 * (spec.workspace_radius_m - wall.at_m)};
    const double break_n = std::min(kPersonalWallMost_n, kPersonalWallShare * std::max(0.0, ceiling_n));
    // With a low stiffness and a small workspace, the wall must break before the device reaches its end stop.
    wall.depth_m = std::min(break_n / wall.stiffness_n_per_m, 0.5 * (spec.workspace_radius_m - wall.at_m));
    return wall;
}

bool PersonalSpace::tick(const Vec3& hand_m, const PersonalWall& wall, bool whole, double dt_s) noexcept {
    tick_assert(dt_s >= 0.0 && wall.stiffness_n_per_m >= 0.0 && wall.depth_m >= 0.0);
    if (!known_ || (inside_m_ <= 0.0 && stretch_m_ == 0.0)) wall_ = wall;
    const double inside_m = -hand_m.y - wall_.at_m;
    const double way_m = known_ ? inside_m - inside_m_ : 0.0;
    inside_m_ = inside_m;
    known_ = true;
    if (!whole) armed_ = false;
    if (armed_) {
        const double most_m = wall_.stiffness_n_per_m > 0.0 ? kMostRiseN / wall_.stiffness_n_per_m : 0.0;
        stretch_m_ =
            std::clamp(stretch_m_ + std::min(way_m, most_m), 0.0, std::max(0.0, std::min(inside_m, wall_.depth_m)));
        if (inside_m < wall_.depth_m) return false;
        armed_ = false;
        return true;
    }
    stretch_m_ = std::max(0.0, stretch_m_ + std::min(0.0, way_m)) * (kReleaseS / (kReleaseS + dt_s));
    if (stretch_m_ < 1e-7) stretch_m_ = 0.0;  // 1e-7 m is far below one step of the motor's force
    armed_ = whole && inside_m <= -kRearmM;
    return false;
}

bool PullThrough::tick(const Vec3& hand_m, const Vec3& held_n, double reach_m, bool whole, double dt_s) noexcept {
    const double across_n2 = held_n.x * held_n.x + held_n.z * held_n.z;
    const bool pulls = whole && hand_m.y <= -kNearHalf * reach_m && held_n.y >= kPersonalWallMost_n &&
                       across_n2 <= kStraight * kStraight * held_n.y * held_n.y;
    const double slid_x = hand_m.x - from_m_.x, slid_z = hand_m.z - from_m_.z;
    if (!pulls || (held_s_ > 0.0 && slid_x * slid_x + slid_z * slid_z > kSlide_m * kSlide_m)) {
        held_s_ = 0.0;
        return false;
    }
    if (held_s_ == 0.0) from_m_ = hand_m;
    held_s_ += dt_s;
    if (held_s_ < kHold_s) return false;
    held_s_ = 0.0;
    return true;
}

void LeftoverForce::begin(const Vec3& force_n, double stiffness_n_per_m) noexcept {
    const double size = std::sqrt(glm::dot(force_n, force_n));
    stretch_m_ = size > 1e-4 && stiffness_n_per_m > 0.0 ? size / stiffness_n_per_m : 0.0;
    stiffness_n_per_m_ = stiffness_n_per_m;
    direction_ = stretch_m_ > 0.0 ? force_n / size : Vec3(0.0);
}

void LeftoverForce::tick(const Vec3& hand_step_m, double dt_s) noexcept {
    tick_assert(stretch_m_ >= 0.0 && dt_s >= 0.0);
    if (stretch_m_ == 0.0) return;
    stretch_m_ = std::max(0.0, stretch_m_ - std::max(0.0, glm::dot(hand_step_m, direction_))) *
                 (PersonalSpace::kReleaseS / (PersonalSpace::kReleaseS + dt_s));
    if (stretch_m_ < 1e-7) stretch_m_ = 0.0;
}

void DeskPress::tick(FeatureId touched, double press_n, bool button, double needed_n) noexcept {
    const bool pushed_before = pushed_, button_before = button_was_;
    button_was_ = button;
    pushed_ = touched && press_n >= (pushed_before ? kRelease * needed_n : needed_n);
    if (held_ && !pushed_ && !button) held_ = kNoFeature;
    if (held_ || !touched || !((pushed_ && !pushed_before) || (button && !button_before))) return;
    held_ = touched;
    ++presses_;
}

}  // namespace handrail::servo
