// Finds the game pads, SpaceMouse devices and rumble pads of a session, even if they are connected later. Turns their
// sticks and buttons into steering and commands, and sends cues to them. Only a separate thread accesses the devices,
// so a slow device delays neither the app thread nor the servo. The functions for the app thread lock a mutex for
// microseconds. step() is the whole body of the thread's loop, so tests with a virtual clock need no thread. If no
// device is connected, the thread only searches every two seconds.
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

// Returns the command of a button, as in the table of docs/user-guide/devices.md; nothing if the button has none.
std::optional<core::Command> command_of(drivers::CompanionButton button);

class CompanionDevices {
public:
    static constexpr double kPeriod_s = 0.008, kLookAgain_s = 2.0;
    // Interval between cues. There are about 62 cues a second, which is half of what a pad accepts over Bluetooth.
    static constexpr double kCueEvery_s = 0.016;
    // Interval after which an unchanged cue is sent again, in case a report was lost.
    static constexpr double kCueAgain_s = 0.5;

    // The clock must outlive this object.
    explicit CompanionDevices(Clock& clock) : clock_(clock) {}
    ~CompanionDevices() { stop(); }
    CompanionDevices(const CompanionDevices&) = delete;
    CompanionDevices& operator=(const CompanionDevices&) = delete;

    // App thread. stop() stops the motion and the force of every device. stop() may be called again.
    void start();
    void stop();

    // The functions from here to give() are for the app thread.
    bool any() const { return count_.load(std::memory_order_relaxed) > 0; }
    core::Steering steering();                   // sum of the steering of all devices
    std::vector<core::Command> take_commands();  // commands of the buttons that were pressed since the last call
    std::vector<std::string> take_news();     // sentences about devices: found, disconnected, or not permitted to open
    void give(const device::FingerCue& cue);  // gives a cue that lasts until the next one

    // Runs one round at the clock's present time. The thread calls it; with a virtual clock, the owner of the clock
    // calls it.
    void step();

private:
    struct Plugged {
        drivers::FoundCompanion found;
        std::unique_ptr<drivers::Companion> device;
        drivers::CompanionState state;
        device::FingerCue sent;
        double sent_s = -1e9;
    };

    void run();
    void look_around(double now_s);
    bool serve(Plugged& plugged, const device::FingerCue& cue, double now_s, core::Steering& sum);

    Clock& clock_;
    std::thread thread_;  // only the app thread uses it
    std::atomic<bool> stop_requested_{false};
    std::atomic<std::size_t> count_{0};

    std::mutex mutex_;  // guards the four members after it
    core::Steering steering_;
    std::vector<core::Command> commands_;
    std::vector<std::string> news_;
    device::FingerCue cue_;

    // Members that only the thread of this object uses:
    std::vector<Plugged> plugged_;
    std::set<std::string> refused_;  // paths of devices that could not be opened; each is reported once
    double looked_s_ = -1e9;
};

}  // namespace handrail::companions
