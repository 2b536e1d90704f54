// Limits the force that reaches a motor; there is no other path to the motor. ForceLimiter limits the force's size,
// ramps it in, and removes it. It does not limit the rate of change, because the phase lag of such a limit in the force
// path would make walls unstable. The geometry in front of it already limits jumps of the force. Plain state, which
// belongs to the servo state. Real-time safe: no allocation, lock, clock or exception; about 30 flops a tick.
#pragma once

#include "worlds/base/vec.h"

namespace handrail::render {

// How the limiter treats the force in this tick.
enum class ForceFlow {
    Run,   // ramp the force in over 1 s from the current gain, then pass it in full
    Fade,  // fade the force out over 75 ms, or faster on request
    Cut,   // zero force in this very tick; afterwards the force ramps in over 1 s
};

class ForceLimiter {
public:
    static constexpr double kRampS = 1.0;
    static constexpr double kFadeS = 0.075;
    static constexpr double kDropoutReturnS = 0.020;
    static constexpr double kResumeDecayS = 0.080;

    // Returns the limited force. A vector that is too long is scaled and keeps its direction. A force that is not
    // finite gives zero, has the effect of ForceFlow::Cut, and makes broken() true for this tick.
    // - wanted_n: force that the renderer requests, in any frame.
    // - ceiling_n: the smaller of the person's choice and the device's peak. Infinity means no limit; a negative
    //   ceiling or NaN is replaced by 0.
    // - fade_s: duration of a fade from full gain, used only with ForceFlow::Fade.
    Vec3 limit(const Vec3& wanted_n, double ceiling_n, ForceFlow flow, double dt_s, double fade_s = kFadeS) noexcept;

    // Makes this tick's output zero because of one or two bad samples, and restores the full force kDropoutReturnS
    // later. The ramp then continues from where it was.
    void drop_out() noexcept;
    // Starts the ramp again from zero. Used after a new scene, a teleport, enabling forces or clearing a fault.
    void restart() noexcept { gain_ = 0.0; }
    // Call it after a gap over which the motor held the last output, because the next output would otherwise jump. The
    // output then starts from the size of the held force, and the difference decays with kResumeDecayS. This correction
    // only weakens the force and never turns it.
    void resume_after_gap() noexcept { resume_pending_ = true; }

    double gain() const noexcept { return gain_; }    // gain of the ramp, 0 to 1
    bool broken() const noexcept { return broken_; }  // true if the last requested force was not finite
    Vec3 last_n() const noexcept { return last_n_; }  // the last output

private:
    double gain_ = 0.0;
    double dropout_gain_ = 1.0;
    bool dropped_ = false;
    double resume_offset_n_ = 0.0;  // correction after a gap: newtons subtracted from the magnitude
    bool resume_pending_ = false;
    bool broken_ = false;
    Vec3 last_n_{0.0};
};

}  // namespace handrail::render
