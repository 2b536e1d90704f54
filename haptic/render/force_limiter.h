// The only way out for a force: nothing reaches a motor that did not pass here. Bounds the vector, ramps it in, and
// takes it away. It has no slew-rate limit: one in the force path is a phase lag that makes walls unstable; jumps are
// bounded by the geometry in front of it. Plain state owned by whoever owns the servo state; real-time safe: no
// allocation, lock, clock or exception, about 30 flops a tick.
#pragma once

#include "worlds/base/vec.h"

namespace handrail {

// What the force may do on this tick.
enum class ForceFlow {
    Run,   // ramp in over 1 s from wherever the gain stands, then pass on in full
    Fade,  // take away over 75 ms, or faster if hurried
    Cut,   // zero on this very tick; the way back is the 1 s ramp
};

class ForceLimiter {
public:
    static constexpr double kRampS = 1.0;
    static constexpr double kFadeS = 0.075;
    static constexpr double kDropoutReturnS = 0.020;
    static constexpr double kResumeDecayS = 0.080;

    // wanted_n: what the renderer asks for, any frame. ceiling_n: the smaller of the person's choice and the device's
    // peak; infinity is none; negative or not a number counts as 0. The vector is scaled, its direction kept. A force
    // that is not finite gives zero, cuts, and sets broken() for this tick. fade_s: how long a fade from full gain
    // takes, only used with ForceFlow::Fade.
    Vec3 limit(const Vec3& wanted_n, double ceiling_n, ForceFlow flow, double dt_s, double fade_s = kFadeS) noexcept;

    // This tick's output is zero and the full force is back kDropoutReturnS later: one or two bad samples. The ramp
    // goes on from where it was.
    void drop_out() noexcept;
    // The ramp starts again from zero: new scene, teleport, forces enabled, a fault let go.
    void restart() noexcept { gain_ = 0.0; }
    // The motor held the last output over a gap, and the next limit() would jump. It starts from the held force
    // instead, and the difference decays with kResumeDecayS. Only ever weakens the force, and never turns it.
    void resume_after_gap() noexcept { resume_pending_ = true; }

    double gain() const noexcept { return gain_; }    // ramp, 0 to 1
    bool broken() const noexcept { return broken_; }  // the last wanted force was not finite
    Vec3 last_n() const noexcept { return last_n_; }  // the last output

private:
    double gain_ = 0.0;
    double dropout_gain_ = 1.0;
    bool dropped_ = false;
    double resume_offset_n_ = 0.0;  // newtons taken off the magnitude
    bool resume_pending_ = false;
    bool broken_ = false;
    Vec3 last_n_{0.0};
};

}  // namespace handrail
