// What pads and pucks do to a session and what it does to them, in two calls a frame. App thread; where none is plugged
// in both are one comparison.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/companions/companion_devices.h"
#include "audio-cues/plan/finger_planner.h"

namespace handrail {

class CompanionSession {
public:
    // Looks for devices from now on, on a thread of its own. `run_thread` false: the owner of virtual time calls
    // devices().step().
    explicit CompanionSession(Clock& clock, bool run_thread = true);

    // Before the app's tick: steers it and presses what was pressed, unless the person is busy elsewhere. Gives the
    // sentences that are due: what was found, what is gone.
    std::vector<std::string> guide(Session& app, double now_s, bool busy_elsewhere = false);
    // After it: cues from what the app asks to be heard and what the hand touches; `tool` is nullptr where there is no
    // hand.
    void follow(const Session& app, std::span<const CueRequest> requests, const ToolState* tool, double now_s);

    CompanionDevices& devices() { return devices_; }

private:
    CompanionDevices devices_;
    FingerPlanner planner_;
    std::shared_ptr<const Scene> scene_;
    int worlds_entered_ = 0;
    Steering steering_;
};

// Of a device that was asked for by name and has no hand.
bool is_companion(std::string_view name);
std::string cues_and_walking_sentence(std::string_view model);
std::string no_companion_sentence(std::string_view name);

}  // namespace handrail
