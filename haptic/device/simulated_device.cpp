#include "haptic/device/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "worlds/base/contract.h"

namespace handrail::device {
namespace {

constexpr double kHandMassKg = 0.3;
constexpr double kHandDampingNsPerM = 3.0;
constexpr double kHandSpringNPerM = 300.0;
// Damping of a hand that follows the mouse. With only 3 Ns/m, the hand overshoots a step of the mouse by two thirds.
constexpr double kFollowDampingNsPerM = 18.0;
constexpr double kRestSpringNPerM = 20.0;
constexpr double kDeviceMassKg = 0.1;
constexpr double kDryFrictionN = 0.05;
constexpr double kSubstepS = 1e-4;
// Longest pause of the servo loop that is simulated; the steps of a longer one are skipped.
constexpr double kLongestGapS = 0.5;

// Decrements `samples`, the number of samples for which a simulated failure still lasts. Returns true while the failure
// lasts. A negative number is never decremented, so that failure lasts for ever.
bool take_one(int& samples) noexcept {
    if (samples == 0) return false;
    if (samples > 0) --samples;
    return true;
}

}  // namespace

SimulatedDevice::SimulatedDevice(const DeviceSpec& spec, std::shared_ptr<SimulatedHand> hand, const Vec3& start_m)
    : spec_(spec), hand_(std::move(hand)), body_{start_m, Vec3(0.0)}, last_answer_m_(start_m) {
    contract_pre(hand_ != nullptr && is_finite(start_m));
    command_.target_m = start_m;
}

Result<void> SimulatedDevice::open() {
    started_ = false;
    body_.velocity_m_per_s = Vec3(0.0);
    felt_n_ = Vec3(0.0);
    held_.clear();
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
    hand_->state.publish({now_s, body_.position_m, body_.velocity_m_per_s, felt_n_});

    DeviceSample sample;
    sample.buttons = command_.buttons;
    sample.gimbal_rad = command_.gimbal_rad;
    sample.position_m = measured_m();
    sample.hot = trouble_.hot;
    sample.failed = trouble_.failed;
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
    held_.give(time_s_ + spec_.delay_s, command.force_n);
}

void SimulatedDevice::close() noexcept {
    held_.clear();
    felt_n_ = Vec3(0.0);
}

Vec3 SimulatedDevice::motor_force_n(double time_s) noexcept {
    felt_n_ = held_.at(time_s);
    return trouble_.unplugged ? Vec3(0.0) : felt_n_;
}

void SimulatedDevice::step(double to_s) noexcept {
    if (!(to_s > time_s_)) return;
    if (to_s - time_s_ > kLongestGapS) time_s_ = to_s - kLongestGapS;

    if (command_.mode == HandMode::Move) {
        const double gap_s = to_s - time_s_;
        Vec3& position = body_.position_m;
        const Vec3 way = command_.target_m - position;
        const double distance_m = std::sqrt(glm::dot(way, way));
        const double reach_m = command_.speed_m_per_s * gap_s;
        const Vec3 before = position;
        position = command_.speed_m_per_s > 0.0 && distance_m > reach_m ? position + way * (reach_m / distance_m)
                                                                        : command_.target_m;
        body_.velocity_m_per_s = command_.speed_m_per_s > 0.0 ? (position - before) / gap_s : Vec3(0.0);
        motor_force_n(to_s);
        time_s_ = to_s;
        return;
    }

    HandMechanics mechanics;
    mechanics.mass_kg = kHandMassKg + kDeviceMassKg;
    mechanics.damping_ns_per_m =
        (command_.mode == HandMode::Follow ? kFollowDampingNsPerM : kHandDampingNsPerM) + spec_.device_damping_ns_per_m;
    mechanics.spring_n_per_m = command_.mode == HandMode::Follow ? kHandSpringNPerM
                               : command_.mode == HandMode::Rest ? kRestSpringNPerM
                                                                 : 0.0;
    mechanics.dry_friction_n = kDryFrictionN;
    mechanics.reach_m = spec_.workspace_radius_m;
    const Vec3 push_n = command_.mode == HandMode::Follow ? Vec3(0.0) : command_.push_n;
    const int steps = std::max(1, static_cast<int>(std::ceil((to_s - time_s_) / kSubstepS - 1e-6)));
    const double h = (to_s - time_s_) / steps;
    const double start_s = time_s_;
    for (int i = 0; i < steps; ++i)
        advance_hand(body_, mechanics, command_.target_m, motor_force_n(start_s + i * h) + push_n, h);
    time_s_ = to_s;
}

Vec3 SimulatedDevice::measured_m() const noexcept {
    return command_.mode == HandMode::Move ? body_.position_m : encoded_m(body_.position_m, spec_.encoder_quantum_m);
}

}  // namespace handrail::device
