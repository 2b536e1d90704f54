// Things that the app moves sixty times a second, felt a thousand times a second.
#include "haptic/servo/body_playback.h"

#include "tests/support/servo_rig.h"

namespace handrail::test {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;

std::shared_ptr<const HapticScene> crate_scene(double south_face_y) {
    HapticSceneBuilder crate;
    crate.add_box({Vec3(-0.25), Vec3(0.25)}, SurfaceLabel{FeatureId{4}, kDefaultMaterial, false});
    HapticSceneBuilder builder;
    builder.add_body(FeatureId{4}, crate.build(), {Vec3(0.0, south_face_y + 0.25, 0.0), {}, 1.0});
    return builder.build();
}

BodyFrame frame_at(const HapticScene& scene, double south_face_y, double time_s, std::uint64_t number) {
    BodyFrame frame;
    frame.scene = scene.generation;
    frame.number = number;
    frame.time_s = time_s;
    frame.count = 1;
    frame.poses[0].at.position_m = {0.0, south_face_y + 0.25, 0.0};
    return frame;
}

TEST(BodyPlayback, a_crate_pushed_sixty_times_a_second_meets_the_hand_without_a_staircase) {
    ServoRig rig;
    rig.tuning.force_ceiling_n = 100.0;
    rig.scene = crate_scene(0.02);
    rig.arm();
    for (int i = 0; i < 1100; ++i) rig.tick(Vec3(0.0));
    const double speed = -0.1, begin_s = rig.now_s;
    BodyFrame frame = frame_at(*rig.scene, 0.02, begin_s, 1);
    double next_frame_s = begin_s, before = 0.0, largest = 0.0;
    for (int i = 0; i < 250; ++i) {
        rig.now_s += kTick;
        if (rig.now_s >= next_frame_s) {
            next_frame_s += kFrame_s;
            frame = frame_at(*rig.scene, 0.02 + speed * (rig.now_s - begin_s), rig.now_s, frame.number + 1);
            rig.pose.time_s = rig.now_s;
        }
        rig.last = servo_tick(rig.state, rig.scene.get(), rig.tuning, rig.pose, rig.sample, rig.now_s, &frame);
        const double force = -rig.last.force_n.y;
        largest = std::max(largest, std::abs(force - before));
        before = force;
    }
    // 800 N/m at 0.1 m/s is 0.08 N a tick; the playback runs at most a tenth faster than real time. A staircase would step by 1.3 N.
    EXPECT_LE(largest, 0.08 * 1.11);
    EXPECT_GT(before, 2.0);
    EXPECT_EQ(rig.tool().contacts.contacts[0].feature, FeatureId{4});
}

TEST(BodyPlayback, plays_exactly_what_was_given_once_it_stands_still) {
    const auto scene = crate_scene(0.5);
    BodyPlayback playback;
    playback.give(frame_at(*scene, 0.5, 1.0, 1), true);
    EXPECT_EQ(playback.at(*scene, 0.9).poses[0].at.position_m.y, 0.75);
    playback.give(frame_at(*scene, 0.4, 1.0 + kFrame_s, 2), false);
    const BodyPoses half = playback.at(*scene, 1.0 + 0.5 * kFrame_s);
    EXPECT_NEAR(half.poses[0].at.position_m.y, 0.7, 1e-12);
    const std::uint64_t moving = half.number;
    const BodyPoses there = playback.at(*scene, 2.0);
    EXPECT_EQ(there.poses[0].at.position_m.y, 0.65);
    EXPECT_GT(there.number, moving);
    EXPECT_EQ(playback.at(*scene, 2.1).number, there.number) << "nothing moves any more";
}

TEST(BodyPlayback, a_thing_that_stood_long_starts_from_where_it_stood) {
    const auto scene = crate_scene(0.5);
    BodyPlayback playback;
    playback.give(frame_at(*scene, 0.5, 1.0, 1), true);
    playback.at(*scene, 5.0);
    playback.give(frame_at(*scene, 0.49, 5.02, 2), false);
    EXPECT_NEAR(playback.at(*scene, 5.02 - 0.5 * kFrame_s).poses[0].at.position_m.y, 0.745, 1e-12);
}

TEST(BodyPlayback, frames_of_another_scene_are_not_mistaken_for_this_one) {
    const auto first = crate_scene(0.5), second = crate_scene(0.3);
    BodyPlayback playback;
    playback.give(frame_at(*first, 0.5, 1.0, 1), true);
    EXPECT_EQ(playback.at(*first, 1.0).poses.size(), 1U);
    EXPECT_TRUE(playback.at(*second, 1.0).poses.empty()) << "the scene's own places hold";
    playback.give(frame_at(*second, 0.3, 1.1, 2), false);
    EXPECT_EQ(playback.at(*second, 1.2).poses[0].at.position_m.y, 0.55);
}

TEST(BodyPlayback, an_edit_of_the_same_world_does_not_take_the_force_away) {
    ServoRig rig;
    rig.press({0.0, 0.03, 0.0});
    const double pressed = glm::length(rig.last.force_n);
    EXPECT_GT(pressed, 1.0);
    HapticSceneBuilder edited;
    edited.add_box({Vec3(-10.0, ServoRig::kWallY, -10.0), Vec3(10.0, ServoRig::kWallY + 10.0, 10.0)}, SurfaceLabel{ServoRig::kWall, kDefaultMaterial, false});
    edited.add_box({Vec3(5.0), Vec3(6.0)});
    rig.scene = edited.build(rig.scene->world);
    rig.tick({0.0, 0.03, 0.0});
    EXPECT_NEAR(glm::length(rig.last.force_n), pressed, 1e-9);
    rig.scene = wall_scene(ServoRig::kWallY, ServoRig::kWall);  // another world
    rig.tick({0.0, 0.03, 0.0});
    EXPECT_LT(glm::length(rig.last.force_n), 0.1 * pressed);
}

}  // namespace
}  // namespace handrail::test
