// Passes data between a session, the servos of its hands and its ears, in a fixed order. The owner has the clock: real
// time in the program, virtual time in scenarios and tests, recorded time in a replay. App thread. Owns none of the
// things that it connects.
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

namespace handrail::core {

class SessionDriver {
public:
    // What a set-up shows to the hand instead of the world.
    struct SetUpTouch {
        std::shared_ptr<const render::HapticScene> scene;
        servo::ServoTuning tuning;
        servo::WorkspacePose pose;
        device::HandCommand simulated;  // for a simulated hand
    };
    // Extra steps of some owners. Each may be empty.
    struct Steps {
        // Called after the session's tick and before anything is passed on, with the tools of that tick.
        std::function<void(double now_s, const servo::ToolState& tool, const servo::ToolState& left_tool)> ticked;
        // Receives the settings that the session changed, by key and value. Returns true if the ears must get the
        // settings. Empty: they get them after every change.
        std::function<bool(std::vector<std::pair<std::string, std::string>> changes)> take_settings;
        // Called before the ears and the servos receive anything.
        std::function<void()> hands_over;
        // Receives what is about to be announced and played.
        std::function<void(std::vector<cues::CueRequest>& cues)> look_at_cues;
    };

    // All of them outlive this object.
    SessionDriver(Session& app, cues::EarsInbox& ears, Steps steps = {})
        : app_(app), ears_(ears), steps_(std::move(steps)) {}

    // Sets the servo of hand 0 (the only or right one) or 1, which then receives everything again; null: none.
    // simulated: its device, if the session moves it.
    void drive(std::size_t which, servo::ServoInbox* servo, std::shared_ptr<device::SimulatedHand> simulated = nullptr);

    // Ticks the session, then calls hand_over(). The tools are what the servos published last.
    void tick(double now_s, const servo::ToolState& tool, const servo::ToolState& left_tool = {});
    // Passes on the settings that the session changed, to their owner and to the ears. hand_over() begins with this.
    void hand_over_settings();
    // Passes on what has changed since the last call, in this order: settings; world, cues and listener to the ears;
    // then data for the left and the right servo.
    void hand_over();

    // A set-up controls the right hand until end_set_up(); hand_over() does not touch that hand.
    void begin_set_up();
    void feel_set_up(const SetUpTouch& touch);
    // confirms: how often the set-up requested to confirm a fault; the servo adds them to those of the session.
    void end_set_up(std::uint32_t confirms);

private:
    struct Hand {
        servo::ServoInbox* servo = nullptr;
        std::shared_ptr<device::SimulatedHand> simulated;
        // Last sent:
        std::shared_ptr<const render::HapticScene> scene, desk;
        std::uint64_t bodies = 0;
        std::uint32_t guidance = 0;
    };

    void give_world(std::size_t which);
    void give_ears();

    Session& app_;
    cues::EarsInbox& ears_;
    Steps steps_;
    std::array<Hand, 2> hands_;
    std::shared_ptr<const Scene> heard_scene_;
    int heard_world_ = 0;
    bool set_up_ = false;
    std::uint32_t confirms_ = 0;  // of all set-ups up to now
};

}  // namespace handrail::core
