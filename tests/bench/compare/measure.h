// Measures time and error of one renderer on one scene. Times are processor times of the calling thread. For each tick
// the shortest time of several passes is used, which excludes the load of other programs. All other results are the
// same on every machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/compare/contestant.h"
#include "tests/support/names.h"

namespace handrail::bench {

// Returns the processor time of this thread in seconds.
double thread_s();

struct Measured {
    std::string scene, family, renderer, title, knob;
    std::uint32_t seed = 0;
    double knob_value = 0.0;
    bool has_proxy = true;  // the renderer has a proxy, which can be tested for penetration
    std::size_t ticks = 0;
    double mean_s = 0.0, p50_s = 0.0, p999_s = 0.0, worst_s = 0.0;
    double mean_rounds = 0.0;
    int most_rounds = 0;
    // True if the scene has a reference. The errors are distances of the proxy from the reference; at 1 kN/m a
    // millimetre is a newton.
    bool referenced = false;
    double error_rms_m = 0.0, error_p99_m = 0.0, error_max_m = 0.0;
    double off_share = 0.0;  // share of the ticks with an error of more than 10 um
    // How often the renderer began to release a surface on which the reference exerts half a newton, or to push through
    // such a surface.
    int wrong_holds = 0;
    double penetration_m = 0.0;   // deepest penetration of the proxy into any obstacle
    double largest_jump_n = 0.0;  // greatest change of the force between two ticks
    // Greatest change of the force divided by stiffness times the hand's step, over ticks with steps of more than a
    // micrometre.
    double largest_gain = 0.0;
    std::optional<double> given_j;  // work on the hand; only on closed paths
    // Only for spheres: error of the force's direction against the exact direction.
    std::optional<double> direction_error_rms_rad, direction_error_max_rad;
    std::optional<double> instructions;
};

// The reference for a scene, computed once for all renderers.
struct Truth {
    std::vector<Vec3> reference_m;  // position of the proxy in each tick; empty: no reference
};
// Computes the reference. The result is empty if that would take more than `most_work` comparisons.
Truth truth_of(const BenchWorld& world, double most_work);

// Measures one renderer. `judging_work` limits the comparisons for finding penetrations. If a renderer needs more
// comparisons, evenly distributed ticks are skipped.
Measured measure(const BenchWorld& world, const Truth& truth, const Contestant& contestant, int passes,
                 double judging_work);

// Runs only the ticks, for counting instructions. Returns a number that depends on all results, so that the compiler
// removes none.
double counted_ticks(const BenchWorld& world, const Contestant& contestant);

}  // namespace handrail::bench
