// Finds the stiffest wall against which a hand can lean with each renderer, in the closed loop of haptic/loop.
#include <memory>

#include "haptic/loop/closed_loop.h"
#include "tests/bench/compare/bench.h"
#include "tests/support/names.h"
#include "tests/support/touch_worlds.h"

namespace handrail::bench {
namespace {

// Makes a world that fills x < 0 near the origin, for a proxy that comes from +x.
BenchWorld leaning_world(const std::string& wall) {
    test::TouchWorld world;
    if (wall == "flat wall" || wall == "three objects that overlap") {
        world.box({-1, -1, -1}, {0, 1, 1});
        if (wall != "flat wall") {
            world.box({-1.1, -1.2, -1.1}, {0, 1.2, 1.3});
            world.box({-1.2, -1.1, -1.2}, {0, 1.3, 1.1});
        }
    } else {
        // The wall has a groove of 20 degrees along y, with its bottom at x = -0.02.
        const double half = radians_from_degrees(10.0), depth = 0.3, out = depth * std::tan(half);
        world.quad({-.02, -1, 0}, {depth - .02, -1, out}, {depth - .02, 1, out}, {-.02, 1, 0});
        world.quad({-.02, -1, 0}, {depth - .02, -1, -out}, {depth - .02, 1, -out}, {-.02, 1, 0});
    }
    BenchWorld built;
    built.name = wall;
    built.scene = world.scene();
    built.judge = world.judge();
    built.radius_m = 0.002;
    return built;
}

}  // namespace

Stability stable_stiffness(const Contestant& contestant, const std::string& wall, double factor) {
    const BenchWorld world = leaning_world(wall);
    LoopSettings settings;
    settings.hand.mass_kg = 0.4;
    settings.hand.damping_ns_per_m = 3.2;
    settings.hand.spring_n_per_m = 300.0;
    settings.tremor_m = 0.05e-3;
    const auto render = [&](double stiffness) -> ClosedLoop::Render {
        const std::shared_ptr<void> state(contestant.make(world, contestant.knob_value), contestant.drop);
        return [=, tick = contestant.tick](const Vec3& measured_m, double, double) {
            return (tick(state.get(), measured_m).tool_m - measured_m) * stiffness;
        };
    };
    return {wall, contestant.key, contestant.title, stable_stiffness_n_per_m(settings, render, 6.0, 2.0, factor)};
}

}  // namespace handrail::bench
