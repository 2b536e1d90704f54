// Tests features of the session. Each test uses only plain state, without a session.
#include <gmock/gmock.h>

#include "app/core/movers/doors.h"
#include "app/core/movers/triggers.h"
#include "app/core/whereabouts/queries.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace features_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Returns a floor with a pillar 3 m north of the base and a pool around the pillar.
std::shared_ptr<const Scene> yard() {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor");
    builder.box({-0.5, 3.0, 0.0}, {0.5, 4.0, 2.0}, "pillar");
    builder.box({-2.0, 2.0, 0.0}, {2.0, 5.0, 0.3}, "pool", SolidRole::Liquid, {}, FeatureKind::Liquid);
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

TEST(Features, answer_ahead_of_me_without_a_full_session) {
    test::PlainSession plain(yard());
    Rooms rooms(plain.context);
    Queries queries(plain.context, rooms);
    EXPECT_TRUE(queries.act(Command::AheadOfMe, 0.0));
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("illar")));
    plain.avatar.heading_rad = plain.avatar.heading_goal_rad = kPi;
    EXPECT_TRUE(queries.act(Command::Heading, 0.0));
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("south")));
    EXPECT_FALSE(queries.act(Command::Use, 0.0)) << "another's command";
    EXPECT_THAT(plain.said(), IsEmpty());
}

TEST(Features, use_nothing_if_nothing_is_in_reach) {
    test::PlainSession plain(yard());
    Doors doors(plain.context, plain.world, plain.avatar);
    EXPECT_TRUE(doors.act(Command::Use, 0.0));
    EXPECT_EQ(plain.said().size(), 1U);
    EXPECT_FALSE(doors.act(Command::Exits, 0.0)) << "another's command";
    EXPECT_FALSE(doors.take_arrived());
}

TEST(Features, announce_a_liquid_once_each_time_the_body_enters_it) {
    test::PlainSession plain(yard());
    Triggers triggers(plain.context, plain.world);
    triggers.tick(0.0);
    EXPECT_THAT(plain.said(), IsEmpty());
    for (int time = 0; time < 2; ++time) {
        plain.avatar.walker->place({0.0, 2.5, 0.0});
        triggers.tick(1.0);
        EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("ool")));
        triggers.tick(1.1);
        EXPECT_THAT(plain.said(), IsEmpty()) << "still in it";
        plain.avatar.walker->place({0.0, 0.0, 0.0});
        triggers.tick(2.0);
        EXPECT_THAT(plain.said(), IsEmpty());
    }
}

TEST(Features, know_the_rooms_from_the_tick_on_which_they_are_found) {
    test::PlainSession plain(yard());
    Rooms rooms(plain.context);
    EXPECT_FALSE(rooms.looked_for());
    EXPECT_FALSE(rooms.known()) << "in no world";
    rooms.enter_world(plain.as_read);
    EXPECT_TRUE(rooms.awaited());
    EXPECT_FALSE(rooms.known()) << "before the next tick";
    rooms.tick(0.0);
    EXPECT_TRUE(rooms.looked_for());
    EXPECT_TRUE(rooms.known());
}

}  // namespace features_test
}  // namespace handrail
