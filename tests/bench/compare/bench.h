// Runs every renderer on every scene family and compares speed with error. Also finds the stiffest wall against which a
// hand can lean with each renderer, and measures the servo thread. Only that thread runs in real time. The file of each
// renderer names its sources.
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
    std::string only;  // text that the scene's name or family must contain, in any case; empty: all scenes
    bool quick = false;
    int seeds = 2;          // random variants of every family, in addition to the original scene; a quick run has 0
    double servo_s = 60.0;  // seconds for which the servo thread is measured; a quick run has 1; 0: not measured
    // Called with the name of each scene before it runs; may be empty.
    std::function<void(const std::string&)> progress;
};

struct SceneCost {
    std::string scene, family;
    std::size_t obstacles = 0, ticks = 0;
    double build_s = 0.0, bytes_per_obstacle = 0.0;
    bool referenced = false;
    // For simplified meshes: requested and measured distance from the original; 0: not simplified.
    double simplify_bound_m = 0.0, simplify_measured_m = 0.0;
};

// The stiffest wall that a hand of 0.3 kg and 3 Ns/m holds stably while it presses with 6 N (haptic/loop). The delay is
// 1 ms, and the renderer adds no damping.
struct Stability {
    std::string wall, renderer, title;
    double stiffness_n_per_m = 0.0;
};

// Results for a place where more obstacles are near the proxy than a tick has time for (tests/support/worst_cases.h),
// with Handrail's own renderer.
struct WorstTicks {
    std::string scene;
    std::size_t ticks = 0;
    double mean_s = 0.0, p999_s = 0.0, worst_s = 0.0;
    int most_work = 0, most_looks = 0;  // greatest ProxySolver::work() and looks() of any tick
    std::size_t waits = 0;              // number of ticks that ended with unfinished work
    // Instructions, as a mean over all ticks and of the worst tick; negative: not counted.
    double instructions = -1.0, worst_instructions = -1.0;
};

// Results for a ball on a rubber string that a hand pushes to and fro. The hand follows a prescribed path exactly
// (bodies_part.cpp).
struct BodiesMeasured {
    std::string way;
    double mass_kg = 0.0;
    double error_n = 0.0;  // root mean square error of the force on the hand, compared with the formula
    double felt_n = 0.0;   // amplitude of the force that the formula gives
    // Energy given to the hand in one loop: measured, and computed by the formula.
    double given_j = 0.0, right_given_j = 0.0;
    double tick_s = 0.0, step_s = 0.0;  // mean times of a tick of the hand and of a step of the engine
};

struct BenchReport {
    bool quick = false;
    std::string machine, day;  // `day` is a date such as "2026-11-22", universal time
    std::vector<Measured> results;
    std::vector<SceneCost> scenes;
    std::vector<Stability> stability;
    std::vector<WorstTicks> worst;
    std::vector<BodiesMeasured> bodies;
    std::optional<ServoMeasured> servo;
    std::vector<std::string> left_out;  // sentences about requested parts that could not run
    double took_s = 0.0;
};

BenchReport run_bench(const BenchOptions& options);

// scene_names() returns the names of the scenes that `options` select. count_once() runs the ticks of one renderer on
// one of these scenes, for counting instructions.
std::vector<std::string> scene_names(const BenchOptions& options);
Result<double> count_once(const BenchOptions& options, const std::string& renderer, std::size_t& ticks);

// The parts of run_bench().
Stability stable_stiffness(const Contestant& contestant, const std::string& wall, double factor);
std::vector<BodiesMeasured> run_bodies();
Result<ServoMeasured> run_servo_thread(double seconds);
WorstTicks run_worst_case(int number, int ticks, int passes);

}  // namespace handrail::bench
