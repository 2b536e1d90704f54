// Runs every renderer on every scene family and compares speed with error. Also finds the stiffest wall that a hand can
// lean on with each renderer, and measures the servo thread. Nothing here runs in real time except the servo's own
// thread. The file of each renderer names its sources.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "haptic/servo/servo_measure.h"
#include "tests/bench/compare/measure.h"
#include "tests/support/names.h"
#include "worlds/base/result.h"

namespace handrail::bench {

struct BenchOptions {
    std::vector<std::filesystem::path> maps;
    std::string only;  // substring of the scene's name or family, case-insensitive; empty: all
    bool quick = false;
    int seeds = 2;          // random variants of every family, in addition to the original scene; quick: 0
    double servo_s = 60.0;  // quick: 1; 0: skip the servo thread
    std::function<void(const std::string&)> progress;  // receives the name of the scene that begins; may be empty
};

struct SceneCost {
    std::string scene, family;
    std::size_t obstacles = 0, ticks = 0;
    double build_s = 0.0, bytes_per_obstacle = 0.0;
    bool referenced = false;
    double simplify_bound_m = 0.0, simplify_measured_m = 0.0;  // 0: not simplified
};

// The stiffest wall that a hand of 0.3 kg and 3 Ns/m holds stably while it presses with 6 N (haptic/loop). The delay is
// 1 ms, and the renderer adds no damping.
struct Stability {
    std::string wall, renderer, title;
    double stiffness_n_per_m = 0.0;
};

// A place where more is near the ball than a tick has time for (tests/support/worst_cases), with our own renderer.
struct WorstTicks {
    std::string scene;
    std::size_t ticks = 0;
    double mean_s = 0.0, p999_s = 0.0, worst_s = 0.0;
    int most_work = 0, most_looks = 0;                      // maximum of ProxySolver::work() and looks() in one tick
    std::size_t waits = 0;                                  // ticks that ended with work left to do
    double instructions = -1.0, worst_instructions = -1.0;  // mean, and of the worst tick; negative: not counted
};

// A ball on a rubber string that a hand pushes to and fro. The hand follows a prescribed path exactly
// (bodies_part.cpp).
struct BodiesMeasured {
    std::string way;
    double mass_kg = 0.0;
    double error_n = 0.0;                       // root mean square error of the force on the hand against the formula
    double felt_n = 0.0;                        // amplitude of the force by the formula
    double given_j = 0.0, right_given_j = 0.0;  // energy given to the hand in one loop: measured, and by the formula
    double tick_s = 0.0, step_s = 0.0;          // mean times of the hand's tick and of the engine's step
};

struct BenchReport {
    bool quick = false;
    std::string machine, day;  // "2026-11-22", universal time
    std::vector<Measured> results;
    std::vector<SceneCost> scenes;
    std::vector<Stability> stability;
    std::vector<WorstTicks> worst;
    std::vector<BodiesMeasured> bodies;
    std::optional<ServoMeasured> servo;
    std::vector<std::string> left_out;  // sentences: what was requested and could not be run
    double took_s = 0.0;
};

BenchReport run_bench(const BenchOptions& options);

// Returns the names of the scenes that these options select. count_once() runs the ticks of one renderer on one of
// them, for counting instructions.
std::vector<std::string> scene_names(const BenchOptions& options);
Result<double> count_once(const BenchOptions& options, const std::string& renderer, std::size_t& ticks);

// Parts of run_bench.
Stability stable_stiffness(const Contestant& contestant, const std::string& wall, double factor);
std::vector<BodiesMeasured> run_bodies();
Result<ServoMeasured> run_servo_thread(double seconds);
WorstTicks run_worst_case(int number, int ticks, int passes);

}  // namespace handrail::bench
