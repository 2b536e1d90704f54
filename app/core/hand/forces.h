// Switches force on and off. The class responds to the force key, to the stop key, and to devices that are plugged in
// or fail. It suggests a break after a long time of touching. Use it on the app thread only.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "app/core/context/session_part.h"

namespace handrail::core {

class Forces : SessionPart {
public:
    // Permits or forbids force by writing to `hands`, from which the servos get their values.
    Forces(const SessionContext& context, HandsState& hands) : SessionPart(context), hands_(hands) {}

    // Carries out the command of the force key. Returns false if the command belongs to another feature.
    bool act(Command command, double now_s);
    // Stops all force, sound and speech. The servo's switches and the window both report the same press of the stop
    // key. The second report changes nothing and returns false, so that it does not silence the announcement of the
    // first.
    bool stop(double now_s);
    // `stops` is the number of presses of the stop key until now, as the servo's switches count them. Returns true if
    // the session has not stopped yet for the last of these presses.
    bool know_stops(std::uint32_t stops);
    // Replaces the present device by `hand`, which may also mean that there is no device.
    void take(const HandFacts& hand);
    // Announces that a usable device was plugged in. The next press of the force key then switches to this device.
    void offer(const std::string& spoken_name, double now_s);
    // If a fault has ended by itself, announces that the force key switches the force on again.
    void tick(double now_s);
    // Suggests a break when it is due.
    void announce_break(double now_s);

private:
    void toggle(double now_s);
    std::string why_none_yet() const;

    HandsState& hands_;
    bool offered_ = false;
    bool fault_lasted_ = false;
    double stopped_s_ = -1e9;
    std::uint32_t stops_known_ = 0;
    double breaks_announced_ = 0.0;
    double contact_before_s_ = 0.0;  // seconds of contact with devices that were used earlier
};

}  // namespace handrail::core
