// Measures the cost of bodies. A hand slides over a floor of boxes, 3 mm deep at 0.25 m/s, among crates that are
// bodies.
// The crates stand still or move far away, or one of them pushes the proxy. Under callgrind, instructions.sh counts the
// instructions of touch_tick().
//   bodies_touch TICKS none|still|far|pushing [BODIES]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "haptic/render/proxy_solver.h"
#include "haptic/servo/body_playback.h"
#include "tests/support/names.h"
#include "tests/support/solver_probe.h"

namespace handrail::test {
namespace {

// Ticks between two frames of the app, which reports poses sixty times a second.
constexpr std::size_t kTicksOfFrame = 16;

[[gnu::noinline]] double measured_ticks(TouchState& state, const HapticScene& scene, const TouchTuning& tuning,
                                        const std::vector<Vec3>& goals, const std::vector<BodyFrame>& frames,
                                        BodyPlayback& playback) {
    double sum = 0.0;
    for (std::size_t i = 0; i < goals.size(); ++i) {
        const BodyFrame& newest = frames[std::min(i / kTicksOfFrame + 1, frames.size() - 1)];
        BodyPoses poses;
        if (!scene.bodies.empty()) poses = playback.at(newest, scene, 1e-3 * static_cast<double>(i));
        sum += touch_tick(state, scene, tuning, goals[i], 1e-3, Vec3(0.0), poses).force_n.x;
    }
    return sum;
}

int run(int ticks, const std::string& mode, int bodies) {
    HapticSceneBuilder floor;
    for (int x = -5; x < 5; ++x)
        for (int y = -5; y < 5; ++y) floor.add_box({Vec3(x, y, -1.0), Vec3(x + 1.0, y + 1.0, 0.0)});
    HapticSceneBuilder crate;
    crate.add_box({Vec3(-0.1), Vec3(0.1)});
    const auto shape = crate.build();
    const bool pushing = mode == "pushing";
    for (int b = 0; mode != "none" && b < bodies; ++b) {
        const double turn = 2.0 * kPi * b / bodies;
        const Vec3 place =
            pushing && b == 0 ? Vec3(-0.105, 0.0, 0.05) : Vec3(std::cos(turn), std::sin(turn), 0.3) * 2.0;
        floor.add_body(FeatureId{static_cast<std::uint32_t>(b)}, shape,
                       {place, rotation_about({0, 0, 1}, pushing && b == 0 ? 0.0 : turn), 1.0});
    }
    const auto scene = floor.build();
    std::vector<BodyPose> poses;
    std::vector<Vec3> steps;
    for (const HapticBody& body : scene->bodies) {
        poses.push_back({body.start, true});
        if (mode == "far") steps.emplace_back(0.0, 0.0, 2e-4);
        if (pushing) steps.push_back(poses.size() == 1 ? Vec3(2e-4, 0.0, 0.0) : Vec3(0.0));
    }
    std::vector<Vec3> goals;
    for (int i = 0; i < ticks; ++i)
        goals.emplace_back(pushing ? 0.0 : 0.4 * std::sin(6e-4 * i), pushing ? 0.0 : 0.4 * std::cos(5e-4 * i), 0.002);
    TouchTuning tuning;
    tuning.default_friction_static = tuning.default_friction_kinetic = 0.3;
    // Each frame has its own poses and those of the moments before it, as the newest frame in the program has.
    std::vector<BodyFrame> frames(1);
    frames[0].push(scene->generation, 0.0, poses);
    for (std::size_t tick = kTicksOfFrame; !steps.empty() && tick < goals.size() + 2 * kTicksOfFrame;
         tick += kTicksOfFrame) {
        const double there_and_back = tick / 192 % 2 == 0 ? 1.0 : -1.0;
        for (std::size_t b = 0; b < poses.size(); ++b)
            poses[b].at.position_m += steps[b] * (there_and_back * static_cast<double>(kTicksOfFrame));
        frames.push_back(frames.back());
        frames.back().push(scene->generation, 1e-3 * static_cast<double>(tick), poses);
    }
    TouchState state;
    BodyPlayback playback;
    touch_tick(state, *scene, tuning, goals[0] + Vec3(0.0, 0.0, 0.01), 1e-3, Vec3(0.0),
               playback.at(frames[0], *scene, 0.0, true));
    std::cout << fmt::format("{}, {} bodies, {} of them tracked, checksum {}\n", mode, scene->bodies.size(),
                             SolverProbe(state.solver()).tracked(),
                             measured_ticks(state, *scene, tuning, goals, frames, playback));
    return 0;
}

}  // namespace
}  // namespace handrail::test

int main(int argc, char** argv) {
    const std::string mode = argc > 2 ? argv[2] : "still";
    if (mode != "none" && mode != "still" && mode != "far" && mode != "pushing") {
        std::cerr << "none, still, far or pushing, not " << mode << ".\n";
        return 2;
    }
    return handrail::test::run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 20000, mode,
                               argc > 3 ? std::clamp(std::atoi(argv[3]), 1, 10000) : 20);
}
