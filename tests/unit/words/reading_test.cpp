// Tests the scenes that the reader makes of sentences about rooms.
#include <gmock/gmock.h>

#include <sstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/words/words_text.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace words_reading_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr const char* kLibrary =
    "Building: Town library.\n"
    "Walls: 0.2 metres thick.\n\n"
    "Hall, 8 by 6 metres. Door outside in the south wall. Window in the west wall.\n"
    "Start in the middle, facing north.\n\n"
    "Corridor, 20 by 2 metres, north of Hall. Door to Hall. Door to Library 12 metres along its left wall.\n"
    "Table by the window ...\n\n"
    "Library, 6 by 5 metres, north of Corridor, 2 metres further east. Window in the north wall. Table by the "
    "window.\n";

Vec2 at_of(const Scene& scene, const std::string& join) {
    for (const StatedPortal& portal : scene.stated->portals) {
        std::string names;
        for (const std::uint32_t r : portal.rooms) names += (names.empty() ? "" : " ") + scene.stated->rooms[r].name;
        if (names == join) return Vec2(portal.place_m);
    }
    ADD_FAILURE() << join;
    return Vec2(1e9);
}

TEST(RoomsInWords, are_placed_next_to_each_other_with_doors_as_stated) {
    const Scene scene = test::read_rooms(kLibrary);
    EXPECT_EQ(scene.name, "Town library");
    EXPECT_EQ(scene.report.format, "rooms");
    const auto [least, most] = test::box_of(*test::room_of(scene, "Corridor"));
    EXPECT_NEAR(least.x, -6.0, 1e-9);
    EXPECT_NEAR(least.y, 6.0, 1e-9);
    EXPECT_NEAR(most.x, 14.0, 1e-9);
    EXPECT_NEAR(test::box_of(*test::room_of(scene, "Library")).first.x, 3.0, 1e-9) << "two metres off the middle";
    EXPECT_THAT(test::joins_of(scene),
                UnorderedElementsAre("door Hall", "door Corridor | Hall", "door Corridor | Library"));
    EXPECT_NEAR(glm::length(at_of(scene, "Corridor Library") - Vec2(6.0, 8.0)), 0.0, 1e-6) << "12 m from its west end";
    EXPECT_NEAR(glm::length(at_of(scene, "Hall Corridor") - Vec2(4.0, 6.0)), 0.0, 1e-6);
    ASSERT_FALSE(scene.starts.empty());
    EXPECT_NEAR(glm::length(scene.starts[0].feet_m - Vec3(4.0, 3.0, 0.0)), 0.0, 1e-6);
    EXPECT_TRUE(scene.starts[0].base);
}

TEST(RoomsInWords, report_a_door_that_is_made_wider_than_stated) {
    const auto simplified = [](const char* wide) {
        return test::read_rooms(
                   std::string("Hall, 5 by 4 metres.\n\nDen, 4 by 4 metres, east of Hall.\nOpening to Hall, ") + wide +
                   " metres wide.\n")
            .report.simplified;
    };
    EXPECT_THAT(simplified("0.4"), testing::Contains(HasSubstr("made 60 centimetres wide")));
    EXPECT_THAT(simplified("0.7"), testing::Not(testing::Contains(HasSubstr("centimetres wide"))));
}

TEST(RoomsInWords, report_the_line_of_a_thing_next_to_something_that_does_not_exist) {
    const Scene scene = test::read_rooms(kLibrary);
    ASSERT_EQ(scene.report.warnings.size(), 1U);
    EXPECT_EQ(scene.report.warnings[0].line, 8);
    EXPECT_THAT(scene.report.warnings[0].sentence(), HasSubstr("no window in Corridor"));
}

TEST(RoomsInWords, can_be_walked_from_room_to_room) {
    const Scene scene = test::read_rooms(kLibrary);
    const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
    for (const StatedRoom& room : scene.stated->rooms)
        EXPECT_TRUE((*ways)->reachable(scene.starts[0].feet_m, room.at_m + Vec3(0.0, -1.0, 0.0))) << room.name;
}

TEST(RoomsInWords, place_a_thing_by_its_window_wall_or_corner) {
    const Scene scene = test::read_rooms(
        "Kitchen, 5 by 4 metres. Door outside. Window in the east wall, 1 metre along.\nTable by the window, made of "
        "wood.\n"
        "Stove in the north-west corner. Bin, 0.4 by 0.4 by 0.6 metres, 1 metre from the west wall and 0.5 metres from "
        "the south wall, clue. Clock, 0.3 by 0.1 by 0.3 metres, against the north wall, 3 metres along, 1.8 metres "
        "above the floor, landmark.\nChair next to Table.\n");
    EXPECT_THAT(scene.report.warnings, IsEmpty());
    const Aabb table = test::thing_of(scene, "Table")->bounds_m, stove = test::thing_of(scene, "Stove")->bounds_m,
               bin = test::thing_of(scene, "Bin")->bounds_m, clock = test::thing_of(scene, "Clock")->bounds_m,
               chair = test::thing_of(scene, "Chair")->bounds_m;
    EXPECT_NEAR(table.max_m.x, 4.94, 1e-6) << "with its back to the wall";
    EXPECT_NEAR(table.centre_m().y, 1.0, 1e-6);
    EXPECT_NEAR(table.size_m().y, 1.2, 1e-6) << "its longer side along it";
    EXPECT_NEAR(stove.min_m.x, 0.06, 1e-6);
    EXPECT_NEAR(stove.max_m.y, 3.94, 1e-6);
    EXPECT_NEAR(bin.min_m.x, 1.06, 1e-6);
    EXPECT_NEAR(bin.min_m.y, 0.56, 1e-6);
    EXPECT_NEAR(clock.min_m.z, 1.8, 1e-6);
    EXPECT_NEAR(clock.centre_m().x, 3.0, 1e-6);
    EXPECT_TRUE(test::thing_of(scene, "Clock")->landmark);
    EXPECT_TRUE(test::thing_of(scene, "Bin")->clue);
    EXPECT_EQ(scene.material(test::thing_of(scene, "Table")->material).name, "wood");
    EXPECT_NEAR(chair.max_m.x, table.min_m.x, 1e-6);
    EXPECT_EQ(test::thing_of(scene, "Chair")->source.line, 4);
}

TEST(RoomsInWords, have_the_same_meaning_in_german_and_english) {
    const Scene english = test::read_rooms(
        "Step: 50 cm.\nStorey: Below, 2.8 metres high.\n"
        "Hall, 8 by 6 metres, wooden floor. Door outside in the south wall, 1.2 metres wide.\n"
        "Cupboard in the north-east corner, landmark. Start in the middle, facing east.\n"
        "Flur, 20 by 2 metres, north of Hall. Open to Hall, 2 metres wide. Sliding door to Library, 12 metres along "
        "the "
        "north wall.\n"
        "Library, 6 by 5 metres, north of Flur, 2 metres further east. Table, 2 by 1 by 0.75 metres, by the door.\n"
        "Stairs, 3 by 6 metres, west of Flur, flush with its south end, stairs to Above. Door to Flur.\n"
        "Storey: Above.\nUpper, 40 by 4 steps, above Flur. Door to Stairs.\n");
    const Scene german = test::read_rooms(
        "Schritt: 50 Zentimeter.\nStockwerk: Below, 2,8 Meter hoch.\n"
        "Hall, 8 mal 6 Meter, Boden aus Holz. Tür nach draußen in der Südwand, 1,2 Meter breit.\n"
        "Schrank in der Nordostecke, Landmarke. Start in der Mitte, Blick nach Osten.\n"
        "Flur, 20 mal 2 Meter, nördlich der Hall. Offen zur Hall, 2 Meter breit. Schiebetür zur Library, 12 Meter "
        "entlang der Nordwand.\n"
        "Library, 6 mal 5 Meter, nördlich vom Flur, 2 Meter weiter nach Osten. Tisch, 2 mal 1 mal 0,75 Meter, neben "
        "der "
        "Tür.\n"
        "Stairs, 3 mal 6 Meter, westlich vom Flur, bündig am südlichen Ende, Treppe nach Above. Tür zum Flur.\n"
        "Stockwerk: Above.\nUpper, 40 mal 4 Schritte, über Flur. Tür zur Stairs.\n");
    EXPECT_THAT(english.report.warnings, IsEmpty());
    for (const Diagnostic& warning : german.report.warnings) ADD_FAILURE() << warning.sentence();
    EXPECT_EQ(test::joins_of(german), test::joins_of(english));
    EXPECT_THAT(test::joins_of(english), ::testing::Contains("door Stairs, Above | Upper"));
    EXPECT_THAT(test::joins_of(english), ::testing::Contains("stairs Stairs, Above | Stairs, Below"));
    ASSERT_EQ(german.solids.size(), english.solids.size());
    for (std::size_t i = 0; i < german.solids.size(); ++i) {
        EXPECT_EQ(german.solids[i].shape.bounds_m.min_m, english.solids[i].shape.bounds_m.min_m) << i;
        EXPECT_EQ(german.solids[i].shape.bounds_m.max_m, english.solids[i].shape.bounds_m.max_m) << i;
    }
    ASSERT_EQ(german.starts.size(), english.starts.size());
    EXPECT_EQ(german.starts[0].heading_rad, english.starts[0].heading_rad);
    EXPECT_NEAR(english.stated->storeys[1].floor_m, 2.8, 1e-9);
}

TEST(RoomsInWords, use_the_step_length_that_the_text_states) {
    const Scene scene = test::read_rooms("Step: 65 centimetres.\nHall, 10 by 8 steps.\n");
    EXPECT_NEAR(test::room_of(scene, "Hall")->area_m2, 6.5 * 5.2, 1e-9);
    EXPECT_THAT(scene.report.guessed, ::testing::Contains(HasSubstr("65 centimetres")));
}

TEST(RoomsInWords, join_all_storeys_between_the_ends_of_stairs_and_lifts) {
    const Scene scene = test::read_rooms(
        "Storey: Ground.\nHall, 8 by 6 metres.\nLift, 2 by 2 metres, west of Hall, lift to Second. Door to Hall.\n"
        "Stairs, 3 by 6 metres, east of Hall, up to Second. Door to Hall.\n"
        "Storey: First.\nOffice, 8 by 6 metres, above Hall. Door to Lift. Door to Stairs.\n"
        "Storey: Second.\nAttic, 8 by 6 metres, above Hall. Door to Lift. Door to Stairs.\n");
    for (const Diagnostic& warning : scene.report.warnings) ADD_FAILURE() << warning.sentence();
    EXPECT_EQ(largest_connected(*scene.stated), static_cast<int>(scene.stated->rooms.size()));
    EXPECT_EQ(scene.stated->lifts, 1);
    const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value());
    EXPECT_TRUE((*ways)->reachable(test::room_of(scene, "Hall")->at_m, test::room_of(scene, "Attic")->at_m));
}

TEST(RoomsInWords, treat_a_door_mentioned_in_both_rooms_as_one_door) {
    const Scene scene = test::read_rooms(
        "Hall, 8 by 6 metres. Door to Study, in the middle of the north wall.\nStudy, 4 by 4 metres, north of Hall. "
        "Door to Hall.\n");
    EXPECT_THAT(test::joins_of(scene), ElementsAre("door Hall | Study"));
}

struct Reported {
    const char *text, *sentence;
    int line;
};

TEST(RoomsInWords, that_cannot_be_placed_are_reported_by_line_with_the_assumption_made) {
    const Reported kReported[] = {
        {"Hall, 8 by 6 metres.\n\nStudy, 4 by 4 metres, north of Hal.\n", "nearest name is Hall", 3},
        {"Hall, 8 by 6 metres.\n\nStudy, 4 by 4 metres.\n", "put east of Hall", 3},
        {"Hall. Door outside.\n", "A size of 4 by 4 metres was assumed", 1},
        {"Hall, 8 by 6 metres. Door to Cellar.\n", "no room called Cellar", 1},
        {"Hall, 8 by 6 metres.\nA, 4 by 4 metres, north of Hall.\nB, 4 by 4 metres, south of Hall. Door to A.\n",
         "B and A share no wall", 3},
        {"Hall, 8 by 6 metres. Door to A in the west wall.\nA, 4 by 4 metres, north of Hall.\n", "wall that they share",
         1},
        {"Hall, 8 by 6 metres. Door outside, 9 metres along the north wall.\n", "8 metres long. The end", 1},
        {"Hall, 8 by 6 metres. Table shimmering in the middle of purple.\n", "purple\" was not understood", 1},
        {"Table in the middle.\nHall, 8 by 6 metres.\n", "before the first room", 1},
        {"Hall, 8 by 6 metres.\n\nA, 4 by 4 metres, corner at 2 metres east and 2 metres north.\n", "overlap", 3},
        {"Hall, 3 by 3 metres. Piano, 4 by 1 by 1 metres, in the middle.\n", "does not fit", 1},
        {"A, 3 by 6 metres, stairs to Heaven.\n", "room without stairs", 1},
        {"A, 3 by 3 metres, north of B.\nB, 3 by 3 metres, north of A.\n", "", 0},
    };
    for (const Reported& reported : kReported) {
        const Scene scene = test::read_rooms(reported.text);
        std::string all;
        bool found = *reported.sentence == '\0';
        for (const Diagnostic& warning : scene.report.warnings) {
            all += warning.sentence() + "\n";
            found |= warning.line == reported.line && warning.sentence().find(reported.sentence) != std::string::npos;
        }
        EXPECT_TRUE(found) << reported.text << reported.sentence << "\n" << all;
    }
}

TEST(RoomsInWords, refuse_a_text_without_rooms_or_with_zero_sizes_in_one_sentence) {
    EXPECT_THAT(read_words("Dear friends.\n# Hall\n", "a.rooms").error().sentence(),
                HasSubstr("does not name any rooms"));
    EXPECT_THAT(read_words(std::string("Hall, 8 by 6\0 metres.", 20), "a.rooms").error().sentence(),
                HasSubstr("it is not text"));
    EXPECT_FALSE(read_words("", "a.rooms").has_value());
}

TEST(RoomsInWords, cut_at_any_byte_become_a_world_or_an_error_sentence) {
    const std::string whole = kLibrary;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        const Result<Scene> scene = read_words(whole.substr(0, at), "cut.rooms");
        if (scene) ASSERT_TRUE(validate(*scene).has_value()) << at;
        else ASSERT_FALSE(scene.error().sentence().empty()) << at;
    }
}

TEST(RoomsInWords, are_read_from_windows_editors_and_in_latin_1) {
    const Scene scene = test::read_rooms(
        "\xEF\xBB\xBFHalle, 8 mal 6 Meter.\r\nK\xFC"
        "che, 4 mal 4 Meter, n\xF6rdlich der Halle.\r\n");
    EXPECT_EQ(test::box_of(*test::room_of(scene, "Küche")).first.y, 6.0);
}

// Returns the example on `page` between the texts `begin` and `end`.
std::string example_of(const std::string& page, const std::string& begin, const std::string& end) {
    const std::string guide = test::content_of(test::project_root() / "docs" / page);
    const std::size_t from = guide.find(begin), to = guide.find(end, from);
    EXPECT_NE(to, std::string::npos) << page;
    if (to == std::string::npos) return {};
    std::string example;
    for (std::istringstream lines(guide.substr(from, to - from)); !lines.eof();) {
        std::string line;
        std::getline(lines, line);
        example += (line.starts_with("    ") ? line.substr(4) : line) + "\n";
    }
    return example;
}

void expect_library(const std::string& example, const std::string& gallery) {
    const Scene scene = test::read_rooms(example);
    for (const Diagnostic& warning : scene.report.warnings) ADD_FAILURE() << warning.sentence();
    EXPECT_EQ(scene.stated->rooms.size(), 6U);
    EXPECT_EQ(largest_connected(*scene.stated), 6);
    EXPECT_EQ(scene.stated->windows.size(), 2U);
    const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value());
    EXPECT_TRUE((*ways)->reachable(scene.starts[0].feet_m, test::room_of(scene, gallery)->at_m));
}

TEST(RoomsInWords, in_the_example_of_the_authors_guide_are_completely_understood) {
    expect_library(example_of("map-authors-guide/words.md", "    Building: Town library.", "A sentence ends with"),
                   "Gallery");
}

TEST(RoomsInWords, in_the_example_of_the_german_guide_are_completely_understood) {
    expect_library(
        example_of("de/autorenhandbuch/raeume-in-worten.md", "    Gebäude: Stadtbücherei.", "Ein Satz endet mit"),
        "Galerie");
}

}  // namespace words_reading_test
}  // namespace handrail
