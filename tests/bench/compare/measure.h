// Time and error of one renderer on one scene. Times are this thread's own; the least of several passes for each tick,
// so that what other programs do to the machine is left out and what a tick needs is not. Everything else is the same
// on every machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/compare/contestant.h"

namespace handrail::bench {

// The processor time of this thread.
double thread_s();

struct Measured {
    std::string scene, family, renderer, title, knob;
    std::uint32_t seed = 0;
    double knob_value = 0.0;
    bool has_ball = true;  // that could be asked whether it lies in something
    std::size_t ticks = 0;
    double mean_s = 0.0, p50_s = 0.0, p999_s = 0.0, worst_s = 0.0;
    double mean_rounds = 0.0;
    int most_rounds = 0;
    // Against the reference. At 1 kN/m a millimetre is a newton.
    bool referenced = false;
    double error_rms_m = 0.0, error_p99_m = 0.0, error_max_m = 0.0;
    double off_share = 0.0;  // ticks that are off by more than 10 um
    // Times it began to let go of, or to push through, what the reference holds with half a newton.
    int wrong_holds = 0;
    double penetration_m = 0.0;   // deepest of the ball in anything
    double largest_jump_n = 0.0;  // of the force between two ticks
    // Change of the force over stiffness times the hand's step, ticks with steps over a micrometre.
    double largest_gain = 0.0;
    std::optional<double> given_j;                                           // on closed paths: work on the hand
    std::optional<double> direction_error_rms_rad, direction_error_max_rad;  // spheres: against the exact one
    std::optional<double> instructions;
};

// What a scene is judged by, walked once for all renderers.
struct Truth {
    std::vector<Vec3> reference_m;  // by tick; empty: none
};
// Nothing where the walk would take more comparisons than most_work.
Truth truth_of(const BenchWorld& world, double most_work);

// judging_work: comparisons that looking for penetration may take; ticks are left out evenly beyond it.
Measured measure(const BenchWorld& world, const Truth& truth, const Contestant& contestant, int passes,
                 double judging_work);

// The ticks alone, for counting instructions; returns a number that depends on all of them.
double counted_ticks(const BenchWorld& world, const Contestant& contestant);

}  // namespace handrail::bench
