// Detects drop-outs of a sound device from the device's own clock. After a drop-out the device restarts, and from then
// on its clock is permanently late by at least a period. Plain state; one thread.
#pragma once

#include <array>
#include <cstddef>

namespace handrail::sinks {

class DropoutWatch {
public:
    // Length of a window. Only the smallest delay in each window is compared, because single late ticks do no harm.
    static constexpr double kWindow_s = 1.0;
    // Least increase of the delay that is a drop-out. It is less than a period of 256 samples, and far more than
    // clocks drift apart in a window.
    static constexpr double kLate_s = 0.004;
    // Number of windows with a drop-out within kWithin_s from which on there are too many.
    static constexpr std::size_t kMost = 3;
    static constexpr double kWithin_s = 60.0;

    // Returns true from the tick in which there were too many drop-outs until reset(). `device_s` is the playing time
    // by the device's own clock.
    bool tick(double now_s, double device_s);
    void reset() { *this = DropoutWatch{}; }

private:
    bool started_ = false, had_window_ = false, too_many_ = false;
    double window_ends_s_ = 0.0;
    double least_s_ = 0.0,
           // Smallest delay of the device relative to the clock, in this window and in the last one.
        last_least_s_ = 0.0;
    std::array<double, kMost> dropped_s_{};  // times of the drop-outs, newest first
    std::size_t dropped_ = 0;
};

}  // namespace handrail::sinks
