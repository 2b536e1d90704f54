// A hand, a device and a renderer in one loop, in virtual time: what stability, friction chatter and stalls are studied
// with, by tests and by the benchmark. The hand and the way of the force to the motor are those of the simulated
// device; added are tremor, noise of the sensor and stalls of the loop. The renderer is any function from a measured
// place to a force. Deterministic: same settings and seed, same numbers. Off the real-time path; one thread. Model: one
// mass, held force, fixed delay, encoder step; no flexibility, no amplifier lag, three axes uncoupled. Sources: Colgate
// & Schenkel, Passivity of a class of sampled-data systems, 1997; Diolaiti et al., Stability of haptic rendering, 2006.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <span>

#include "haptic/device/hand_dynamics.h"

namespace handrail {

struct LoopSettings {
    HandMechanics hand;  // with the device in it
    double period_s = 1e-3;
    double delay_s = 1e-3;  // from the place read to the force on the hand, beyond the hold
    double encoder_quantum_m = 0.06e-3;
    double tremor_m = 0.0;       // rms along each axis of how the hand's target trembles, 8 to 12 Hz
    double noise_m = 0.0;        // rms along each axis of the sensor, white, before the encoder's step
    double stall_every_s = 0.0;  // 0: none
    double stall_s = 0.0;        // during a stall nothing is read or written and the motor holds
    std::uint32_t seed = 1;
};

// What the person does at a moment.
struct HandIntent {
    Vec3 target_m{0.0};
    Vec3 push_n{0.0};
};

struct LoopTick {
    double time_s = 0.0;
    Vec3 hand_m{0.0};  // truly
    Vec3 velocity_m_per_s{0.0};
    Vec3 measured_m{0.0};   // what the renderer was given last
    Vec3 commanded_n{0.0};  // what it answered last
    double work_j = 0.0;    // of the motor on the hand since the start
    bool stalled = false;   // nobody asked it on this tick
};

class ClosedLoop {
public:
    using Intent = std::function<HandIntent(double time_s)>;
    // since_s: time since the renderer was last asked.
    using Render = std::function<Vec3(const Vec3& measured_m, double time_s, double since_s)>;

    ClosedLoop(const LoopSettings& settings, const Vec3& start_m);

    // One period: read, render, write, then the hand moves on. About 1 us and what the renderer takes.
    LoopTick tick(const Intent& intent, const Render& render);

private:
    static constexpr int kSteps = 20;  // of the hand within one period
    static constexpr int kTremors = 3;

    double unit();
    Vec3 noise_m();
    Vec3 tremor_m(double time_s) const;

    LoopSettings settings_;
    std::mt19937 random_;
    HandBody body_;
    HeldForces held_;
    double phases_[3 * kTremors] = {};
    std::uint64_t periods_ = 0;
    double since_s_ = 0.0;
    LoopTick last_;
};

// Of a signal sampled every period_s: root mean square of what lies above cut_hz (fourth-order Butterworth; the first
// fifth is let settle), the largest difference between neighbours, largest minus smallest, and how often the sign turns
// round (zeros are passed over).
double rms_above(std::span<const double> signal, double cut_hz, double period_s);
double largest_step(std::span<const double> signal);
double peak_to_peak(std::span<const double> signal);
int sign_changes(std::span<const double> signal);

// The stiffest wall that a loop holds, in N/m: given by `wall` for each stiffness and filling x < 0, pressed with
// press_n by the hand of `settings` for seconds_s. Stable means that the hand stays within 0.3 mm over the last third.
// Rises from 50 N/m by `factor` until the first that is not stable, at most to 60 kN/m.
double stable_stiffness_n_per_m(LoopSettings settings,
                                const std::function<ClosedLoop::Render(double stiffness_n_per_m)>& wall, double press_n,
                                double seconds_s = 3.0, double factor = 1.08);

}  // namespace handrail
