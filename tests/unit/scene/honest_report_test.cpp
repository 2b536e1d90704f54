// Tests the report on a building whose file states rooms: its counts, and what the user should check first.
#include "worlds/scene/honest_report.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"

#include <functional>
#include <memory>

namespace handrail {
namespace honest_report_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

StatedRoom room(const std::string& name, const std::string& number, int line) {
    StatedRoom room;
    room.name = name;
    room.number = number;
    room.source.line = line;
    room.at_m = {1.0 * line, 2.0, 0.0};
    return room;
}

StatedPortal door(const std::string& name, std::vector<std::uint32_t> rooms, int line) {
    StatedPortal portal;
    portal.name = name;
    portal.rooms = std::move(rooms);
    portal.source.line = line;
    return portal;
}

// Returns a hall, a kitchen and a stairwell, which portals join in a row. The hall also leads outside.
StatedBuilding three_rooms() {
    StatedBuilding stated;
    stated.schema = "IFC4";
    stated.storeys = {{"Cellar", -2.5, 0}, {"Ground floor", 0.0, 3}};
    stated.rooms = {room("Hall", "1", 10), room("Kitchen", "2", 20), room("Stairwell", "3", 30)};
    stated.rooms[2].holds_stairs = true;
    stated.portals = {door("Front door", {0}, 40), door("Kitchen door", {0, 1}, 41), door("Glass door", {1, 2}, 42)};
    stated.windows.resize(4);
    stated.stairs = 1;
    stated.openings = 7;
    stated.openings_cut = 6;
    return stated;
}

Scene scene_of(StatedBuilding stated) {
    Scene scene;
    scene.stated = std::make_shared<const StatedBuilding>(std::move(stated));
    return scene;
}

std::vector<ToCheck> checks(const HonestReport& report) {
    std::vector<ToCheck> what;
    for (const CheckPoint& point : report.check) what.push_back(point.what);
    return what;
}

TEST(HonestReport, counts_what_the_file_states_and_finds_nothing_to_check_in_a_sound_building) {
    Scene scene = scene_of(three_rooms());
    scene.features.resize(3);
    scene.features[1].landmark = true;
    const HonestReport report = honest_report(scene);
    EXPECT_THAT(checks(report), ElementsAre());
    EXPECT_EQ(report.doors_of_two_rooms, 2);
    EXPECT_EQ(report.doors_of_one_room, 1);
    EXPECT_EQ(report.doors_of_no_room, 0);
    EXPECT_EQ(report.openings_uncut, 1);
    EXPECT_EQ(report.largest_connected, 3);
    EXPECT_EQ(honest_sentence(scene, report),
              "This world has 3 rooms on 1 of 2 storeys, 3 doors, 4 windows and one flight of stairs. It also has no "
              "furniture "
              "and one landmark.");
    EXPECT_THAT(
        honest_details(scene, report),
        testing::IsSupersetOf({"The format of the file is IFC4.", "Ground floor, at a height of 0 metres: 3 rooms.",
                               "Openings cut out of walls, floors and roofs: 6 of 7."}));
}

TEST(HonestReport, states_in_words_that_a_building_has_no_rooms_and_no_furniture) {
    StatedBuilding stated;
    stated.storeys = {{"Ground floor", 0.0, 0}};
    const Scene scene = scene_of(std::move(stated));
    EXPECT_THAT(
        honest_sentence(scene, honest_report(scene)),
        HasSubstr("has no rooms on one storey, no doors, no windows and no stairs. It also has no furniture and "
                  "no landmarks."));
    const test::InLanguage german("de");
    EXPECT_THAT(honest_sentence(scene, honest_report(scene)), HasSubstr("Keine Räume auf einem Stockwerk."));
}

TEST(HonestReport, finds_each_kind_of_planted_fault_at_its_place) {
    struct Planted {
        ToCheck what;
        const char* words;
        int line;
        std::function<void(StatedBuilding&)> plant;
    };
    for (const Planted& planted : {
             Planted{ToCheck::ImpassableDoor, "nobody can get through the door Glass door", 42,
                     [](StatedBuilding& b) { b.portals[2].passable = false; }},
             Planted{ToCheck::DoorToNoRoom, "the door Front door does not lead to any room in the file", 40,
                     [](StatedBuilding& b) { b.portals[0].rooms.clear(); }},
             Planted{ToCheck::OddName, "Room 3 contains stairs, but its name does not say so", 30,
                     [](StatedBuilding& b) { b.rooms[2].name = "Room"; }},
             Planted{ToCheck::RoomWithoutName, "a room has no name", 20,
                     [](StatedBuilding& b) { b.rooms[1].name = b.rooms[1].number = ""; }},
             Planted{ToCheck::DoorCutFree, "something that blocked the door Kitchen door was cut away", 41,
                     [](StatedBuilding& b) { b.portals[1].opened_by_box = true; }},
             Planted{ToCheck::RoomWithoutRoute, "no door or stairs in the file lead to Stairwell 3", 30,
                     [](StatedBuilding& b) { b.portals.pop_back(); }},
         }) {
        SCOPED_TRACE(planted.words);
        StatedBuilding stated = three_rooms();
        planted.plant(stated);
        const Scene scene = scene_of(std::move(stated));
        const HonestReport report = honest_report(scene);
        EXPECT_THAT(checks(report), ElementsAre(planted.what));
        ASSERT_FALSE(report.check.empty());
        EXPECT_EQ(check_words(scene, report.check[0]), planted.words);
        EXPECT_EQ(report.check[0].source.line, planted.line);
        EXPECT_THAT(honest_sentence(scene, report), HasSubstr(std::string("Check this first: ") + planted.words + "."));
    }
}

TEST(HonestReport, names_the_gravest_fault_first_and_the_number_of_further_ones) {
    StatedBuilding stated = three_rooms();
    stated.rooms.push_back(room("Attic", "4", 50));  // no portal leads to the attic
    stated.rooms[2].name = "Room";
    stated.portals[1].passable = false;
    const Scene scene = scene_of(std::move(stated));
    const HonestReport report = honest_report(scene);
    EXPECT_THAT(checks(report), ElementsAre(ToCheck::ImpassableDoor, ToCheck::OddName, ToCheck::RoomWithoutRoute));
    EXPECT_EQ(report.check[1].at_m.x, 30.0) << "where the room is";
    EXPECT_THAT(honest_sentence(scene, report),
                HasSubstr("Check this first: nobody can get through the door Kitchen door; then check 2 more."));
}

TEST(HonestReport, accepts_unusual_room_names_that_mention_stairs) {
    StatedRoom room;
    room.holds_stairs = true;
    for (const char* name : {"Stair", "staircase", "Treppenhaus", "Nottreppe"}) {
        room.name = name;
        EXPECT_FALSE(is_oddly_named(room)) << name;
    }
    room.name = "Room";
    EXPECT_TRUE(is_oddly_named(room));
    room.holds_stairs = false;
    EXPECT_FALSE(is_oddly_named(room));
}

}  // namespace honest_report_test
}  // namespace handrail
