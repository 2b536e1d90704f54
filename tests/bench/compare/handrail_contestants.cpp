// Our own renderer, as the program uses it and with its knobs turned.
#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "tests/bench/compare/contestant.h"

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
    Touch(const BenchWorld& world, double slide_cap_m) : scene_(*world.scene), tuning_(plain_tuning(world)) { tuning_.slide_cap_hand_m = slide_cap_m; }
    TickOutcome tick(const Vec3& goal_m) {
        const TouchResult r = touch_tick(state_, scene_, tuning_, goal_m, 1e-3);
        return {r.proxy_m, r.contacts.iterations};
    }

private:
    const HapticScene& scene_;
    TouchTuning tuning_;
    TouchState state_;
};

// As good as none, so that the knobs' curves show the knobs.
constexpr double kPathCap_m = 0.02;

class Solver {
public:
    Solver(const BenchWorld& world, double most_rounds, double margin_m) : scene_(*world.scene) {
        request_.radius_m = world.radius_m;
        request_.margin_m = margin_m;
        request_.growth_m = 2e-5;
        request_.ghost_exit_m = 1e-3;
        request_.most_rounds = static_cast<int>(most_rounds);
    }
    TickOutcome tick(const Vec3& goal_m) {
        const Vec3 step = has_last_ ? goal_m - last_goal_m_ : Vec3(0.0);
        last_goal_m_ = goal_m;
        has_last_ = true;
        request_.goal_m = goal_m;
        request_.path_cap_m = std::max(kPathCap_m, 2.0 * glm::length(step));
        const int rounds = solver_.move(scene_, request_).iterations;
        return {solver_.offset_m() == Vec3(0.0) ? goal_m : solver_.world_m(), rounds};
    }

private:
    const HapticScene& scene_;
    ProxySolver solver_;
    ProxySolver::Request request_;
    Vec3 last_goal_m_{0.0};
    bool has_last_ = false;
};

struct Rounds : Solver {
    Rounds(const BenchWorld& world, double most) : Solver(world, most, 0.02) {}
};
struct Margin : Solver {
    Margin(const BenchWorld& world, double margin_m) : Solver(world, ProxySolver::kMaxIterations, margin_m) {}
};

}  // namespace

Contestant handrail_touch() { return contestant<Touch>("handrail", "Handrail", "", TouchTuning{}.slide_cap_hand_m); }
// 20 mm a tick is as good as no cap, and still a length for which candidates can be gathered.
Contestant handrail_uncapped() { return contestant<Touch>("handrail_uncapped", "Handrail, slide cap 20 mm", "", 0.02); }
Contestant handrail_rounds(int most) {
    return contestant<Rounds>(fmt::format("rounds_{}", most), fmt::format("Handrail's solver, at most {} rounds", most), "rounds", most);
}
Contestant handrail_margin(double margin_m) {
    return contestant<Margin>(fmt::format("margin_{:g}_mm", margin_m * 1e3), fmt::format("Handrail's solver, margin {:g} mm", margin_m * 1e3), "margin_m",
                              margin_m);
}

std::vector<Contestant> main_contestants() {
    return {handrail_touch(), handrail_uncapped(), penalty_sum(), sequential_planes(), active_set(64), single_precision()};
}

std::vector<Contestant> knobbed_contestants() {
    std::vector<Contestant> all = main_contestants();
    for (const int rounds : {1, 2, 4, 8, 20, 64}) all.push_back(handrail_rounds(rounds));
    for (const double margin_m : {0.001, 0.005, 0.05}) all.push_back(handrail_margin(margin_m));
    for (const int rounds : {2, 8, 20}) all.push_back(active_set(rounds));
    return all;
}

}  // namespace handrail::bench
