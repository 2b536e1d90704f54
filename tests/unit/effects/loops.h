// Makes random smooth closed paths of a hand, and measures an effect law along them.
#pragma once

#include <memory>
#include <random>
#include <vector>

#include "haptic/render/touch.h"
#include "tests/support/names.h"

namespace handrail::test {

constexpr double kTick_s = 1e-3;
constexpr int kLoopTicks = 4000;

// Returns a closed path of 4 s with three harmonics for each axis. It reaches at most `reach_hand_m` from the origin
// along each axis, in hand metres.
inline std::vector<Vec3> random_loop(unsigned seed, double reach_hand_m) {
    std::mt19937 random(seed);
    const auto unit = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    double size[3][3], phase[3][3];
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 3; ++k) {
            size[axis][k] = reach_hand_m / 3.0 * (0.3 + 0.7 * unit());
            phase[axis][k] = 2.0 * kPi * unit();
        }
    std::vector<Vec3> loop(kLoopTicks);
    for (int i = 0; i < kLoopTicks; ++i)
        for (int axis = 0; axis < 3; ++axis)
            for (int k = 0; k < 3; ++k)
                loop[static_cast<std::size_t>(i)][axis] +=
                    size[axis][k] * std::sin(2.0 * kPi * (k + 1) * i / kLoopTicks + phase[axis][k]);
    return loop;
}

// Returns the path as a device with encoder steps of `quantum_m` measures it.
inline std::vector<Vec3> quantised(std::vector<Vec3> path, double quantum_m = 6e-5) {
    for (Vec3& p : path)
        for (int axis = 0; axis < 3; ++axis) p[axis] = quantum_m * std::round(p[axis] / quantum_m);
    return path;
}

struct LoopOutcome {
    double given_j = 0.0;         // energy that the law gives to the hand in the second round
    double largest_n = 0.0;       // largest force
    double largest_step_n = 0.0;  // largest change of the force in one tick
    // Largest change of the force divided by the hand's movement. Ignores ticks in which the hand moves less than 0.02
    // mm.
    double steepest_n_per_m = 0.0;
    double felt = 0.0;  // share of the ticks with a force
};

// Moves the hand along the loop twice around `centre_m`. The loop is in hand metres; the function multiplies it by the
// scale. Measures only the second round, in which the effects of the start have faded.
inline LoopOutcome go_round(const HapticScene& scene, TouchTuning tuning, const std::vector<Vec3>& loop,
                            const Vec3& centre_m = Vec3(0.0)) {
    TouchState state;
    LoopOutcome outcome;
    Vec3 last_force(0.0), last(0.0);
    const double scale = tuning.world_m_per_hand_m;
    for (int i = 0; i <= 2 * kLoopTicks; ++i) {
        const Vec3 hand = loop[static_cast<std::size_t>(i % kLoopTicks)];
        const TouchResult r = touch_tick(state, scene, tuning, centre_m + hand * scale, kTick_s);
        EXPECT_TRUE(is_finite(r.force_n));
        if (i > kLoopTicks) {
            const Vec3 step = hand - last, change = r.force_n - last_force;
            outcome.given_j += glm::dot((r.force_n + last_force) * 0.5, step);
            outcome.largest_n = std::max(outcome.largest_n, glm::length(r.force_n));
            outcome.largest_step_n = std::max(outcome.largest_step_n, glm::length(change));
            if (glm::length(step) > 2e-5)
                outcome.steepest_n_per_m = std::max(outcome.steepest_n_per_m, glm::length(change) / glm::length(step));
            outcome.felt += (r.force_n != Vec3(0.0) ? 1.0 : 0.0) / kLoopTicks;
        }
        last_force = r.force_n;
        last = hand;
    }
    return outcome;
}

}  // namespace handrail::test
