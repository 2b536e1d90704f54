#include "haptic/device/simulated_device.h"

#include <vector>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/world_axes.h"

namespace handrail {
namespace simulated_device_test {

constexpr double kTick = 1e-3;

// Returns the specification of a device without encoder steps and delay, so that formulas can predict how the simulated
// hand moves.
DeviceSpec plain_spec() {
    DeviceSpec spec = ideal_device_spec();
    spec.workspace_radius_m = 1e3;
    return spec;
}

struct Bench {
    std::shared_ptr<SimulatedHand> hand = std::make_shared<SimulatedHand>();
    SimulatedDevice device;
    double now_s = 100.0;

    explicit Bench(const DeviceSpec& spec, const Vec3& start_m = Vec3(0.0)) : device(spec, hand, start_m) {
        EXPECT_TRUE(device.open());
        device.read(now_s);
    }
    DeviceSample tick(const Vec3& force_n = Vec3(0.0)) {
        device.write({force_n});
        now_s += kTick;
        return device.read(now_s);
    }
    HandState truth() {
        hand->state.refresh();
        return hand->state.read();
    }
};

TEST(SimulatedDevice, move_sets_the_exact_position_against_any_force) {
    Bench bench(*find_device_spec("sim-t"));
    const Vec3 target(0.0123456789, -0.01, 0.2);  // not on an encoder step, and outside the device's workspace
    bench.hand->command.publish({HandMode::Move, target, 0.0, Vec3(0.0), 1});
    for (int i = 0; i < 10; ++i) {
        const DeviceSample sample = bench.tick(Vec3(5, 5, 5));
        EXPECT_EQ(sample.position_m, target);
        EXPECT_EQ(sample.buttons, 1u);
        EXPECT_TRUE(sample.fresh && sample.connected);
    }
}

TEST(SimulatedDevice, move_with_a_speed_goes_straight_at_that_speed_and_stops_at_the_target) {
    Bench bench(*find_device_spec("sim-t"));
    const Vec3 target(0.03, 0.04, 0.0);  // the target is 50 mm away: 500 ticks at 0.1 m/s
    bench.hand->command.publish({HandMode::Move, target, 0.1, Vec3(0.0), 0});
    for (int i = 1; i < 500; ++i) {
        const DeviceSample sample = bench.tick();
        ASSERT_NEAR(glm::length(sample.position_m), i * 1e-4, 1e-9);
        ASSERT_NEAR(glm::length(glm::cross(sample.position_m, target)), 0.0, 1e-12);
    }
    bench.tick();
    EXPECT_EQ(bench.tick().position_m, target);
}

TEST(SimulatedDevice, push_accelerates_a_hand_towards_push_over_damping) {
    Bench bench(plain_spec());
    bench.hand->command.publish({HandMode::Push, Vec3(0.0), 0.0, Vec3(0.35, 0, 0), 0});
    for (int i = 0; i < 2000; ++i) bench.tick();
    // The resulting speed is 0.35 N minus 0.05 N of dry friction, divided by 3 Ns/m.
    EXPECT_NEAR(bench.truth().velocity_m_per_s.x, 0.1, 1e-4);
    EXPECT_NEAR(bench.truth().velocity_m_per_s.y, 0.0, 1e-12);
}

TEST(SimulatedDevice, holds_still_against_a_light_push_by_dry_friction) {
    Bench bench(plain_spec());
    bench.hand->command.publish({HandMode::Push, Vec3(0.0), 0.0, Vec3(0.049, 0, 0), 0});
    for (int i = 0; i < 1000; ++i) bench.tick();
    EXPECT_EQ(bench.truth().position_m, Vec3(0.0));
}

TEST(SimulatedDevice, rest_uses_a_soft_spring_and_follow_a_stiff_one) {
    for (const auto& [mode, stiffness] : {std::pair{HandMode::Rest, 20.0}, std::pair{HandMode::Follow, 300.0}}) {
        Bench bench(plain_spec());
        bench.hand->command.publish({mode, Vec3(0.0), 0.0, Vec3(0.0), 0});
        for (int i = 0; i < 5000; ++i) bench.tick(Vec3(0, 1, 0));
        // The motors push with 1 N. The dry friction, which may act in either direction, adds to that force or reduces
        // it.
        EXPECT_NEAR(bench.truth().position_m.y, 1.0 / stiffness, 0.0501 / stiffness);
    }
}

TEST(SimulatedDevice, follows_its_target_with_little_overshoot) {
    Bench bench(plain_spec());
    bench.hand->command.publish({HandMode::Follow, Vec3(0.02, 0, 0), 0.0, Vec3(0.0), 0});
    double farthest = 0.0;
    for (int i = 0; i < 4000; ++i) farthest = std::max(farthest, bench.tick().position_m.x);
    EXPECT_NEAR(bench.truth().position_m.x, 0.02, 2e-4);
    EXPECT_GT(farthest, 0.019);
    // The damping ratio 18 / (2 sqrt(300 * 0.4)) = 0.82 gives an overshoot of exp(-pi 0.82 / sqrt(1 - 0.82^2)) = 1.1 %.
    // Dry friction reduces the overshoot.
    EXPECT_LT(farthest, 0.02 * 1.012);
}

TEST(SimulatedDevice, positions_are_quantised_in_encoder_steps_near_the_true_position) {
    const DeviceSpec& spec = *find_device_spec("sim-t");
    Bench bench(spec);
    bench.hand->command.publish({HandMode::Push, Vec3(0.0), 0.0, Vec3(0.3, 0.2, -0.1), 0});
    for (int i = 0; i < 300; ++i) {
        const Vec3 measured = bench.tick().position_m;
        const Vec3 truth = bench.truth().position_m;
        for (int axis = 0; axis < 3; ++axis) {
            const double steps = measured[axis] / spec.encoder_quantum_m;
            ASSERT_NEAR(steps, std::round(steps), 1e-9);
            ASSERT_LE(std::abs(measured[axis] - truth[axis]), 0.5 * spec.encoder_quantum_m * (1 + 1e-9));
        }
    }
}

TEST(SimulatedDevice, stops_at_the_end_of_its_reach) {
    const DeviceSpec& spec = *find_device_spec("sim-f");
    Bench bench(spec);
    bench.hand->command.publish({HandMode::Push, Vec3(0.0), 0.0, Vec3(3, 0, 0), 0});
    for (int i = 0; i < 1000; ++i) bench.tick();
    EXPECT_NEAR(bench.truth().position_m.x, spec.workspace_radius_m, 1e-12);
    EXPECT_EQ(bench.truth().velocity_m_per_s, Vec3(0.0));
}

TEST(SimulatedDevice, delays_the_effect_of_a_force_by_its_latency) {
    DeviceSpec spec = plain_spec();
    spec.delay_s = 2e-3;
    Bench bench(spec);
    bench.hand->command.publish({HandMode::Push, Vec3(0.0), 0.0, Vec3(0.0), 0});
    bench.tick(Vec3(1, 0, 0));
    bench.tick(Vec3(1, 0, 0));
    EXPECT_EQ(bench.truth().position_m.x, 0.0);
    bench.tick(Vec3(1, 0, 0));
    EXPECT_GT(bench.truth().position_m.x, 0.0);
}

TEST(SimulatedDevice, has_exactly_the_configured_faults) {
    Bench bench(*find_device_spec("sim-t"));
    bench.hand->command.publish({HandMode::Move, Vec3(0.01, 0, 0), 0.0, Vec3(0.0), 0});
    bench.tick();
    DeviceTrouble trouble;
    trouble.not_a_number_samples = 2;
    bench.hand->trouble.publish(trouble);
    EXPECT_FALSE(is_finite(bench.tick().position_m));
    EXPECT_FALSE(is_finite(bench.tick().position_m));
    EXPECT_EQ(bench.tick().position_m, Vec3(0.01, 0, 0));
    trouble = {};
    trouble.jump_samples = 1;
    trouble.jump_m = Vec3(0, 0.05, 0);
    bench.hand->trouble.publish(trouble);
    EXPECT_EQ(bench.tick().position_m, Vec3(0.01, 0.05, 0));
    EXPECT_EQ(bench.tick().position_m, Vec3(0.01, 0, 0));
    trouble = {};
    trouble.silent_samples = 3;
    bench.hand->trouble.publish(trouble);
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(bench.tick().fresh);
    EXPECT_TRUE(bench.tick().fresh);
    trouble = {};
    trouble.unplugged = true;
    bench.hand->trouble.publish(trouble);
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(bench.tick().connected);
    bench.hand->trouble.publish(DeviceTrouble{});
    EXPECT_TRUE(bench.tick().connected);
}

TEST(SimulatedDevice, gives_bit_identical_samples_for_identical_commands) {
    const auto run = [] {
        Bench bench(*find_device_spec("sim-f"));
        std::vector<Vec3> seen;
        for (int i = 0; i < 2000; ++i) {
            if (i % 17 == 0)
                bench.hand->command.publish(
                    {HandMode::Follow, Vec3(0.001 * (i % 13), 0.002 * (i % 5), 0), 0.0, Vec3(0.0), 0});
            seen.push_back(bench.tick(Vec3(0.1 * (i % 3), 0, -0.2)).position_m);
        }
        return seen;
    };
    EXPECT_EQ(run(), run());
}

// Right, forward and up on the device must be east, north and up in the world.
TEST(SimulatedDevice, right_forward_up_are_east_north_up_and_a_force_to_the_east_pushes_right) {
    for (int axis = 0; axis < 3; ++axis) {
        auto hand = std::make_shared<SimulatedHand>();
        SimulatedDevice device(*find_device_spec("sim-t"), hand);
        ASSERT_TRUE(device.open());
        HandCommand command;
        command.mode = HandMode::Move;
        command.target_m[axis] = 0.01;
        hand->command.publish(command);
        device.read(0.0);
        const DeviceSample seen = device.read(0.001);
        const test::ThroughWorld through = test::through_world(device.spec(), seen.position_m, axis);
        test::expect_east_north_up(through, axis, 0.01, 1e-12);
        command.mode = HandMode::Push;
        hand->command.publish(command);
        Vec3 last = seen.position_m;
        for (int i = 2; i < 60; ++i) {
            device.write(through.command);
            last = device.read(0.001 * i).position_m;
        }
        EXPECT_GT(last[axis], 0.0101) << axis;
    }
}

}  // namespace simulated_device_test
}  // namespace handrail
