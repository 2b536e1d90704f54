// Measures one touch tick with Google Benchmark, in small worlds and, if the file is present, in a real map. The
// program reports times and never asserts them.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>

#include "haptic/compile/compile_haptic.h"
#include "haptic/compile/simplify_scene.h"
#include "tests/bench/walk.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/touch_worlds.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace {

void replay_ticks(benchmark::State& bench, const HapticScene& scene, const std::vector<Vec3>& goals, double radius_m) {
    TouchState state;
    TouchTuning tuning;
    tuning.radius_m = radius_m;
    std::size_t i = 0;
    for (auto _ : bench) {
        benchmark::DoNotOptimize(touch_tick(state, scene, tuning, goals[i], 1e-3));
        if (++i == goals.size()) {
            i = 0;
            state.reset();
        }
    }
}

// Measures one closest-point query for each kind of obstacle, from random places near it.
void register_closest_points() {
    // Number of kinds, without custom obstacles.
    constexpr std::size_t kOurKinds = static_cast<std::size_t>(ObstacleKind::Custom);
    TouchWorld worlds[kOurKinds];
    const auto of = [&](ObstacleKind kind) -> TouchWorld& { return worlds[static_cast<std::size_t>(kind)]; };
    const Vec3 low(-.1, -.1, -.1), high(.1, .1, .1);
    of(ObstacleKind::Triangle).triangle(low, {.1, -.1, 0}, high);
    of(ObstacleKind::Polygon)
        .polygon({{.1, 0, 0}, {.05, .087, 0}, {-.05, .087, 0}, {-.1, 0, 0}, {-.05, -.087, 0}, {.05, -.087, 0}});
    of(ObstacleKind::Box).box(low, high);
    of(ObstacleKind::Brush).brush_box(low, high);
    of(ObstacleKind::Sphere).sphere({0, 0, 0}, .1);
    of(ObstacleKind::Capsule).capsule(low, high, .05);
    of(ObstacleKind::Cylinder).cylinder(low, high, .05);
    of(ObstacleKind::Cone).cone(low, high, .05);
    constexpr const char* kNames[kOurKinds] = {"triangle", "polygon of 6", "box",      "brush of 7",
                                               "sphere",   "capsule",      "cylinder", "cone"};
    std::mt19937 random(1);
    const auto places = std::make_shared<std::vector<Vec3>>();
    for (int i = 0; i < 1024; ++i)
        places->emplace_back((random() % 400) / 1e3 - .2, (random() % 400) / 1e3 - .2, (random() % 400) / 1e3 - .2);
    for (std::size_t kind = 0; kind < kOurKinds; ++kind)
        benchmark::RegisterBenchmark(
            (std::string("closest/") + kNames[kind]).c_str(),
            [scene = worlds[kind].scene(), places](benchmark::State& bench) {
                std::size_t i = 0;
                for (auto _ : bench) benchmark::DoNotOptimize(scene->closest(0, (*places)[i++ % places->size()]));
            });
}

// Measures how long a world takes to compile after the person changes the scale: first without simplification, then
// with details left out or widened that are too small to feel. Also measures the search for such details alone.
void register_simplifying() {
    constexpr double kReach_m = 0.075, kRim = 0.8, kRounding_hand_m = 1.5e-3, kProxy_hand_m = 1e-3;
    for (const char* name : {"house.map", "school.map", "quake-e1m1.map"}) {
        const auto file = std::string_view(name).starts_with("quake") ? real_world(name)
                                                                      : test::project_root() / "worlds" / "maps" / name;
        if (!file) continue;
        const Result<Scene> read = read_world(*file);
        if (!read) continue;
        const auto scene = std::make_shared<const Scene>(*read);
        const Vec3 size = scene->bounds_m.size_m();
        for (const double scale : {60.0, std::min(500.0, 0.5 * std::hypot(size.x, size.y) / (kRim * kReach_m))}) {
            const SimplifyOptions options{scale, {}, {}};
            const double rounding_m = std::min(kRounding_hand_m, kProxy_hand_m) * scale;
            const std::string at = fmt::format("{} at {:.0f}", name, scale);
            benchmark::RegisterBenchmark(("compile/" + at).c_str(), [=](benchmark::State& bench) {
                for (auto _ : bench) benchmark::DoNotOptimize(compile_haptic(*scene, exploring(rounding_m)));
            });
            benchmark::RegisterBenchmark(("plan/" + at).c_str(), [=](benchmark::State& bench) {
                for (auto _ : bench) benchmark::DoNotOptimize(plan_simplification(*scene, options));
            });
            benchmark::RegisterBenchmark(("simplify/" + at).c_str(), [=](benchmark::State& bench) {
                const Simplification plan = plan_simplification(*scene, options);
                for (auto _ : bench)
                    if (!plan.changes_nothing()) benchmark::DoNotOptimize(simplified(*scene, plan));
            });
            benchmark::RegisterBenchmark(("compile simplified/" + at).c_str(), [=](benchmark::State& bench) {
                const Simplification plan = plan_simplification(*scene, options);
                const Scene felt = plan.changes_nothing() ? *scene : simplified(*scene, plan);
                for (auto _ : bench) benchmark::DoNotOptimize(compile_haptic(felt, exploring(rounding_m)));
                bench.counters["widened"] = static_cast<double>(plan.widened());
                bench.counters["left out"] = static_cast<double>(plan.left_out.size());
            });
        }
    }
}

void register_all() {
    register_closest_points();
    register_simplifying();
    for (const TouchCase& c : hard_cases())
        benchmark::RegisterBenchmark(("tick/" + c.name).c_str(), [c](benchmark::State& bench) {
            replay_ticks(bench, *c.world.scene(), c.goals_m, c.radius_m);
        });
    const auto path = real_world("quake-e1m1.map");
    if (!path) return;
    const Result<Scene> scene = read_world(*path);
    if (!scene || scene->starts.empty()) return;
    const auto haptic = compile_haptic(*scene, MaterialSource::KeysOnly);
    const auto goals = std::make_shared<std::vector<Vec3>>(
        record_walk(*haptic, TouchTuning{}, scene->starts.front().feet_m + Vec3(0, 0, 1.0), 20000));
    benchmark::RegisterBenchmark("tick/walk in quake-e1m1",
                                 [=](benchmark::State& bench) { replay_ticks(bench, *haptic, *goals, 0.005); });
    benchmark::RegisterBenchmark("compile/quake-e1m1", [scene](benchmark::State& bench) {
        for (auto _ : bench) benchmark::DoNotOptimize(compile_haptic(*scene, MaterialSource::KeysOnly));
    });
}

}  // namespace
}  // namespace handrail::test

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    handrail::test::register_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
