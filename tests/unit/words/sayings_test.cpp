// Tests expressions that people use in room descriptions, and what the reader reports about them.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/unit/words/words_text.h"
#include "worlds/exports/as_words.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace words_sayings_test {

using ::testing::HasSubstr;

std::string warnings_of(const Scene& scene) {
    std::string text;
    for (const Diagnostic& warning : scene.report.warnings)
        if (warning.line > 0) text += warning.sentence() + "\n";
    return text;
}

Aabb boxed(const Scene& scene, std::size_t furnishing) { return scene.stated->furnishings.at(furnishing).bounds_m; }

bool overlap_flat(const Aabb& a, const Aabb& b) {
    return a.min_m.x < b.max_m.x - 1e-6 && b.min_m.x < a.max_m.x - 1e-6 && a.min_m.y < b.max_m.y - 1e-6 &&
           b.min_m.y < a.max_m.y - 1e-6;
}

// Returns the distance of `thing` from the middle of the nearest door.
double before_door(const Scene& scene, const Aabb& thing) {
    double nearest = 1e300;
    for (const StatedPortal& portal : scene.stated->portals) {
        const Vec2 at(portal.place_m);
        const Vec2 off = glm::max(glm::max(Vec2(thing.min_m) - at, at - Vec2(thing.max_m)), Vec2(0.0));
        nearest = std::min(nearest, glm::length(off));
    }
    return nearest;
}

TEST(SayingsInWords, accept_german_genitives_as_names_of_rooms_and_things) {
    const Scene scene = test::read_rooms(
        "Gebäude: Haus.\n\nFlur, 8 mal 2 Meter. Tür nach draußen in der Westwand.\n\n"
        "Küche, 4 mal 4 Meter, nördlich des Flurs, bündig mit dem Westende. Tür zum Flur.\n\n"
        "Großer Saal, 6 mal 5 Meter, südlich des Flures. Tür zum Flur. Tisch in der Mitte des Raums.\n\n"
        "Zimmer des Hausmeisters, 3 mal 5 Meter, östlich des großen Saals. Tür zum großen Saal.\n\n"
        "Keller, 3 mal 2 Meter, links des Flurs.\n\nLager, 3 mal 2 Meter, westlich des Kellers. Tür zum Keller.\n");
    EXPECT_EQ(warnings_of(scene), "");
    EXPECT_NEAR(test::box_of(*test::room_of(scene, "Küche")).first.y, 2.0, 1e-9);
    EXPECT_NEAR(test::box_of(*test::room_of(scene, "Großer Saal")).second.y, 0.0, 1e-9);
    EXPECT_NEAR(test::box_of(*test::room_of(scene, "Zimmer des Hausmeisters")).first.x, 7.0, 1e-9);
    EXPECT_NEAR(test::box_of(*test::room_of(scene, "Lager")).second.x, -3.0, 1e-9);
    EXPECT_THAT(test::joins_of(scene), ::testing::Contains("door Großer Saal | Zimmer des Hausmeisters"));
}

// Most walls have a door in the middle, where the reader would otherwise place a thing against that wall. So the reader
// must place the thing next to the door.
TEST(SayingsInWords, place_things_without_a_stated_place_clear_of_doors) {
    const Scene scene = test::read_rooms(
        "Building: House.\n\nHall, 7 by 5 metres. Door outside in the south wall. Door outside in the north wall.\n"
        "Door outside in the west wall. Door outside 0.6 metres along the east wall.\nWindow in the north wall.\n"
        "Table against the north wall. Shelf by the window. Cupboard against the west wall. Bench.\n"
        "Sofa. Chair next to Table.\n");
    EXPECT_EQ(warnings_of(scene), "");
    ASSERT_EQ(scene.stated->furnishings.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_GT(before_door(scene, boxed(scene, i)), 0.9) << i;
        for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap_flat(boxed(scene, i), boxed(scene, k))) << i << k;
    }
    EXPECT_NEAR(boxed(scene, 0).max_m.y, 4.94, 1e-6) << "still against its wall";
}

TEST(SayingsInWords, turn_two_chairs_into_two_things) {
    for (const char* text :
         {"Building: House.\n\nHall, 6 by 5 metres. Door outside.\nTable in the middle. Two chairs next to the table. "
          "3 shelves against the north wall. Two armchairs 1 metre from the south wall.\n",
          "Gebäude: Haus.\n\nHalle, 6 mal 5 Meter. Tür nach draußen.\nTisch in der Mitte. Zwei Stühle neben dem "
          "Tisch. 3 Regale an der Nordwand. Zwei Sessel 1 Meter von der Südwand.\n"}) {
        const Scene scene = test::read_rooms(text);
        EXPECT_EQ(warnings_of(scene), "");
        ASSERT_EQ(scene.stated->furnishings.size(), 8U) << text;
        std::multiset<std::string> names;
        for (const StatedThing& thing : scene.stated->furnishings) names.insert(scene.find(thing.feature)->name);
        EXPECT_EQ(names.count("Chair") + names.count("Stuhl"), 2U);
        EXPECT_EQ(names.count("Shelf") + names.count("Regal"), 3U);
        for (std::size_t i = 0; i < 8; ++i)
            for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap_flat(boxed(scene, i), boxed(scene, k))) << i << k;
    }
    // A name may begin with a number word. "Three Graces" is one thing.
    const Scene graces = test::read_rooms(
        "Building: House.\n\nHall, 6 by 5 metres. Door outside.\nThree Graces, 1 by 1 by 2 metres, in the middle.\n");
    EXPECT_EQ(graces.stated->furnishings.size(), 1U);
    EXPECT_EQ(warnings_of(graces), "");
}

TEST(SayingsInWords, do_not_count_a_railing_as_a_wall) {
    for (const char* text : {"Building: House.\n\nHall, 4 by 4 metres. Door outside.\n\n"
                             "Balcony, 4 by 2 metres, north of Hall, railing 1 metre high. Door to Hall.\n\n"
                             "Terrace, 4 by 2 metres, east of Hall, with a 0.9 metre high railing. Door to Hall.\n",
                             "Gebäude: Haus.\n\nHalle, 4 mal 4 Meter. Tür nach draußen.\n\n"
                             "Balkon, 4 mal 2 Meter, nördlich der Halle, Geländer 1 Meter hoch. Tür zur Halle.\n\n"
                             "Terrasse, 4 mal 2 Meter, östlich der Halle, mit einem 0,9 Meter hohen Geländer. Tür zur "
                             "Halle.\n"}) {
        const Scene scene = test::read_rooms(text);
        const double storey_m = scene.stated->rooms[0].height_m;
        for (const StatedRoom& room : scene.stated->rooms) EXPECT_NEAR(room.height_m, storey_m, 1e-9) << room.name;
        std::set<int> lines;
        for (const Diagnostic& warning : scene.report.warnings) lines.insert(warning.line);
        EXPECT_EQ(lines, (std::set<int>{5, 7})) << warnings_of(scene);
        EXPECT_THAT(warnings_of(scene), HasSubstr("railing of 0.9 metres cannot be built"));
    }
}

TEST(SayingsInWords, about_an_unknown_thing_are_reported_with_the_chosen_meaning) {
    const Scene scene = test::read_rooms(
        "Building: House.\n\nHall, 4 by 4 metres. Door outside.\nWnidow in the north wall.\nStatue, 0.5 by 0.5 by 2 "
        "metres, in the north-east corner.\nThing: Obelisk, in the north-west corner.\n");
    ASSERT_EQ(scene.stated->furnishings.size(), 3U);
    std::set<int> lines;
    for (const Diagnostic& warning : scene.report.warnings) lines.insert(warning.line);
    EXPECT_EQ(lines, (std::set<int>{4})) << "a size or the word Thing says that a thing is meant";
    EXPECT_THAT(
        warnings_of(scene),
        HasSubstr("Wnidow is not a kind of thing that Handrail knows. It was put there as a plain thing of 0.6 by"));
}

// The adjoining pieces of an outline must become one room without a wall between the pieces.
TEST(OutlinesInWords, of_adjoining_pieces_become_one_outline) {
    const Scene scene = test::read_rooms(
        "Building: House.\n\nRoom: Foyer, corners 0 0, 3 0, 3 6, 0 6, and corners 3 0, 5 0, 5 2, 3 2, hole 1 4, 2 4, 2 "
        "5, "
        "1 5. Door outside in the west wall.\n");
    EXPECT_EQ(warnings_of(scene), "");
    const StatedRoom& foyer = *test::room_of(scene, "Foyer");
    EXPECT_NEAR(foyer.area_m2, 21.0, 1e-6);
    ASSERT_EQ(foyer.rings.size(), 2U);
    EXPECT_EQ(foyer.rings[0].size(), 6U) << "an L";
    for (const WordLanguage language : {WordLanguage::English, WordLanguage::German}) {
        const std::string written = text_of(stated_house(scene, language), scene, language);
        EXPECT_NEAR(test::room_of(test::read_rooms(written), "Foyer")->area_m2, 21.0, 1e-6) << written;
    }
}

// The stairs in these texts are not in a separate room. A walker must be able to go up and down the stairs, whether
// they are straight or turn back.
TEST(StairsInWords, from_one_room_to_another_are_walked_and_exported_again) {
    const char* texts[] = {
        "Building: House.\n\nStorey: Ground, 3 metres high.\n\nHall, 6 by 8 metres. Door outside in the south wall.\n"
        "Stairs from Hall to Gallery, at 4 metres east and 4 metres north, 1.2 by 4.5 metres, up to the north.\n\n"
        "Storey: Upper, 3 metres high.\n\nGallery, 6 by 8 metres, above Hall.\n",
        "Gebäude: Haus.\n\nStockwerk: Unten, 3 Meter hoch.\n\nHall, 6 mal 8 Meter. Tür nach draußen in der Südwand.\n"
        "Treppe von Hall zu Gallery, bei 3 Meter nach Osten und 4 Meter nach Norden, 2,4 mal 4 Meter, hinauf nach "
        "Norden und zurück, genannt Haupttreppe.\n\n"
        "Stockwerk: Oben, 3 Meter hoch.\n\nGallery, 6 mal 8 Meter, über Hall.\n"};
    for (const char* text : texts) {
        const Scene scene = test::read_rooms(text);
        EXPECT_EQ(warnings_of(scene), "");
        ASSERT_EQ(scene.stated->stairs, 1);
        const Result<WalkSpace> space = make_walk_space(scene, walker_measures(scene, 0.25, 1.8, 0.25));
        ASSERT_TRUE(space.has_value()) << space.error().sentence();
        const RoomGraph graph = make_rooms(scene, *space);
        // A walker must be able to go from the foot of the stairs to their top on one connected walkable area.
        std::set<std::string> reached;
        std::vector<std::uint32_t> open;
        std::vector<bool> seen(space->spans.size(), false);
        const std::uint32_t from = space->nearest(Vec3(1.0, 1.0, 0.0), 0.5, 0.3, 0.3);
        ASSERT_NE(from, kNothing);
        open.push_back(from);
        seen[from] = true;
        while (!open.empty()) {
            const std::uint32_t now = open.back();
            open.pop_back();
            if (graph.room_of_span[now] != kNothing) reached.insert(graph.rooms[graph.room_of_span[now]].name);
            for (const std::uint32_t next : space->spans[now].next)
                if (next != kNothing && !seen[next]) seen[next] = true, open.push_back(next);
        }
        EXPECT_TRUE(reached.contains("Hall") && reached.contains("Gallery"))
            << text << ::testing::PrintToString(reached);
        for (const WordLanguage language : {WordLanguage::English, WordLanguage::German}) {
            const WordsHouse house = stated_house(scene, language);
            const std::string written = text_of(house, scene, language);
            const Scene again = test::read_rooms(written);
            EXPECT_EQ(warnings_of(again), "") << written;
            EXPECT_EQ(test::joins_of(again), test::joins_of(scene)) << written;
            EXPECT_EQ(text_of(stated_house(again, language), again, language), written);
        }
    }
}

TEST(StairsInWords, that_lead_nowhere_are_reported_with_their_line) {
    const Scene scene =
        test::read_rooms("Building: One.\n\nHall, 4 by 4 metres. Door outside.\nStairs from Hall to Attic.\n");
    EXPECT_THAT(warnings_of(scene), HasSubstr("line 4"));
    EXPECT_EQ(scene.stated->stairs, 0);
}

}  // namespace words_sayings_test
}  // namespace handrail
