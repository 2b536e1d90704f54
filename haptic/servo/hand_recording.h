// What a recording keeps of each servo tick: the sample as the servo saw it, the force, and the numbers of all inputs
// from the app, so that the tick can be computed again. The servo only adds rows to the ring; the recorder takes them
// out. Without a ring a tick pays nothing.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>

#include "haptic/device/haptic_device.h"
#include "worlds/base/feature_id.h"
#include "worlds/base/spsc_ring.h"

namespace handrail::servo {

// For each input: how many times it had been handed over when the tick read it, counted since this servo began; 0:
// never yet.
struct ServoReads {
    std::uint32_t scene = 0, tuning = 0, pose = 0, bodies = 0, guidance = 0;
    std::uint32_t stops = 0;  // ServoSwitches::stops
    bool focused = true;      // ServoSwitches::focused
    bool stopping = false;    // the force is fading because the servo stops
    bool operator==(const ServoReads&) const = default;
};

// The same for the engine of the free bodies.
struct EngineReads {
    std::uint32_t engine = 0;   // HandChannel::engine; 0: there is none
    std::uint64_t frame = 0;    // DynamicsFrame::number of the newest frame that the tick knew; 0: none yet
    std::uint32_t refused = 0;  // BodiesInReach::take_refused
    bool operator==(const EngineReads&) const = default;
};

struct HandRow {
    double time_s = 0.0;          // time of the tick, a whole number of microseconds
    device::DeviceSample sample;  // rounded by round_to_whole_steps
    Vec3 force_n{0.0};            // on the hand, device frame
    FeatureId contact = kNoFeature;
    std::uint32_t servo = 0;  // which of this hand's servos, counted from 1
    ServoReads reads;
    EngineReads bodies;
};

// Passes rows from one servo at a time to the recorder.
struct HandRing {
    static constexpr std::size_t kRows = 4096;  // 4 s
    SpscRing<HandRow, kRows> rows;
    std::atomic<std::uint64_t> lost{0};  // rows that found no room
    std::uint32_t servos = 0;            // app thread: number of servos that were given the ring so far

    void push(const HandRow& row) noexcept {
        if (!rows.push(row)) lost.fetch_add(1, std::memory_order_relaxed);
    }
};

// Rounds a time to whole microseconds, so that it can be stored as an integer and is bit-identical when read.
inline double in_whole_microseconds(double time_s) noexcept { return std::round(time_s * 1e6) / 1e6; }
// Rounds a sample in the same way: to whole micrometres, and to millionths of a radian for the grip. If one coordinate
// of a vector is not finite or over a kilometre (1,000 rad) away, the whole vector becomes NaN.
void round_to_whole_steps(device::DeviceSample& sample) noexcept;

}  // namespace handrail::servo
