// Passes data between a session, the servos of its hands, and speech and sound, in a fixed order. The owner provides
// the time: real time in the program, virtual time in scenarios and tests, recorded time in a replay. The driver owns
// none of the objects that it connects. Use it on the app thread.
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
    // The scene that the right hand feels during a set-up, instead of the world.
    struct SetUpTouch {
        std::shared_ptr<const render::HapticScene> scene;
        servo::ServoTuning tuning;
        servo::WorkspacePose pose;
        device::HandCommand simulated;  // command for a simulated hand
    };
    // Functions that some owners add. Each may be empty.
    struct Steps {
        // Called after the session's tick and before any data is passed on, with the states of the tools in that tick.
        std::function<void(double now_s, const servo::ToolState& tool, const servo::ToolState& left_tool)> ticked;
        // Receives the settings that the session has changed, as key and value. Returns true if speech and sound must
        // get the settings. If this function is empty, they get the settings after every change.
        std::function<bool(std::vector<std::pair<std::string, std::string>> changes)> take_settings;
        // Called before speech, sound and the servos receive any data.
        std::function<void()> hands_over;
        // Receives all cues before they are announced and played, and may change them.
        std::function<void(std::vector<cues::CueRequest>& cues)> look_at_cues;
    };

    // `app` and `ears` must outlive this object.
    SessionDriver(Session& app, cues::EarsInbox& ears, Steps steps = {})
        : app_(app), ears_(ears), steps_(std::move(steps)) {}

    // Sets the servo of hand 0 (the only or right hand) or hand 1. The servo then receives all data again. If `servo`
    // is null, the hand has no servo. `simulated` is the device of the hand if the session moves that device.
    void drive(std::size_t which, servo::ServoInbox* servo, std::shared_ptr<device::SimulatedHand> simulated = nullptr);

    // Ticks the session, then calls hand_over(). `tool` and `left_tool` are the states that the servos published last.
    void tick(double now_s, const servo::ToolState& tool, const servo::ToolState& left_tool = {});
    // Passes the settings that the session has changed to their owner and to speech and sound. hand_over() calls it
    // first.
    void hand_over_settings();
    // Passes on all changes since the last call in this order:
    // - the settings;
    // - world, cues and listener for sound and speech;
    // - the data for the left and the right servo.
    void hand_over();

    // Lets a set-up control the right hand until end_set_up(). Meanwhile, hand_over() does not touch that hand.
    void begin_set_up();
    void feel_set_up(const SetUpTouch& touch);
    // Returns the right hand to the session. `confirms` is how often the set-up requested to confirm a fault. The servo
    // adds it to the number of confirmations by the session.
    void end_set_up(std::uint32_t confirms);

private:
    struct Hand {
        servo::ServoInbox* servo = nullptr;
        std::shared_ptr<device::SimulatedHand> simulated;
        // The following values were sent to speech, sound and servos last.
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
    std::uint32_t confirms_ = 0;  // number of confirmations by all set-ups until now
};

}  // namespace handrail::core
