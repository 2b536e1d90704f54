// Simulates a hand, a device and a renderer in one loop, in virtual time. Tests and the benchmark use it to study
// stability, friction chatter and stalls. The hand and the delayed force are those of the simulated device. The loop
// adds tremor, sensor noise and stalls. The renderer is any function from a measured position to a force.
// Deterministic: the same settings and seed give the same numbers. Never used on the servo thread; one thread. The
// model has one mass, held force, a fixed delay, encoder steps and three uncoupled axes, but no flexibility and no
// amplifier lag. Sources: Colgate & Schenkel, Passivity of a class of sampled-data systems, 1997; Diolaiti et al.,
// Stability of haptic rendering, 2006.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <span>

#include "haptic/device/hand_dynamics.h"

namespace handrail::loop {

struct LoopSettings {
    device::HandMechanics hand;  // mechanics of the hand together with the device
    double period_s = 1e-3;
    // Time from reading the position until the force acts on the hand, without the half period for which the force is
    // held on average.
    double delay_s = 1e-3;
    double encoder_quantum_m = 0.06e-3;
    double tremor_m = 0.0;  // tremor of the hand's target, 8 to 12 Hz, root mean square along each axis
    double noise_m = 0.0;   // white noise of the sensor, before the encoder rounds, root mean square along each axis
    double stall_every_s = 0.0;  // time between two stalls; 0: no stalls
    double stall_s = 0.0;  // Length of a stall. During it nothing is read or written, and the motor holds its force.
    std::uint32_t seed = 1;
};

// Target and force of the person's hand at a moment.
struct HandIntent {
    Vec3 target_m{0.0};
    Vec3 push_n{0.0};
};

struct LoopTick {
    double time_s = 0.0;
    Vec3 hand_m{0.0};  // true position of the hand
    Vec3 velocity_m_per_s{0.0};
    Vec3 measured_m{0.0};   // position that the renderer received last
    Vec3 commanded_n{0.0};  // force that the renderer returned last
    double work_j = 0.0;    // work that the motor has done on the hand since the start
    bool stalled = false;   // true if the loop stalled, so that it did not call the renderer in this tick
};

class ClosedLoop {
public:
    using Intent = std::function<HandIntent(double time_s)>;
    // Computes a force from a measured position. `since_s` is the time since the last call of this function.
    using Render = std::function<Vec3(const Vec3& measured_m, double time_s, double since_s)>;

    ClosedLoop(const LoopSettings& settings, const Vec3& start_m);

    // Runs one period: reads the position, calls the renderer and writes its force; then the hand moves. Takes about 1
    // us plus the renderer's time.
    LoopTick tick(const Intent& intent, const Render& render);

private:
    static constexpr int kSteps = 20;  // number of steps in which the hand is simulated within one period
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

// Statistics of a signal with one sample every period_s:
// - rms_above: root mean square of the part above cut_hz (fourth-order Butterworth). The first fifth of the signal is
//   ignored, because the filter settles there.
// - largest difference between neighbouring samples
// - largest minus smallest value
// - number of sign changes, in which zeros are skipped
double rms_above(std::span<const double> signal, double cut_hz, double period_s);
double largest_step(std::span<const double> signal);
double peak_to_peak(std::span<const double> signal);
int sign_changes(std::span<const double> signal);

// Returns the stiffness in N/m of the stiffest wall that is stable in the loop. `wall` makes the renderer for each
// stiffness. The wall fills x < 0, and the hand of `settings` presses it with `press_n` for `seconds_s`. A wall is
// stable if the hand stays within 0.3 mm over the last third of that time. The stiffness starts at 50 N/m and rises by
// `factor` until the wall is unstable, at most to 60 kN/m.
double stable_stiffness_n_per_m(LoopSettings settings,
                                const std::function<ClosedLoop::Render(double stiffness_n_per_m)>& wall, double press_n,
                                double seconds_s = 3.0, double factor = 1.08);

}  // namespace handrail::loop
