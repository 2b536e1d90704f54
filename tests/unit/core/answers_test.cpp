// Tests that typed questions get an answer of one sentence, and that the answer is true of the world.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/real_worlds.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace answers_test {

using test::AppSession;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Visitor : AppSession {
    explicit Visitor(const char* world = "house.map") : Visitor(test::our_world(world)) {}
    explicit Visitor(std::shared_ptr<const Scene> world) {
        app.apply(WorldEntered{make_ready(std::move(world))}, 0.0);
        run(0.1);
        request(Command::Exits);
        run(0.1);
        said.clear();
    }
    // Types a line and returns the last announcement. Fails if a list is open afterwards.
    std::string typed(const std::string& text) {
        const std::string answer = line(text);
        EXPECT_FALSE(app.dialogue().is_open()) << text;
        return answer;
    }
};

TEST(Answers, state_where_things_and_rooms_are) {
    Visitor s;
    EXPECT_THAT(s.typed("where is the sofa"), AllOf(StartsWith("Sofa: "), HasSubstr("Living room")));
    EXPECT_THAT(s.typed("where is the kitchen?"), AllOf(StartsWith("Kitchen: "), HasSubstr("on foot")));
    EXPECT_EQ(s.typed("where is the hall"), "You are in Hall.");
    EXPECT_THAT(s.typed("how far is it to the kitchen"), StartsWith("Kitchen: "));
    EXPECT_EQ(s.typed("which room is the sofa in"), "Sofa is in Living room.");
    EXPECT_THAT(s.typed("fridge?"), StartsWith("Refrigerator: "));
    EXPECT_THAT(s.typed("where is the nearest door"), StartsWith("Front door: 1 step behind"));
}

TEST(Answers, lead_to_no_cabin_of_a_lift_on_the_next_storey) {
    Visitor s("school.map");
    EXPECT_THAT(s.typed("how do I go upstairs"), StartsWith("To Upper corridor. "));
}

TEST(Answers, mean_the_nearest_door_if_every_door_has_the_same_name) {
    const auto file = test::real_world("duplex-apartment.ifc");
    if (!file) GTEST_SKIP() << test::needs_real_world("duplex-apartment.ifc");
    Visitor s(test::world_in(*file));
    EXPECT_EQ(s.typed("which door"), "Door, 2 steps ahead, leads to Foyer.");
    EXPECT_EQ(s.typed("how far is the door"), "Door: 2 steps ahead.");
    EXPECT_THAT(s.typed("how big is this room"), StartsWith("Ground outside: "));
    EXPECT_THAT(s.typed("where is the toilet"), StartsWith("Bathroom "));
}

TEST(Answers, count_what_the_world_contains) {
    Visitor s;
    std::size_t doors = 0;
    for (const Feature& feature : s.app.scene()->features) doors += feature.kind == FeatureKind::Door ? 1 : 0;
    EXPECT_EQ(s.typed("how many doors are there"), fmt::format("There are {} doors.", doors));
    EXPECT_EQ(s.typed("how many storeys are there"), "There are 2 storeys.");
    EXPECT_EQ(s.typed("how many rooms"), "There are 13 rooms.");
    EXPECT_THAT(s.typed("list the rooms"), AllOf(StartsWith("13 rooms: "), HasSubstr("and 1 more")));
}

TEST(Answers, state_whether_a_door_is_open_and_where_it_leads) {
    Visitor s;
    EXPECT_EQ(s.typed("is the front door open"), "Front door is shut.");
    EXPECT_EQ(s.typed("is the door open"), "Front door is shut.");
    EXPECT_THAT(s.typed("where does this door lead"), AllOf(StartsWith("Front door, "), HasSubstr("leads to Garden")));
    s.request(Command::Use);
    s.run(5.0);
    EXPECT_EQ(s.typed("is the front door open"), "Front door is open.");
}

TEST(Answers, describe_what_is_above_below_and_around) {
    Visitor s;
    EXPECT_THAT(s.typed("what is upstairs"), AllOf(StartsWith("Storey 2, 6 rooms: "), HasSubstr("Landing")));
    EXPECT_EQ(s.typed("what is above me"), "Above you: Landing.");
    EXPECT_EQ(s.typed("what is below me"), "No room is below you.");
    EXPECT_EQ(s.typed("what is downstairs"), "There is no storey below this one.");
    EXPECT_EQ(s.typed("which floor am i on"), "You are on storey 1 of 2.");
    EXPECT_THAT(s.typed("what is behind me"), StartsWith("Behind: Front door"));
    EXPECT_THAT(s.typed("how big is this room"), StartsWith("Hall: "));
    EXPECT_THAT(s.typed("what is in the kitchen"), AllOf(StartsWith("Kitchen: "), HasSubstr("Refrigerator")));
}

TEST(Answers, name_the_rooms_above_and_below_a_room) {
    Visitor s;
    const std::string above = s.typed("what is above the kitchen");
    EXPECT_THAT(above, StartsWith("Above Kitchen: "));
    EXPECT_THAT(s.typed("which rooms are below the landing?"), AllOf(StartsWith("Below Landing: "), HasSubstr("Hall")));
    EXPECT_EQ(s.typed("what is below the kitchen"), "No room is below Kitchen.");
    EXPECT_EQ(s.request(Command::AboveBelow), "Above you: Landing. No room is below you.");
}

TEST(Answers, say_how_a_corridor_runs_and_what_is_at_its_ends) {
    Visitor s("school.map");
    const std::string runs = s.typed("how long is the lower corridor");
    EXPECT_THAT(runs, AllOf(StartsWith("Lower corridor: "), HasSubstr(" It runs "),
                            HasSubstr(" from west to east, with "), HasSubstr("West end: "), HasSubstr("East end: ")));
    EXPECT_THAT(s.typed("describe the lower corridor"), HasSubstr(runs.substr(runs.find("It runs"))));
    EXPECT_THAT(s.typed("where does the lower corridor run"), runs);
    EXPECT_THAT(s.typed("how big is the library"), ::testing::Not(HasSubstr("It runs")));
}

// Returns an office of two storeys. An older and a newer kind of zone divide its rooms into two wings; a third zone has
// all rooms.
std::string office_with_wings() {
    std::string text = test::office_ifc({2, 1, 4}).text;
    std::vector<std::string> spaces;
    for (std::size_t at = text.find("=IFCSPACE("); at != std::string::npos; at = text.find("=IFCSPACE(", at + 1))
        spaces.push_back(text.substr(text.rfind('#', at), at - text.rfind('#', at)));
    const auto half = spaces.begin() + static_cast<std::ptrdiff_t>(spaces.size() / 2);
    const std::vector<std::string> east(spaces.begin(), half), west(half, spaces.end());
    const std::string lines = fmt::format(
        "#900000=IFCZONE('z0',$,'All',$,$);\n"
        "#900001=IFCRELASSIGNSTOGROUP('z1',$,$,$,({}),$,#900000);\n"
        "#900002=IFCZONE('z2',$,'East wing',$,$);\n"
        "#900003=IFCRELASSIGNSTOGROUP('z3',$,$,$,({}),$,#900002);\n"
        "#900004=IFCSPATIALZONE('z4',$,'West wing',$,$,$,$,$,$);\n"
        "#900005=IFCRELREFERENCEDINSPATIALSTRUCTURE('z5',$,$,$,({}),#900004);\n",
        fmt::join(spaces, ","), fmt::join(east, ","), fmt::join(west, ","));
    return text.insert(text.rfind("ENDSEC;"), lines);
}

TEST(Answers, name_the_wing_of_a_room_and_the_wings_of_a_building) {
    const test::TemporaryFolder folder;
    Visitor s(test::world_in(folder.write("office.ifc", office_with_wings())));
    const auto& rooms = s.app.scene()->stated->rooms;
    ASSERT_GE(rooms.size(), 8U);
    for (const StatedRoom& room : rooms)
        EXPECT_EQ(room.part, &room < &rooms[rooms.size() / 2] ? "East wing" : "West wing") << room.name;
    const std::string first = s.typed("describe " + rooms.front().name);
    EXPECT_THAT(first, HasSubstr(" It is in East wing. "));
    EXPECT_THAT(s.typed("describe " + rooms.back().name), HasSubstr(" It is in West wing. "));
    EXPECT_THAT(s.request(Command::Overview), HasSubstr("Its parts: East wing, "));
    EXPECT_EQ(s.typed("which wing am i in"), "You are in none of the parts that the file names.");
    s.app.apply(Placed{rooms.front().at_m, 0.0}, s.now);
    s.run(0.2);
    EXPECT_THAT(s.typed("which wing am i in"), HasSubstr(" is in East wing."));
    Visitor house;
    EXPECT_EQ(house.typed("which wing am i in"),
              "The file of this world does not say in which wing or part of the building you are.");
    const test::InLanguage spoken("de");
    Visitor haus;
    EXPECT_THAT(haus.typed("in welchem Flügel bin ich"), StartsWith("Die Datei dieser Welt sagt nicht"));
}

TEST(Answers, lead_to_the_first_room_of_the_next_storey) {
    Visitor s;
    EXPECT_THAT(s.typed("how do i get upstairs"), StartsWith("To Landing."));
    EXPECT_TRUE(s.app.guide().leads());
    EXPECT_EQ(s.typed("take me downstairs"), "There is no storey below this one.");
}

// Types the same requests in two languages: a route, then the beacon on a thing.
struct Running {
    const char *language, *go, *how_far, *on_the_route, *end, *ended, *none, *thing, *beacon_off, *off, *already_off;
};

TEST(Answers, end_what_guides_the_person_and_begin_nothing_in_both_languages) {
    for (const Running& typed :
         {Running{"en", "take me to the kitchen", "how far is it still", "You are on the route to Kitchen: ",
                  "stop following", "You are no longer following a route.", "You are not following a route.", "Piano",
                  "stop the beacon", "Beacon off", "The beacon is already off."},
          Running{"de", "bring mich zur Küche", "wie weit ist es noch", "Du folgst dem Weg zu Küche: noch ",
                  "folgen beenden", "Du folgst keinem Weg mehr.", "Es ist kein Weg gewählt.", "Klavier",
                  "Signal ausschalten", "Signal aus", "Das Signal ist schon aus."}}) {
        const test::InLanguage spoken(typed.language);
        Visitor s;
        EXPECT_EQ(s.typed(typed.end), typed.none);
        s.typed(typed.go);
        s.run(5.0);
        ASSERT_TRUE(s.app.guide().leads());
        EXPECT_THAT(s.typed(typed.how_far), StartsWith(typed.on_the_route));
        EXPECT_EQ(s.typed(typed.end), typed.ended);
        EXPECT_FALSE(s.app.guide().leads());
        EXPECT_EQ(s.typed(typed.beacon_off), typed.already_off);
        EXPECT_FALSE(s.app.guide().leads()) << "a beacon that is off must not begin";
        s.request(Command::SetBeacon);
        if (s.app.dialogue().is_open()) {
            s.line(typed.thing);
            s.line("1");
        }
        ASSERT_TRUE(s.app.guide().beacon().on());
        EXPECT_EQ(s.typed(typed.beacon_off), typed.off);
        EXPECT_FALSE(s.app.guide().leads());
    }
}

TEST(Answers, end_the_learning_of_a_room_only_if_it_has_begun) {
    Visitor s;
    EXPECT_EQ(s.typed("stop learning"), "You are not learning a room.");
    s.request(Command::LearnPlace);
    s.run(1.0);
    s.typed("stop learning");
    EXPECT_EQ(s.typed("stop learning"), "You are not learning a room.");
}

TEST(Answers, come_while_a_list_is_open_and_close_it) {
    Visitor s;
    s.request(Command::Help);
    ASSERT_TRUE(s.app.dialogue().is_open());
    EXPECT_EQ(s.typed("how many storeys are there"), "There are 2 storeys.");
    s.request(Command::Find);
    EXPECT_THAT(s.typed("how far is the kitchen"), StartsWith("Kitchen: "));
}

TEST(Answers, follow_as_soon_as_the_rooms_are_known) {
    AppSession s;
    s.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
    s.run(0.05);
    s.line("how many storeys are there");
    s.run(1.0);
    EXPECT_THAT(s.said, ::testing::Contains("There are 2 storeys."));
}

TEST(Answers, of_questions_that_are_not_understood_state_what_would_have_worked) {
    Visitor s;
    EXPECT_THAT(s.app.question_hint("does the sofa smell of lavender or rather of old socks"),
                HasSubstr("where is Sofa"));
    EXPECT_EQ(s.app.question_hint("the moon is made of cheese"), "");
}

// What a person types in a world, and what the answer contains. The numbers and names are those of the world's file.
struct TypedIn {
    const char *world, *language;
    std::vector<std::pair<const char*, const char*>> lines;
};

std::vector<TypedIn> typed_in_worlds() {
    return {{"house.map",
             "de",
             {{"wo ist die Toilette", "Toilette: "},
              {"wie weit ist es bis zur Küche", "Küche: "},
              {"wie viele Räume gibt es", "Es gibt 13 Räume."},
              {"was ist oben", "Oberer Flur"},
              {"was ist über mir", "Über dir: Oberer Flur."},
              {"welche Tür ist das", "Haustür, "},
              {"ist die Tür offen", "Haustür ist geschlossen."},
              {"auf welchem Stockwerk bin ich", "Stockwerk 1 von 2"},
              {"was ist hinter mir", "Haustür"},
              {"wie groß ist dieser Raum", "Flur: "},
              {"wo ist die nächste Tür", "Haustür: "},
              {"liste die Räume auf", "13 Räume: "},
              {"wie komme ich nach oben", "Oberer Flur"}}},
            {"school.map",
             "en",
             {{"where is the toilet", "Toilet: "},
              {"how many rooms", "There are 26 rooms."},
              {"what is upstairs", "Library"},
              {"which door", "Main door, "},
              {"is the door open", "Main door is shut."},
              {"what floor am I on", "storey 1 of 2"},
              {"where is the nearest door", "Main door: "},
              {"list the rooms", "26 rooms: "}}},
            {"fzk-haus.ifc",
             "de",
             {{"wo ist die Küche", "Küche: "},
              {"wie weit ist das Bad", "Bad: "},
              {"wie viele Räume", "Es gibt 7 Räume."},
              {"was ist oben", "Galerie"},
              {"liste die Räume auf", "7 Räume: "},
              {"ist die Tür offen", "Tür ist geschlossen."},
              {"wie komme ich nach oben", "Galerie"}}},
            {"duplex-apartment.ifc",
             "en",
             {{"how far is the kitchen", "Kitchen: "},
              {"how many rooms", "There are 21 rooms."},
              {"is the door open", "Door is shut."},
              {"what is upstairs", "Bedroom"}}}};
}

TEST(Answers, agree_with_each_world_in_its_language) {
    for (const TypedIn& all : typed_in_worlds()) {
        const bool bundled = std::string_view(all.world).ends_with(".map");
        const auto file = test::real_world(all.world);
        if (!bundled && !file) {
            std::cout << "Skipped: " << test::needs_real_world(all.world) << '\n';
            continue;
        }
        const test::InLanguage spoken(all.language);
        Visitor s(bundled ? test::our_world(all.world) : test::world_in(*file));
        for (const auto& [line, part] : all.lines)
            EXPECT_THAT(s.typed(line), HasSubstr(part)) << all.world << ": " << line;
    }
}

TEST(Answers, and_directions_say_of_each_shut_door_that_it_must_be_opened) {
    for (const auto& [world, room] : {std::pair("house.map", "Kitchen"), std::pair("school.map", "Fountain water"),
                                      std::pair("school.map", "Room 2")}) {
        Visitor s(world);
        s.request(Command::Routes);
        s.line(room);
        s.run(1.0);
        const std::string rest = s.request(Command::RestOfRoute);
        std::size_t shut = 0;
        for (std::size_t at = 0; (at = rest.find("door", at)) != std::string::npos; ++at, ++shut)
            EXPECT_TRUE(rest.substr(at).starts_with("door, shut. Open it.") ||
                        rest.substr(at).starts_with("door on your"))
                << world << ", " << room << ": " << rest;
        EXPECT_GT(shut, 0U) << world << ", " << room << ": " << rest;
    }
}

}  // namespace answers_test
}  // namespace handrail
