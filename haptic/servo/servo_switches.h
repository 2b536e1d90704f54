// What must not wait until the app next looks at its keys: the stop key and the keyboard's loss. Whoever sees them
// first sets them, in any thread, without waiting; the servo reads them at each tick. A count instead of a flag, so
// that a stop pressed while the app lets an earlier one go is not lost: the force stays off until the app has named the
// newest count (ServoTuning::stops_let_go).
#pragma once

#include <atomic>
#include <cstdint>

#include "haptic/servo/servo_tick.h"

namespace handrail {

struct ServoSwitches {
    std::atomic<std::uint32_t> stops{0};  // presses of the stop key
    std::atomic<bool> focused{true};

    void stop() noexcept { stops.fetch_add(1, std::memory_order_release); }
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

// The tuning as the switches leave it: they only ever take force away. By what they read, or by what was read of them.
inline ServoTuning with_switches(ServoTuning tuning, std::uint32_t stops, bool focused) noexcept {
    tuning.panic = tuning.panic || stops != tuning.stops_let_go;
    tuning.focused = tuning.focused && focused;
    return tuning;
}
inline ServoTuning with_switches(const ServoTuning& tuning, const ServoSwitches& switches) noexcept {
    return with_switches(tuning, switches.stops.load(std::memory_order_acquire),
                         switches.focused.load(std::memory_order_acquire));
}

}  // namespace handrail
