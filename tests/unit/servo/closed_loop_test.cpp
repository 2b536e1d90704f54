// Tests the servo with a simulated hand at the grip: how a wall feels to a person who leans on it.
#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_loop.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/servo_rig.h"

namespace handrail {
namespace closed_loop_test {

using test::kTick;

struct ClosedLoop {
    VirtualClock clock;
    std::shared_ptr<SimulatedHand> hand = std::make_shared<SimulatedHand>();
    ServoLoop loop;
    ServoTuning tuning;
    double scale;

    // Makes a plaster wall that is 20 mm of hand travel north of the middle. The proxy is 4 mm wide in hand travel.
    ClosedLoop(const char* device, double world_m_per_hand_m)
        : loop(std::make_unique<SimulatedDevice>(*find_device_spec(device), hand), clock), scale(world_m_per_hand_m) {
        EXPECT_TRUE(loop.open());
        tuning.touch.world_m_per_hand_m = scale;
        tuning.touch.radius_m = 0.002 * scale;
        // The limit is so high that it has no effect: walls are as stiff as the device can render.
        tuning.touch.rated_stiffness_n_per_m = 1e9;
        tuning.touch.default_stiffness_fraction = 0.75;
        tuning.touch.damping_ns_per_m = 5.0;
        tuning.force_ceiling_n = 100.0;
        loop.set_tuning(tuning);
        loop.set_pose({});
        loop.set_scene(test::wall_scene(0.022 * scale));
        // The servo first needs a movement of the hand; then its force ramps up.
        move(Vec3(0, 0, 0.005));
        move(Vec3(0.0));
        run(1.1);
    }
    const ToolState& tick() {
        loop.step();
        clock.advance_s(kTick);
        return loop.tool();
    }
    void run(double seconds) {
        for (int i = 0; i < seconds / kTick; ++i) tick();
    }
    void move(const Vec3& target_m, double speed_m_per_s = 0.1) {
        hand->command.publish({HandMode::Move, target_m, speed_m_per_s, Vec3(0.0), 0});
        run(0.1 + glm::length(target_m) / speed_m_per_s);
    }
};

TEST(ClosedLoop, pressing_3_mm_into_plaster_on_the_simulated_touch_gives_0_9_newtons_without_overshoot) {
    ClosedLoop bench("sim-t", 60.0);
    bench.hand->command.publish({HandMode::Move, Vec3(0, 0.023, 0), 0.1, Vec3(0.0), 0});
    double peak = 0.0;
    for (int i = 0; i < 1300; ++i) peak = std::max(peak, -bench.tick().force_n.y);
    EXPECT_NEAR(-bench.loop.tool().force_n.y, 0.9, 1e-9);
    // The second part is the damping of 5 Ns/m at 0.1 m/s, because the hand still moves.
    EXPECT_LE(peak, 0.9 * 1.2 + 0.5);
    bench.hand->command.publish({HandMode::Move, Vec3(0, 0.015, 0), 0.1, Vec3(0.0), 0});
    double left_s = -1.0;
    for (int i = 0; i < 200; ++i) {
        const ToolState& tool = bench.tick();
        if (tool.hand_m.y <= 0.020) {
            if (left_s < 0.0) left_s = tool.time_s;
            ASSERT_TRUE(tool.time_s - left_s < 0.005 || tool.force_n == Vec3(0.0));
        }
    }
    EXPECT_GT(left_s, 0.0);
}

TEST(ClosedLoop, a_hand_leaning_on_the_stiffest_wall_comes_to_rest) {
    for (const char* device : {"sim-t", "sim-f"})
        for (const double scale : {1.0, 60.0})
            for (const HandMode mode : {HandMode::Push, HandMode::Rest}) {
                SCOPED_TRACE(fmt::format("{} at scale {}, mode {}", device, scale, static_cast<int>(mode)));
                ClosedLoop bench(device, scale);
                bench.hand->command.publish({mode, Vec3(0, 0.02, 0), 0.0, Vec3(0, 2.0, 0), 0});
                bench.run(3.0);
                double low = 1e9, high = -1e9, mean = 0.0;
                for (int i = 0; i < 500; ++i) {
                    const ToolState& tool = bench.tick();
                    low = std::min(low, tool.hand_m.y);
                    high = std::max(high, tool.hand_m.y);
                    mean += -tool.force_n.y / 500;
                }
                EXPECT_LT(high - low, 0.3e-3);
                // The tolerance covers dry friction, the encoder's step and the spring of the resting hand.
                EXPECT_NEAR(mean, 2.0, 0.2);
            }
}

TEST(ClosedLoop, follows_the_mouse_to_the_wall_and_stays_in_front_of_it) {
    ClosedLoop bench("sim-t", 60.0);
    bench.hand->command.publish({HandMode::Follow, Vec3(0, 0.03, 0), 0.0, Vec3(0.0), 0});
    bench.run(2.0);
    // The wall and the simulated hand are springs of 300 N/m each, so each takes half of the 10 mm beyond the wall.
    EXPECT_NEAR(bench.loop.tool().hand_m.y, 0.025, 3e-4);
    EXPECT_NEAR(bench.loop.tool().proxy_m.y, 0.02 * 60.0, 1e-9);
}

}  // namespace closed_loop_test
}  // namespace handrail
