// Every renderer on every scene family, speed against error; the stiffest wall a hand can lean on
// with each; and the servo thread. Off the real-time path, one thread (and the servo's own). Sources of the renderers
// stand in their files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/bench/compare/measure.h"
#include "worlds/base/result.h"

namespace handrail::bench {

struct BenchOptions {
    std::vector<std::filesystem::path> maps;
    std::string only;  // scenes whose name or family holds this, without regard to case; empty: all
    bool quick = false;
    int seeds = 2;          // random lies of every family besides the scene as it stands; quick: 0
    double servo_s = 60.0;  // quick: 1; 0: leave the servo thread out
    std::function<void(const std::string&)> progress;  // what it is at from now on: a scene by its name; may be empty
};

struct SceneCost {
    std::string scene, family;
    std::size_t obstacles = 0, ticks = 0;
    double build_s = 0.0, bytes_per_obstacle = 0.0;
    bool referenced = false;
    double simplify_bound_m = 0.0, simplify_measured_m = 0.0;  // 0: not simplified
};

// The stiffest wall that a hand of 0.3 kg and 3 Ns/m holds when it presses with 6 N (haptic/loop), delay 1 ms, no
// damping by the renderer.
struct Stability {
    std::string wall, renderer, title;
    double stiffness_n_per_m = 0.0;
};

struct ServoThread {
    double seconds = 0.0;
    std::uint64_t ticks = 0, overruns = 0;
    double period_p50_s = 0.0, period_p99_s = 0.0, period_worst_s = 0.0, tick_p99_s = 0.0, tick_worst_s = 0.0;
    std::string scheduling;
};

// A place where more is near the ball than a tick has time for (tests/support/worst_cases), with our own renderer.
struct WorstTicks {
    std::string scene;
    std::size_t ticks = 0;
    double mean_s = 0.0, p999_s = 0.0, worst_s = 0.0;
    int most_work = 0, most_looks = 0;                      // ProxySolver::work() and looks() of one tick
    std::size_t waits = 0;                                  // ticks that ended with something left to do
    double instructions = -1.0, worst_instructions = -1.0;  // mean, and of the worst tick; < 0: not counted
};

// A ball on a rubber string, pushed to and fro by a hand that is led exactly (bodies_part.cpp).
struct BodiesMeasured {
    std::string way;
    double mass_kg = 0.0;
    double error_n = 0.0;                       // rms, of the hand, against the formula
    double felt_n = 0.0;                        // half the swing of the force by the formula
    double given_j = 0.0, right_given_j = 0.0;  // to the hand in a loop, and by the formula
    double tick_s = 0.0, step_s = 0.0;          // mean, of the hand's side and of the engine
};

struct BenchReport {
    bool quick = false;
    std::string machine, day;  // "2026-11-22", universal time
    std::vector<Measured> results;
    std::vector<SceneCost> scenes;
    std::vector<Stability> stability;
    std::vector<WorstTicks> worst;
    std::vector<BodiesMeasured> bodies;
    std::vector<ServoThread> servo;     // none or one
    std::vector<std::string> left_out;  // sentences: what was asked for and could not be run
    double took_s = 0.0;
};

BenchReport run_bench(const BenchOptions& options);

// Which scenes these options choose, by name; and the ticks of one renderer on one of them alone, for counting
// instructions.
std::vector<std::string> scene_names(const BenchOptions& options);
Result<double> count_once(const BenchOptions& options, const std::string& renderer, std::size_t& ticks);

// Parts of run_bench.
Stability stable_stiffness(const Contestant& contestant, const std::string& wall, double factor);
std::vector<BodiesMeasured> run_bodies();
ServoThread run_servo_thread(double seconds);
WorstTicks run_worst_case(int number, int ticks, int passes);

}  // namespace handrail::bench
