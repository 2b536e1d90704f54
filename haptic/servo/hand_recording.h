// Defines the recording's row for each servo tick: the sample as the servo saw it, the force, and the numbers of all
// inputs from the app. With it, the tick can be computed again. The servo only adds rows to the ring, and the recorder
// removes them. Without a ring, a tick has no cost for the recording.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>

#include "haptic/device/haptic_device.h"
#include "worlds/base/feature_id.h"
#include "worlds/base/spsc_ring.h"

namespace handrail::servo {

// For each input of the servo, how many values the app had passed when the tick read it, counted since this servo
// began. 0: none yet.
struct ServoReads {
    std::uint32_t scene = 0, tuning = 0, pose = 0, bodies = 0, guidance = 0;
    std::uint32_t stops = 0;  // value of ServoSwitches::stops
    bool focused = true;      // value of ServoSwitches::focused
    bool stopping = false;    // true while the force is fading because the servo stops
    bool operator==(const ServoReads&) const = default;
};

// The numbers of the inputs from the engine of the free bodies.
struct EngineReads {
    std::uint32_t engine = 0;   // HandChannel::engine; 0: no engine
    std::uint64_t frame = 0;    // DynamicsFrame::number of the newest frame that the tick knew; 0: none yet
    std::uint32_t refused = 0;  // result of BodiesInReach::take_refused()
    bool operator==(const EngineReads&) const = default;
};

struct HandRow {
    double time_s = 0.0;          // time of the tick in seconds, a whole number of microseconds
    device::DeviceSample sample;  // sample after round_to_whole_steps()
    Vec3 force_n{0.0};            // force on the hand, device frame
    FeatureId contact = kNoFeature;
    std::uint32_t servo = 0;  // number of the servo among this hand's servos, counted from 1
    ServoReads reads;
    EngineReads bodies;
};

// Passes rows from one servo at a time to the recorder.
struct HandRing {
    static constexpr std::size_t kRows = 4096;  // enough rows for 4 s
    SpscRing<HandRow, kRows> rows;
    std::atomic<std::uint64_t> lost{0};  // number of rows for which the ring had no room
    std::uint32_t servos = 0;            // number of servos that were given the ring so far; app thread

    void push(const HandRow& row) noexcept {
        if (!rows.push(row)) lost.fetch_add(1, std::memory_order_relaxed);
    }
};

// Rounds a time to whole microseconds, so that it can be stored as an integer and read back bit-identical.
inline double in_whole_microseconds(double time_s) noexcept { return std::round(time_s * 1e6) / 1e6; }
// Rounds a sample, as in_whole_microseconds() rounds a time: positions to whole micrometres, and angles of the grip to
// millionths of a radian. If one coordinate of a vector is not finite, or exceeds a kilometre (1,000 rad), the whole
// vector becomes NaN.
void round_to_whole_steps(device::DeviceSample& sample) noexcept;

}  // namespace handrail::servo
