#include "haptic/servo/workspace_map.h"

#include <limits>
#include <random>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace workspace_map_test {

constexpr double kTick = 1e-3;
constexpr double kFrame = 1.0 / 60.0;

TEST(SinCosOfHeading, agrees_with_the_standard_library_in_every_quarter_and_for_large_angles) {
    std::mt19937_64 random(3);
    for (const double range : {1.0, 10.0, 1e3, 1e6}) {
        std::uniform_real_distribution<double> heading(-range, range);
        for (int i = 0; i < 20000; ++i) {
            const double h = heading(random);
            double s = 0, c = 0;
            sin_cos_of_heading(h, s, c);
            const double tolerance = 4e-16 + 1e-16 * range;
            ASSERT_NEAR(s, std::sin(h), tolerance) << h;
            ASSERT_NEAR(c, std::cos(h), tolerance) << h;
        }
    }
    double s = 1, c = 0;
    sin_cos_of_heading(0.0, s, c);
    EXPECT_EQ(s, 0.0);
    EXPECT_EQ(c, 1.0);
}

TEST(WorkspaceFrame, maps_device_forward_to_the_heading_and_scales_lengths_but_not_forces) {
    const WorkspaceFrame north = frame_of(Vec3(1, 2, 3), 0.0);
    EXPECT_EQ(north.to_world(Vec3(0.01, 0.02, 0.03), 60.0), Vec3(1.6, 3.2, 4.8));
    const WorkspaceFrame east = frame_of(Vec3(0.0), kPi / 2);
    // If the person faces east, forward is +x and right is -y.
    EXPECT_NEAR(glm::length(east.to_world(Vec3(0, 1, 0), 2.0) - Vec3(2, 0, 0)), 0.0, 1e-15);
    EXPECT_NEAR(glm::length(east.to_world(Vec3(1, 0, 0), 2.0) - Vec3(0, -2, 0)), 0.0, 1e-15);
    const WorkspaceFrame odd = frame_of(Vec3(0.0), 1.234);
    const Vec3 force(0.3, -0.7, 1.1);
    EXPECT_NEAR(glm::length(odd.turn_to_device(odd.turn_to_world(force)) - force), 0.0, 1e-15);
    EXPECT_NEAR(glm::length(odd.turn_to_world(Vec3(0, 1, 0)) - forward_of_heading(1.234)), 0.0, 1e-15);
    EXPECT_NEAR(glm::length(odd.turn_to_world(Vec3(1, 0, 0)) - right_of_heading(1.234)), 0.0, 1e-15);
}

struct Step {
    double largest_m = 0.0;
    double smallest_m = 1e9;
    double end_lag_m = 0.0;  // distance by which the workspace is behind the walker at the end
};

// A walker moves north at 1 m/s. Frame i reaches the servo `late(i)` seconds after its own time. Returns the steps of
// the workspace in the last two thirds of the walk.
template <class FrameTimes, class Late>
Step walk(double seconds, const FrameTimes& frame_time, const Late& late) {
    PosePlayback playback;
    Step step;
    int next = 0;
    WorkspacePose newest;
    newest.time_s = frame_time(0);
    double last_y = 0.0;
    for (int tick = 0; tick * kTick < seconds; ++tick) {
        const double now = tick * kTick;
        while (frame_time(next) + late(next) <= now) {
            newest.time_s = frame_time(next);
            newest.origin_m = Vec3(0, newest.time_s, 0);
            ++next;
        }
        if (next == 0) continue;
        playback.give(newest, now);
        const double y = playback.at(now, kTick).origin_m.y;
        if (now > seconds / 3) {
            step.largest_m = std::max(step.largest_m, y - last_y);
            step.smallest_m = std::min(step.smallest_m, y - last_y);
        }
        last_y = y;
        step.end_lag_m = now - y;
    }
    return step;
}

TEST(PosePlayback, turns_even_frames_into_one_smooth_movement) {
    const Step step = walk(
        3.0, [](int i) { return i * kFrame; }, [](int) { return 1e-4; });
    EXPECT_NEAR(step.largest_m, 1e-3, 1e-5);
    EXPECT_NEAR(step.smallest_m, 1e-3, 1e-5);
    EXPECT_LT(step.end_lag_m, kFrame + 0.005);
    EXPECT_GT(step.end_lag_m, kFrame);
}

TEST(PosePlayback, stays_smooth_when_frames_jitter) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> jitter(-0.004, 0.004), transit(0.0, 0.003);
    std::vector<double> times, late;
    for (int i = 0; i < 400; ++i) {
        times.push_back(0.01 + i * kFrame + jitter(random));
        late.push_back(transit(random));
    }
    const Step step = walk(
        5.0, [&](int i) { return times[static_cast<size_t>(i)]; }, [&](int i) { return late[static_cast<size_t>(i)]; });
    EXPECT_LE(step.largest_m, 1.1e-3);
    EXPECT_GE(step.smallest_m, 0.9e-3);
}

TEST(PosePlayback, waits_for_a_late_frame_and_continues_without_a_jump) {
    const auto late = [](int i) { return i % 60 == 30 ? 0.03 : 1e-4; };
    const Step step = walk(
        4.0, [](int i) { return i * kFrame; }, late);
    EXPECT_GE(step.smallest_m, 0.0);
    EXPECT_LE(step.largest_m, 1.1e-3 + 1e-12);
}

TEST(PosePlayback, lets_a_resting_body_set_off_without_a_jump) {
    PosePlayback playback;
    WorkspacePose pose;
    pose.time_s = 1.0;
    EXPECT_TRUE(playback.give(pose, 1.0));
    double now = 1.0, last = 0.0;
    for (; now < 6.0; now += kTick) {
        EXPECT_FALSE(playback.give(pose, now));  // the app passes the same pose again on every tick
        EXPECT_EQ(playback.at(now, kTick).origin_m, Vec3(0.0));
    }
    for (int frame = 1; frame <= 60; ++frame) {
        pose.time_s = 6.0 + frame * kFrame;
        pose.origin_m.y = frame * kFrame;
        for (; now < pose.time_s + kFrame; now += kTick) {
            playback.give(pose, now);
            const double y = playback.at(now, kTick).origin_m.y;
            ASSERT_GE(y, last);
            ASSERT_LE(y - last, 1.1e-3 + 1e-12);
            last = y;
        }
    }
    EXPECT_GT(last, 0.9);
}

TEST(PosePlayback, jumps_only_on_request_and_reports_it) {
    PosePlayback playback;
    WorkspacePose pose;
    EXPECT_TRUE(playback.give(pose, pose.time_s));
    pose.time_s = kFrame;
    pose.origin_m = Vec3(5, 0, 0);
    pose.jump = 1;
    EXPECT_TRUE(playback.give(pose, pose.time_s));
    EXPECT_EQ(playback.at(kFrame, kTick).origin_m, Vec3(5, 0, 0));
}

TEST(PosePlayback, turns_the_shorter_way_across_north) {
    PosePlayback playback;
    WorkspacePose pose;
    pose.heading_rad = radians_from_degrees(350.0);
    playback.give(pose, pose.time_s);
    pose.time_s = kFrame;
    pose.heading_rad = radians_from_degrees(10.0);
    playback.give(pose, pose.time_s);
    for (double now = 0.0; now < 0.2; now += kTick) EXPECT_GT(playback.at(now, kTick).forward.y, 0.98);
    EXPECT_NEAR(glm::length(playback.at(0.2, kTick).forward - forward_of_heading(radians_from_degrees(10.0))), 0.0,
                1e-12);
}

TEST(PosePlayback, ignores_invalid_poses_and_poses_from_the_past) {
    PosePlayback playback;
    WorkspacePose pose;
    pose.time_s = 1.0;
    playback.give(pose, pose.time_s);
    WorkspacePose bad = pose;
    bad.origin_m.x = std::numeric_limits<double>::quiet_NaN();
    bad.time_s = 2.0;
    bad.jump = 7;
    EXPECT_FALSE(playback.give(bad, 2.0));
    bad = pose;
    bad.origin_m = Vec3(9, 9, 9);
    bad.time_s = 0.5;
    EXPECT_FALSE(playback.give(bad, 2.0));
    EXPECT_EQ(playback.at(3.0, kTick).origin_m, Vec3(0.0));
}

}  // namespace workspace_map_test
}  // namespace handrail
