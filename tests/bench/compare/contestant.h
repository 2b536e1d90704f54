// A renderer as the comparison sees it: three plain functions and a knob. Each renderer manages its own state between
// ticks.
#pragma once

#include <string>

#include "tests/bench/compare/bench_world.h"
#include "tests/support/names.h"

namespace handrail::bench {

// All renderers use 1 kN/m: the force is kStiffness times (tool - goal).
inline constexpr double kStiffness_n_per_m = 1000.0;

struct TickOutcome {
    Vec3 tool_m{0.0};  // world coordinates; equal to the goal in free space
    int rounds = 0;    // number of repetitions of the renderer's inner loop in this tick
};

struct Contestant {
    std::string key;    // key in JSON, such as "handrail"
    std::string title;  // "Handrail, the whole touch tick"
    std::string knob;   // "rounds", "margin_m"; empty: none
    double knob_value = 0.0;
    bool has_ball = true;  // false: a penalty method has no proxy that could stay outside
    void* (*make)(const BenchWorld&, double knob_value) = nullptr;
    TickOutcome (*tick)(void* state, const Vec3& goal_m) = nullptr;
    void (*drop)(void* state) = nullptr;
};

// Makes a contestant from a class with State(const BenchWorld&, double) and tick(goal).
template <class State>
Contestant contestant(std::string key, std::string title, std::string knob = {}, double knob_value = 0.0,
                      bool has_ball = true) {
    return {std::move(key),
            std::move(title),
            std::move(knob),
            knob_value,
            has_ball,
            [](const BenchWorld& world, double value) -> void* { return new State(world, value); },
            [](void* state, const Vec3& goal_m) { return static_cast<State*>(state)->tick(goal_m); },
            [](void* state) { delete static_cast<State*>(state); }};
}

Contestant handrail_touch();     // touch_tick as the program calls it
Contestant handrail_uncapped();  // practically without slide cap, like the other renderers: hard cases only
Contestant handrail_rounds(int most_rounds);  // only the solver
Contestant handrail_margin(double margin_m);  // only the solver
Contestant penalty_sum();
Contestant sequential_planes();
Contestant active_set(int most_rounds);
Contestant single_precision();

// The renderers that run on every scene, and the same ones with all values of their knobs.
std::vector<Contestant> main_contestants();
std::vector<Contestant> knobbed_contestants();

}  // namespace handrail::bench
