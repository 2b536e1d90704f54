// Makes contestants of Handrail's own renderer, with the program's settings and with other values of its knobs.
#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "tests/bench/compare/contestant.h"
#include "tests/support/names.h"

namespace handrail::bench {
namespace {

TouchTuning plain_tuning(const BenchWorld& world) {
    TouchTuning tuning;
    tuning.radius_m = world.radius_m;
    tuning.override_stiffness_n_per_m = kStiffness_n_per_m;
    return tuning;
}

class Touch {
public:
    Touch(const BenchWorld& world, double slide_cap_m) : scene_(*world.scene), tuning_(plain_tuning(world)) {
        tuning_.slide_cap_hand_m = slide_cap_m;
    }
    TickOutcome tick(const Vec3& goal_m) {
        const TouchResult r = touch_tick(state_, scene_, tuning_, goal_m, 1e-3);
        return {r.proxy_m, r.contacts.iterations};
    }

private:
    const HapticScene& scene_;
    TouchTuning tuning_;
    TouchState state_;
};

// The hard cases have practically no slide cap, so that the curves show the effect of the knobs and not of the cap.
// Large worlds use the program's own cap; otherwise candidates would have to be gathered along a path that no hand
// takes.
constexpr double kNoCap_m = 0.1;
double path_cap_m(const BenchWorld& world) { return world.hard_case ? kNoCap_m : TouchTuning{}.slide_cap_hand_m; }

class Solver {
public:
    Solver(const BenchWorld& world, double most_rounds, double margin_m, double cap_m)
        : scene_(*world.scene), path_cap_m_(cap_m) {
        request_.radius_m = world.radius_m;
        request_.margin_m = margin_m;
        request_.growth_m = 2e-5;
        request_.most_rounds = static_cast<int>(most_rounds);
    }
    TickOutcome tick(const Vec3& goal_m) {
        const Vec3 step = has_last_ ? goal_m - last_goal_m_ : Vec3(0.0);
        last_goal_m_ = goal_m;
        has_last_ = true;
        request_.goal_m = goal_m;
        request_.path_cap_m = std::max(path_cap_m_, 2.0 * glm::length(step));
        const int rounds = solver_.move(scene_, request_).iterations;
        return {solver_.offset_m() == Vec3(0.0) ? goal_m : solver_.world_m(), rounds};
    }

private:
    const HapticScene& scene_;
    ProxySolver solver_;
    ProxySolver::Request request_;
    double path_cap_m_;
    Vec3 last_goal_m_{0.0};
    bool has_last_ = false;
};

struct Rounds : Solver {
    Rounds(const BenchWorld& world, double most) : Solver(world, most, 0.02, path_cap_m(world)) {}
};
struct Margin : Solver {
    Margin(const BenchWorld& world, double margin_m)
        : Solver(world, ProxySolver::kMaxIterations, margin_m, TouchTuning{}.slide_cap_hand_m) {}
};

}  // namespace

Contestant handrail_touch() { return contestant<Touch>("handrail", "Handrail", "", TouchTuning{}.slide_cap_hand_m); }
Contestant handrail_uncapped() {
    return contestant<Touch>("handrail_uncapped", "Handrail without the slide cap", "", kNoCap_m);
}
Contestant handrail_rounds(int most) {
    return contestant<Rounds>(fmt::format("rounds_{}", most), fmt::format("Handrail's solver, at most {} rounds", most),
                              "rounds", most);
}
Contestant handrail_margin(double margin_m) {
    return contestant<Margin>(fmt::format("margin_{:g}_mm", margin_m * 1e3),
                              fmt::format("Handrail's solver, margin {:g} mm", margin_m * 1e3), "margin_m", margin_m);
}

std::vector<Contestant> main_contestants() {
    return {handrail_touch(), penalty_sum(), sequential_planes(), active_set(64), single_precision()};
}

std::vector<Contestant> knobbed_contestants() {
    std::vector<Contestant> all = main_contestants();
    all.push_back(handrail_uncapped());
    for (const int rounds : {1, 2, 4, 8, 20, 64}) all.push_back(handrail_rounds(rounds));
    for (const double margin_m : {0.001, 0.005, 0.05}) all.push_back(handrail_margin(margin_m));
    for (const int rounds : {2, 8, 20}) all.push_back(active_set(rounds));
    return all;
}

}  // namespace handrail::bench
