#include "haptic/device/hand_dynamics.h"

#include <algorithm>
#include <cmath>

namespace handrail::device {

void advance_hand(HandBody& hand, const HandMechanics& mechanics, const Vec3& target_m, const Vec3& force_n,
                  double step_s) noexcept {
    const Vec3 force = force_n + mechanics.spring_n_per_m * (target_m - hand.position_m) -
                       mechanics.damping_ns_per_m * hand.velocity_m_per_s;
    Vec3 velocity = hand.velocity_m_per_s + force * (step_s / mechanics.mass_kg);
    // Dry friction reduces the speed but never reverses it. If the friction's impulse exceeds the remaining momentum,
    // the device stops.
    const double speed = std::sqrt(glm::dot(velocity, velocity));
    const double taken = mechanics.dry_friction_n * step_s / mechanics.mass_kg;
    velocity = speed > taken ? velocity * (1.0 - taken / speed) : Vec3(0.0);
    hand.velocity_m_per_s = velocity;
    hand.position_m += velocity * step_s;
    const double distance_m = std::sqrt(glm::dot(hand.position_m, hand.position_m));
    if (distance_m > mechanics.reach_m) {
        const Vec3 outward = hand.position_m / distance_m;
        hand.position_m = outward * mechanics.reach_m;
        hand.velocity_m_per_s -= outward * std::max(0.0, glm::dot(hand.velocity_m_per_s, outward));
    }
}

Vec3 encoded_m(const Vec3& position_m, double quantum_m) noexcept {
    const double q = quantum_m;
    if (!(q > 0.0)) return position_m;
    return {std::round(position_m.x / q) * q, std::round(position_m.y / q) * q, std::round(position_m.z / q) * q};
}

void HeldForces::give(double from_s, const Vec3& force_n) noexcept {
    if (count_ == kMost) {
        first_ = (first_ + 1) % kMost;
        --count_;
    }
    held_[(first_ + count_) % kMost] = {from_s, force_n};
    ++count_;
}

Vec3 HeldForces::at(double time_s) noexcept {
    while (count_ > 0 && held_[first_].from_s <= time_s + 1e-9) {
        now_n_ = held_[first_].force_n;
        first_ = (first_ + 1) % kMost;
        --count_;
    }
    return now_n_;
}

void HeldForces::clear() noexcept {
    count_ = 0;
    now_n_ = Vec3(0.0);
}

}  // namespace handrail::device
