// Measures a tick at the worst known places: time, counted work, and how often the proxy or a body had to wait.
#include <algorithm>

#include "haptic/render/proxy_solver.h"
#include "tests/bench/compare/bench.h"
#include "tests/bench/compare/measure.h"
#include "tests/support/names.h"
#include "tests/support/solver_probe.h"
#include "tests/support/worst_cases.h"

namespace handrail::bench {

WorstTicks run_worst_case(int number, int ticks, int passes) {
    const test::WorstCase worst = test::worst_case(number, ticks);
    WorstTicks out;
    out.scene = worst.name;
    out.ticks = worst.goals_m.size();
    std::vector<double> best(out.ticks, 1e9);
    for (int pass = 0; pass < passes; ++pass) {
        TouchState state;
        std::vector<BodyPose> poses;
        for (const HapticBody& body : worst.scene->bodies) poses.push_back({body.start, body.present});
        out.waits = 0;
        for (std::size_t i = 0; i < out.ticks; ++i) {
            if (worst.move) worst.move(i, poses);
            const BodyPoses at{poses, i + 1};
            const double begun_s = thread_s();
            const TouchResult r = touch_tick(state, *worst.scene, worst.tuning, worst.goals_m[i], 1e-3, Vec3(0.0), at);
            best[i] = std::min(best[i], thread_s() - begun_s);
            out.most_work = std::max(out.most_work, SolverProbe(state.solver()).work());
            out.most_looks = std::max(out.most_looks, SolverProbe(state.solver()).looks());
            out.waits += r.contacts.waits;
        }
    }
    for (const double t : best) out.mean_s += t / static_cast<double>(out.ticks);
    std::sort(best.begin(), best.end());
    out.p999_s = best[best.size() * 999 / 1000];
    out.worst_s = best.back();
    return out;
}

}  // namespace handrail::bench
