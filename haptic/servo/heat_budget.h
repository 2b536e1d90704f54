// How warm a device's motors have become, from the forces they were asked for. A motor heats with the square of its
// current, and so of the force; a device that reports nothing is spared by this alone. Plain state, servo thread only;
// three multiplications a tick.
#pragma once

#include "haptic/render/tick_assert.h"

namespace handrail {

class HeatBudget {
public:
    static constexpr double kWindowS = 10.0;  // of the running mean; what ten seconds of a coil's heating come to
    // Of the heat that is allowed: from the limit it takes 7 s without force to get there.
    static constexpr double kCooledShare = 0.5;

    // Adds dt_s of a force of this size. sustained_n: root mean square over the window that the motors bear; infinity:
    // any.
    void add(double force_n, double sustained_n, double dt_s) noexcept {
        tick_assert(force_n >= 0.0 && sustained_n > 0.0 && dt_s >= 0.0);
        mean_square_n2_ += (force_n * force_n - mean_square_n2_) * (dt_s / (kWindowS + dt_s));
        warmth_ = mean_square_n2_ / (sustained_n * sustained_n);
        too_warm_ = warmth_ > 1.0 || (too_warm_ && warmth_ > kCooledShare);
    }
    double warmth() const noexcept { return warmth_; }    // share of what is allowed
    bool too_warm() const noexcept { return too_warm_; }  // from above 1 until below kCooledShare

private:
    double mean_square_n2_ = 0.0;
    double warmth_ = 0.0;
    bool too_warm_ = false;
};

}  // namespace handrail
