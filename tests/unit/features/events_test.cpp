// Tests the facts that features report as events. Each test uses only plain state, without a session.
#include <gmock/gmock.h>

#include "app/core/context/touch_events.h"
#include "app/core/movers/doors.h"
#include "app/core/whereabouts/queries.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace events_test {

std::shared_ptr<const Scene> yard() {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor");
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

TEST(Events, arrive_once_and_in_order) {
    Events events;
    events.report(HelpRequested{Command::Exits}, 1.0);
    events.report(Teleported{{1.0, 2.0, 3.0}, 0.5}, 2.0);
    const std::vector<SessionEvent> reported = events.take();
    ASSERT_EQ(reported.size(), 2U);
    EXPECT_EQ(reported[0].time_s, 1.0);
    EXPECT_EQ(std::get<HelpRequested>(reported[0].what).command, Command::Exits);
    EXPECT_EQ(std::get<Teleported>(reported[1].what).feet_m, Vec3(1.0, 2.0, 3.0));
    EXPECT_TRUE(events.take().empty());
}

TEST(Events, that_are_not_fetched_keep_only_the_newest) {
    Events events;
    const std::size_t more = 10;
    for (std::size_t i = 0; i < Events::kMost + more; ++i)
        events.report(RoomEntered{static_cast<std::uint32_t>(i), {}}, static_cast<double>(i));
    const std::vector<SessionEvent> reported = events.take();
    ASSERT_EQ(reported.size(), Events::kMost);
    for (std::size_t i = 0; i < reported.size(); ++i) ASSERT_EQ(std::get<RoomEntered>(reported[i].what).room, i + more);
}

TEST(Events, report_a_touch_only_when_the_touched_thing_changes) {
    test::PlainSession plain(yard());
    TouchEvents touch(plain.context);
    const auto feel = [&](ToolState& tool, FeatureId feature) {
        tool.contacts.count = feature == kNoFeature ? 0 : 1;
        tool.contacts.contacts[0].feature = feature;
        tool.contacts.strongest = 0;
        tool.contact_n = 1.5;
        touch.tick(0.0);
    };
    feel(plain.hands.tool, FeatureId{3});
    feel(plain.hands.tool, FeatureId{3});
    feel(plain.hands.left_tool, FeatureId{3});
    feel(plain.hands.tool, kNoFeature);
    feel(plain.hands.tool, FeatureId{3});
    const std::vector<SessionEvent> reported = plain.events.take();
    ASSERT_EQ(reported.size(), 3U) << "once each hand, and again after letting go";
    for (const std::size_t i : {0U, 1U, 2U}) {
        const auto& touched = std::get<Touched>(reported[i].what);
        EXPECT_EQ(touched.feature, FeatureId{3});
        EXPECT_EQ(touched.left, i == 1);
        EXPECT_EQ(touched.force_n, 1.5);
    }
}

TEST(Events, report_requested_help_and_no_other_command) {
    test::PlainSession plain(yard());
    Rooms rooms(plain.context);
    Queries queries(plain.context, rooms);
    rooms.enter_world(plain.as_read);
    rooms.tick(0.0);
    EXPECT_TRUE(queries.act(Command::Heading, 1.0));
    EXPECT_FALSE(queries.act(Command::Use, 2.0));
    EXPECT_TRUE(rooms.act(Command::Exits, 3.0));
    std::vector<Command> requested;
    std::vector<double> at_s;
    for (const SessionEvent& event : plain.events.take())
        if (const auto* help = std::get_if<HelpRequested>(&event.what)) {
            requested.push_back(help->command);
            at_s.push_back(event.time_s);
        }
    EXPECT_THAT(requested, testing::ElementsAre(Command::Heading, Command::Exits));
    EXPECT_THAT(at_s, testing::ElementsAre(1.0, 3.0));
}

}  // namespace events_test
}  // namespace handrail
