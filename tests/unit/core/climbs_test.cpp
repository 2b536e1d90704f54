// Tests stairs on which the walker cannot walk: the session announces these stairs at their ends, and the Use key
// climbs them.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/hall_with_lift.h"

namespace handrail {
namespace climbs_test {

using testing::HasSubstr;
using testing::Not;

struct Visit : test::AppSession {
    Visit() {
        app.apply(WorldEntered{make_ready(test::hall_with_narrow_stairs())}, 0.0);
        request(Command::Exits);  // The answer waits until the rooms are known.
    }
    // Goes through the door into the stairwell.
    void go_in() {
        walk(4.0);
        tap(Command::Use);
        run(1.5);
        walk(1.6);
    }
};

TEST(Climbs, stairs_are_announced_on_arrival_and_the_announced_key_takes_them_up_and_down) {
    Visit visit;
    visit.go_in();
    ASSERT_GT(visit.app.feet_m().y, 6.3) << "in the stairwell";
    EXPECT_TRUE(visit.heard("Stairs, 3 metres up, in one go: Enter takes them"));
    visit.run(1.0);
    const std::string up = visit.request(Command::Use);
    EXPECT_THAT(up, HasSubstr("You took the stairs up, 3 metres"));
    EXPECT_NEAR(visit.app.feet_m().z, 3.0, 0.02);
    visit.said.clear();
    visit.run(2.0);
    EXPECT_FALSE(visit.heard("takes them")) << "who has just taken them knows them";
    const std::string down = visit.request(Command::Use);
    EXPECT_THAT(down, HasSubstr("You took the stairs down, 3 metres"));
    EXPECT_NEAR(visit.app.feet_m().z, 0.0, 0.02);
}

TEST(Climbs, the_use_key_opens_the_door_ahead_rather_than_taking_the_stairs_behind) {
    Visit visit;
    visit.app.apply(Placed{{3.0, 6.6, visit.app.feet_m().z}, kPi}, visit.now);
    visit.run(0.5);
    const double floor_m = visit.app.feet_m().z;
    visit.tap(Command::Use);
    visit.run(2.0);
    EXPECT_EQ(visit.app.feet_m().z, floor_m) << visit.said.back();
    EXPECT_TRUE(visit.heard("oor opens")) << visit.said.back();
}

TEST(Climbs, away_from_the_stairs_the_use_key_acts_on_other_things_or_reports_nothing_to_use) {
    Visit visit;
    EXPECT_THAT(visit.request(Command::Use), Not(HasSubstr("stairs")));
    EXPECT_NEAR(visit.app.feet_m().z, 0.0, 0.02);
}

// On the middle storey, one flight begins where the other ends, and a door is equally near.
TEST(Climbs, on_a_route_the_use_key_takes_the_flight_of_that_route_in_its_direction) {
    test::AppSession person;
    person.app.apply(WorldEntered{make_ready(test::hall_with(PlanSpaceKind::Stairs, "Spiral stairs", 1.6, 1.6, 3))},
                     0.0);
    person.request(Command::Exits);
    for (const auto& [from_z_m, to, to_z_m] :
         {std::tuple{0.0, "Hall, Level 2", 6.0}, std::tuple{6.0, "Hall, Level 0", 0.0}}) {
        person.app.apply(Placed{{3.0, 6.6, from_z_m}, kPi}, person.now);
        person.run(0.5);
        person.request(Command::Routes);
        person.line(to);
        for (const double z_m : {3.0, to_z_m}) {
            EXPECT_THAT(person.request(Command::RepeatLeg), HasSubstr("You are standing at them")) << person.news();
            person.request(Command::Use);
            person.run(1.0);
            EXPECT_NEAR(person.app.feet_m().z, z_m, 0.05) << "to " << to << ": " << person.news();
        }
    }
}

TEST(Climbs, are_listed_among_the_exits_and_on_the_route) {
    Visit visit;
    visit.go_in();
    EXPECT_THAT(visit.request(Command::Exits), HasSubstr("Stairs, in one go to Spiral stairs, Level 1"));
}

}  // namespace climbs_test
}  // namespace handrail
