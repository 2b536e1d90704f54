// Runs the set-up wizard together with the servo, the cue planner and a voice that takes realistic time, on a virtual
// clock without threads. The simulated hand is on a simulated device or on an emulated Falcon.
#pragma once

#include "app/wizard/wizard_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "haptic/drivers/falcon_device.h"
#include "tests/emulators/falcon_emulator.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {

// A device with a simulated hand on it.
class HeldDevice {
public:
    virtual ~HeldDevice() = default;
    virtual Result<void> open(const std::function<void(const std::string&)>& report) = 0;
    virtual HandFacts facts() const = 0;
    virtual HapticDevice& device() = 0;
    // Sets the place that the hand tries to keep, in the device's frame.
    virtual void aim(const Vec3& at_m) = 0;
    virtual void button(bool down) = 0;
    virtual Vec3 force_on_hand_n() = 0;
};

class HeldSimulated final : public HeldDevice {
public:
    explicit HeldSimulated(std::string_view name = "sim-t") : spec_(*find_device_spec(name)), device_(spec_, hand) {}
    Result<void> open(const std::function<void(const std::string&)>&) override { return device_.open(); }
    HandFacts facts() const override { return {true, true, spec_, "17"}; }
    HapticDevice& device() override { return device_; }
    void aim(const Vec3& at_m) override {
        command.target_m = at_m;
        hand->command.publish(command);
    }
    void button(bool down) override {
        command.buttons = down ? 1U : 0U;
        hand->command.publish(command);
    }
    Vec3 force_on_hand_n() override {
        hand->state.refresh();
        return hand->state.read().force_n;
    }

    std::shared_ptr<SimulatedHand> hand = std::make_shared<SimulatedHand>();
    HandCommand command;

private:
    DeviceSpec spec_;
    SimulatedDevice device_;
};

// An emulated Falcon. It sleeps at first, wakes at the second attempt, and finds its zero when the hand moves it.
class HeldFalcon final : public HeldDevice {
public:
    explicit HeldFalcon(VirtualClock& clock);
    Result<void> open(const std::function<void(const std::string&)>& report) override;
    HandFacts facts() const override { return {true, false, *find_device_spec("falcon"), "A9001"}; }
    HapticDevice& device() override { return *device_; }
    void aim(const Vec3& at_m) override { emulator.grip_m = {at_m.x, at_m.z, 0.125 - at_m.y}; }
    void button(bool down) override { emulator.buttons = down ? 4 : 0; }
    Vec3 force_on_hand_n() override {
        const Vec3 falcon_n = emulator.force_on_hand_n();
        return {falcon_n.x, -falcon_n.z, falcon_n.y};
    }

    FalconEmulator emulator;

private:
    VirtualClock& clock_;
    TemporaryFolder folder_;
    std::function<void(const std::string&)> report_;
    std::unique_ptr<FalconDevice> device_;
};

class WizardRig {
public:
    explicit WizardRig(std::string_view only = "", HeldDevice* held = nullptr, VirtualClock* clock = nullptr);

    // Advances the whole rig by one millisecond.
    void advance();
    template <class Condition>
    bool run_until(Condition&& condition, double most_s = 60.0) {
        for (const double end_s = now_s() + most_s; now_s() < end_s;) {
            if (condition()) return true;
            advance();
        }
        return condition();
    }
    void run(double for_s) {
        run_until([] { return false; }, for_s);
    }
    void key(std::string_view name) { session.press(name, now_s()); }
    bool question_begins(std::string_view beginning) const { return wizard().question().starts_with(beginning); }
    const Wizard& wizard() const { return session.wizard(); }
    std::vector<std::string> said() const;
    bool has_said(std::string_view words) const;
    double now_s() const { return clock_.now_s(); }
    double force_n() { return held_ ? glm::length(held_->force_on_hand_n()) : 0.0; }
    DeviceProfile profile() const;  // the held device's profile in the settings; empty if there is none
    int clicks() const;

    SettingsStore store;
    WizardSession session;
    RecordingAudio audio;
    RecordingSpeech speech{175.0};
    WizardSense sense;
    // Greatest force, and greatest change of the force in a tick, since the start or the last forget_forces().
    double largest_force_n = 0.0, largest_step_n = 0.0;
    void forget_forces() { largest_force_n = largest_step_n = 0.0; }

private:
    VirtualClock own_clock_;
    VirtualClock& clock_;
    HeldDevice* held_;
    std::unique_ptr<ServoState> servo_;
    CuePlanner planner_{Settings{}};
    std::vector<CueRequest> requests_;
    std::vector<ContactEvent> contacts_;
    double next_frame_s_ = 0.0, next_cue_s_ = 0.0;
    Vec3 last_force_n_{0.0};
    std::vector<std::string> news_;
};

// Simulates a person who knows what to do and answers as soon as a question ends. The hand moves at 25 cm/s, and a
// reaction takes 0.3 s.
class BriskPerson {
public:
    BriskPerson(WizardRig& rig, HeldDevice* held) : rig_(rig), held_(held) {}
    // Answers every question until the wizard ends. Returns false if the wizard did not end within `most_s`.
    bool answer_all(double most_s);

    double felt_n = 0.35;  // least force that the person notices, in newtons

private:
    void advance();
    void wait(double for_s);
    void go(const Vec3& to_share);  // place in units of the device's radius
    void answer_one();

    WizardRig& rig_;
    HeldDevice* held_;
    Vec3 at_m_{0.0};
};

}  // namespace handrail::test
