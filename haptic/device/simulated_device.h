// Simulates a force-feedback device, with the hand that holds it. Handrail uses it without hardware: in scenarios, in
// tests, and for mouse and keys. It is deterministic: the same commands at the same times give bit-identical samples.
// Push and Rest use the hand of the closed-loop studies behind the stiffness rule. That hand has 0.3 kg and 3 Ns/m, on
// a device of 0.1 kg with its DeviceSpec's damping and 0.05 N of dry friction. Follow is a hand that knows its
// destination: a spring of 300 N/m, damped to a ratio of 0.8.
#pragma once

#include <cstdint>
#include <memory>

#include "haptic/device/hand_dynamics.h"
#include "haptic/device/haptic_device.h"
#include "worlds/base/latest_value.h"

namespace handrail::device {

enum class HandMode : std::uint8_t {
    // The hand moves to target_m in a straight line at speed_m_per_s, whatever force acts, and stays exactly there.
    Move,
    Follow,  // A spring of 300 N/m pulls the hand towards target_m. Mouse and keys use this mode.
    Push,    // the hand presses with the force push_n and has no target
    Rest,    // like Push, with a spring of 20 N/m towards target_m, as if the arm leaned on the device
};

// How the simulated person moves the hand, until the next command replaces this one. Device frame, metres and newtons.
struct HandCommand {
    HandMode mode = HandMode::Follow;
    Vec3 target_m{0.0};
    double speed_m_per_s = 0.0;  // for Move only; 0 or less: the hand arrives at once
    Vec3 push_n{0.0};
    std::uint32_t buttons = 0;
    Vec3 gimbal_rad{0.0};
};

// Simulated failures, for tests and scenarios. Each counter says for how many samples the failure lasts, from the
// moment it is published. 0: no failure.
struct DeviceTrouble {
    int not_a_number_samples = 0;
    int jump_samples = 0;  // samples in which jump_m is added to the position; negative: for ever
    Vec3 jump_m{0.0};
    // Samples without a new answer: the last position is repeated and `fresh` is false. Negative: for ever.
    int silent_samples = 0;
    bool unplugged = false;
    bool hot = false;     // the motors report that they are too warm
    bool failed = false;  // the driver reports that the device does not obey commands
};

// The true position of the hand and the force on it, without encoder steps and simulated failures. Drawing, scenarios
// and tests use it.
struct HandState {
    double time_s = 0.0;
    Vec3 position_m{0.0};
    Vec3 velocity_m_per_s{0.0};
    Vec3 force_n{0.0};  // force from the motors
};

// Channels between the thread that moves the hand (the app) and the servo thread. Each value has one producer and one
// consumer.
struct SimulatedHand {
    LatestValue<HandCommand> command;    // from the app to the servo
    LatestValue<DeviceTrouble> trouble;  // from the app to the servo
    LatestValue<HandState> state;        // from the servo to the app
};

// Simulates the time between two reads in steps of at most 0.1 ms. The motors hold the force that was written last. In
// modes other than Move, the force acts on the hand `delay_s` after it was written. Only Move can move the hand out of
// the sphere of workspace_radius_m. About 0.5 us per 1 ms tick.
class SimulatedDevice final : public HapticDevice {
public:
    // The hand starts at rest at `start_m`. `hand` is shared with the code that moves it; never null.
    SimulatedDevice(const DeviceSpec& spec, std::shared_ptr<SimulatedHand> hand, const Vec3& start_m = Vec3(0.0));

    const DeviceSpec& spec() const override { return spec_; }
    Result<void> open() override;
    DeviceSample read(double now_s) noexcept override;
    void write(const ForceCommand& command) noexcept override;
    void close() noexcept override;

private:
    void step(double to_s) noexcept;
    Vec3 motor_force_n(double time_s) noexcept;
    Vec3 measured_m() const noexcept;

    DeviceSpec spec_;
    std::shared_ptr<SimulatedHand> hand_;
    // Only the servo thread uses the members below.
    HandCommand command_;
    DeviceTrouble trouble_;
    bool started_ = false;
    double time_s_ = 0.0;
    HandBody body_;
    Vec3 felt_n_{0.0};
    Vec3 last_answer_m_{0.0};
    HeldForces held_;
};

}  // namespace handrail::device
