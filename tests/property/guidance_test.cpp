// Tests guidance with a thousand random hands that push at random. Guidance never exceeds its limits of force, speed,
// change of force and energy. It releases the hand exactly when the hand resists for long enough.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "haptic/device/simulated_device.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/support/servo_rig.h"

namespace handrail::test {
namespace guidance_test {

struct Measured {
    double force_n = 0.0, free_speed_m_per_s = 0.0, slow_step_n = 0.0, step_share = 0.0, worst_power_share = 0.0;
    // Greatest changes of force in a tick, for hands below 0.1, 0.3 and 1 m/s, and faster ones.
    std::array<double, 4> step_n{};
    int let_go = 0, arrived = 0;
};

// Simulates one person, with a path within reach, one of the strengths, and intermittent pushes of up to 3 N.
void lead_one(const DeviceSpec& spec, std::mt19937& random, Measured& worst) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto somewhere = [&](double reach_m) {
        return Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)) * (reach_m / std::sqrt(3.0));
    };
    const double reach_m = 0.8 * spec.workspace_radius_m;
    const double scale = std::array{1.0, 15.0, 60.0, 250.0}[static_cast<std::size_t>(uniform(0, 4))];
    auto hand = std::make_shared<SimulatedHand>();
    HandCommand command;
    command.mode = HandMode::Move;
    hand->command.publish(command);
    SimulatedDevice device(spec, hand, Vec3(0.0));
    ServoState state(spec);
    const auto scene = wall_scene(1e5);
    ServoTuning tuning;
    tuning.touch.world_m_per_hand_m = scale;
    tuning.touch.rated_stiffness_n_per_m = spec.rated_stiffness_n_per_m;
    tuning.workspace.rim = false;
    WorkspacePose pose;
    pose.time_s = 0.0;
    GuidancePath path, none;
    path.number = 1;
    path.strength = std::array{1.0, 0.6, 0.3}[static_cast<std::size_t>(uniform(0, 3))];
    path.count = static_cast<std::uint32_t>(uniform(1, 6));
    for (std::uint32_t i = 0; i < path.count; ++i) path.points_m[i] = somewhere(reach_m) * scale;
    const double most_n = path.strength * std::min(0.8, 0.25 * spec.peak_force_n);

    // The hand moves a little, so that the servo's force ramps in. A second later the guidance begins.
    const Vec3 begins = somewhere(reach_m);
    double push_until_s = 0.0, free_since_s = 0.0, given_j = 0.0, against_s = 0.0;
    Vec3 push(0.0), last_force(0.0), last_hand(0.0), last_sample(0.0), velocity(0.0);
    bool acted = false;
    for (int i = 1; i <= 6500; ++i) {
        const double now_s = i * kTick;
        if (i == 5) {
            command.target_m = begins;
            command.speed_m_per_s = 0.3;
            hand->command.publish(command);
        }
        if (i >= 1500 && now_s >= push_until_s) {
            push = uniform(0, 1) < 0.6 ? Vec3(0.0) : glm::normalize(somewhere(1.0)) * uniform(0.2, 3.0);
            push_until_s = now_s + uniform(0.05, 1.5);
            command.mode = HandMode::Push;
            command.push_n = push;
            hand->command.publish(command);
        }
        if (push != Vec3(0.0)) free_since_s = now_s;
        pose.time_s = now_s;
        const DeviceSample sample = device.read(now_s);
        device.write(
            servo_tick(state, {scene.get(), tuning, pose, sample, now_s, nullptr, nullptr, i >= 1500 ? &path : &none}));
        const GuidanceState& g = state.tool().guidance;
        const Vec3 force = g.force_n;
        if (i >= 1500) {
            ASSERT_TRUE(is_finite(force));
            ASSERT_LE(glm::length(force), most_n + 1e-12);
            ASSERT_LE(glm::length(force), most_n * (i - 1499) * kTick / Guidance::kRamp_s + 1e-9) << "the ramp";
            ASSERT_LE(glm::length(state.tool().force_n), most_n + 1e-9) << "nothing else acts here";
            worst.force_n = std::max(worst.force_n, glm::length(force));
            // Computes the greatest change of force in one tick that the law of the pull permits. The spring acts on
            // the distance between the hand and the pulling point. That point moves as far as the hand, and by up to
            // 0.04 mm more. The reduction with speed depends on the hand's velocity, smoothed over 20 ms, and on the
            // direction in which the velocity is measured. The ramp at the beginning and the fade at the end are added.
            const double step_n = glm::length(force - last_force),
                         moved_m = glm::length(sample.position_m - last_sample);
            const Vec3 velocity_before = velocity;
            if (i > 1500)
                velocity += ((sample.position_m - last_sample) / kTick - velocity) * (kTick / (0.020 + kTick));
            if (i > 1500) {
                const double speed = std::max(glm::length(velocity), glm::length(velocity_before));
                const double away_m = 2.0 * moved_m + Guidance::kPointSpeed_m_per_s * kTick;
                const double per_speed = std::sqrt(2.0) / Guidance::kFastest_m_per_s;
                const double may_n =
                    std::min(most_n, Guidance::kStiffness_n_per_m * away_m * (1.0 + per_speed * speed) +
                                         most_n * per_speed * glm::length(velocity - velocity_before)) +
                    most_n * kTick / Guidance::kFade_s + most_n * kTick / Guidance::kRamp_s;
                ASSERT_LE(step_n, may_n + 1e-9) << "hand at " << moved_m / kTick << " m/s";
                worst.step_share = std::max(worst.step_share, step_n / may_n);
                const double v = moved_m / kTick;
                double& in_bin = worst.step_n[v < 0.1 ? 0 : v < 0.3 ? 1 : v < 1.0 ? 2 : 3];
                in_bin = std::max(in_bin, step_n);
                if (moved_m < 1e-4) worst.slow_step_n = std::max(worst.slow_step_n, step_n);
            }
            last_sample = sample.position_m;
            hand->state.refresh();
            const HandState felt = hand->state.read();
            if (now_s - free_since_s > 0.7)
                worst.free_speed_m_per_s = std::max(worst.free_speed_m_per_s, glm::length(felt.velocity_m_per_s));
            given_j += glm::dot(0.5 * (force + last_force), felt.position_m - last_hand);
            // If a pull of most_n ends at 5 cm/s, its power is at most most_n * 1.25 cm/s. The energy stored in one
            // spring is added.
            const double may_j =
                most_n * 0.0125 * (now_s - 1.5) + 0.5 * most_n * most_n / Guidance::kStiffness_n_per_m + 2e-4;
            worst.worst_power_share = std::max(worst.worst_power_share, given_j / may_j);
            // Counts, independently of the guidance, for how long the hand resists it.
            if (g.phase == GuidancePhase::Acts) {
                acted = true;
                against_s = g.counter_n > 1.2 ? against_s + kTick : 0.0;
                ASSERT_LT(against_s, 0.3 + 1.5 * kTick);
            } else if (g.phase == GuidancePhase::LetGo && acted) {
                ASSERT_GE(against_s, 0.3 - 1.5 * kTick);
                acted = false;
                ++worst.let_go;
            } else if (g.phase == GuidancePhase::Arrived && acted) {
                acted = false;
                ++worst.arrived;
            }
            last_hand = felt.position_m;
        }
        last_force = force;
    }
}

TEST(Guidance, never_exceeds_its_limits_in_a_thousand_random_pulls) {
    const std::uint32_t seed = seed_of_run();
    std::mt19937 random(seed);
    for (const char* device : {"sim-t", "sim-f"}) {
        Measured worst;
        for (int run = 0; run < scaled(500); ++run) {
            lead_one(*find_device_spec(device), random, worst);
            if (testing::Test::HasFatalFailure()) FAIL() << device << ", run " << run << ", seed " << seed;
        }
        fmt::print(
            "{}: {:.3f} N, free hand {:.1f} mm/s, a tick {:.3f} N below 0.1 m/s, {:.3f} below 0.3, {:.3f} below 1, "
            "{:.2f} of what the law allows, "
            "{:.2f} of the energy allowed, {} let go, {} arrived\n",
            device, worst.force_n, 1e3 * worst.free_speed_m_per_s, worst.step_n[0], worst.step_n[1], worst.step_n[2],
            worst.step_share, worst.worst_power_share, worst.let_go, worst.arrived);
        EXPECT_LE(worst.force_n, 0.8 + 1e-12);
        EXPECT_LE(worst.free_speed_m_per_s, 0.05);
        EXPECT_LE(worst.slow_step_n, 0.16);
        EXPECT_LE(worst.worst_power_share, 1.0);
        EXPECT_GT(worst.let_go, scaled(500) / 20);
        EXPECT_GT(worst.arrived, scaled(500) / 20);
    }
}

}  // namespace guidance_test
}  // namespace handrail::test
