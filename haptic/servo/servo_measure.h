// Measures the servo under the conditions of the program: its own thread, real time, and a simulated hand that sweeps
// around one place. `handrail bench` and the comparison of renderers use it. Any thread; takes as long as the
// measurement.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "haptic/servo/servo_tick.h"
#include "worlds/base/result.h"

namespace handrail::servo {

struct ServoMeasured {
    double seconds = 0.0;
    std::uint64_t ticks = 0, overruns = 0;
    double touching = 0.0;  // share of the samples, taken every 16 ms, at which the hand touched something
    PeriodHistogram periods;
    DurationHistogram durations;
    std::string scheduling;  // a sentence about the thread's scheduling (scheduling_sentence)
};

// Runs the measurement. The hand holds a simulated Falcon and moves up to 35 mm in every direction from the middle of
// its workspace. Fails if the device cannot be opened.
Result<ServoMeasured> measure_servo(std::shared_ptr<const render::HapticScene> scene, const WorkspacePose& pose,
                                    const ServoTuning& tuning, double seconds);

}  // namespace handrail::servo
