// The hand that leads the session: which one is wanted, the search for it, and what is plugged in meanwhile. App
// thread.
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

namespace handrail {

class HandInUse {
public:
    // All outlive this object.
    struct Parts {
        const ExploreArguments& arguments;
        const SettingsStore& settings;
        Clock& clock;
        ServoSwitches& switches;
        ServoLoop::EventRing& contacts;  // of whichever device is in use
        Session& app;
        SessionDriver& driver;  // is told which servo there is
        const SessionVoice& say;
        HandRing* recording;  // null: nobody records
    };
    explicit HandInUse(const Parts& parts) : parts_(parts) {}

    // By name or serial number, auto or none, as the command line or the settings say.
    std::string wanted() const { return parts_.arguments.device.value_or(parts_.settings.values().haptic.device); }

    // Until a real hand is found, and where none is, a simulated one is there; who asked for a certain device waits for
    // that. What is said of the search belongs to the reply of `asked_s`.
    void begin(double asked_s);
    // Once a frame: what the search and the plugs have to tell; a hand that was found takes its place. False when a
    // device that was asked for on the command line cannot be had, with the reason in `err`.
    bool look(std::ostream& err);
    // For the set-up without a world: begins the search, then takes what it found; its words go to `news`, to be said
    // in their place.
    void begin_for_set_up();
    void look_for_set_up(std::vector<std::string>& news);
    bool looking() const { return search_.has_value(); }
    // The reply to which its words belong: the one it began with, or the one to an offer that was taken since.
    double asked_s() const { return asked_s_; }

    // There is a servo, and so something that feels.
    bool driven() const { return servo_ != nullptr; }
    // A simulated one that nobody asked for.
    bool stands_in() const { return facts_.present && facts_.simulated && !hand_without_looking(wanted()); }
    // A hand that can be set up. A simulated one counts only for who asked for one: nobody else wants to be asked to
    // move its grip.
    bool can_be_set_up() const;
    const HandFacts& facts() const { return facts_; }
    // The newest of the servo; kept until the next call.
    void read();
    const ToolState& tool() const { return tool_; }
    // Once, for a real device: what may make it uneven. And what its guard has to tell, whenever it has.
    void tell_how_it_runs();

    // Once a frame: from the first real device on, takes all force away before the computer sleeps, as the stop key
    // does, and says afterwards how it comes back. `left`: the newest of the left hand; null: that is no real device.
    void watch_sleep(const ToolState* left);

    // Takes the force away, and tells it where that cannot be made sure of. Waits for a force that is still on to fade,
    // at most 76 ms.
    void let_go();
    void stop_looking() { search_.reset(); }

private:
    void use(const HandFacts& facts, std::unique_ptr<GuardedDevice> device);
    bool take_found(std::ostream& err);
    bool do_without(const Error& problem, std::ostream& err);
    void look_at_plugs();
    void offer(PluggedHand hand);
    void offer_calibration();
    void tell_of_guard();

    Parts parts_;
    std::shared_ptr<SimulatedHand> simulated_;
    std::unique_ptr<ServoLoop> servo_;
    GuardedDevice* guarded_ = nullptr;  // servo_ owns it
    HandFacts facts_;
    ToolState tool_;
    std::optional<HandSearch> search_;
    std::optional<PlugWatch> plug_watch_;
    std::optional<PluggedHand> offer_;  // the last one made
    double asked_s_ = 0.0;              // when the program or the person began the search
    bool told_how_it_runs_ = false;
    bool guard_missed_ = false;  // and the device offered anew
    std::optional<SleepWatch> sleep_;
};

}  // namespace handrail
