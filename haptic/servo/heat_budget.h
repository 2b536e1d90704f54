// Estimates how warm a device's motors have become, from the commanded forces. A motor heats with the square of its
// current, and so with the square of the force. If a device reports no temperature, HeatBudget is its only protection.
// Plain state, servo thread only; three multiplications a tick.
#pragma once

#include "haptic/render/tick_assert.h"

namespace handrail::servo {

class HeatBudget {
public:
    // Time constant of the running mean, about the thermal time of a motor coil.
    static constexpr double kWindowS = 10.0;
    // Share of the permitted heat below which the motors have cooled enough. From the limit, this takes 7 s without
    // force.
    static constexpr double kCooledShare = 0.5;

    // Adds a force of the size `force_n` that acted for `dt_s`. `sustained_n` is the root mean square over the window
    // that the motors tolerate; infinity: no limit.
    void add(double force_n, double sustained_n, double dt_s) noexcept {
        tick_assert(force_n >= 0.0 && sustained_n > 0.0 && dt_s >= 0.0);
        mean_square_n2_ += (force_n * force_n - mean_square_n2_) * (dt_s / (kWindowS + dt_s));
        warmth_ = mean_square_n2_ / (sustained_n * sustained_n);
        too_warm_ = warmth_ > 1.0 || (too_warm_ && warmth_ > kCooledShare);
    }
    double warmth() const noexcept { return warmth_; }  // share of the permitted heat; 1 is the limit
    // Becomes true when the warmth exceeds 1, and false when it falls below kCooledShare.
    bool too_warm() const noexcept { return too_warm_; }

private:
    double mean_square_n2_ = 0.0;
    double warmth_ = 0.0;
    bool too_warm_ = false;
};

}  // namespace handrail::servo
