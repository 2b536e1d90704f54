// Lists the faults of a live device, and the sentences that describe them. Each sentence says what happened and what
// the person can do. Any thread except the servo thread, because composing a sentence allocates.
#pragma once

#include <cstdint>
#include <string>

namespace handrail::servo {

enum class Fault : std::uint8_t {
    None,
    BadSample,     // Three positions in a row are not finite or out of reach; latched.
    Jump,          // Three positions in a row are farther apart than a hand can move in a tick; latched.
    Unplugged,     // the device is no longer connected; latched
    DeviceSilent,  // the device has not answered for 25 ms; the force returns automatically with the next answer
    LateLoop,      // the loop is too slow to render a stable wall; latched
    Stalled,       // one gap of the loop was longer than 25 ms; the force returns automatically
    Unhomed,       // the device does not know its own position yet
    BadForce,      // the renderer computed a force that is not finite, which is a bug in Handrail; latched
    TooHot,  // The device reports that it is too warm, or the commanded forces exceed what its motors bear; latched.
    DriverError,  // the driver reports that the device does not obey commands; latched
    MayPush,      // the process that held the device ended, and the device may still push; latched
    ForceOff,     // the process that held the device ended, and the device has since accepted zero force; latched
    // FocusLost and ButtonReleased are not faults. The force pauses and returns automatically with a ramp.
    FocusLost,       // the window lost the keyboard focus
    ButtonReleased,  // the person has released the button that must be held for any force
};

// Returns true if the device is lost. Such a fault replaces all others. It may itself be replaced by another such fault
// when more is known.
inline bool is_lost(Fault fault) {
    return fault == Fault::Unplugged || fault == Fault::MayPush || fault == Fault::ForceOff;
}
// Returns true for a pause, in which nothing is broken, so that no alarm is due.
inline bool is_pause(Fault fault) { return fault == Fault::FocusLost || fault == Fault::ButtonReleased; }
// Returns true if the force returns automatically, with a ramp, once the cause has ended.
inline bool passes_by_itself(Fault fault) {
    return is_pause(fault) || fault == Fault::DeviceSilent || fault == Fault::Stalled || fault == Fault::Unhomed;
}
// Returns a sentence suitable for speech; empty for None.
std::string fault_sentence(Fault fault);

}  // namespace handrail::servo
