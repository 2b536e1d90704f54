// Manages the hand that leads the session: decides which hand the person wants, searches for it, and offers devices
// that are connected later. App thread.
#pragma once

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/core/session/session_driver.h"
#include "app/main/commands.h"
#include "app/main/find_hand.h"
#include "app/main/session_voice.h"
#include "app/main/sleep_watch.h"
#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_loop.h"

namespace handrail::program {

class HandInUse {
public:
    // The parts that this class uses. All of them must outlive the HandInUse.
    struct Parts {
        const ExploreArguments& arguments;
        const settings::SettingsStore& settings;
        Clock& clock;
        servo::ServoSwitches& switches;
        servo::ServoLoop::EventRing& contacts;  // contacts of the hand in use
        core::Session& app;
        core::SessionDriver& driver;  // is informed which servo is in use
        const SessionVoice& say;
        servo::HandRing* recording;  // null if nothing is recorded
    };
    explicit HandInUse(const Parts& parts) : parts_(parts) {}

    // Returns the wanted hand: a name, a serial number, "auto" or "none". The command line overrides the settings.
    std::string wanted() const { return parts_.arguments.device.value_or(parts_.settings.values().haptic.device); }

    // Starts the search. Until it finds a real hand, the session uses a simulated one; if there is no real hand, the
    // session keeps the simulated one. If the person requested a certain device, the session has no hand until the
    // search has found that device. Sentences about the search belong to the reply of `requested_s`.
    void begin(double requested_s);
    // Call once a frame. Announces news of the search and of connected devices, and starts to use a hand that the
    // search has found. Returns false, and writes the reason to `err`, if a device requested on the command line is not
    // available.
    bool look(std::ostream& err);
    // For the set-up without a world: begin_for_set_up starts the search, and look_for_set_up stores its result. The
    // sentences go to `news`, so that the set-up can speak them at the right place.
    void begin_for_set_up();
    void look_for_set_up(std::vector<std::string>& news);
    bool looking() const { return search_.has_value(); }
    // Returns the time of the reply to which sentences about the search belong: the start, or the last accepted offer.
    double requested_s() const { return requested_s_; }

    // Returns true if a servo runs, so that the person can feel forces.
    bool driven() const { return servo_ != nullptr; }
    // Returns true if the hand is a simulated one, and the person requested neither a simulated hand nor "none".
    bool stands_in() const { return facts_.present && facts_.simulated && !hand_without_looking(wanted()); }
    // Returns true if the hand can be set up. A simulated hand can be set up only if the person requested it; nobody
    // else wants a request to move its grip.
    bool can_be_set_up() const;
    const core::HandFacts& facts() const { return facts_; }
    // Reads the newest state of the servo. tool() returns that state until the next call.
    void read();
    const servo::ToolState& tool() const { return tool_; }
    // For a real device: announces once what may make the servo run unevenly, and announces each report of the guard.
    void report_scheduling();

    // Call once a frame. If a real device is or was in use, removes all force before the computer sleeps, as the stop
    // key does. Afterwards announces how to bring the force back. `left` is the newest state of the left hand; null if
    // the left hand is no real device.
    void watch_sleep(const servo::ToolState* left);

    // Removes the force. Announces it if the removal of the force cannot be guaranteed. Waits at most 76 ms for a
    // remaining force to fade.
    void let_go();
    void stop_looking() { search_.reset(); }

private:
    void use(const core::HandFacts& facts, std::unique_ptr<drivers::GuardedDevice> device);
    bool take_found(std::ostream& err);
    bool do_without(const Error& problem, std::ostream& err);
    void look_at_plugs();
    void offer(drivers::PluggedHand hand);
    void offer_calibration();
    void report_guard();

    Parts parts_;
    std::shared_ptr<device::SimulatedHand> simulated_;
    std::unique_ptr<servo::ServoLoop> servo_;
    drivers::GuardedDevice* guarded_ = nullptr;  // servo_ owns it
    core::HandFacts facts_;
    servo::ToolState tool_;
    std::optional<HandSearch> search_;
    std::optional<PlugWatch> plug_watch_;
    std::optional<drivers::PluggedHand> offer_;  // the device that was last offered to the person
    double requested_s_ = 0.0;                   // when the program or the person started the search
    bool scheduling_reported_ = false;
    bool guard_missed_ = false;  // true if the guard process ended and the device was offered again
    std::optional<SleepWatch> sleep_;
};

}  // namespace handrail::program
