// Tests the engine on its own thread and in virtual time. Everything that a caller passes to DynamicsLoop must arrive
// in the engine, and the same calls must give bit-identical results.
#include "haptic/dynamics/dynamics_loop.h"

#include "tests/support/names.h"
#include "tests/unit/dynamics/rig.h"

namespace handrail::test {
namespace dynamics_loop_test {

std::shared_ptr<const DynamicsScene> ball_on_floor() {
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(5, 5, 0)}, kFloor);
    const DynamicsPiece ball = ball_of(0.1), leaf = box_of(0.2);
    BodyNature nature;
    EXPECT_EQ(builder.add_body(std::span(&ball, 1), kThing, 0, {Vec3(0, 0, 0.5), {}, 1.0}, nature), BodyFault::None);
    builder.add_driven(std::span(&leaf, 1), FeatureId{3}, 1, {Vec3(2, 0, 0.2), {}, 1.0});
    return builder.build();
}

// Exchanges with the loop everything that the app, the hands and the sounds exchange with it, in virtual time. Returns
// where the ball is at the end.
Vec3 play(double from_s) {
    auto loop = std::make_unique<DynamicsLoop>(ball_on_floor(), from_s);
    EXPECT_FALSE(loop->step_until(from_s));
    Vec3 at(0.0);
    for (int ms = 1; ms <= 2000; ++ms) {
        const double now = from_s + 1e-3 * ms;
        if (ms > 1000 && ms < 1200) {
            HandPush push;
            push.time_s = now - 1e-3;
            push.dt_s = 1e-3;
            push.body = 0;
            push.game = 1;
            push.force_n = Vec3(3, 0, 0);
            EXPECT_TRUE(loop->pushes(0).push(push));
        }
        loop->place_hand(0, {Vec3(0, 0, 1), 0.02, now});
        if (ms == 1)
            loop->drive(std::make_shared<const std::vector<BodyPose>>(1, BodyPose{{Vec3(2, 1, 0.2), {}, 1.0}, true}));
        loop->step_until(now);
        if (loop->newer_frame_for_app()) at = loop->frame_for_app().things[0].position_m;
    }
    EXPECT_EQ(loop->late_steps(), 0U);
    EXPECT_TRUE(loop->newer_frame(0));
    EXPECT_EQ(loop->frame(0).near_count[0], 1);
    EXPECT_EQ(loop->frame(0).near_count[1], 0) << "hand 1 is not there";
    BodyEvent event;
    bool hit = false;
    while (loop->take_event(event)) hit = hit || event.kind == BodyEvent::Kind::Hit;
    EXPECT_TRUE(hit);
    // A restart must put the ball back to its start.
    EXPECT_TRUE(loop->order({DynamicsLoop::Order::Kind::Restart}));
    loop->step_until(from_s + 2.005);
    loop->newer_frame_for_app();
    EXPECT_EQ(loop->frame_for_app().game, 2U);
    EXPECT_NEAR(loop->frame_for_app().things[0].position_m.z, 0.5, 1e-3);
    return at;
}

TEST(DynamicsLoop, gives_bit_identical_results_in_virtual_time) {
    const Vec3 first = play(0.0);
    EXPECT_GT(first.x, 0.05);
    EXPECT_EQ(play(0.0), first);
}

TEST(DynamicsLoop, skips_time_that_it_cannot_catch_up) {
    auto made = std::make_unique<DynamicsLoop>(ball_on_floor());
    DynamicsLoop& loop = *made;
    EXPECT_TRUE(loop.step_until(10.0));
    EXPECT_NEAR(loop.lost_s(), 10.0 - DynamicsLoop::kMostBehind * Dynamics::kStep_s, 2.0 * Dynamics::kStep_s);
    ASSERT_TRUE(loop.newer_frame_for_app());
    EXPECT_EQ(loop.frame_for_app().number, static_cast<std::uint64_t>(DynamicsLoop::kMostBehind));
    EXPECT_NEAR(loop.frame_for_app().time_s, 10.0, 2.0 * Dynamics::kStep_s);
    EXPECT_FALSE(loop.step_until(10.0));
}

TEST(DynamicsLoop, runs_on_its_own_thread_in_parallel_with_servo_and_audio) {
    SteadyClock clock;
    auto loop = std::make_unique<DynamicsLoop>(ball_on_floor(), clock.now_s());
    loop->start(clock);
    loop->start(clock);  // the second call must change nothing
    const double end_s = clock.now_s() + 30.0;
    std::uint64_t frames = 0;
    bool fell = false, heard = false;
    while (clock.now_s() < end_s && !(fell && heard && frames > 20)) {
        const double now = clock.now_s();
        loop->place_hand(0, {Vec3(0, 0, 1), 0.02, now});
        HandPush push;
        push.time_s = now;
        push.dt_s = 1e-3;
        push.body = 0;
        push.game = 1;
        push.force_n = Vec3(0, 0, -0.1);
        loop->pushes(0).push(push);
        if (loop->newer_frame(0)) {
            ++frames;
            fell = fell || loop->frame(0).things[0].position_m.z < 0.2;
        }
        BodyEvent event;
        while (loop->take_event(event)) heard = true;
        clock.sleep_until_s(now + 1e-3);
    }
    loop->stop();
    loop->stop();
    EXPECT_TRUE(fell);
    EXPECT_TRUE(heard);
    EXPECT_GT(frames, 20U);
    loop->start(clock);  // the loop starts again after the stop
    loop.reset();
}

}  // namespace dynamics_loop_test
}  // namespace handrail::test
