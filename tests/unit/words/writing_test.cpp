// Tests worlds that are written as room descriptions and read again.
#include <gmock/gmock.h>

#include <random>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/words/words_text.h"
#include "worlds/exports/as_words.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace words_writing_test {

// Returns a random building of adjacent rooms on up to three storeys. Some rooms have corners cut out. The building has
// doors, openings, stairs, things, and names that need quotation marks.
std::string random_building(std::mt19937& random) {
    const auto upto = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    std::string text = "Building: Random " + std::to_string(upto(1000)) + ".\nWalls: " + std::to_string(10 + upto(20)) +
                       " cm thick.\n";
    const int storeys = 1 + upto(3), columns = 2 + upto(3), rows = 1 + upto(3);
    std::vector<int> wide, deep;
    for (int i = 0; i < columns; ++i) wide.push_back(300 + upto(400));
    for (int i = 0; i < rows; ++i) deep.push_back(300 + upto(400));
    const auto number = [](int cm) {
        return std::to_string(cm / 100) + "." + std::string(cm % 100 < 10 ? "0" : "") + std::to_string(cm % 100);
    };
    const auto name = [](int storey, int x, int y) {
        constexpr std::array<const char*, 4> kNames{"Room", "\"Office, north\"", "Küche", "\"Door to 2.5 metres\""};
        std::string made = kNames[static_cast<std::size_t>((storey + x * 2 + y) % 4)];
        const std::string place = " " + std::to_string(storey * 100 + y * 10 + x);
        return made.ends_with('"') ? made.substr(0, made.size() - 1) + place + "\"" : made + place;
    };
    for (int s = 0; s < storeys; ++s) {
        text += "Storey: Floor " + std::to_string(s) + ", " + number(260 + upto(100)) + " metres high.\n";
        int y_cm = upto(500) - 250;
        for (int y = 0; y < rows; ++y) {
            int x_cm = -700;
            for (int x = 0; x < columns; ++x) {
                const int w = wide[static_cast<std::size_t>(x)], d = deep[static_cast<std::size_t>(y)];
                text += "\nRoom: " + name(s, x, y);
                const auto east = [](int cm) {
                    return std::to_string(cm < 0 ? -cm : cm) + " cm " + (cm < 0 ? "west" : "east");
                };
                const auto north = [](int cm) {
                    return std::to_string(cm < 0 ? -cm : cm) + " cm " + (cm < 0 ? "south" : "north");
                };
                // Makes this room L-shaped if no other room depends on its corner.
                const bool cut = upto(5) == 0 && y == rows - 1 && s == storeys - 1;
                if (cut)
                    text += ", corners " + std::to_string(x_cm) + " " + std::to_string(y_cm) + ", " +
                            std::to_string(x_cm + w) + " " + std::to_string(y_cm) + ", " + std::to_string(x_cm + w) +
                            " " + std::to_string(y_cm + d) + ", " + std::to_string(x_cm + w / 2) + " " +
                            std::to_string(y_cm + d) + ", " + std::to_string(x_cm + w / 2) + " " +
                            std::to_string(y_cm + d / 2) + ", " + std::to_string(x_cm) + " " +
                            std::to_string(y_cm + d / 2) + " cm";
                else
                    text += ", " + number(w) + " by " + number(d) + " metres, corner at " + east(x_cm) + " and " +
                            north(y_cm);
                if (upto(7) == 0) text += upto(2) == 0 ? ", raised by 35 centimetres" : ", sunk by 0.5 metres";
                text += upto(3) == 0 ? ", wooden floor.\n" : ".\n";
                // Adds edges to step down, also in rooms that are otherwise not described, and lifts to the storey
                // above.
                if (x + 1 < columns && upto(6) == 0)
                    text += "Drop of 0.4 metres from " + name(s, x, y) + " to " + name(s, x + 1, y) + ".\n";
                if (s + 1 < storeys && upto(4) == 0)
                    text += "Lift from " + name(s, x, y) + " to " + name(s + 1, x, y) + ", at " + east(x_cm + w / 2) +
                            " and " + north(y_cm + d / 2) + ", 1.2 by 1.4 metres" +
                            (upto(2) == 0 ? ", called \"Lift, small\".\n" : ".\n");
                const bool opening = upto(4) == 0;
                if (x + 1 < columns && upto(5) > 0)
                    text += std::string(opening ? "Opening" : "Door") + " to " + name(s, x + 1, y) + ", " +
                            number(70 + upto(60)) + " metres wide.\n";
                if (y + 1 < rows && upto(3) > 0)
                    text += std::string(upto(4) == 0 ? "Sliding door" : "Door") + " to " + name(s, x, y + 1) + ".\n";
                if (s == 0 && y == 0 && x == 0) text += "Door outside in the south wall, called \"Main, entrance\".\n";
                if (!cut && upto(2) == 0)
                    text += "Table against the north wall, landmark. Bin in the south-east corner, made of metal.\n";
                x_cm += w;
            }
            y_cm += deep[static_cast<std::size_t>(y)];
        }
        if (s == 0 && storeys > 1)
            text += "\nRoom: Stairs, 3 by 7 metres, west of " + name(0, 0, 0) + ", stairs to \"Floor " +
                    std::to_string(storeys - 1) + "\". Door to " + name(0, 0, 0) + ".\n";
    }
    return text;
}

std::vector<std::string> names_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const StatedRoom& room : scene.stated->rooms) names.push_back(room.name);
    std::sort(names.begin(), names.end());
    return names;
}

void expect_same_building(const Scene& before, const Scene& after, const std::string& text) {
    ASSERT_EQ(names_of(after), names_of(before)) << text;
    ASSERT_EQ(test::joins_of(after), test::joins_of(before)) << text;
    for (const StatedRoom& room : before.stated->rooms) {
        const StatedRoom& again = *test::room_of(after, room.name);
        EXPECT_NEAR(again.area_m2, room.area_m2, 1e-3) << room.name << text;
        EXPECT_NEAR(again.floor_m, room.floor_m, 1e-3) << room.name << text;
        EXPECT_LT(glm::length(test::box_of(again).first - test::box_of(room).first), 1e-3) << room.name << text;
    }
    // Each door must be at its original place.
    for (const StatedPortal& portal : before.stated->portals) {
        double nearest = 1e9;
        for (const StatedPortal& other : after.stated->portals)
            if (other.kind == portal.kind) nearest = std::min(nearest, glm::length(other.place_m - portal.place_m));
        EXPECT_LT(nearest, 2e-3) << portal.name << text;
    }
    EXPECT_EQ(after.stated->furnishings.size(), before.stated->furnishings.size()) << text;
}

TEST(WrittenInWords, random_buildings_are_read_back_with_the_same_rooms_and_doors_in_both_languages) {
    std::mt19937 random(20261124);
    for (int round = 0; round < 40; ++round) {
        const std::string text = random_building(random);
        const Scene scene = test::read_rooms(text);
        for (const WordLanguage language : {WordLanguage::English, WordLanguage::German}) {
            const std::string written = text_of(stated_house(scene, language), scene, language);
            const Scene again = test::read_rooms(written);
            for (const Diagnostic& warning : again.report.warnings)
                if (warning.line > 0) ADD_FAILURE() << warning.sentence() << written;
            ASSERT_NO_FATAL_FAILURE(expect_same_building(scene, again, "\n" + text + "\n-----\n" + written));
            EXPECT_EQ(text_of(stated_house(again, language), again, language), written) << "and the same text";
            if (HasFailure()) return;
        }
    }
}

// The rooms by name and what joins them. A written staircase is a room on each storey, but this graph contains it as
// one room.
struct Graph {
    std::set<std::string> rooms;
    std::multiset<std::string> joins;
};

Graph graph_of(const WordsHouse& house) {
    Graph graph;
    for (const WordsHouse::Room& room : house.rooms) graph.rooms.insert(room.name);
    for (const WordsHouse::Door& door : house.doors) {
        std::multiset<std::string> names;
        for (const std::size_t r : door.rooms) names.insert(house.rooms[r].name);
        std::string text = door.opening ? "opening" : "door";
        for (const std::string& name : names) text += " | " + name;
        graph.joins.insert(text);
    }
    for (const WordsHouse::Lift& lift : house.lifts)
        graph.joins.insert("lift | " + house.rooms[lift.from].name + " | " + house.rooms[lift.to].name);
    return graph;
}

void expect_map_comes_back(const std::string& map) {
    const std::string path = (test::project_root() / "worlds/maps/").string() + map;
    const Result<Scene> scene = read_world(path);
    ASSERT_TRUE(scene.has_value());
    const Result<WalkSpace> space = make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(space.has_value());
    const RoomGraph graph = make_rooms(*scene, *space);
    for (const WordLanguage language : {WordLanguage::English, WordLanguage::German}) {
        const WordsHouse house = found_house(*scene, graph, *space, language);
        ASSERT_EQ(house.rooms.size(), graph.rooms.size());
        const std::string written = text_of(house, *scene, language);
        const Scene again = test::read_rooms(written);
        for (const Diagnostic& warning : again.report.warnings)
            if (warning.line > 0) ADD_FAILURE() << warning.sentence();
        const Graph before = graph_of(house), after = graph_of(stated_house(again, language));
        EXPECT_EQ(after.rooms, before.rooms);
        EXPECT_EQ(after.joins, before.joins);
    }
}

// After reading, a walker must be able to use the drop and the lift: only down at the drop, and in both directions with
// the lift.
TEST(WrittenInWords, a_drop_and_a_lift_can_be_used_after_reading_in_both_languages) {
    const char* texts[] = {
        "Building: Stage.\n\nStorey: Ground, 3 metres high.\n\n"
        "Room: Stage, 5 by 4 metres. Door outside in the south wall. "
        "Drop of 0.5 metres from Stage to Pit, 3 metres wide.\n"
        "Lift from Stage to Loft, at 1 metre east and 3 metres north, 1.2 by 1.2 metres, called Platform.\n\n"
        "Room: Pit, 5 by 4 metres, east of Stage.\n\nStorey: Above, 3 metres high.\n\nRoom: Loft, 5 by 4 metres, "
        "corner at 0 metres east and 0 metres north.\n",
        "Gebäude: Stage.\nSprache: Deutsch.\n\nStockwerk: Unten, 3 Meter hoch.\n\n"
        "Raum: Stage, 5 mal 4 Meter. Tür nach draußen in der Südwand. "
        "Kante von 0,5 Metern von Stage zu Pit, 3 Meter breit.\n"
        "Aufzug von Stage zu Loft, bei 1 Meter nach Osten und 3 Meter nach Norden, 1,2 mal 1,2 Meter, genannt "
        "Platform.\n\nRaum: Pit, 5 mal 4 Meter, östlich von Stage.\n\nStockwerk: Oben, 3 Meter hoch.\n\n"
        "Raum: Loft, 5 mal 4 Meter, Ecke bei 0 Meter nach Osten und 0 Meter nach Norden.\n"};
    for (const char* text : texts) {
        const Scene scene = test::read_rooms(text);
        for (const Diagnostic& warning : scene.report.warnings)
            if (warning.line > 0) ADD_FAILURE() << warning.sentence();
        EXPECT_NEAR(test::room_of(scene, "Pit")->floor_m, -0.5, 1e-9);
        const Result<WalkSpace> space = make_walk_space(scene, walker_measures(scene, 0.25, 1.8, 0.25));
        ASSERT_TRUE(space.has_value()) << space.error().sentence();
        const RoomGraph graph = make_rooms(scene, *space);
        int lifts = 0, openings = 0;
        for (const Portal& portal : graph.portals) {
            const std::string from = graph.rooms[portal.rooms[0]].name, to = graph.rooms[portal.rooms[1]].name;
            if (portal.kind == PassageKind::Lift) {
                ++lifts;
                EXPECT_EQ(std::set<std::string>({from, to}), std::set<std::string>({"Stage", "Loft"}));
                EXPECT_FALSE(portal.one_way);
                EXPECT_EQ(scene.find(portal.feature)->name, "Platform");
            }
            openings += portal.kind == PassageKind::Opening ? 1 : 0;
        }
        EXPECT_EQ(lifts, 1) << text;
        EXPECT_EQ(openings, 1) << "where the edge is";
        // The drop leads half a metre down. Nobody can walk up there.
        int drops = 0;
        for (const WalkLink& link : space->links)
            if (link.kind == PassageKind::Drop) {
                ++drops;
                EXPECT_FALSE(link.both_ways);
                EXPECT_NEAR(space->place_m(link.from).z - space->place_m(link.to).z, 0.5, 0.01);
                EXPECT_NEAR(space->place_m(link.from).x, 5.0, 0.4);
            }
        EXPECT_GT(drops, 0) << text;
        const Vec3 above(4.0, 2.0, 0.0), below(6.0, 2.0, -0.5);
        EXPECT_FALSE(space->straight(above, below));
        EXPECT_FALSE(space->straight(below, above));
        // If the world is written again, the text must also contain the drop and the lift.
        for (const WordLanguage language : {WordLanguage::English, WordLanguage::German}) {
            const bool german = language == WordLanguage::German;
            const std::string written = text_of(stated_house(scene, language), scene, language);
            EXPECT_NE(
                written.find(german ? "Kante von 0,5 Meter von Stage zu Pit" : "Drop of 0.5 metres from Stage to Pit"),
                std::string::npos)
                << written;
            EXPECT_NE(written.find(german ? "Aufzug von Stage zu Loft" : "Lift from Stage to Loft"), std::string::npos)
                << written;
            const Scene again = test::read_rooms(written);
            ASSERT_NO_FATAL_FAILURE(expect_same_building(scene, again, "\n" + written));
        }
    }
}

TEST(WrittenInWords, lifts_and_drops_that_lead_nowhere_are_reported_with_their_line) {
    const Scene scene = test::read_rooms(
        "Building: One.\n\nRoom: Hall, 4 by 4 metres. Door outside.\nLift from Hall to Attic.\n"
        "Drop of 0.5 metres from Hall to Cellar.\n");
    std::set<int> lines;
    for (const Diagnostic& warning : scene.report.warnings) lines.insert(warning.line);
    EXPECT_TRUE(lines.contains(4) && lines.contains(5));
}

TEST(WrittenInWords, the_house_is_read_back_with_the_same_rooms_and_doors) { expect_map_comes_back("house.map"); }
TEST(WrittenInWords, the_school_is_read_back_with_the_same_rooms_and_doors) { expect_map_comes_back("school.map"); }
TEST(WrittenInWords, the_first_room_is_read_back) { expect_map_comes_back("first_room.map"); }

TEST(WrittenInWords, windows_name_their_wall_wherever_their_room_is) {
    for (const std::string side : {"north", "east", "south", "west"})
        for (const char* corner : {"5 metres east and 2 metres north", "5 metres west and 2 metres south"}) {
            const std::string window = "Window in the " + side + " wall, 1.5 metres along";
            const Scene scene = test::read_rooms("Room: Hall, 4 by 3 metres, corner at " + std::string(corner) +
                                                 ". Door outside in the east wall.\n" + window + ", 1 metre wide.\n");
            const std::string written =
                text_of(stated_house(scene, WordLanguage::English), scene, WordLanguage::English);
            EXPECT_NE(written.find(window), std::string::npos) << written;
        }
}

TEST(WrittenInWords, a_building_from_openstreetmap_is_read_back) {
    const std::string osm = test::content_of(test::project_root() / "tests/unit/osm/worlds/test_house.osm");
    const Result<Scene> scene = read_osm(osm, "house.osm");
    ASSERT_TRUE(scene.has_value());
    const std::string written = text_of(stated_house(*scene, WordLanguage::English), *scene, WordLanguage::English);
    const Scene again = test::read_rooms(written);
    EXPECT_EQ(names_of(again), names_of(*scene)) << written;
    EXPECT_EQ(test::joins_of(again), test::joins_of(*scene)) << written;
}

}  // namespace words_writing_test
}  // namespace handrail
