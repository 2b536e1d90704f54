// Checks that the hand's side of movable bodies neither allocates nor frees memory. The test counts every call of
// operator new and delete in this program.
#include "haptic/servo/servo_tick.h"
#include "tests/support/count_allocations.h"
#include "tests/support/names.h"
#include "tests/unit/dynamics/rig.h"

namespace handrail::test {
namespace no_allocation_test {

TEST(BodiesInReach, never_allocate_or_free_in_a_tick) {
    BodyWorldMaker world;
    world.floor();
    world.box({Vec3(0.9, -5, 0), Vec3(1.9, 5, 5)}, kWall);
    BodyNature nature;
    for (int i = 0; i < 6; ++i)
        world.body(i % 2 ? ball_of(0.1) : box_of(0.1), Vec3(0.25 * i - 0.5, 0.02 * i, 0.1), nature);
    HandSetup setup;
    setup.ceiling_n = 2.5;
    const auto moves = world.moves();
    Dynamics engine(moves);
    Hand hand(0, world.felt(), *moves, setup);
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    engine.step(frame, events);
    long during = 0, held = 0, contacts = 0;
    for (int i = 0; i < 4000; ++i) {
        const double now_s = Dynamics::kStep_s + 1e-3 * i;
        const Vec3 goal =
            Vec3(-0.8 + 0.4e-3 * i, 0.1 * std::sin(0.003 * i), 0.12 + 0.1 * std::sin(0.005 * i)) / setup.scale;
        hand.want_grip = i % 900 > 500;
        const long before = allocations;
        hand.hear(frame);
        hand.tick(goal, now_s, 1e-3);
        hand.bodies().turn_held({std::sqrt(0.5), 0, 0, std::sqrt(0.5)});
        hand.bodies().heavy();
        during += allocations - before;
        held += hand.bodies().holds() != kNoBody;
        contacts += hand.touch.contacts.count;
        hand.send_to(engine);
        // The restart makes all earlier contacts invalid, so the hand's side must start again within a tick.
        if (i == 2500) engine.restart();
        while (engine.time_s() + Dynamics::kStep_s <= now_s + 1e-3) engine.step(frame, events);
        events.clear();
    }
    EXPECT_EQ(during, 0);
    EXPECT_GT(held, 50);
    EXPECT_GT(contacts, 100);
}

// Checks the whole servo tick. The hand grips bodies by button and by key and turns them, the workspace jumps, and the
// device stops answering.
TEST(ServoTick, never_allocates_or_frees_with_free_bodies) {
    BodyWorldMaker world;
    world.floor();
    for (int i = 0; i < 6; ++i) world.body(box_of(0.1), Vec3(0.3 * i - 0.8, 0.0, 0.1), BodyNature{});
    const auto moves = world.moves();
    const auto felt = world.felt();
    const DeviceSpec spec = *find_device_spec("sim-t");
    Dynamics engine(moves);
    const auto channel = std::make_shared<HandChannel>();
    HandBodyServo hand(moves, channel, 0, felt->bodies.size());
    ServoState state(spec);
    ServoTuning tuning;
    tuning.touch.world_m_per_hand_m = 20.0;
    tuning.touch.radius_m = 0.04;
    tuning.touch.rated_stiffness_n_per_m = spec.rated_stiffness_n_per_m;
    tuning.bodies.grip_buttons = 1;
    WorkspacePose pose;
    pose.origin_m = Vec3(0.0, 0.0, 0.2);
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    long during = 0, held = 0, touched = 0;
    for (int i = 0; i < 6000; ++i) {
        const double now_s = Dynamics::kStep_s + 1e-3 * i;
        DeviceSample sample;
        sample.connected = sample.homed = true;
        sample.fresh = i % 700 != 3;
        sample.position_m = Vec3(-0.05 + 1.6e-5 * i, 0.004 * std::sin(0.003 * i), -0.004 + 0.004 * std::sin(0.005 * i));
        sample.buttons = i % 900 > 500 ? 1U : 0U;
        tuning.bodies.hold = i % 1300 > 900;
        tuning.bodies.quarters = i / 250;
        if (i == 3500) ++pose.jump;
        pose.time_s = now_s;
        const long before = allocations;
        servo_tick(
            state,
            {.scene = felt.get(), .tuning = tuning, .pose = pose, .sample = sample, .now_s = now_s, .engine = &hand});
        during += allocations - before;
        held += state.tool().holds != kNoBody;
        touched += state.tool().touches();
        if (channel->place.refresh()) engine.place_hand(0, channel->place.read());
        for (HandPush push; channel->pushes.pop(push);) engine.push(0, push);
        while (engine.time_s() + Dynamics::kStep_s <= now_s + 1e-3) {
            engine.step(frame, events);
            channel->frame.publish(frame);
        }
        events.clear();
    }
    EXPECT_EQ(during, 0);
    EXPECT_GT(held, 100);
    EXPECT_GT(touched, 100);
}

}  // namespace no_allocation_test
}  // namespace handrail::test
