// What can go wrong with a live device, and the words for it. The sentences say what happened and what to do; any
// thread but the servo's.
#pragma once

#include <cstdint>
#include <string>

namespace handrail {

enum class Fault : std::uint8_t {
    None,
    BadSample,     // three positions in a row that are no numbers or out of all reach; latched
    Jump,          // three positions in a row that no hand can reach in a tick; latched
    Unplugged,     // latched
    DeviceSilent,  // no answer for 25 ms; the force comes back by itself with an answer
    LateLoop,      // a rate too slow to hold a wall; latched
    Stalled,       // one gap of the loop over 25 ms; the force comes back by itself
    Unhomed,       // the device does not yet know where it is
    BadForce,      // the renderer computed a force that is no number: our mistake; latched
    TooHot,        // the device says so, or it was asked for more than its motors bear; latched
    DriverError,   // the driver says that the device does not do as it is told; latched
    MayPush,       // what held the device is gone, and the device may still push; latched
    ForceOff,      // what held the device is gone, and the device has taken zero since; latched
    // Nothing is broken: the force waits, and comes back by itself with a ramp.
    FocusLost,       // the window lost the keyboard
    ButtonReleased,  // force only while the device's button is held, and it is not
};

// There is no device any more; these outweigh every other fault, and follow each other as more is known.
inline bool is_gone(Fault fault) {
    return fault == Fault::Unplugged || fault == Fault::MayPush || fault == Fault::ForceOff;
}
// Nothing is broken; no alarm is due.
inline bool is_pause(Fault fault) { return fault == Fault::FocusLost || fault == Fault::ButtonReleased; }
// The force comes back by itself when the cause is gone, and a ramp over.
inline bool passes_by_itself(Fault fault) {
    return is_pause(fault) || fault == Fault::DeviceSilent || fault == Fault::Stalled || fault == Fault::Unhomed;
}
// Fit to be spoken; empty for None.
std::string fault_sentence(Fault fault);

}  // namespace handrail
