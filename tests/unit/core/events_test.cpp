// Tests the events that a session reports while a person walks through the bundled house.
#include <gtest/gtest.h>

#include "tests/support/names.h"
#include "tests/unit/core/route_walker.h"
#include "worlds/base/text.h"

namespace handrail {
namespace events_test {

TEST(SessionEvents, of_a_walk_through_our_house_report_rooms_doors_the_path_and_teleports) {
    test::AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    s.run(0.1);
    s.request(Command::Exits);  // The answer waits until the rooms are known.
    (void)s.app.take_events();
    ASSERT_TRUE(test::go_to_room(s, "Kitchen", 90.0));
    int rooms = 0, doors = 0;
    std::vector<std::string> led, arrived;
    std::string last;
    for (const SessionEvent& event : s.app.take_events()) {
        if (const auto* entered = std::get_if<RoomEntered>(&event.what)) {
            ++rooms;
            last = entered->name;
        }
        doors += std::holds_alternative<DoorUsed>(event.what) ? 1 : 0;
        if (const auto* to = std::get_if<Led>(&event.what)) led.push_back(to->goal);
        if (const auto* there = std::get_if<Arrived>(&event.what)) {
            arrived.push_back(there->goal);
            EXPECT_EQ(there->by, LedBy::Ear);
            EXPECT_FALSE(there->to_nearest);
        }
        EXPECT_LE(event.time_s, s.now);
    }
    EXPECT_GT(rooms, 0);
    EXPECT_GT(doors, 0);
    EXPECT_EQ(sentence_case(last), "Kitchen");
    ASSERT_FALSE(led.empty());
    EXPECT_EQ(led.front(), "Kitchen");
    EXPECT_EQ(arrived, std::vector<std::string>{"Kitchen"});
    s.app.apply(Placed{{6.0, -4.0, 0.0}, 0.5}, s.now);
    const std::vector<SessionEvent> put = s.app.take_events();
    ASSERT_EQ(put.size(), 1U);
    EXPECT_EQ(std::get<Teleported>(put[0].what).feet_m, Vec3(6.0, -4.0, 0.0));
}

TEST(SessionEvents, report_a_stay_at_a_thing_once_and_a_typed_answer_with_its_question) {
    test::AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    s.run(0.2);
    (void)s.app.take_events();
    const auto visits = [&] {
        std::vector<std::pair<std::string, VisitedBy>> all;
        for (const SessionEvent& event : s.app.take_events())
            if (const auto* visit = std::get_if<ThingVisited>(&event.what))
                all.emplace_back(s.app.scene()->features[visit->feature.value].name, visit->by);
        return all;
    };
    // At the base, the walker faces the stairs from far away. Standing there is not reported as a visit to the stairs,
    // but asking about them is.
    s.run(3.0);
    EXPECT_TRUE(visits().empty());
    s.request(Command::AheadOfMe);
    s.run(0.1);
    const auto requested = visits();
    ASSERT_EQ(requested.size(), 1U);
    EXPECT_EQ(requested[0].second, VisitedBy::Query);
    s.request(Command::AheadOfMe);
    s.run(3.0);
    EXPECT_TRUE(visits().empty()) << "one stay is told once";
    // Walks towards the thing ahead until that thing stops the walker, and then stands still.
    s.hold(Command::Forward, 6.0);
    s.run(3.0);
    const auto faced = visits();
    ASSERT_FALSE(faced.empty());
    EXPECT_EQ(faced.back().second, VisitedBy::Facing);
    s.request(Command::NameRoom);
    s.app.apply(LineTyped{"My hall"}, s.now);
    int answers = 0;
    for (const SessionEvent& event : s.app.take_events())
        if (const auto* answered = std::get_if<Answered>(&event.what)) {
            ++answers;
            EXPECT_EQ(answered->text, "My hall");
            EXPECT_FALSE(answered->question.empty());
        }
    EXPECT_EQ(answers, 1);
}

}  // namespace events_test
}  // namespace handrail
