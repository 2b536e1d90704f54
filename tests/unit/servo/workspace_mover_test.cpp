// Tests how the hand moves its own workspace through the whole servo tick: at the rim, by grabbing, and by keys.
#include "haptic/servo/workspace_mover.h"

#include <gtest/gtest.h>

#include "tests/support/names.h"
#include "tests/support/servo_rig.h"

namespace handrail::test {
namespace workspace_mover_test {

constexpr double kReach = 0.075;  // workspace radius of the simulated Touch

ServoRig rig_with_rim() {
    ServoRig rig;
    rig.scene = wall_scene(100.0);  // the wall is far away
    rig.tuning.workspace.rim = true;
    rig.arm();
    for (int i = 0; i < 1100; ++i) rig.tick(Vec3(0.0));
    return rig;
}

TEST(Rim, consists_of_a_ridge_and_a_nearly_free_zone_without_a_jump_in_force) {
    for (const DeviceSpec& spec : device_specs()) {
        const Rim rim = rim_of(spec);
        SCOPED_TRACE(spec.name);
        EXPECT_EQ(rim.force_n(0.79 * spec.workspace_radius_m), 0.0);
        EXPECT_GT(rim.top_n, 2.0 * rim.beyond_n);
        EXPECT_LE(rim.top_n, 0.5) << "far weaker than a wall";
        EXPECT_LE(rim.top_n / (rim.top_m - rim.from_m), 0.3 * spec.rated_stiffness_n_per_m + 1e-9);
        double last = 0.0;
        for (double part = 0.7; part < 1.2; part += 1e-4) {
            const double force = rim.force_n(part * spec.workspace_radius_m);
            EXPECT_NEAR(force, last, 0.01);
            last = force;
            EXPECT_EQ(rim.speed(part * spec.workspace_radius_m) > 0.0, part * spec.workspace_radius_m > rim.past_m);
        }
        EXPECT_LT(rim.beyond_n, WorkspaceMover::kMovingForceN);
    }
}

TEST(WorkspaceMover, scrolls_faster_deeper_past_the_rim_and_stops_on_the_way_back) {
    ServoRig rig = rig_with_rim();
    rig.go({0.0, 0.92 * kReach, 0.0});
    EXPECT_EQ(rig.tool().workspace_motion, WorkspaceMotion::Scrolled);
    EXPECT_EQ(rig.count(ContactEventKind::RimPassed), 1);
    const auto way_in = [&](double part) {
        const Vec3 before = rig.tool().workspace_shift_m;
        for (int i = 0; i < 200; ++i) rig.tick({0.0, part * kReach, 0.0});
        return rig.tool().workspace_shift_m - before;
    };
    const Vec3 slow = way_in(0.92), fast = way_in(0.97);
    EXPECT_GT(slow.y, 1e-3);
    EXPECT_GT(fast.y, 2.0 * slow.y);
    EXPECT_EQ(fast.x, 0.0);
    EXPECT_EQ(fast.z, 0.0);
    rig.go({0.0, 0.8 * kReach, 0.0});
    EXPECT_EQ(rig.tool().workspace_motion, WorkspaceMotion::Still);
    EXPECT_EQ(rig.count(ContactEventKind::RimLeft), 1);
    EXPECT_EQ(way_in(0.8), Vec3(0.0));
}

TEST(WorkspaceMover, scrolls_in_any_direction_on_the_rim_and_only_if_switched_on) {
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0.6, 0.0, -0.8)}) {
        ServoRig rig = rig_with_rim();
        rig.go(way * (0.97 * kReach));
        for (int i = 0; i < 100; ++i) rig.tick(way * (0.97 * kReach));
        const Vec3 shift = rig.tool().workspace_shift_m;
        EXPECT_GT(glm::dot(shift, way), 1e-3);
        EXPECT_LT(glm::length(shift - way * glm::dot(shift, way)), 1e-9);
        EXPECT_LT(glm::dot(rig.last.force_n, way), 0.0) << "the rim is felt";
    }
    ServoRig off = rig_with_rim();
    off.tuning.workspace.rim = false;
    off.go({0.97 * kReach, 0.0, 0.0});
    EXPECT_EQ(off.tool().workspace_shift_m, Vec3(0.0));
    EXPECT_EQ(off.last.force_n, Vec3(0.0));
}

TEST(WorkspaceMover, does_not_scroll_into_a_wall_but_along_it) {
    ServoRig rig;
    rig.tuning.workspace.rim = true;
    rig.tuning.workspace.limits_m = {Vec3(-50.0), Vec3(50.0)};
    rig.scene = wall_scene(0.1);
    rig.arm();
    const Vec3 hand = glm::normalize(Vec3(1.0, 2.0, 0.0)) * (0.98 * kReach);
    rig.go(hand);
    for (int i = 0; i < 3000; ++i) {
        rig.tick(hand);
        ASSERT_LT(glm::length(rig.last.force_n), WorkspaceMover::kMovingForceN);
        ASSERT_LE(rig.tool().proxy_m.y, 0.095 + 1e-9) << "the ball stays in front of the wall";
    }
    EXPECT_NEAR(rig.tool().proxy_m.y, 0.095, 1e-6) << "and came up to it";
    EXPECT_GT(rig.tool().workspace_shift_m.x, 0.03) << "and went on along it";
}

TEST(WorkspaceMover, never_exceeds_its_limits_and_reports_reaching_them) {
    ServoRig rig = rig_with_rim();
    rig.tuning.workspace.limits_m = {Vec3(-0.05), Vec3(0.05)};
    rig.go({0.99 * kReach, 0.0, 0.0});
    for (int i = 0; i < 3000; ++i) rig.tick({0.99 * kReach, 0.0, 0.0});
    EXPECT_EQ(rig.tool().workspace_shift_m.x, 0.05);
    EXPECT_TRUE(rig.tool().workspace_at_limit);
    // If the walker is outside the bounds, the workspace must stay at the walker. The hand must not move the workspace
    // farther out, but may move it back in.
    rig.pose.origin_m = Vec3(1.0, 0.0, 0.0);
    ++rig.pose.jump;
    rig.go({0.0, 0.0, 0.0});
    rig.go({0.99 * kReach, 0.0, 0.0});
    for (int i = 0; i < 300; ++i) rig.tick({0.99 * kReach, 0.0, 0.0});
    EXPECT_EQ(rig.tool().workspace_shift_m.x, 0.0);
    rig.go({-0.99 * kReach, 0.0, 0.0});
    for (int i = 0; i < 300; ++i) rig.tick({-0.99 * kReach, 0.0, 0.0});
    EXPECT_LT(rig.tool().workspace_shift_m.x, 0.0);
}

TEST(WorkspaceMover, a_grabbed_world_moves_exactly_with_the_hand) {
    ServoRig rig = rig_with_rim();
    rig.tuning.workspace.grab_buttons = 1;
    rig.go({0.01, 0.02, 0.0});
    const Vec3 place = rig.tool().hip_m;
    rig.sample.buttons = 1;
    rig.go({-0.03, -0.02, 0.01});
    EXPECT_LT(glm::length(rig.tool().hip_m - place), 1e-12);
    EXPECT_EQ(rig.count(ContactEventKind::Grabbed), 1);
    EXPECT_EQ(rig.last.force_n, Vec3(0.0));
    rig.sample.buttons = 0;
    rig.go({0.01, 0.02, 0.0});  // after the button is released, the hand moves without the world
    EXPECT_EQ(rig.count(ContactEventKind::LetGo), 1);
    EXPECT_NEAR(glm::length(rig.tool().hip_m - place - Vec3(0.04, 0.04, -0.01)), 0.0, 1e-12);
}

TEST(WorkspaceMover, a_pressed_wall_fades_within_75_ms_before_the_world_moves_and_is_as_hard_as_before) {
    ServoRig rig;
    rig.tuning.workspace.grab_buttons = 2;
    rig.press({0.0, 0.0275, 0.0});  // the hand presses 2.5 mm deep, which gives 2 N
    ASSERT_NEAR(rig.last.force_n.y, -2.0, 0.01);
    rig.sample.buttons = 2;
    double last = 2.0;
    for (int i = 0; i < 75; ++i) {
        rig.tick({0.0, 0.0275, 0.0});
        EXPECT_LE(-rig.last.force_n.y, last + 1e-12);
        EXPECT_GE(-rig.last.force_n.y, last - 0.05);
        last = -rig.last.force_n.y;
    }
    EXPECT_LT(last, WorkspaceMover::kMovingForceN);
    rig.sample.buttons = 0;
    for (int i = 0; i < 1000; ++i) rig.tick({0.0, 0.0275, 0.0});
    const double rests_n = -rig.last.force_n.y;
    EXPECT_LT(rests_n, WorkspaceMover::kMovingForceN) << "nothing winds the wall up again";
    rig.go({0.0, 0.0285, 0.0});
    for (int i = 0; i < 50; ++i) rig.tick({0.0, 0.0285, 0.0});
    EXPECT_NEAR(-rig.last.force_n.y - rests_n, 0.8, 0.008) << "a millimetre deeper at 800 N/m";
}

TEST(WorkspaceMover, keys_move_the_workspace_and_a_jump_resets_it) {
    ServoRig rig = rig_with_rim();
    rig.tuning.workspace.push_hand_m_per_s = {0.0, 0.03, 0.0};
    for (int i = 0; i < 1000; ++i) rig.tick(Vec3(0.0));
    EXPECT_NEAR(rig.tool().workspace_shift_m.y, 0.03, 1e-9);
    EXPECT_EQ(rig.tool().workspace_motion, WorkspaceMotion::Pushed);
    ++rig.pose.jump;
    rig.tuning.workspace.push_hand_m_per_s = Vec3(0.0);
    rig.tick(Vec3(0.0));
    EXPECT_EQ(rig.tool().workspace_shift_m, Vec3(0.0));
    EXPECT_EQ(rig.tool().workspace_jump, rig.pose.jump);
}

}  // namespace workspace_mover_test
}  // namespace handrail::test
