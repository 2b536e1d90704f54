// Defines a renderer in the comparison: three plain functions and a knob, which is a parameter that can be varied. Each
// renderer manages its own state between ticks.
#pragma once

#include <string>

#include "tests/bench/compare/bench_world.h"
#include "tests/support/names.h"

namespace handrail::bench {

// Stiffness of all renderers, 1 kN/m. The force is kStiffness_n_per_m times (tool - goal).
inline constexpr double kStiffness_n_per_m = 1000.0;

struct TickOutcome {
    Vec3 tool_m{0.0};  // position of the proxy in the world; equal to the goal in free space
    int rounds = 0;    // number of repetitions of the renderer's inner loop in this tick
};

struct Contestant {
    std::string key;    // key in JSON, for example "handrail"
    std::string title;  // for example "Handrail, the whole touch tick"
    std::string knob;   // parameter that is varied, for example "rounds" or "margin_m"; empty: none
    double knob_value = 0.0;
    bool has_proxy = true;  // false for a penalty method, which has no proxy that could stay outside
    void* (*make)(const BenchWorld&, double knob_value) = nullptr;
    TickOutcome (*tick)(void* state, const Vec3& goal_m) = nullptr;
    void (*drop)(void* state) = nullptr;
};

// Makes a contestant from a class with State(const BenchWorld&, double) and tick(goal).
template <class State>
Contestant contestant(std::string key, std::string title, std::string knob = {}, double knob_value = 0.0,
                      bool has_proxy = true) {
    return {std::move(key),
            std::move(title),
            std::move(knob),
            knob_value,
            has_proxy,
            [](const BenchWorld& world, double value) -> void* { return new State(world, value); },
            [](void* state, const Vec3& goal_m) { return static_cast<State*>(state)->tick(goal_m); },
            [](void* state) { delete static_cast<State*>(state); }};
}

Contestant handrail_touch();     // touch_tick() with the program's settings
Contestant handrail_uncapped();  // practically without a slide cap, like the other renderers; only for hard cases
Contestant handrail_rounds(int most_rounds);  // only the solver, with at most `most_rounds` rounds
Contestant handrail_margin(double margin_m);  // only the solver, with the margin `margin_m`
Contestant penalty_sum();
Contestant sequential_planes();
Contestant active_set(int most_rounds);
Contestant single_precision();

// main_contestants() returns the renderers that run on every scene. knobbed_contestants() also returns one renderer for
// each value of their knobs.
std::vector<Contestant> main_contestants();
std::vector<Contestant> knobbed_contestants();

}  // namespace handrail::bench
