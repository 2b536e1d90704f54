// Runs touch_tick() along a path and passes the result of every tick to a check. The check may take the solver as a
// SolverProbe.
#pragma once

#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/solver_probe.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {

inline TouchTuning plain_tuning(double radius_m) {
    TouchTuning tuning;
    tuning.radius_m = radius_m;
    tuning.rated_stiffness_n_per_m = 1000.0;
    tuning.default_stiffness_fraction = 1.0;  // 1 kN/m, so that a millimetre gives a newton
    return tuning;
}

// Returns a tuning without a slide-speed cap, so that the tests check only the solver.
inline TouchTuning uncapped_tuning(double radius_m) {
    TouchTuning tuning = plain_tuning(radius_m);
    tuning.slide_cap_hand_m = 1.0;
    return tuning;
}

template <class Check>
void replay(const HapticScene& scene, const std::vector<Vec3>& goals_m, const Motion& motion, const TouchTuning& tuning,
            Check&& check) {
    TouchState state;
    for (std::size_t i = 0; i < goals_m.size(); ++i) {
        const Vec3 goal = motion(goals_m[i]);
        const TouchResult result = touch_tick(state, scene, tuning, goal, 1e-3);
        check(i, goal, result, state.solver());
    }
}

// The proxy's position in each tick, in the world's own frame, and whether the solver had settled in that tick.
struct Trace {
    std::vector<Vec3> proxies_m;
    std::vector<bool> settled;
};

inline Trace trace(const TouchWorld& world, const std::vector<Vec3>& goals_m, const Motion& motion,
                   const TouchTuning& tuning) {
    Trace out;
    replay(*world.scene(motion), goals_m, motion, tuning,
           [&](std::size_t, const Vec3&, const TouchResult& r, const ProxySolver&) {
               out.proxies_m.push_back(motion.back(r.proxy_m));
               out.settled.push_back(r.contacts.converged);
           });
    return out;
}

// Returns the greatest difference over the ticks in which both traces had settled. If more than the share
// `most_unsettled` of the ticks had not settled, the result is infinite.
inline double largest_difference(const Trace& a, const Trace& b, double most_unsettled = 0.01) {
    double worst = 0.0;
    std::size_t unsettled = 0;
    for (std::size_t i = 0; i < a.proxies_m.size(); ++i) {
        if (!a.settled[i] || !b.settled[i]) ++unsettled;
        else worst = std::max(worst, glm::length(a.proxies_m[i] - b.proxies_m[i]));
    }
    return static_cast<double>(unsettled) <= most_unsettled * static_cast<double>(a.proxies_m.size())
               ? worst
               : std::numeric_limits<double>::infinity();
}

}  // namespace handrail::test
