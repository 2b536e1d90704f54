// Moves a hand through quake-e1m1.map, with a proxy of 5 mm at scale 1. Under callgrind, instructions.sh counts one of
// these:
// - servo: the whole servo_tick (sample checks, workspace, touch, events, limiter), without guidance
// - pull, grooves: the whole servo_tick, while guidance pulls the hand or the hand is among 32 grooves
// - touch: only touch_tick, as in the program
// - plain: only touch_tick, compiled without any optional feature
// - all: only touch_tick, compiled with all optional features, whether the scene uses them or not touch_walk [TICKS
//   [servo|pull|grooves|touch|plain|all]]
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

#include "haptic/compile/compile_haptic.h"
#include "haptic/servo/servo_tick.h"
#include "tests/bench/walk.h"
#include "tests/bench/walked_scene.h"
#include "tests/support/names.h"

namespace handrail::test {
namespace {

struct Tally {
    double checksum = 0.0;
    long touching = 0, gatherings = 0, worst_iterations = 0;
};

using Tick = TouchResult(TouchState&, const HapticScene&, const TouchTuning&, const Vec3&, double, const Vec3&,
                         const BodyPoses&) noexcept;

// callgrind starts and stops counting at this function, which it finds by its name. The function must contain nothing
// else.
template <Tick tick>
[[gnu::noinline]] Tally measured_ticks(const HapticScene& scene, const TouchTuning& tuning,
                                       const std::vector<Vec3>& goals, TouchState& state) {
    Tally tally;
    for (const Vec3& goal : goals) {
        const TouchResult r = tick(state, scene, tuning, goal, 1e-3, Vec3(0.0), {});
        tally.checksum += r.force_n.x + 3.0 * r.force_n.y + 7.0 * r.force_n.z + r.proxy_m.x * 1e-6;
        tally.touching += r.contacts.count > 0;
        tally.worst_iterations = std::max<long>(tally.worst_iterations, r.contacts.iterations);
    }
    return tally;
}

// Returns the guidance path. The end of the path of "pull" is so far away that the pull never ends. The path of
// "grooves" surrounds the hand by the greatest number of grooves.
GuidancePath led(const std::string& how, const std::vector<Vec3>& goals) {
    GuidancePath path;
    if (how == "servo") return path;
    path.number = 1;
    if (how == "pull") path.strength = 0.0;  // without force, the pull does all of its work but never releases the hand
    path.kind = how == "pull" ? GuidanceKind::Pull : GuidanceKind::Grooves;
    path.count = GuidancePath::kMostPoints;
    for (std::uint32_t i = 0; i < path.count; ++i)
        path.points_m[i] =
            how == "pull" ? Vec3(1e6 + i, 0.0, 0.0) : goals[(i / 2 + i % 2) * (goals.size() - 1) / (path.count / 2)];
    return path;
}

[[gnu::noinline]] Tally measured_ticks(const HapticScene& scene, const ServoTuning& tuning,
                                       const std::vector<Vec3>& goals, ServoState& state,
                                       const GuidancePath& guidance) {
    Tally tally;
    double now_s = 0.0;
    const GuidancePath none;
    for (const Vec3& goal : goals) {
        DeviceSample sample;
        // At scale 1, with the workspace at the origin, hand coordinates equal world coordinates.
        sample.position_m = goal;
        const ForceCommand command = servo_tick(state, {.scene = &scene,
                                                        .tuning = tuning,
                                                        .pose = WorkspacePose{},
                                                        .sample = sample,
                                                        .now_s = now_s += 1e-3,
                                                        .guidance = state.tool().waiting_for_hand ? &none : &guidance});
        tally.checksum += command.force_n.x;
        tally.touching += state.tool().contacts.count > 0;
        tally.worst_iterations = std::max<long>(tally.worst_iterations, state.tool().contacts.iterations);
    }
    return tally;
}

int run(int ticks, const std::string& part) {
    int status = 0;
    const std::optional<Scene> scene = walked_scene(status);
    if (!scene) return status;
    const auto haptic = compile_haptic(*scene, MaterialSource::KeysOnly);
    TouchTuning tuning;
    tuning.damping_ns_per_m = 5.0;
    tuning.passivity_guard = true;  // as in the program, although with this damping the guard never has to add any
    tuning.default_friction_static = tuning.default_friction_kinetic = 0.3;
    const std::vector<Vec3> goals = record_walk(*haptic, tuning, scene->starts.front().feet_m + Vec3(0, 0, 1.0), ticks);
    TouchState touch_state;
    ServoState servo_state(ideal_device_spec());
    ServoTuning servo_tuning;
    servo_tuning.touch = tuning;
    const GuidancePath path = led(part, goals);
    const auto begin = std::chrono::steady_clock::now();
    const Tally tally =
        part == "touch"   ? measured_ticks<touch_tick>(*haptic, tuning, goals, touch_state)
        : part == "plain" ? measured_ticks<touch_tick_with<PlainFeatures>>(*haptic, tuning, goals, touch_state)
        : part == "all"   ? measured_ticks<touch_tick_with<AllFeatures>>(*haptic, tuning, goals, touch_state)
                          : measured_ticks(*haptic, servo_tuning, goals, servo_state, path);
    const double ns = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
    std::cout << fmt::format(
        "{} obstacles, {} ticks, {:.1f} % touching, {:.0f} ns per tick, at most {} rounds, ended {:.1f} m from the "
        "start, checksum {}\n",
        haptic->obstacles.size(), ticks, 100.0 * static_cast<double>(tally.touching) / ticks, ns / ticks,
        tally.worst_iterations, glm::length(goals.back() - goals.front()), tally.checksum);
    return 0;
}

}  // namespace
}  // namespace handrail::test

int main(int argc, char** argv) {
    return handrail::test::run(argc > 1 ? std::atoi(argv[1]) : 60000, argc > 2 ? argv[2] : "servo");
}
