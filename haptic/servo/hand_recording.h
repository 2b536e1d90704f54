// What a recording keeps of each tick of a servo: the sample as the servo saw it, the force, and the numbers of all
// that it had from the app, so that the same tick can be computed again. Whoever records takes the rows out of the
// ring; the servo only puts them in. Without a ring a tick pays nothing.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>

#include "haptic/device/haptic_device.h"
#include "worlds/base/feature_id.h"
#include "worlds/base/spsc_ring.h"

namespace handrail {

// How often each was handed over until the tick read it, counted since this servo began; 0: never yet.
struct ServoReads {
    std::uint32_t scene = 0, tuning = 0, pose = 0, bodies = 0, guidance = 0;
    std::uint32_t stops = 0;  // of ServoSwitches
    bool focused = true;      // likewise
    bool stopping = false;    // the force is brought down for the end
    bool operator==(const ServoReads&) const = default;
};

// Likewise of the engine of what is free to move.
struct EngineReads {
    std::uint32_t engine = 0;   // HandChannel::engine; 0: there is none
    std::uint64_t frame = 0;    // DynamicsFrame::number of the newest it knew; 0: none yet
    std::uint32_t refused = 0;  // HandBodies::take_refused
    bool operator==(const EngineReads&) const = default;
};

struct HandRow {
    double time_s = 0.0;  // of the tick, whole microseconds
    DeviceSample sample;  // as rounded by in_whole_steps
    Vec3 force_n{0.0};    // on the hand, device frame
    FeatureId contact = kNoFeature;
    std::uint32_t servo = 0;  // which of those that one hand had after each other, from 1
    ServoReads reads;
    EngineReads bodies;
};

// From one servo at a time to whoever records.
struct HandRing {
    static constexpr std::size_t kRows = 4096;  // 4 s
    SpscRing<HandRow, kRows> rows;
    std::atomic<std::uint64_t> lost{0};  // that found no room
    std::uint32_t servos = 0;            // app thread: that were given the ring so far

    void push(const HandRow& row) noexcept {
        if (!rows.push(row)) lost.fetch_add(1, std::memory_order_relaxed);
    }
};

// A time as whole microseconds, so that it can be written as a whole number and is the same to the bit when read.
inline double in_whole_microseconds(double time_s) noexcept { return std::round(time_s * 1e6) / 1e6; }
// The same for a sample: whole micrometres, and millionths of a radian for the grip. A place that is not finite or
// farther off than a kilometre is no place in any of its numbers.
void round_to_whole_steps(DeviceSample& sample) noexcept;

}  // namespace handrail
