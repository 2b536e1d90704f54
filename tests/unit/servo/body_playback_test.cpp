// Tests the playback of moving bodies. The app moves bodies sixty times a second. The servo must play their movement so
// smoothly that a hand, which the servo renders a thousand times a second, feels no steps.
#include "haptic/servo/body_playback.h"

#include "tests/support/names.h"
#include "tests/support/servo_rig.h"

namespace handrail::test {
namespace body_playback_test {

constexpr double kFrame_s = 1.0 / 60.0;

std::shared_ptr<const HapticScene> crate_scene(double south_face_y) {
    HapticSceneBuilder crate;
    crate.add_box({Vec3(-0.25), Vec3(0.25)}, SurfaceLabel{FeatureId{4}, kDefaultMaterial, false});
    HapticSceneBuilder builder;
    builder.add_body(FeatureId{4}, crate.build(), {Vec3(0.0, south_face_y + 0.25, 0.0), {}, 1.0});
    return builder.build();
}

void push(BodyFrame& frame, const HapticScene& scene, double south_face_y, double time_s) {
    frame.push(scene.generation, time_s, {BodyPose{{Vec3(0.0, south_face_y + 0.25, 0.0), {}, 1.0}, true}});
}

TEST(BodyPlayback, a_crate_pushed_sixty_times_a_second_moves_smoothly_against_the_hand) {
    ServoRig rig;
    rig.tuning.force_ceiling_n = 100.0;
    rig.scene = crate_scene(0.02);
    rig.arm();
    for (int i = 0; i < 1100; ++i) rig.tick(Vec3(0.0));
    const double speed = -0.1, begin_s = rig.now_s;
    BodyFrame frame;
    push(frame, *rig.scene, 0.02, begin_s);
    double next_frame_s = begin_s, before = 0.0, largest = 0.0;
    for (int i = 0; i < 250; ++i) {
        rig.now_s += kTick;
        if (rig.now_s >= next_frame_s) {
            next_frame_s += kFrame_s;
            push(frame, *rig.scene, 0.02 + speed * (rig.now_s - begin_s), rig.now_s);
            rig.pose.time_s = rig.now_s;
        }
        rig.last = servo_tick(rig.state, {rig.scene.get(), rig.tuning, rig.pose, rig.sample, rig.now_s, &frame});
        const double force = -rig.last.force_n.y;
        largest = std::max(largest, std::abs(force - before));
        before = force;
    }
    // At 800 N/m and 0.1 m/s, the force changes by 0.08 N a tick. The playback runs at most a tenth faster than real
    // time. Without the playback, the force would change in steps of 1.3 N.
    EXPECT_LE(largest, 0.08 * 1.11);
    EXPECT_GT(before, 2.0);
    EXPECT_EQ(rig.tool().contacts.contacts[0].feature, FeatureId{4});
}

TEST(BodyPlayback, plays_the_exact_pose_once_the_body_rests) {
    const auto scene = crate_scene(0.5);
    BodyPlayback playback;
    BodyFrame frame;
    push(frame, *scene, 0.5, 1.0);
    EXPECT_EQ(playback.at(frame, *scene, 0.9, true).at(0).at.position_m.y, 0.75);
    push(frame, *scene, 0.4, 1.0 + kFrame_s);
    const BodyPoses half = playback.at(frame, *scene, 1.0 + 0.5 * kFrame_s);
    EXPECT_NEAR(half.at(0).at.position_m.y, 0.7, 1e-12);
    const std::uint64_t moving = half.number;
    const BodyPoses there = playback.at(frame, *scene, 2.0);
    EXPECT_EQ(there.at(0).at.position_m.y, 0.65);
    EXPECT_GT(there.number, moving);
    EXPECT_EQ(playback.at(frame, *scene, 2.1).number, there.number) << "nothing moves any more";
}

TEST(BodyPlayback, a_thing_that_rested_long_starts_from_where_it_rested) {
    const auto scene = crate_scene(0.5);
    BodyPlayback playback;
    BodyFrame frame;
    push(frame, *scene, 0.5, 1.0);
    playback.at(frame, *scene, 5.0, true);
    push(frame, *scene, 0.49, 5.02);
    EXPECT_NEAR(playback.at(frame, *scene, 5.02 - 0.5 * kFrame_s).at(0).at.position_m.y, 0.745, 1e-12);
}

TEST(BodyPlayback, frames_of_another_scene_are_ignored) {
    const auto first = crate_scene(0.5), second = crate_scene(0.3);
    BodyPlayback playback;
    BodyFrame frame;
    push(frame, *first, 0.5, 1.0);
    EXPECT_TRUE(playback.at(frame, *first, 1.0, true).know(0));
    EXPECT_FALSE(playback.at(frame, *second, 1.0).know(0)) << "the scene's own places hold";
    push(frame, *second, 0.3, 1.1);
    EXPECT_EQ(playback.at(frame, *second, 1.2).at(0).at.position_m.y, 0.55);
}

TEST(BodyPlayback, reports_the_moving_bodies_with_numbered_paths_that_continue_the_previous_ones) {
    HapticSceneBuilder crate;
    crate.add_box({Vec3(-0.25), Vec3(0.25)});
    const auto shape = crate.build();
    HapticSceneBuilder builder;
    for (int b = 0; b < 3; ++b)
        builder.add_body(FeatureId{static_cast<std::uint32_t>(b)}, shape, {Vec3(b, 0.0, 0.0), {}, 1.0});
    const auto scene = builder.build();
    std::vector<BodyPose> poses;
    for (const HapticBody& body : scene->bodies) poses.push_back({body.start, true});
    BodyFrame frame;
    BodyPlayback playback;
    frame.push(scene->generation, 1.0, poses);
    const std::uint64_t begin = playback.at(frame, *scene, 1.0, true).ways->number;
    poses[1].at.position_m.z = 1.0;
    frame.push(scene->generation, 1.02, poses);
    poses[2].present = false;
    frame.push(scene->generation, 1.04, poses);
    const BodyPaths first = *playback.at(frame, *scene, 1.01).ways;
    const BodyPoses poses_then = playback.at(frame, *scene, 1.03);
    const BodyPaths second = *poses_then.ways;
    ASSERT_EQ(first.moving.size(), 1U);
    EXPECT_EQ(first.moving[0].body, 1U);
    EXPECT_EQ(first.number_before, begin);
    ASSERT_EQ(second.moving.size(), 1U);
    EXPECT_EQ(second.moving[0].body, 2U);
    EXPECT_EQ(second.number_before, first.number);
    EXPECT_TRUE(poses_then.at(2).present);
    EXPECT_FALSE(playback.at(frame, *scene, 1.05).at(2).present);
    EXPECT_EQ(playback.at(frame, *scene, 1.06).ways->number, second.number) << "at rest at the end of its ways";
}

TEST(BodyPlayback, editing_the_world_keeps_the_force) {
    ServoRig rig;
    rig.press({0.0, 0.03, 0.0});
    const double pressed = glm::length(rig.last.force_n);
    EXPECT_GT(pressed, 1.0);
    HapticSceneBuilder edited;
    edited.add_box({Vec3(-10.0, ServoRig::kWallY, -10.0), Vec3(10.0, ServoRig::kWallY + 10.0, 10.0)},
                   SurfaceLabel{ServoRig::kWall, kDefaultMaterial, false});
    edited.add_box({Vec3(5.0), Vec3(6.0)});
    rig.scene = edited.build(rig.scene->world);
    rig.tick({0.0, 0.03, 0.0});
    EXPECT_NEAR(glm::length(rig.last.force_n), pressed, 1e-9);
    rig.scene = wall_scene(ServoRig::kWallY, ServoRig::kWall);  // the scene changes to that of another world
    rig.tick({0.0, 0.03, 0.0});
    EXPECT_LT(glm::length(rig.last.force_n), 0.1 * pressed);
}

}  // namespace body_playback_test
}  // namespace handrail::test
