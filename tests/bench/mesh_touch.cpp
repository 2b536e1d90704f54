// Measures how the density of triangles affects the cost. A proxy of 5 mm slides at 0.2 m/s, pressed 2 to 5 mm deep,
// over spheres of radius 0.5 m made of 1e3 to 1e6 triangles. Prints one line per sphere: build time, memory, time per
// tick.
//   mesh_touch [TICKS [FREQUENCY [count]]]
// A frequency of n gives 20 n^2 triangles. Under callgrind, instructions.sh counts the instructions of
// measured_ticks(); "count" omits the timing.
#include <fmt/format.h>

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "haptic/render/haptic_scene.h"
#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/solver_probe.h"
#include "tests/support/sphere_mesh.h"

namespace handrail::test {
namespace {

constexpr double kSphere_m = 0.5, kProxy_m = 0.005, kSpeed_m_per_s = 0.2;

double now_ns() {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::size_t heap_bytes() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

struct Tally {
    double checksum = 0.0;
    long truncated = 0, capped = 0;
    long iterations = 0, most_iterations = 0;
};

// callgrind starts and stops counting at this function, which it finds by its name. The function must contain nothing
// else.
[[gnu::noinline]] Tally measured_ticks(const HapticScene& scene, const TouchTuning& tuning,
                                       const std::vector<Vec3>& goals, TouchState& state) {
    Tally tally;
    for (const Vec3& goal : goals) {
        const TouchResult r = touch_tick(state, scene, tuning, goal, 1e-3);
        tally.checksum += r.force_n.x;
        tally.truncated += r.contacts.truncated;
        tally.capped += r.contacts.capped;
        tally.iterations += r.contacts.iterations;
        tally.most_iterations = std::max<long>(tally.most_iterations, r.contacts.iterations);
    }
    return tally;
}

// Returns for each tick the shortest time of several passes, which excludes the load of other programs.
std::vector<double> tick_times_ns(const HapticScene& scene, const TouchTuning& tuning, const std::vector<Vec3>& goals) {
    constexpr int kPasses = 5;
    std::vector<double> best(goals.size(), 1e18);
    for (int pass = 0; pass < kPasses; ++pass) {
        TouchState state;
        for (std::size_t i = 0; i < goals.size(); ++i) {
            const double begin = now_ns();
            const TouchResult r = touch_tick(state, scene, tuning, goals[i], 1e-3);
            best[i] = std::min(best[i], now_ns() - begin);
            if (!(r.radius_m > 0.0)) std::abort();
        }
    }
    return best;
}

void run(int frequency, int ticks, bool timed) {
    const TriangleMesh mesh = sphere_mesh(frequency, kSphere_m);
    const std::size_t before = heap_bytes();
    const double begin = now_ns();
    const auto scene = [&] {
        HapticSceneBuilder builder;
        builder.add_mesh(mesh);
        return builder.build();
    }();
    const double build_ns = now_ns() - begin;
    const auto triangles = static_cast<double>(mesh.triangles.size());
    const double beyond = (static_cast<double>(heap_bytes() - before) -
                           static_cast<double>(mesh.points_m.size() * sizeof(Vec3)) - triangles * sizeof(Corners)) /
                          triangles;
    TouchTuning tuning;
    tuning.radius_m = kProxy_m;
    const std::vector<Vec3> goals = sphere_slide(kSphere_m, kProxy_m, kSpeed_m_per_s, ticks);
    TouchState state;
    const Tally tally = measured_ticks(*scene, tuning, goals, state);
    std::vector<double> ns = timed ? tick_times_ns(*scene, tuning, goals) : std::vector<double>(goals.size(), 0.0);
    double sum = 0.0;
    for (const double t : ns) sum += t;
    std::sort(ns.begin(), ns.end());
    std::cout << fmt::format(
        "{:8} triangles  build {:5.2f} us each  {:5.1f} B each beyond the mesh  tick mean {:6.0f} ns, 99.9 % {:6.0f} "
        "ns, worst {:6.0f} ns  "
        "{:.2f} rounds, at most {}  a gathering per {:.1f} ticks  capped {} truncated {}  checksum {}\n",
        mesh.triangles.size(), build_ns / triangles / 1e3, beyond, sum / static_cast<double>(ns.size()),
        ns[ns.size() * 999 / 1000], ns.back(), static_cast<double>(tally.iterations) / ticks, tally.most_iterations,
        static_cast<double>(ticks) /
            static_cast<double>(std::max<std::uint64_t>(1, SolverProbe(state.solver()).gatherings())),
        tally.capped, tally.truncated, tally.checksum);
}

}  // namespace
}  // namespace handrail::test

int main(int argc, char** argv) {
    const int ticks = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20000;
    if (argc > 2) {
        handrail::test::run(std::clamp(std::atoi(argv[2]), 1, 700), ticks, argc == 3);
        return 0;
    }
    for (const int frequency : {7, 22, 71, 224}) handrail::test::run(frequency, ticks, true);
    return 0;
}
