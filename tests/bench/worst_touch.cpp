// Measures a tick at the worst places of tests/support/worst_cases.h: time, counted work, and how often the proxy or a
// body had to wait.
//   worst_touch [TICKS [CASE [count]]]
// Under callgrind, instructions.sh counts the instructions of measured_ticks(); "count" omits the timing.
#include <fmt/format.h>
#include <fmt/ranges.h>
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_DUMP_STATS
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "haptic/render/proxy_solver.h"
#include "tests/support/names.h"
#include "tests/support/solver_probe.h"
#include "tests/support/worst_cases.h"

namespace handrail::test {
namespace {

double now_ns() {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Run {
    const WorstCase& worst;
    TouchState state;
    std::vector<BodyPose> poses;
    std::uint64_t number = 0;

    explicit Run(const WorstCase& w) : worst(w) {
        for (const HapticBody& body : w.scene->bodies) poses.push_back({body.start, body.present});
    }
    TouchResult tick(std::size_t i) {
        return touch_tick(state, *worst.scene, worst.tuning, worst.goals_m[i], 1e-3, Vec3(0.0), {poses, number});
    }
    void move(std::size_t i) {
        if (!worst.move) return;
        worst.move(i, poses);
        ++number;
    }
};

// callgrind starts and stops counting at this function, which it finds by its name. The function must contain nothing
// else.
[[gnu::noinline]] double measured_ticks(Run& run, std::size_t i) { return run.tick(i).force_n.x; }

void report(int number, int ticks, bool timed) {
    constexpr int kPasses = 3;
    const WorstCase worst = worst_case(number, ticks);
    std::vector<double> best(worst.goals_m.size(), timed ? 1e18 : 0.0);
    double checksum = 0.0;
    std::vector<int> work(best.size());
    long truncated = 0, capped = 0, rounds = 0;
    int most_looks = 0;
    {
        Run run(worst);
        for (std::size_t i = 0; i < best.size(); ++i) {
            run.move(i);
            checksum += measured_ticks(run, i);
            CALLGRIND_DUMP_STATS;
            most_looks = std::max(most_looks, SolverProbe(run.state.solver()).looks());
            work[i] = SolverProbe(run.state.solver()).work();
        }
    }
    for (int pass = 0; timed && pass < kPasses; ++pass) {
        Run run(worst);
        truncated = capped = rounds = 0;
        for (std::size_t i = 0; i < best.size(); ++i) {
            run.move(i);
            const double begin = now_ns();
            const TouchResult r = run.tick(i);
            best[i] = std::min(best[i], now_ns() - begin);
            truncated += r.contacts.truncated;
            capped += r.contacts.capped;
            rounds += r.contacts.iterations;
        }
    }
    if (!timed) {
        std::cout << fmt::format("{}\nwork of each tick: {}\n", worst.name, fmt::join(work, " "));
        return;
    }
    double sum = 0.0;
    for (const double t : best) sum += t;
    const auto worst_at = static_cast<std::size_t>(std::max_element(best.begin(), best.end()) - best.begin());
    std::sort(best.begin(), best.end());
    std::cout << fmt::format(
        "{}: mean {:.1f} us, 99.9 % {:.1f} us, worst {:.1f} us in tick {} with {} of work; {} of work at most, {:.2f} "
        "rounds, {} looks at most, truncated {}, capped {}, checksum {}\n",
        worst.name, 1e-3 * sum / static_cast<double>(best.size()), 1e-3 * best[best.size() * 999 / 1000],
        1e-3 * best.back(), worst_at, work[worst_at], *std::max_element(work.begin(), work.end()),
        static_cast<double>(rounds) / static_cast<double>(best.size()), most_looks, truncated, capped, checksum);
}

}  // namespace
}  // namespace handrail::test

int main(int argc, char** argv) {
    using namespace handrail::test;
    const int ticks = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3000;
    for (int number = 0; number < kWorstCases; ++number)
        if (argc <= 2 || number == std::atoi(argv[2])) report(number, ticks, argc <= 3);
    return 0;
}
