// The faults of a live device, and the sentences that describe them. Each sentence says what happened and what to do.
// Any thread but the servo's.
#pragma once

#include <cstdint>
#include <string>

namespace handrail::servo {

enum class Fault : std::uint8_t {
    None,
    BadSample,     // three positions in a row are not finite or out of reach; latched
    Jump,          // three positions in a row are farther than a hand can move in a tick; latched
    Unplugged,     // latched
    DeviceSilent,  // no answer for 25 ms; the force returns automatically with the next answer
    LateLoop,      // the rate is too slow to render a stable wall; latched
    Stalled,       // one gap of the loop over 25 ms; the force returns automatically
    Unhomed,       // the device does not know its own position yet
    BadForce,      // the renderer computed a force that is not finite, a bug of Handrail; latched
    TooHot,        // the device reports it, or the commanded forces exceed what its motors bear; latched
    DriverError,   // the driver reports that the device does not obey commands; latched
    MayPush,       // the process that held the device ended, and the device may still push; latched
    ForceOff,      // the process that held the device ended, and the device has since accepted zero force; latched
    // Not faults: the force pauses, and returns automatically with a ramp.
    FocusLost,       // the window lost the keyboard focus
    ButtonReleased,  // force only while the device's button is held, and it is released
};

// Returns true if the device is lost. These faults outweigh all others, and one may replace another as more becomes
// known.
inline bool is_gone(Fault fault) {
    return fault == Fault::Unplugged || fault == Fault::MayPush || fault == Fault::ForceOff;
}
// Returns true if nothing is broken, so that no alarm is due.
inline bool is_pause(Fault fault) { return fault == Fault::FocusLost || fault == Fault::ButtonReleased; }
// Returns true if the force comes back automatically, with a ramp, once the cause is gone.
inline bool passes_by_itself(Fault fault) {
    return is_pause(fault) || fault == Fault::DeviceSilent || fault == Fault::Stalled || fault == Fault::Unhomed;
}
// Suitable for speech; empty for None.
std::string fault_sentence(Fault fault);

}  // namespace handrail::servo
