#include "haptic/device/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handrail {
namespace {

constexpr double kHandMassKg = 0.3;
constexpr double kHandDampingNsPerM = 3.0;
constexpr double kHandSpringNPerM = 300.0;
constexpr double kFollowDampingNsPerM = 18.0;  // with the 3 Ns/m alone the hand overshoots a mouse's step by two thirds
constexpr double kRestSpringNPerM = 20.0;
constexpr double kDeviceMassKg = 0.1;
constexpr double kDryFrictionN = 0.05;
constexpr double kSubstepS = 1e-4;
constexpr double kLongestGapS = 0.5;  // a longer pause of the loop is not made up for step by step

// Counts one sample off a trouble; negative numbers never run out.
bool take_one(int& samples) noexcept {
    if (samples == 0) return false;
    if (samples > 0) --samples;
    return true;
}

}  // namespace

SimulatedDevice::SimulatedDevice(const DeviceSpec& spec, std::shared_ptr<SimulatedHand> hand, const Vec3& start_m)
    : spec_(spec), hand_(std::move(hand)), position_m_(start_m), last_answer_m_(start_m) {
    command_.target_m = start_m;
}

Result<void> SimulatedDevice::open() {
    started_ = false;
    velocity_m_per_s_ = Vec3(0.0);
    felt_n_ = Vec3(0.0);
    held_count_ = 0;
    return {};
}

DeviceSample SimulatedDevice::read(double now_s) noexcept {
    if (hand_->command.refresh()) command_ = hand_->command.read();
    if (hand_->trouble.refresh()) trouble_ = hand_->trouble.read();
    if (!started_) {
        time_s_ = now_s;
        started_ = true;
    }
    step(now_s);
    hand_->state.publish({now_s, position_m_, velocity_m_per_s_, felt_n_});

    DeviceSample sample;
    sample.buttons = command_.buttons;
    sample.position_m = measured_m();
    if (trouble_.unplugged) {
        sample.position_m = last_answer_m_;
        sample.fresh = false;
        sample.connected = false;
        return sample;
    }
    if (take_one(trouble_.silent_samples)) {
        sample.position_m = last_answer_m_;
        sample.fresh = false;
        return sample;
    }
    if (take_one(trouble_.jump_samples)) sample.position_m += trouble_.jump_m;
    last_answer_m_ = sample.position_m;
    if (take_one(trouble_.not_a_number_samples)) sample.position_m.y = std::numeric_limits<double>::quiet_NaN();
    return sample;
}

void SimulatedDevice::write(const ForceCommand& command) noexcept {
    if (held_count_ == kHeldForces) {
        held_first_ = (held_first_ + 1) % kHeldForces;
        --held_count_;
    }
    held_[(held_first_ + held_count_) % kHeldForces] = {time_s_ + spec_.delay_s, command.force_n};
    ++held_count_;
}

void SimulatedDevice::close() noexcept {
    held_count_ = 0;
    felt_n_ = Vec3(0.0);
}

// The newest force whose time has come; earlier ones are let go.
Vec3 SimulatedDevice::motor_force_n(double time_s) noexcept {
    while (held_count_ > 0 && held_[held_first_].from_s <= time_s + 1e-9) {
        felt_n_ = held_[held_first_].force_n;
        held_first_ = (held_first_ + 1) % kHeldForces;
        --held_count_;
    }
    return trouble_.unplugged ? Vec3(0.0) : felt_n_;
}

void SimulatedDevice::step(double to_s) noexcept {
    if (!(to_s > time_s_)) return;
    if (to_s - time_s_ > kLongestGapS) time_s_ = to_s - kLongestGapS;

    if (command_.mode == HandMode::Move) {
        const double gap_s = to_s - time_s_;
        const Vec3 way = command_.target_m - position_m_;
        const double distance_m = std::sqrt(glm::dot(way, way));
        const double reach_m = command_.speed_m_per_s * gap_s;
        const Vec3 before = position_m_;
        position_m_ = command_.speed_m_per_s > 0.0 && distance_m > reach_m ? position_m_ + way * (reach_m / distance_m) : command_.target_m;
        velocity_m_per_s_ = command_.speed_m_per_s > 0.0 ? (position_m_ - before) / gap_s : Vec3(0.0);
        motor_force_n(to_s);
        time_s_ = to_s;
        return;
    }

    const double mass_kg = kHandMassKg + kDeviceMassKg;
    const double damping = (command_.mode == HandMode::Follow ? kFollowDampingNsPerM : kHandDampingNsPerM) + spec_.device_damping_ns_per_m;
    const double spring = command_.mode == HandMode::Follow ? kHandSpringNPerM : command_.mode == HandMode::Rest ? kRestSpringNPerM : 0.0;
    const Vec3 push_n = command_.mode == HandMode::Follow ? Vec3(0.0) : command_.push_n;
    const int steps = std::max(1, static_cast<int>(std::ceil((to_s - time_s_) / kSubstepS - 1e-6)));
    const double h = (to_s - time_s_) / steps;
    const double start_s = time_s_;
    for (int i = 0; i < steps; ++i) {
        const Vec3 force = motor_force_n(start_s + i * h) + push_n + spring * (command_.target_m - position_m_) - damping * velocity_m_per_s_;
        Vec3 velocity = velocity_m_per_s_ + force * (h / mass_kg);
        // Dry friction takes away speed but never turns it round: below its own impulse the device stands.
        const double speed = std::sqrt(glm::dot(velocity, velocity));
        const double taken = kDryFrictionN * h / mass_kg;
        velocity = speed > taken ? velocity * (1.0 - taken / speed) : Vec3(0.0);
        velocity_m_per_s_ = velocity;
        position_m_ += velocity * h;
        // End stops.
        const double distance_m = std::sqrt(glm::dot(position_m_, position_m_));
        if (distance_m > spec_.workspace_radius_m) {
            const Vec3 outward = position_m_ / distance_m;
            position_m_ = outward * spec_.workspace_radius_m;
            velocity_m_per_s_ -= outward * std::max(0.0, glm::dot(velocity_m_per_s_, outward));
        }
    }
    time_s_ = to_s;
}

Vec3 SimulatedDevice::measured_m() const noexcept {
    const double q = spec_.encoder_quantum_m;
    if (command_.mode == HandMode::Move || !(q > 0.0)) return position_m_;
    return {std::round(position_m_.x / q) * q, std::round(position_m_.y / q) * q, std::round(position_m_.z / q) * q};
}

}  // namespace handrail
