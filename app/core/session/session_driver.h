// Carries values between a session, the servos of its hands and its ears, each step in a stated order. The owner has
// the clock: real time in the program, virtual time in scenarios and tests, recorded time in a replay. App thread; owns
// none of what it connects.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/core/session/session.h"
#include "audio-cues/plan/ears_inbox.h"
#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_inbox.h"

namespace handrail {

class SessionDriver {
public:
    // What a set-up gives to the hand in place of the world.
    struct SetUpTouch {
        std::shared_ptr<const HapticScene> scene;
        ServoTuning tuning;
        WorkspacePose pose;
        HandCommand simulated;  // of a simulated hand
    };
    // What only some owners do. Each may be empty.
    struct Steps {
        // After the session's tick, before anything is handed over; with the tools that the tick had.
        std::function<void(double now_s, const ToolState& tool, const ToolState& left_tool)> ticked;
        // Takes the settings that the session changed, by key and value. True: the ears are given the settings anew.
        // Empty: they are for every change.
        std::function<bool(std::vector<std::pair<std::string, std::string>> changes)> take_settings;
        // Before the ears and the servos are given anything.
        std::function<void()> hands_over;
        // What is about to be said and played.
        std::function<void(std::vector<CueRequest>& cues)> look_at_cues;
    };

    // All outlive this object.
    SessionDriver(Session& app, EarsInbox& ears, Steps steps = {}) : app_(app), ears_(ears), steps_(std::move(steps)) {}

    // The servo of hand 0 (the only or right one) or 1 from now on, which is given everything anew; null: none.
    // simulated: its device, if the session moves it.
    void drive(std::size_t which, ServoInbox* servo, std::shared_ptr<SimulatedHand> simulated = nullptr);

    // A tick of the session, then hand_over(). The tools are what the servos published last.
    void tick(double now_s, const ToolState& tool, const ToolState& left_tool = {});
    // Settings that the session changed, to who keeps them and to the ears; hand_over() begins with this.
    void hand_over_settings();
    // What changed since the last time, in this order: settings, world, cues and listener to the ears, then to the
    // left and the right servo.
    void hand_over();

    // A set-up has the right hand until end_set_up(); hand_over() leaves that hand alone.
    void begin_set_up();
    void feel_set_up(const SetUpTouch& touch);
    // confirms: how often the set-up asked to confirm a fault; the servo counts them with those of the session.
    void end_set_up(std::uint32_t confirms);

private:
    struct Hand {
        ServoInbox* servo = nullptr;
        std::shared_ptr<SimulatedHand> simulated;
        // Given last.
        std::shared_ptr<const HapticScene> scene, desk;
        std::uint64_t bodies = 0;
        std::uint32_t guidance = 0;
    };

    void give_world(std::size_t which);
    void give_ears();

    Session& app_;
    EarsInbox& ears_;
    Steps steps_;
    std::array<Hand, 2> hands_;
    std::shared_ptr<const Scene> heard_scene_;
    int heard_world_ = 0;
    bool set_up_ = false;
    std::uint32_t confirms_ = 0;  // of all set-ups so far
};

}  // namespace handrail
