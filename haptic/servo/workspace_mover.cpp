#include "haptic/servo/workspace_mover.h"

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_assert.h"
#include "haptic/servo/vectors.h"

namespace handrail::servo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The rim is the outer fifth of the workspace radius. It consists of the ridge, the fall of the force behind the ridge,
// and the scrolling zone. The values are the ends of ridge and fall, as shares of the radius; the rim begins at
// kRimFrom.
constexpr double kRimTop = 0.86, kRimPast = 0.9;
constexpr double kRidge_n = 0.5;  // force of the ridge; clearly felt, far below a wall's 2.5 N
constexpr double kBeyond_n = 0.1;
// Greatest stiffness of the ridge as a share of the device's rated stiffness. The share is low because the hand may
// feel a wall at the same time.
constexpr double kRidgeStiffness = 0.3;
constexpr double kFastestScroll_hand_m_per_s = 0.05;  // greatest speed of scrolling; three metres a second at scale 60
// Position between top_m and past_m at which a hand that moves back in stops scrolling; 0 is top_m, 1 is past_m.
constexpr double kBackPart = 0.8;

// Greatest contact force while the workspace moves. Together with the rim's kBeyond_n it is still below kMovingForceN.
constexpr double kMovingContact_n = 0.08;
constexpr double kMovingTotal_n = 0.19;
// Rate at which the contact force is reduced; 2.5 N are gone after 75 ms, as in every fade.
constexpr double kEase_n_per_s = 33.0;
constexpr double kBack_n_per_s = 5.0;
constexpr double kRimGainMoving = 0.2;
constexpr double kRimGain_per_s = 60.0;

// Removes from the motion every component that points into a contact.
Vec3 along_contacts(Vec3 motion, const render::ContactSet& contacts) noexcept {
    for (int round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < contacts.count; ++i) {
            const Vec3& normal = contacts.contacts[i].normal;
            motion -= normal * std::min(0.0, glm::dot(motion, normal));
        }
    // In a narrow corner, removing one component may bring another back. In that case there is no motion.
    for (std::size_t i = 0; i < contacts.count; ++i)
        if (glm::dot(motion, contacts.contacts[i].normal) < -1e-9 * length(motion)) return Vec3(0.0);
    return motion;
}

// Limits the step along one axis so that `at` stays within [low, high], or at least does not go farther outside.
double within(double at, double step, double low, double high) noexcept {
    const double to = at + step;
    if (to > high && step > 0.0) return std::max(0.0, high - at);
    if (to < low && step < 0.0) return std::min(0.0, low - at);
    return step;
}

}  // namespace

Rim rim_of(const device::DeviceSpec& spec) noexcept {
    const double reach = spec.workspace_radius_m;
    Rim rim{kRimFrom * reach, kRimTop * reach, kRimPast * reach, reach, 0.0, 0.0};
    rim.top_n = std::min(kRidge_n, kRidgeStiffness * spec.rated_stiffness_n_per_m * (rim.top_m - rim.from_m));
    rim.beyond_n = std::min(kBeyond_n, 0.4 * rim.top_n);
    return rim;
}

double Rim::force_n(double distance_m) const noexcept {
    if (!(distance_m > from_m)) return 0.0;
    if (distance_m < top_m) return top_n * ((distance_m - from_m) / (top_m - from_m));
    if (distance_m < past_m) return top_n + (beyond_n - top_n) * ((distance_m - top_m) / (past_m - top_m));
    return beyond_n;
}

double Rim::speed(double distance_m) const noexcept {
    if (!(distance_m > past_m)) return 0.0;
    return kFastestScroll_hand_m_per_s * std::min(1.0, (distance_m - past_m) / (end_m - past_m));
}

Vec3 WorkspaceMover::rim_force_n() const noexcept {
    const double force = rim_gain_ * rim_.force_n(distance_m_);
    tick_assert(force >= 0.0 && rim_gain_ >= 0.0 && rim_gain_ <= 1.0);
    return rim_on_ && force > 0.0 ? out_m_ * (-force / distance_m_) : Vec3(0.0);
}

double WorkspaceMover::ceiling_n() const noexcept {
    if (motion_ != WorkspaceMotion::Still) return std::max(kMovingTotal_n, contact_ceiling_n_);
    // The rim's force is not limited on the way back in. A limit that rises with time would act like a spring that is
    // wound up while the hand presses it.
    return std::max(kMovingTotal_n, contact_ceiling_n_) + length(rim_force_n());
}

void WorkspaceMover::let_go() noexcept {
    motion_ = WorkspaceMotion::Still;
    hand_known_ = false;
    at_limit_ = false;
}

Vec3 WorkspaceMover::wanted_m(const WorkspaceFrame& frame, const WorkspaceTuning& tuning, const Hand& hand,
                              double world_m_per_hand_m, double dt_s) const noexcept {
    if (motion_ == WorkspaceMotion::Grabbed)
        return hand_known_ ? frame.turn_to_world(hand_m_ - hand.at_m) * world_m_per_hand_m : Vec3(0.0);
    Vec3 speed = tuning.push_hand_m_per_s;
    if (motion_ == WorkspaceMotion::Scrolled) speed += out_m_ * (rim_.speed(distance_m_) / distance_m_);
    return along_contacts(frame.turn_to_world(speed) * (world_m_per_hand_m * dt_s), *hand.contacts);
}

void WorkspaceMover::move(WorkspaceFrame& frame, const WorkspaceTuning& tuning, const Hand& hand,
                          double world_m_per_hand_m, double dt_s) noexcept {
    // 1. Decides which motion the hand requests.
    const WorkspaceMotion before = motion_;
    out_m_ = hand.at_m;
    // The distance is smooth at the border of the region that the rim leaves open, and so is the force.
    if (tuning.rim_open_behind) out_m_.y = std::max(0.0, out_m_.y);
    distance_m_ = length(out_m_);
    rim_on_ = tuning.rim;
    const double scrolls_from_m =
        before == WorkspaceMotion::Scrolled ? rim_.top_m + kBackPart * (rim_.past_m - rim_.top_m) : rim_.past_m;
    if (tuning.grab_key || (hand.buttons & tuning.grab_buttons) != 0) motion_ = WorkspaceMotion::Grabbed;
    else if (tuning.rim && distance_m_ >= scrolls_from_m) motion_ = WorkspaceMotion::Scrolled;
    else if (tuning.push_hand_m_per_s != Vec3(0.0)) motion_ = WorkspaceMotion::Pushed;
    else motion_ = WorkspaceMotion::Still;

    // 2. Limits the contact force that the hand may feel. The limit falls before the workspace moves, and rises again
    //   afterwards.
    if (motion_ != WorkspaceMotion::Still) {
        contact_ceiling_n_ = std::min(contact_ceiling_n_, std::min(hand.wanted_n, hand.ceiling_n));
        contact_ceiling_n_ = std::max(kMovingContact_n, contact_ceiling_n_ - kEase_n_per_s * dt_s);
    } else {
        contact_ceiling_n_ += kBack_n_per_s * dt_s;
        if (contact_ceiling_n_ > hand.ceiling_n) contact_ceiling_n_ = kInfinity;
    }
    if (distance_m_ <= rim_.from_m) rim_gain_ = 1.0;
    else if (motion_ == WorkspaceMotion::Grabbed || motion_ == WorkspaceMotion::Pushed)
        rim_gain_ = std::max(kRimGainMoving, rim_gain_ - kRimGain_per_s * dt_s);

    // 3. Moves the workspace, once the contact force is low enough.
    at_limit_ = false;
    if (motion_ != WorkspaceMotion::Still && contact_ceiling_n_ < kMovingForceN) {
        const Vec3 wanted = wanted_m(frame, tuning, hand, world_m_per_hand_m, dt_s);
        Vec3 step = wanted;
        if (!tuning.limits_m.empty()) {
            const Vec3 at = frame.origin_m + shift_m_;
            for (int axis = 0; axis < 3; ++axis)
                step[axis] = within(at[axis], wanted[axis], tuning.limits_m.min_m[axis], tuning.limits_m.max_m[axis]);
        }
        at_limit_ = step != wanted;
        shift_m_ += step;
    }
    hand_m_ = hand.at_m;
    hand_known_ = true;
    frame.origin_m += shift_m_;
}

void WorkspaceMover::give_way(const Vec3& hip_m, const Vec3& proxy_m, double contact_n) noexcept {
    if (contact_n > contact_ceiling_n_) shift_m_ += (proxy_m - hip_m) * (1.0 - contact_ceiling_n_ / contact_n);
}

}  // namespace handrail::servo
