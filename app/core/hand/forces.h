// Force on and off: the key, the stop, hands that are plugged in or fail, and the break that is due after long
// touching. App thread only.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "app/core/context/session_part.h"

namespace handrail {

class Forces : SessionPart {
public:
    // It tells the servos of `hands` when they may act.
    Forces(const SessionContext& context, HandsState& hands) : SessionPart(context), hands_(hands) {}

    // The force key. False: it is another's.
    bool act(Command command, double now_s);
    // Everything stops: force, sounds, speech. False: the switch and the window tell of the same press, and the second
    // telling must not silence what the first one says.
    bool stop(double now_s);
    // How often the stop key was pressed by now, as the servo's switches count. True: the session has still to stop.
    bool know_stops(std::uint32_t stops);
    // Another device, or none, in place of the one there was.
    void take(const HandFacts& hand);
    // A device that could be used was plugged in: says so, and the force key takes it the next time.
    void offer(const std::string& spoken_name, double now_s);
    // Tells when a confirmation would bring the force back, where that comes by itself.
    void tick(double now_s);
    // Proposes a break where one is due.
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
    double contact_before_s_ = 0.0;  // with devices used earlier
};

}  // namespace handrail
