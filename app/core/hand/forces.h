// Switches force on and off. Handles the force key, the stop, devices that are plugged in or fail, and the suggestion
// of a break after long touching. App thread only.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "app/core/context/session_part.h"

namespace handrail::core {

class Forces : SessionPart {
public:
    // Permits or forbids forces of the servos through `hands`.
    Forces(const SessionContext& context, HandsState& hands) : SessionPart(context), hands_(hands) {}

    // Handles the force key. Returns false if the command belongs to another feature.
    bool act(Command command, double now_s);
    // Stops everything: force, sounds, speech. The switch and the window both report the same press. The second report
    // does nothing and returns false, because it must not silence what the first one announced.
    bool stop(double now_s);
    // stops: presses of the stop key up to now, as the servo's switches count them. Returns true if the session has not
    // yet stopped.
    bool know_stops(std::uint32_t stops);
    // Replaces the device by another one, or by none.
    void take(const HandFacts& hand);
    // A usable device was plugged in. Announces it; the next press of the force key takes it.
    void offer(const std::string& spoken_name, double now_s);
    // After a fault has ended without help, announces that the force key brings the force back.
    void tick(double now_s);
    // Suggests a break when it is due.
    void tell_break(double now_s);

private:
    void toggle(double now_s);
    std::string why_none_yet() const;

    HandsState& hands_;
    bool offered_ = false;
    bool fault_lasted_ = false;
    double stopped_s_ = -1e9;
    std::uint32_t stops_known_ = 0;
    double breaks_told_ = 0.0;
    double contact_before_s_ = 0.0;  // seconds of contact with devices used earlier
};

}  // namespace handrail::core
