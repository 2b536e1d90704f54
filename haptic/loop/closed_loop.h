// A hand, a device and a renderer in one loop, in virtual time. Tests and the benchmark use it to study stability,
// friction chatter and stalls. The hand and the delay of the force are those of the simulated device; it adds tremor,
// sensor noise and stalls of the loop. The renderer is any function from a measured position to a force. Deterministic:
// the same settings and seed give the same numbers. Off the real-time path; one thread. Model: one mass, held force,
// fixed delay, encoder step; no flexibility, no amplifier lag, three uncoupled axes. Sources: Colgate & Schenkel,
// Passivity of a class of sampled-data systems, 1997; Diolaiti et al., Stability of haptic rendering, 2006.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <span>

#include "haptic/device/hand_dynamics.h"

namespace handrail::loop {

struct LoopSettings {
    device::HandMechanics hand;  // includes the device
    double period_s = 1e-3;
    double delay_s = 1e-3;  // from reading the position to the force on the hand, beyond the hold
    double encoder_quantum_m = 0.06e-3;
    double tremor_m = 0.0;       // tremor of the hand's target, 8 to 12 Hz, rms along each axis
    double noise_m = 0.0;        // white noise of the sensor before the encoder's step, rms along each axis
    double stall_every_s = 0.0;  // 0: no stalls
    double stall_s = 0.0;        // during a stall nothing is read or written, and the motor holds its force
    std::uint32_t seed = 1;
};

// What the person wants at a moment.
struct HandIntent {
    Vec3 target_m{0.0};
    Vec3 push_n{0.0};
};

struct LoopTick {
    double time_s = 0.0;
    Vec3 hand_m{0.0};  // true position
    Vec3 velocity_m_per_s{0.0};
    Vec3 measured_m{0.0};   // the renderer's last input
    Vec3 commanded_n{0.0};  // the renderer's last answer
    double work_j = 0.0;    // work of the motor on the hand since the start
    bool stalled = false;   // the renderer was not called in this tick
};

class ClosedLoop {
public:
    using Intent = std::function<HandIntent(double time_s)>;
    // since_s: time since the last call of the renderer.
    using Render = std::function<Vec3(const Vec3& measured_m, double time_s, double since_s)>;

    ClosedLoop(const LoopSettings& settings, const Vec3& start_m);

    // Runs one period: read, render, write, then the hand moves. Takes about 1 us plus the renderer's time.
    LoopTick tick(const Intent& intent, const Render& render);

private:
    static constexpr int kSteps = 20;  // steps of the hand within one period
    static constexpr int kTremors = 3;

    double unit();
    Vec3 noise_m();
    Vec3 tremor_m(double time_s) const;

    LoopSettings settings_;
    std::mt19937 random_;
    device::HandBody body_;
    device::HeldForces held_;
    double phases_[3 * kTremors] = {};
    std::uint64_t periods_ = 0;
    double since_s_ = 0.0;
    LoopTick last_;
};

// Statistics of a signal sampled every period_s:
// - rms_above: root mean square of the part above cut_hz (fourth-order Butterworth; the first fifth is left to
//   settle)
// - largest difference between neighbouring samples
// - largest minus smallest value
// - number of sign changes (zeros are skipped)
double rms_above(std::span<const double> signal, double cut_hz, double period_s);
double largest_step(std::span<const double> signal);
double peak_to_peak(std::span<const double> signal);
int sign_changes(std::span<const double> signal);

// The stiffest wall that a loop keeps stable, in N/m. `wall` makes the renderer for each stiffness; the wall fills x <
// 0, and the hand of `settings` presses it with press_n for seconds_s. Stable means that the hand stays within 0.3 mm
// over the last third. The stiffness rises from 50 N/m by `factor` up to the first unstable one, at most to 60 kN/m.
double stable_stiffness_n_per_m(LoopSettings settings,
                                const std::function<ClosedLoop::Render(double stiffness_n_per_m)>& wall, double press_n,
                                double seconds_s = 3.0, double factor = 1.08);

}  // namespace handrail::loop
