// The only path by which a force reaches a motor. It bounds the vector, ramps it in, and takes it away. It has no
// slew-rate limit: that would be a phase lag in the force path, which makes walls unstable. Jumps are bounded by the
// geometry before it. Plain state, owned by the owner of the servo state. Real-time safe: no allocation, lock, clock or
// exception; about 30 flops a tick.
#pragma once

#include "worlds/base/vec.h"

namespace handrail::render {

// What the force may do in this tick.
enum class ForceFlow {
    Run,   // ramp in over 1 s from the current gain, then pass on in full
    Fade,  // fade out over 75 ms, or faster on request
    Cut,   // zero in this very tick; afterwards the 1 s ramp applies
};

class ForceLimiter {
public:
    static constexpr double kRampS = 1.0;
    static constexpr double kFadeS = 0.075;
    static constexpr double kDropoutReturnS = 0.020;
    static constexpr double kResumeDecayS = 0.080;

    // wanted_n: the force that the renderer wants, in any frame. ceiling_n: the smaller of the person's choice and the
    // device's peak; infinity means none; negative or NaN counts as 0. The vector is scaled and keeps its direction. A
    // force that is not finite gives zero, cuts, and sets broken() for this tick. fade_s: duration of a fade from full
    // gain, used only with ForceFlow::Fade.
    Vec3 limit(const Vec3& wanted_n, double ceiling_n, ForceFlow flow, double dt_s, double fade_s = kFadeS) noexcept;

    // Makes this tick's output zero and restores the full force kDropoutReturnS later, for one or two bad samples. The
    // ramp continues from where it was.
    void drop_out() noexcept;
    // Starts the ramp again from zero: after a new scene, a teleport, enabling forces or clearing a fault.
    void restart() noexcept { gain_ = 0.0; }
    // Call it if the motor held the last output over a gap, because the next limit() would jump. The output then starts
    // from the held force, and the difference decays with kResumeDecayS. It only ever weakens the force and never turns
    // it.
    void resume_after_gap() noexcept { resume_pending_ = true; }

    double gain() const noexcept { return gain_; }    // of the ramp, 0 to 1
    bool broken() const noexcept { return broken_; }  // the last wanted force was not finite
    Vec3 last_n() const noexcept { return last_n_; }  // the last output

private:
    double gain_ = 0.0;
    double dropout_gain_ = 1.0;
    bool dropped_ = false;
    double resume_offset_n_ = 0.0;  // newtons subtracted from the magnitude
    bool resume_pending_ = false;
    bool broken_ = false;
    Vec3 last_n_{0.0};
};

}  // namespace handrail::render
