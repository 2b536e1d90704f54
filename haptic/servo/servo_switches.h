// Switches for events that must act before the app next reads its keys: the stop key and the loss of the keyboard
// focus. The first thread that notices an event sets its switch, without waiting; the servo reads the switches in each
// tick. Stops are counted instead of flagged, so that a stop pressed while the app releases an earlier one is not lost.
// The force stays off until the app has confirmed the newest count (ServoTuning::stops_let_go).
#pragma once

#include <atomic>
#include <cstdint>

#include "haptic/servo/servo_tick.h"

namespace handrail::servo {

struct ServoSwitches {
    std::atomic<std::uint32_t> stops{0};  // number of presses of the stop key
    std::atomic<bool> focused{true};

    void stop() noexcept { stops.fetch_add(1, std::memory_order_release); }
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

// Return the tuning after the switches are applied; switches only ever reduce the force. The first overload takes
// values that were read earlier. The second reads the switches itself.
inline ServoTuning with_switches(ServoTuning tuning, std::uint32_t stops, bool focused) noexcept {
    tuning.panic = tuning.panic || stops != tuning.stops_let_go;
    tuning.focused = tuning.focused && focused;
    return tuning;
}
inline ServoTuning with_switches(const ServoTuning& tuning, const ServoSwitches& switches) noexcept {
    return with_switches(tuning, switches.stops.load(std::memory_order_acquire),
                         switches.focused.load(std::memory_order_acquire));
}

}  // namespace handrail::servo
