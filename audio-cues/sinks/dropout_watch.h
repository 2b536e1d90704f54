// Detects drop-outs of a sound device from the device's own clock. A device that restarts after it ran dry stays behind
// permanently, by at least a period. Plain state; one thread.
#pragma once

#include <array>
#include <cstddef>

namespace handrail::sinks {

class DropoutWatch {
public:
    // In each window only the smallest delay counts, because single late ticks do no harm.
    static constexpr double kWindow_s = 1.0;
    // Less than a period of 256 samples, and far more than clocks drift apart in a window.
    static constexpr double kLate_s = 0.004;
    static constexpr std::size_t kMost = 3;  // this many windows with a drop-out within kWithin_s are too many
    static constexpr double kWithin_s = 60.0;

    // `device_s`: how much the device has played, by its own clock. Returns true from the tick on in which there were
    // too many drop-outs, until reset().
    bool tick(double now_s, double device_s);
    void reset() { *this = DropoutWatch{}; }

private:
    bool started_ = false, had_window_ = false, too_many_ = false;
    double window_ends_s_ = 0.0;
    double least_s_ = 0.0,
           last_least_s_ = 0.0;  // smallest delay of the device against the clock, in this window and the one before
    std::array<double, kMost> dropped_s_{};  // times of the drop-outs, newest first
    std::size_t dropped_ = 0;
};

}  // namespace handrail::sinks
