// Tests lifts with more than two halts. They come to each storey when called, and go to the storey that the person
// chooses.
#include <gmock/gmock.h>

#include "app/core/world/mover_play.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/hall_with_lift.h"
#include "worlds/base/human_measures.h"

namespace handrail {
namespace lift_halts_test {

struct Ride : test::AppSession {
    explicit Ride(std::shared_ptr<const Scene> scene) { app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0); }
};

TEST(LiftHalts, include_a_door_between_both_ends_which_the_lift_opens) {
    const auto scene = test::hall_with_lift();
    MoverPlay play;
    play.enter(scene->movers);
    std::uint32_t middle = 0;
    for (std::uint32_t i = 0; i < scene->movers.size(); ++i)
        if (scene->movers[i].lift != kNoMover && std::abs(scene->movers[i].lift_part - 0.5) < 1e-9) middle = i;
    ASSERT_NE(middle, 0U);
    const auto run = [&](double seconds) {
        std::vector<MoverEvent> events;
        for (int i = 0; i < static_cast<int>(60 * seconds); ++i)
            play.tick(
                1.0 / 60.0, [](std::uint32_t, const Placement&, const Placement&) { return Meeting::None; }, events);
    };
    EXPECT_TRUE(play.lift_is_away(middle));
    play.call(middle);
    run(5.0);
    EXPECT_FALSE(play.lift_is_away(middle));
    EXPECT_GT(play.away(middle), 0.9) << "its door is open";
    EXPECT_NEAR(play.at(0).position_m.z - play.at_rest(0).position_m.z, 3.0, 1e-9);
    run(kLiftDoorWait_s + 5.0);
    EXPECT_EQ(play.away(middle), 0.0) << "and shuts by itself";
    play.call(middle);
    run(1.5);
    EXPECT_GT(play.away(middle), 0.9) << "opened again, the lift being there";
    play.set_going(0);
    run(0.5);
    EXPECT_NEAR(play.at(0).position_m.z - play.at_rest(0).position_m.z, 3.0, 1e-9) << "not before its door is shut";
    run(kLiftDoorWait_s + 3.0);
    EXPECT_NEAR(play.at(0).position_m.z - play.at_rest(0).position_m.z, 6.0, 1e-9);
    play.set_going(0);
    run(kLiftDoorWait_s + 7.0);
    EXPECT_NEAR(play.at(0).position_m.z, play.at_rest(0).position_m.z, 1e-9) << "from the highest to the lowest";
}

TEST(LiftHalts, lead_to_the_announced_storey_which_the_key_can_change) {
    Ride ride(test::hall_with_lift());
    ride.walk(4.0);  // The person walks to the door of the lift.
    ride.tap(Command::Use);
    ride.run(1.5);
    ride.walk(2.5);
    ASSERT_GT(ride.app.feet_m().y, 6.4) << "in the cabin";
    ride.tap(Command::Use);
    EXPECT_TRUE(ride.heard("Lift goes to Level 1"));
    ride.run(8.0);
    EXPECT_NEAR(ride.app.feet_m().z, 3.0, 0.02);
    EXPECT_TRUE(ride.heard("Lift stops: Level 1"));
    ride.tap(Command::Use);
    EXPECT_TRUE(ride.heard("Lift goes to Level 2"));
    ride.tap(Command::Use);
    EXPECT_TRUE(ride.heard("Lift goes to Level 0"));
    ride.run(10.0);
    EXPECT_NEAR(ride.app.feet_m().z, 0.0, 0.02);
}

// A route with a lift is announced in stages: leg by leg to the lift, what to do there, and leg by leg behind it.
TEST(LiftHalts, are_reached_and_left_with_directions_leg_by_leg) {
    Ride ride(test::hall_with_lift());
    ride.run(0.5);
    ride.line("route hall, level 1");
    ride.run(0.5);
    EXPECT_TRUE(ride.heard("Straight on. 4 steps, until you meet Lift, 3 metres up.")) << ride.news();
    EXPECT_THAT(ride.request(Command::RestOfRoute), ::testing::HasSubstr("to Hall, Level 1."));
    ride.walk(4.0);
    EXPECT_TRUE(ride.heard("door, shut. ")) << ride.news();
    ride.tap(Command::Use);
    ride.run(1.5);
    ride.walk(2.5);
    EXPECT_THAT(ride.request(Command::RepeatLeg), ::testing::HasSubstr("You are standing in it"));
    ride.tap(Command::Use);
    ride.run(8.0);
    ASSERT_NEAR(ride.app.feet_m().z, 3.0, 0.02) << ride.news();
    const std::string leg = ride.request(Command::RepeatLeg);
    EXPECT_THAT(leg, ::testing::StartsWith("Turn round.")) << ride.news();
    EXPECT_THAT(leg, ::testing::Not(::testing::HasSubstr("in all")));
}

// In the doorway, the door of the lift would touch the walker and open again and again. So the walker steps in.
TEST(LiftHalts, depart_with_a_walker_who_stands_in_the_doorway) {
    for (const double in_m : {0.1, 0.15, 0.2, 0.25}) {
        SCOPED_TRACE(in_m);
        Ride ride(test::hall_with_lift());
        ride.walk(4.0);
        ride.tap(Command::Use);
        ride.run(1.5);
        ride.app.apply(Placed{{3.0, 6.0 + in_m, 0.0}, 0.0}, ride.now);
        ride.run(0.1);
        ride.tap(Command::Use);
        ride.run(12.0);
        if (!ride.heard("Lift goes to Level 1")) continue;  // The walker still stands on the floor before the lift.
        EXPECT_FALSE(ride.heard("touched you")) << ride.news();
        EXPECT_NEAR(ride.app.feet_m().z, 3.0, 0.02) << ride.news();
    }
}

// Under the lintel, the lift would push the walker's head into it. So the walker is moved farther in, and the lift does
// not turn back again and again.
TEST(LiftHalts, allow_boarding_from_the_threshold) {
    for (const double in_m : {0.3, 0.35, 0.4, 0.5}) {
        SCOPED_TRACE(in_m);
        Ride ride(test::hall_with_lift());
        ride.walk(4.0);
        ride.tap(Command::Use);
        ride.run(1.5);
        ride.app.apply(Placed{{3.0, 6.0 + in_m, 0.0}, 0.0}, ride.now);
        ride.run(0.1);
        ride.tap(Command::Use);
        ride.run(9.0);
        EXPECT_FALSE(ride.heard("touched you")) << ride.news();
        EXPECT_NEAR(ride.app.feet_m().z, 3.0, 0.02) << ride.news();
    }
}

}  // namespace lift_halts_test
}  // namespace handrail
