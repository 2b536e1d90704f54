// Connects pads and SpaceMouse devices with a session: guide() passes input to the session, and follow() passes cues to
// the devices. App thread. If no device is connected, each call costs one comparison.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/companions/companion_devices.h"
#include "audio-cues/plan/finger_planner.h"

namespace handrail::companions {

class CompanionSession {
public:
    // Starts to search for devices on a separate thread. If `run_thread` is false, there is no thread, and the owner of
    // a virtual clock calls devices().step().
    explicit CompanionSession(Clock& clock, bool run_thread = true);

    // Call before the session's tick. Steers the session and carries out the commands of pressed buttons. If
    // `busy_elsewhere`, discards them, because the person is answering something else. Returns the sentences that are
    // due: which devices were found or disconnected.
    std::vector<std::string> guide(core::Session& app, double now_s, bool busy_elsewhere = false);
    // Call after the tick. Makes cues from the session's cue requests and from the contacts of the hand. `tool` is
    // nullptr if there is no hand.
    void follow(const core::Session& app, std::span<const cues::CueRequest> requests, const servo::ToolState* tool,
                double now_s);

    CompanionDevices& devices() { return devices_; }

private:
    CompanionDevices devices_;
    cues::FingerPlanner planner_;
    std::shared_ptr<const Scene> scene_;
    int worlds_entered_ = 0;
    core::Steering steering_;
};

// Returns true if `name` names a device that gives cues or steers, but has no hand to feel with.
bool is_companion(std::string_view name);
std::string cues_and_walking_sentence(std::string_view model);
std::string no_companion_sentence(std::string_view name);

}  // namespace handrail::companions
