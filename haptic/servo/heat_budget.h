// Estimates how warm a device's motors have become, from the forces that were commanded. A motor heats with the square
// of its current, and so of the force. It is the only protection for a device that reports no temperature. Plain state,
// servo thread only; three multiplications a tick.
#pragma once

#include "haptic/render/tick_assert.h"

namespace handrail::servo {

class HeatBudget {
public:
    static constexpr double kWindowS = 10.0;  // of the running mean; about the thermal time of a motor coil
    // Share of the allowed heat at which the motors count as cooled. From the limit it takes 7 s without force to get
    // there.
    static constexpr double kCooledShare = 0.5;

    // Adds dt_s of a force of this size. sustained_n: the root mean square over the window that the motors bear;
    // infinity: no limit.
    void add(double force_n, double sustained_n, double dt_s) noexcept {
        tick_assert(force_n >= 0.0 && sustained_n > 0.0 && dt_s >= 0.0);
        mean_square_n2_ += (force_n * force_n - mean_square_n2_) * (dt_s / (kWindowS + dt_s));
        warmth_ = mean_square_n2_ / (sustained_n * sustained_n);
        too_warm_ = warmth_ > 1.0 || (too_warm_ && warmth_ > kCooledShare);
    }
    double warmth() const noexcept { return warmth_; }  // share of the allowed heat
    // True from a warmth above 1 until it falls below kCooledShare.
    bool too_warm() const noexcept { return too_warm_; }

private:
    double mean_square_n2_ = 0.0;
    double warmth_ = 0.0;
    bool too_warm_ = false;
};

}  // namespace handrail::servo
