#include <random>

#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_tick.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/servo_rig.h"

namespace handrail {
namespace walking_test {

using test::kTick;
using test::ServoRig;

DeviceSpec unlimited() {
    DeviceSpec spec = ideal_device_spec();
    spec.workspace_radius_m = 1.0;
    return spec;
}

// The workspace drifts into a wall, and the app reports its place at 60 Hz. The hand must not feel steps. If the servo
// applied each report as it arrives, the force would change by 0.333 N at a time.
TEST(Walking, a_frame_that_drifts_into_a_wall_is_felt_in_steps_of_at_most_25_mn) {
    for (const double heading_deg : {0.0, 37.0, 180.0}) {
        ServoRig rig(unlimited());
        rig.tuning.touch.default_stiffness_fraction = 1.0;  // the wall has 1000 N/m
        rig.tuning.force_ceiling_n = 1e3;
        rig.pose.heading_rad = radians_from_degrees(heading_deg);
        const WorkspaceFrame frame = frame_of(Vec3(0.0), rig.pose.heading_rad);
        rig.arm();
        const Vec3 pressed = frame.turn_to_device(Vec3(0, ServoRig::kWallY, 0));  // the hand presses 5 mm deep
        rig.go(pressed);
        for (int i = 0; i < 1100; ++i) rig.tick(pressed);
        ASSERT_NEAR(glm::length(rig.last.force_n), 5.0, 1e-6);

        const double start_s = rig.now_s;
        WorkspacePose known = rig.pose;
        double last = 5.0, largest = 0.0;
        int frames = 0;
        while (rig.now_s < start_s + 1.0) {
            if (rig.now_s + kTick >= start_s + frames / 60.0) {
                known.time_s = start_s + frames / 60.0;
                known.origin_m = Vec3(0, 0.02 * frames / 60.0, 0);
                ++frames;
            }
            rig.now_s += kTick;
            rig.sample.position_m = pressed;
            rig.last = servo_tick(rig.state, {rig.scene.get(), rig.tuning, known, rig.sample, rig.now_s});
            const double force = glm::length(rig.last.force_n);
            largest = std::max(largest, std::abs(force - last));
            last = force;
        }
        // By the end, the hand is 20 mm deeper, less the delay of about one report.
        EXPECT_GT(last, 20.0) << heading_deg;
        EXPECT_LE(largest, 0.025) << heading_deg;
    }
}

// Returns the amplitude of one frequency in evenly spaced values. First removes their linear trend and applies a Hann
// window.
double amplitude_at(const std::vector<double>& values, double frequency_hz, double step_s) {
    const auto n = static_cast<double>(values.size());
    const double slope = (values.back() - values.front()) / (n - 1);
    double c = 0, s = 0, weight = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double w = 0.5 - 0.5 * std::cos(2 * kPi * static_cast<double>(i) / (n - 1));
        const double v = values[i] - values.front() - slope * static_cast<double>(i);
        const double phase = 2 * kPi * frequency_hz * step_s * static_cast<double>(i);
        c += w * v * std::cos(phase);
        s += w * v * std::sin(phase);
        weight += w;
    }
    return 2.0 * std::hypot(c, s) / weight;
}

struct Walk {
    double largest_step_n = 0.0;
    double at_60_hz_n = 0.0;
    double end_n = 0.0;
    bool falls = false;  // true if the force fell before the walker stood still
};

// Simulates a room with its north wall at y = 4 m. A walker moves at 1 m/s to y = 3.75, with the hand 0.6 m ahead. The
// scale is 60, and the device is a Touch.
Walk walk_into_wall(bool jitter) {
    constexpr double kScale = 60.0, kWall = 4.0, kStop = 3.75;
    ServoRig rig(*find_device_spec("sim-t"));
    rig.scene = test::wall_scene(kWall);
    rig.tuning.touch.world_m_per_hand_m = kScale;
    rig.tuning.touch.radius_m = 0.002 * kScale;
    rig.tuning.touch.rated_stiffness_n_per_m = 400.0;
    rig.tuning.touch.default_stiffness_fraction = 0.75;
    rig.tuning.touch.damping_ns_per_m = 5.0;
    rig.pose.origin_m = Vec3(3.0, 2.0, 1.0);
    const Vec3 ahead(0.0, 0.6 / kScale, 0.0);
    rig.press(ahead);

    std::mt19937 random(5);
    std::uniform_real_distribution<double> late(-0.003, 0.003);
    const double start_s = rig.now_s;
    const auto body_y = [&](double time_s) { return std::min(kStop, 2.0 + std::max(0.0, time_s - start_s)); };
    WorkspacePose known = rig.pose;
    double next_frame_s = start_s, last = 0.0;
    Walk walk;
    std::vector<double> rising;
    for (int frame = 1; rig.now_s < start_s + 2.5;) {
        if (rig.now_s + kTick >= next_frame_s) {
            known.time_s = next_frame_s;
            known.origin_m.y = body_y(next_frame_s);
            next_frame_s = start_s + frame++ / 60.0 + (jitter ? late(random) : 0.0);
        }
        rig.now_s += kTick;
        rig.sample.position_m = ahead;
        rig.last = servo_tick(rig.state, {rig.scene.get(), rig.tuning, known, rig.sample, rig.now_s});
        const double force = -rig.last.force_n.y;
        walk.largest_step_n = std::max(walk.largest_step_n, std::abs(force - last));
        walk.falls |= force < last && rig.tool().hip_m.y < kStop + 0.6 - 1e-6;
        last = force;
        if (force > 0.1 && force < 1.6) rising.push_back(force);
    }
    walk.end_n = last;
    walk.at_60_hz_n = amplitude_at(rising, 60.0, kTick);
    return walk;
}

TEST(Walking, the_measure_of_a_60_hz_line_detects_a_staircase) {
    std::vector<double> staircase, slope;
    for (int i = 0; i < 300; ++i) {
        // The force rises by 5 N/s in steps of 83 mN, so the amplitude at 60 Hz is 0.083 / pi.
        staircase.push_back(5.0 * std::floor(i * kTick * 60.0) / 60.0);
        slope.push_back(5.0 * i * kTick);
    }
    EXPECT_NEAR(amplitude_at(staircase, 60.0, kTick), 0.0265, 0.003);
    EXPECT_LT(amplitude_at(slope, 60.0, kTick), 1e-6);
}

TEST(Walking, into_a_wall_with_the_hand_ahead_raises_the_force_evenly_without_a_60_hz_staircase) {
    for (const bool jitter : {false, true}) {
        const Walk walk = walk_into_wall(jitter);
        // The depth is 3.75 + 0.6 - 4 + 0.12 m of proxy radius = 0.47 m, divided by 60 for the hand. Times 300 N/m, it
        // gives 2.35 N.
        EXPECT_NEAR(walk.end_n, 2.35, 0.01);
        EXPECT_LE(walk.largest_step_n, 0.03);
        EXPECT_LT(walk.at_60_hz_n, 0.02);
        EXPECT_FALSE(walk.falls);
    }
}

}  // namespace walking_test
}  // namespace handrail
