// Game pads, SpaceMouse and rumble pads in a session. Finds them, whether connected before or later, turns their sticks
// and buttons into steering and commands, and gives them cues. A separate thread alone touches the devices, so a slow
// one delays neither app nor servo. The app thread calls everything marked so, which holds a mutex for microseconds.
// step() is the whole body of the loop, so tests with a virtual clock need no thread. With no device connected, the
// thread only looks around every two seconds.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "app/core/session/session.h"
#include "haptic/drivers/companion.h"
#include "worlds/base/clock.h"

namespace handrail::companions {

// The command of a button, as in the table of docs/user-guide/devices.md; nothing if it has none.
std::optional<core::Command> command_of(drivers::CompanionButton button);

class CompanionDevices {
public:
    static constexpr double kPeriod_s = 0.008, kLookAgain_s = 2.0;
    static constexpr double kCueEvery_s = 0.016;  // 62 reports a second, half of what a pad accepts over Bluetooth
    static constexpr double kCueAgain_s = 0.5;    // repeats an unchanged cue, in case a report was lost

    // The clock outlives this object.
    explicit CompanionDevices(Clock& clock) : clock_(clock) {}
    ~CompanionDevices() { stop(); }
    CompanionDevices(const CompanionDevices&) = delete;
    CompanionDevices& operator=(const CompanionDevices&) = delete;

    // App thread. stop() leaves every device still and without force; calling it again does no harm.
    void start();
    void stop();

    // App thread.
    bool any() const { return count_.load(std::memory_order_relaxed) > 0; }
    core::Steering steering();                   // of all devices together
    std::vector<core::Command> take_commands();  // from the buttons pressed since the last call
    std::vector<std::string> take_news();        // sentences: device found, gone, or not permitted
    void give(const device::FingerCue& cue);     // felt until the next cue

    // One round at the clock's time: the thread's body, or called by the owner of a virtual clock.
    void step();

private:
    struct Plugged {
        drivers::FoundCompanion found;
        std::unique_ptr<drivers::Companion> device;
        drivers::CompanionState state;
        device::FingerCue told;
        double told_s = -1e9;
    };

    void run();
    void look_around(double now_s);
    bool serve(Plugged& plugged, const device::FingerCue& cue, double now_s, core::Steering& sum);

    Clock& clock_;
    std::thread thread_;  // used by the app thread
    std::atomic<bool> stop_asked_{false};
    std::atomic<std::size_t> count_{0};

    std::mutex mutex_;  // guards the next four members
    core::Steering steering_;
    std::vector<core::Command> commands_;
    std::vector<std::string> news_;
    device::FingerCue cue_;

    // Used by the companions' thread only.
    std::vector<Plugged> plugged_;
    std::set<std::string> refused_;  // paths that could not be opened; reported once
    double looked_s_ = -1e9;
};

}  // namespace handrail::companions
