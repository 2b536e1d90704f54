// Tests the list of storeys: the name of each storey, its number of rooms, and how to get there.
#include <gmock/gmock.h>

#include "app/core/whereabouts/storeys.h"
#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/real_worlds.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"
#include "tests/unit/core/hall_with_lift.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace storeys_test {

using test::AppSession;
using testing::HasSubstr;

struct Visitor : AppSession {
    explicit Visitor(std::shared_ptr<const Scene> scene) {
        app.apply(WorldEntered{make_ready(std::move(scene))}, 0.0);
        run(0.1);
        request(Command::Exits);
        run(0.1);
    }
    std::vector<ListItem> storeys() {
        request(Command::Storeys);
        return app.dialogue().view().items;
    }
    // Returns the middle of the first room that is at least this high above the ground.
    Vec3 room_above(double least_m) {
        const auto rooms = app.view({}).rooms;
        for (const DrawnRoom& room : *rooms)
            if (room.middle_m.z > least_m && room.area_m2 > 6.0) return room.middle_m;
        ADD_FAILURE() << "no room above " << least_m;
        return Vec3(0.0);
    }
};

TEST(Storeys, of_the_house_are_listed_from_below_with_their_rooms_and_the_current_one_marked) {
    Visitor s(test::our_world("house.map"));
    const std::vector<ListItem> storeys = s.storeys();
    ASSERT_EQ(storeys.size(), 2U);
    EXPECT_EQ(storeys[0].name, "Storey 1");
    EXPECT_EQ(storeys[1].name, "Storey 2");
    EXPECT_THAT(storeys[0].value, HasSubstr(" rooms, you are here"));
    EXPECT_THAT(storeys[1].value, testing::EndsWith(" rooms"));
    EXPECT_EQ(s.app.dialogue().view().at, 0U) << "the list begins at one's own";
    // The numbers are the same as in the description of the whole building.
    s.app.apply(KeyTapped{"Escape"}, s.now);
    const std::string whole = s.request(Command::Overview);
    const std::string upper = storeys[1].value, lower = storeys[0].value.substr(0, storeys[0].value.find(','));
    EXPECT_THAT(whole, HasSubstr("from the lowest up: " + lower + ", " + upper));
}

TEST(Storeys, are_walked_to_by_the_route_to_their_nearest_room) {
    for (const char* language : {"en", "de"}) {
        const test::InLanguage spoken(language);
        Visitor s(test::our_world("house.map"));
        ASSERT_EQ(s.storeys().size(), 2U);
        const std::string way = s.line("2");
        const std::string to = phrase("rooms.way", {{"goal", "|"}, {"route", ""}});
        EXPECT_THAT(way, testing::StartsWith(to.substr(0, to.find('|')))) << way;
        EXPECT_FALSE(s.app.dialogue().is_open());
        // The person follows this route like any other route to a room.
        EXPECT_NE(s.request(Command::RestOfRoute), phrase("way.none"));
    }
}

TEST(Storeys, that_the_walker_is_on_are_described_with_their_rooms) {
    Visitor s(test::our_world("house.map"));
    s.storeys();
    const std::string here = s.line("1");
    EXPECT_THAT(here, HasSubstr("You are on Storey 1. Its rooms: "));
    EXPECT_THAT(here, HasSubstr("Kitchen"));
    EXPECT_THAT(s.request(Command::RestOfRoute), HasSubstr(phrase("way.none"))) << "nobody is led";
}

TEST(Storeys, are_announced_with_the_first_room_on_arrival_and_not_again) {
    Visitor s(test::our_world("house.map"));
    s.news();
    s.app.apply(Placed{s.room_above(2.0), 0.0}, s.now);
    s.run(0.5);
    const std::string up = s.news();
    EXPECT_THAT(up, HasSubstr("House with a garden, storey 2 of 2: ")) << up;
    s.app.apply(Placed{s.app.feet_m(), 1.0}, s.now);
    s.run(0.5);
    EXPECT_THAT(s.news(), testing::Not(HasSubstr("storey 2 of 2")));
    s.request(Command::Home);
    s.run(0.5);
    EXPECT_THAT(s.news(), HasSubstr("House with a garden, storey 1 of 2: "));
}

TEST(Storeys, have_the_names_of_the_file_and_a_lift_under_the_walker_rides_to_the_chosen_one) {
    Visitor s(test::hall_with_lift());
    s.walk(4.0);
    s.tap(Command::Use);
    s.run(1.5);
    s.walk(2.5);
    ASSERT_GT(s.app.feet_m().y, 6.4) << "in the cabin";
    const std::vector<ListItem> storeys = s.storeys();
    ASSERT_EQ(storeys.size(), 3U);
    EXPECT_EQ(storeys[2].name, "Level 2");
    EXPECT_THAT(s.line("level 2"), HasSubstr("Lift goes to Level 2."));
    s.run(14.0);
    EXPECT_NEAR(s.app.feet_m().z, 6.0, 0.02) << "past Level 1 without a stop";
    EXPECT_TRUE(s.heard("Lift stops: Level 2"));
    s.storeys();
    EXPECT_THAT(s.line("level 2"), HasSubstr("You are on Level 2")) << "where it stands it does not go";
    s.storeys();
    EXPECT_THAT(s.line("level 1"), HasSubstr("Lift goes to Level 1."));
    s.run(10.0);
    EXPECT_NEAR(s.app.feet_m().z, 3.0, 0.02);
}

TEST(Storeys, of_architects_models_are_those_that_contain_rooms) {
    const test::TemporaryFolder folder;
    const auto office = folder.write("office.ifc", test::office_ifc({2, 1, 2}).text);
    for (const auto& path : test::with_real_worlds({office}, {"duplex-apartment.ifc"})) {
        Visitor s(test::world_in(path));
        const std::vector<ListItem> storeys = s.storeys();
        ASSERT_GE(storeys.size(), 2U) << path;
        EXPECT_EQ(storeys[0].name, "Level 1") << path;
        EXPECT_EQ(storeys[1].name, "Level 2") << path;
        for (const ListItem& storey : storeys) std::cout << storey.name << ", " << storey.value << "\n";
    }
}

}  // namespace storeys_test
}  // namespace handrail
