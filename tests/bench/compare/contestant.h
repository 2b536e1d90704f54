// A renderer as the comparison sees it: three plain functions and a knob. What a renderer keeps from tick to tick is
// its own business.
#pragma once

#include <string>

#include "tests/bench/compare/bench_world.h"

namespace handrail::bench {

// All renderers speak with 1 kN/m: the force is kStiffness times (tool - goal).
inline constexpr double kStiffness_n_per_m = 1000.0;

struct TickOutcome {
    Vec3 tool_m{0.0};  // world; equal to the goal in free space
    int rounds = 0;    // of whatever the renderer repeats within a tick
};

struct Contestant {
    std::string key;    // "handrail", as JSON names it
    std::string title;  // "Handrail, the whole touch tick"
    std::string knob;   // "rounds", "margin_m"; empty: none
    double knob_value = 0.0;
    bool has_ball = true;  // false: a penalty has no proxy that could stay outside
    void* (*make)(const BenchWorld&, double knob_value) = nullptr;
    TickOutcome (*tick)(void* state, const Vec3& goal_m) = nullptr;
    void (*drop)(void* state) = nullptr;
};

// From a class with State(const BenchWorld&, double) and tick(goal).
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

Contestant handrail_touch();                  // touch_tick as the program calls it
Contestant handrail_uncapped();               // with no slide cap to speak of, like the rivals: hard cases only
Contestant handrail_rounds(int most_rounds);  // the solver alone
Contestant handrail_margin(double margin_m);  // the solver alone
Contestant penalty_sum();
Contestant sequential_planes();
Contestant active_set(int most_rounds);
Contestant single_precision();

// Those that every scene is run with, and these with all their knobs.
std::vector<Contestant> main_contestants();
std::vector<Contestant> knobbed_contestants();

}  // namespace handrail::bench
