// Tests stations and campuses as mappers draw them: doors next to outlines, platforms, lifts, and paths without rooms.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/unit/osm/drawing.h"
#include "tests/unit/osm/osm_text.h"
#include "worlds/navigation/navigation.h"
#include "worlds/scene/honest_report.h"

namespace handrail {
namespace osm_stations_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

using test::Drawing;

TEST(OsmDoors, within_0_3_m_of_an_outline_join_the_rooms_there) {
    for (const double beside_m : {-0.29, -0.1, -0.004, 0.0, 0.01, 0.2, 0.29, -0.5, 0.5}) {
        Drawing drawing;
        for (const char* level : {"0", "1"}) {
            drawing.box(0, 0, 6, 4, {{"indoor", "room"}, {"level", level}, {"name", std::string("West ") + level}});
            drawing.box(6, 0, 12, 4, {{"indoor", "room"}, {"level", level}, {"name", std::string("East ") + level}});
        }
        drawing.node(6 + beside_m, 2, {{"door", "hinged"}, {"level", "0;1"}});
        const std::vector<std::string> joins = test::joins_of(drawing.scene(), StatedPortalKind::Door);
        if (std::abs(beside_m) < 0.3)
            EXPECT_THAT(joins, UnorderedElementsAre("West 0 | East 0", "West 1 | East 1")) << beside_m;
        else EXPECT_THAT(joins, IsEmpty()) << beside_m;
    }
}

TEST(OsmDoors, a_door_node_on_one_level_also_serves_the_outline_next_to_it_on_another) {
    Drawing drawing;
    const int door = drawing.node(6, 2, {{"door", "yes"}, {"level", "0;1"}});
    const int first = drawing.node(0, 0);
    drawing.way({first, drawing.node(6, 0), door, drawing.node(6, 4), drawing.node(0, 4), first},
                {{"indoor", "room"}, {"level", "0"}, {"name", "West 0"}});
    drawing.box(6, 0, 12, 4, {{"indoor", "room"}, {"level", "0"}, {"name", "East 0"}});
    drawing.box(0, 0, 6.1, 4, {{"indoor", "room"}, {"level", "1"}, {"name", "West 1"}});
    drawing.box(6.1, 0, 12, 4, {{"indoor", "room"}, {"level", "1"}, {"name", "East 1"}});
    EXPECT_THAT(test::joins_of(drawing.scene(), StatedPortalKind::Door),
                UnorderedElementsAre("West 0 | East 0", "West 1 | East 1"));
}

TEST(OsmDoors, near_a_corner_do_not_join_the_room_behind_the_corner) {
    Drawing drawing;
    drawing.box(0, 0, 6, 4, {{"indoor", "room"}, {"level", "0"}, {"name", "West"}});
    drawing.box(6, 0, 12, 4, {{"indoor", "room"}, {"level", "0"}, {"name", "East"}});
    drawing.box(0, -4, 12, 0, {{"indoor", "room"}, {"level", "0"}, {"name", "South"}});
    drawing.node(5.8, 0.05, {{"door", "hinged"}, {"level", "0"}});
    EXPECT_THAT(test::joins_of(drawing.scene(), StatedPortalKind::Door), UnorderedElementsAre("West | South"));
}

// The file draws the wall between two rooms once more as a wall of two pieces, which meet in the middle of the doorway.
TEST(OsmDoors, stay_free_if_a_drawn_wall_has_a_corner_in_the_doorway) {
    for (const double askew_m : {0.0, 1.2}) {
        Drawing drawing;
        const int south = drawing.node(6 + askew_m, 0), north = drawing.node(6 - askew_m, 4),
                  door = drawing.node(6, 2, {{"door", "hinged"}, {"level", "0"}}), west = drawing.node(0, 0),
                  east = drawing.node(12, 0);
        drawing.way({west, south, door, north, drawing.node(0, 4), west},
                    {{"indoor", "room"}, {"level", "0"}, {"name", "West"}});
        drawing.way({east, drawing.node(12, 4), north, door, south, east},
                    {{"indoor", "room"}, {"level", "0"}, {"name", "East"}});
        drawing.way({south, door, north}, {{"indoor", "wall"}, {"level", "0"}, {"material", "glass"}});
        const Scene scene = drawing.scene();
        const StatedRoom *from = test::room_named(scene, "West"), *to = test::room_named(scene, "East");
        ASSERT_TRUE(from && to);
        const auto ways = navigation::Navigation::make(scene, navigation::walker_measures(scene, 0.25, 1.8, 0.25));
        ASSERT_TRUE(ways) << ways.error().sentence();
        EXPECT_TRUE((*ways)->plan(from->at_m, to->at_m).reaches) << askew_m;
    }
}

std::vector<std::string> names_of_rooms(const Scene& scene) {
    std::vector<std::string> names;
    for (const StatedRoom& room : scene.stated->rooms) names.push_back(room.name);
    return names;
}

TEST(OsmPlatforms, can_be_walked_with_every_kind_of_tagging) {
    for (const Drawing::Tags& tags : std::vector<Drawing::Tags>{{{"railway", "platform"}},
                                                                {{"public_transport", "platform"}},
                                                                {{"highway", "platform"}},
                                                                {{"railway", "platform"}, {"area", "yes"}}}) {
        Drawing drawing;
        for (const int n : {1, 2}) {
            Drawing::Tags own = tags;
            own.insert(own.end(), {{"ref", std::to_string(n)}, {"level", "0"}});
            drawing.box(0, 8.0 * n, 30, 8.0 * n + 4, own);
        }
        const Scene scene = drawing.scene();
        ASSERT_TRUE(scene.stated) << tags[0].first;
        EXPECT_THAT(names_of_rooms(scene), ElementsAre("Platform 1", "Platform 2")) << tags[0].first;
        for (const StatedRoom& room : scene.stated->rooms) EXPECT_NEAR(room.area_m2, 120.0, 1.0) << room.name;
    }
}

TEST(OsmPlatforms, may_be_a_relation_with_a_hole) {
    Drawing drawing;
    const auto ring = [&](double west, double south, double east, double north) {
        const int first = drawing.node(west, south);
        return drawing.way(
            {first, drawing.node(east, south), drawing.node(east, north), drawing.node(west, north), first}, {});
    };
    const int outer = ring(0, 0, 40, 6), inner = ring(15, 2, 21, 4);
    drawing.relation("<member type='way' ref='" + std::to_string(outer) + "' role='outer'/><member type='way' ref='" +
                         std::to_string(inner) + "' role='inner'/>",
                     {{"type", "multipolygon"}, {"railway", "platform"}, {"level", "0"}, {"ref", "7"}});
    drawing.way({drawing.node(20, 6), drawing.node(20, 12)}, {{"highway", "footway"}, {"name", "Link"}});
    const Scene scene = drawing.scene();
    ASSERT_TRUE(scene.stated);
    const StatedRoom* platform = test::room_named(scene, "Platform 7");
    ASSERT_NE(platform, nullptr);
    EXPECT_NEAR(platform->area_m2, 40 * 6 - 6 * 2, 1.0);
    EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Opening), ElementsAre("Link | Platform 7", "Link"))
        << "joined with each other and with the ground";
}

TEST(OsmPlatforms, are_joined_by_a_footway_that_ends_on_their_edge_and_is_named_after_them) {
    for (const double into_m : {-0.2, 0.0, 0.3, 1.5}) {
        Drawing drawing;
        drawing.box(0, 0, 40, 5, {{"railway", "platform"}, {"ref", "1"}});
        drawing.box(0, 9, 40, 14, {{"railway", "platform"}, {"ref", "2"}});
        drawing.way({drawing.node(20, 5 - into_m), drawing.node(20, 9 + into_m)}, {{"highway", "footway"}});
        const Scene scene = drawing.scene();
        ASSERT_TRUE(scene.stated);
        const HonestReport report = honest_report(scene);
        EXPECT_EQ(report.largest_connected, 3) << into_m;
        EXPECT_TRUE(scene.report.warnings.empty()) << scene.report.warnings[0].sentence();
        EXPECT_THAT(names_of_rooms(scene), Contains("Footway from Platform 1 to Platform 2"));
    }
}

TEST(OsmWays, are_named_by_their_destinations_and_never_numbered) {
    Drawing drawing;
    drawing.box(0, 0, 40, 5, {{"railway", "platform"}, {"ref", "1"}, {"level", "0"}});
    const int edge = drawing.node(20, 5), bend = drawing.node(20, 12), far = drawing.node(20, 28),
              top = drawing.node(20, 40), head = drawing.node(20, 48), room = drawing.node(30, 12);
    drawing.way({edge, bend}, {{"highway", "footway"}});
    drawing.way({bend, far}, {{"highway", "footway"}});
    drawing.way({far, top}, {{"highway", "footway"}});
    drawing.way({top, head}, {{"highway", "steps"}, {"level", "0;1"}});
    drawing.way({bend, room}, {{"highway", "footway"}});
    for (const double x : {-60.0, 60.0})
        drawing.way({drawing.node(x, 0), drawing.node(x, 20)}, {{"highway", "footway"}, {"name", "Lane"}});
    for (const char* level : {"0", "-1"})
        drawing.way({drawing.node(40, 50), drawing.node(40, 60)}, {{"highway", "footway"}, {"level", level}});
    const Scene scene = drawing.scene();
    EXPECT_THAT(names_of_rooms(scene),
                UnorderedElementsAre("Platform 1", "Footway from Platform 1 to the stairs, south-east",
                                     "Footway from Platform 1 to the stairs, south-east",
                                     "Footway from Platform 1 to the stairs, east", "Footway at Platform 1",
                                     "Lane, west", "Lane, east", "Footway, Level 0", "Footway, Level -1"))
        << "two are alike, which is better than a number";
}

TEST(OsmWays, with_the_same_name_are_not_numbered_in_the_list_of_rooms_either) {
    Drawing drawing;
    int from = drawing.node(0, 0);
    for (int k = 1; k <= 5; ++k) {
        const int to = drawing.node(8.0 * k, 0);
        drawing.way({from, to}, {{"highway", "footway"}, {"level", "1"}, {"name", "Deck"}});
        from = to;
    }
    const Scene scene = drawing.scene();
    const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
    std::vector<std::string> names;
    for (const Room& room : make_rooms(scene, (*ways)->space()).rooms)
        if (room.is_way) names.push_back(room.name);
    EXPECT_THAT(names, UnorderedElementsAre("Deck, west", "Deck, west", "Deck, middle", "Deck, east", "Deck, east"));
}

TEST(OsmWays, on_the_ground_are_joined_by_the_ground) {
    Drawing drawing;
    for (const int n : {1, 2, 3})
        drawing.box(0, 10.0 * n, 40, 10.0 * n + 4,
                    {{"railway", "platform"}, {"ref", std::to_string(n)}, {"level", n == 3 ? "-1" : "0"}});
    const Scene scene = drawing.scene();
    EXPECT_EQ(honest_report(scene).largest_connected, 2) << "one lies below";
}

TEST(OsmWays, that_end_on_the_floor_of_another_are_joined_to_it) {
    for (const double off_m : {0.0, 0.9, 1.5}) {
        Drawing drawing;
        drawing.way({drawing.node(0, 0), drawing.node(40, 0)},
                    {{"highway", "footway"}, {"level", "1"}, {"name", "Deck"}, {"width", "2"}});
        drawing.way({drawing.node(20, off_m), drawing.node(20, 20)},
                    {{"highway", "footway"}, {"level", "1"}, {"name", "Bridge"}});
        drawing.way({drawing.node(10, 0.5), drawing.node(10, -20)},
                    {{"highway", "footway"}, {"level", "-1"}, {"name", "Tunnel"}});
        const std::vector<std::string> joins = test::joins_of(drawing.scene(), StatedPortalKind::Opening);
        if (off_m < 1.0) EXPECT_THAT(joins, ElementsAre("Bridge | Deck")) << off_m;
        else EXPECT_THAT(joins, IsEmpty()) << off_m;
    }
}

// Two flights lead from a platform to the street in one line. The upper flight states no level, so the landing between
// them is at the height that their lengths give.
TEST(OsmWays, are_joined_by_two_flights_in_a_row_of_which_one_states_no_level) {
    Drawing drawing;
    const int foot = drawing.node(20, 0), landing = drawing.node(20, 12), top = drawing.node(20, 18);
    drawing.way({drawing.node(0, 0), foot, drawing.node(40, 0)},
                {{"railway", "platform"}, {"layer", "-2"}, {"name", "Track 4"}});
    drawing.way({foot, landing}, {{"highway", "steps"}, {"layer", "-2"}});
    drawing.way({landing, top}, {{"highway", "steps"}});
    drawing.way({top, drawing.node(20, 40)}, {{"highway", "footway"}, {"name", "Street"}});
    const Scene scene = drawing.scene();
    const StatedRoom *low = test::room_named(scene, "Track 4"), *high = test::room_named(scene, "Street");
    ASSERT_TRUE(low && high);
    EXPECT_NEAR(low->floor_m, -6.0, 0.01);
    EXPECT_NEAR(high->floor_m, 0.0, 0.01);
    const auto ways = navigation::Navigation::make(scene, navigation::walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways) << ways.error().sentence();
    const navigation::Route route = (*ways)->plan(high->at_m, low->at_m);
    EXPECT_TRUE(route.reaches) << route.short_of_m;
    EXPECT_LT(route.length_m, 60.0);
}

TEST(OsmWays, without_connections_in_the_file_are_not_reported_as_closed) {
    Drawing drawing;
    drawing.box(0, 0, 40, 5, {{"railway", "platform"}, {"ref", "1"}, {"level", "-1"}});
    drawing.box(0, 9, 40, 14, {{"railway", "platform"}, {"ref", "2"}, {"level", "-1"}});
    EXPECT_THAT(drawing.scene().report.warnings, IsEmpty());
}

TEST(OsmLevelNames, match_the_file_everywhere) {
    Drawing drawing;
    const int high = drawing.box(0, 0, 8, 6, {{"buildingpart", "room"}, {"name", "High"}});
    drawing.relation("<member type='way' ref='" + std::to_string(high) + "' role='buildingpart'/>",
                     {{"type", "level"}, {"level", "1"}, {"name", "Upper floor"}});
    drawing.box(0, 0, 8, 6, {{"indoor", "room"}, {"level", "0"}, {"name", "Low"}});
    drawing.box(-1, -1, 20, 7, {{"indoor", "level"}, {"level", "0"}, {"name", "Ground floor"}});
    drawing.box(0, 0, 8, 6, {{"indoor", "room"}, {"level", "-1"}, {"level:ref", "B1"}, {"name", "Cellar"}});
    drawing.box(10, 0, 18, 6, {{"indoor", "room"}, {"level", "-2"}, {"name", "Deep"}});
    const Scene scene = drawing.scene();
    std::vector<std::string> storeys;
    for (const StatedStorey& storey : scene.stated->storeys) storeys.push_back(storey.name);
    EXPECT_THAT(storeys, ElementsAre("Level -2", "Level B1", "Ground floor", "Upper floor"));
    // The description of a room without a name must contain the file's name of the storey.
    const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
    for (const Room& room : make_rooms(scene, (*ways)->space()).rooms)
        if (room.map_name.empty() && room.made.levels > 1 && room.made.thing.empty()) {
            EXPECT_THAT(storeys, Contains(room.made.storey)) << room.name;
        }
}

TEST(OsmLevelsOfWays, make_storeys_of_levels_that_only_footways_reach) {
    Drawing drawing;
    drawing.box(0, 4, 6, 9, {{"indoor", "room"}, {"level", "1"}, {"name", "Shop"}});
    drawing.box(6, 4, 12, 9, {{"indoor", "room"}, {"level", "1"}, {"name", "Kiosk"}});
    drawing.box(12, 4, 18, 9, {{"indoor", "room"}, {"level", "1"}, {"name", "Office"}});
    const int top = drawing.node(20, 0), foot = drawing.node(20, -8);
    drawing.way({drawing.node(0, 0), top, drawing.node(40, 0)},
                {{"highway", "footway"}, {"level", "1"}, {"name", "Concourse"}});
    drawing.way({top, foot}, {{"highway", "steps"}, {"level", "-2;1"}, {"incline", "down"}});
    drawing.way({drawing.node(0, -8), foot, drawing.node(40, -8)},
                {{"highway", "footway"}, {"level", "-2"}, {"name", "Platform 1"}});
    const Scene scene = drawing.scene();
    ASSERT_TRUE(scene.stated);
    std::vector<std::string> storeys;
    for (const StatedStorey& storey : scene.stated->storeys)
        storeys.push_back(storey.name + ": " + std::to_string(storey.rooms));
    EXPECT_THAT(storeys, ElementsAre("Level -2: 1", "Level 1: 4"));
    for (const StatedRoom& room : scene.stated->rooms)
        EXPECT_NEAR(room.floor_m, scene.stated->storeys[room.storey].floor_m, 0.01) << room.name;
    EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Stairs), ElementsAre("Concourse | Platform 1"));
}

TEST(OsmLifts, are_recognised_from_a_node_in_the_rooms_of_several_levels_and_get_doors) {
    for (const Vec2& at : {Vec2(10, 3), Vec2(10, 0.9), Vec2(1.1, 5)}) {
        Drawing drawing;
        for (const char* level : {"0", "1", "2"})
            drawing.box(0, 0, 20, 6,
                        {{"indoor", "corridor"}, {"level", level}, {"name", std::string("Corridor ") + level}});
        drawing.node(at.x, at.y, {{"highway", "elevator"}, {"level", "0-2"}, {"name", "Lift A"}});
        const Scene scene = drawing.scene();
        ASSERT_TRUE(scene.stated);
        EXPECT_EQ(honest_report(scene).lifts, 1);
        EXPECT_EQ(honest_report(scene).largest_connected, 6);
        EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Door),
                    UnorderedElementsAre("Corridor 0 | Lift A, Level 0", "Corridor 1 | Lift A, Level 1",
                                         "Corridor 2 | Lift A, Level 2"));
        EXPECT_THAT(scene.report.guessed, Contains(HasSubstr("One lift is only a point")));
        const auto ways = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
        ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
        EXPECT_TRUE((*ways)->reachable(test::room_named(scene, "Corridor 0")->at_m,
                                       test::room_named(scene, "Corridor 2")->at_m));
    }
}

TEST(OsmLifts, without_space_for_a_cabin_are_reported) {
    Drawing drawing;
    for (const char* level : {"0", "1"})
        drawing.box(0, 0, 1.5, 6, {{"indoor", "corridor"}, {"level", level}, {"name", "Narrow"}});
    drawing.node(0.7, 3, {{"highway", "elevator"}, {"level", "0;1"}});
    const Scene scene = drawing.scene();
    EXPECT_THAT(scene.report.left_out, Contains(HasSubstr("One lift was left out")));
}

TEST(OsmLifts, with_only_an_outline_are_not_a_building_and_hide_no_footways) {
    Drawing drawing;
    drawing.box(0, 4, 2, 6, {{"highway", "elevator"}, {"level", "0;1"}, {"building", "yes"}});
    const int foot = drawing.node(10, 0), top = drawing.node(16, 0);
    drawing.way({drawing.node(-20, 0), foot}, {{"highway", "footway"}, {"level", "0"}, {"name", "Below"}});
    drawing.way({foot, top}, {{"highway", "steps"}, {"level", "0;1"}});
    drawing.way({top, drawing.node(40, 0)}, {{"highway", "footway"}, {"level", "1"}, {"name", "Above"}});
    const Scene scene = drawing.scene();
    ASSERT_TRUE(scene.stated);
    EXPECT_THAT(test::joins_of(scene, StatedPortalKind::Stairs), ElementsAre("Below | Above"));
}

TEST(OsmThings, include_columns_and_furniture_drawn_as_areas) {
    for (const auto& [tags, name] : std::vector<std::pair<Drawing::Tags, std::string>>{
             {{{"indoor", "column"}}, "pillar"},
             {{{"indoor", "pillar"}}, "pillar"},
             {{{"wall:type", "pillar"}}, "pillar"},
             {{{"indoor", "desk"}}, "Desk"},
             {{{"amenity", "bench"}}, "Bench"},
             {{{"indoor", "furniture"}, {"furniture", "counter"}}, "Counter"}}) {
        Drawing drawing;
        drawing.box(0, 0, 8, 6, {{"indoor", "room"}, {"level", "0"}, {"name", "Hall"}});
        Drawing::Tags own = tags;
        own.emplace_back("level", "0");
        drawing.box(3, 2, 4, 3, own);
        const Scene scene = drawing.scene();
        const auto made = std::count_if(scene.features.begin(), scene.features.end(),
                                        [&, &name = name](const Feature& f) { return f.name == name; });
        EXPECT_EQ(made, 1) << name;
    }
}

TEST(OsmIndoorRelations, place_rooms_on_their_level) {
    Drawing drawing;
    const int low = drawing.box(0, 0, 8, 6, {{"buildingpart", "room"}, {"name", "Low"}}),
              high = drawing.box(0, 0, 8, 6, {{"buildingpart", "room"}, {"name", "High"}});
    for (const auto& [way, level] : {std::pair(low, "-1"), std::pair(high, "2")})
        drawing.relation("<member type='way' ref='" + std::to_string(way) + "' role='buildingpart'/>",
                         {{"type", "level"}, {"level", level}});
    const Scene scene = drawing.scene();
    ASSERT_NE(test::room_named(scene, "Low"), nullptr);
    EXPECT_NEAR(test::room_named(scene, "Low")->floor_m, -3.0, 1e-6);
    EXPECT_NEAR(test::room_named(scene, "High")->floor_m, 6.0, 1e-6);
    EXPECT_THAT(scene.report.guessed, Not(Contains(HasSubstr("without a level"))));
}

TEST(OsmIndoorRelations, place_columns_and_footways_on_their_level) {
    Drawing drawing;
    drawing.box(0, 0, 8, 6, {{"indoor", "room"}, {"level", "0"}, {"name", "Low"}});
    const int high = drawing.box(0, 0, 8, 6, {{"buildingpart", "room"}, {"name", "High"}}),
              column = drawing.box(3, 2, 3.5, 2.5, {{"buildingpart", "column"}}),
              way = drawing.way({drawing.node(9, 0), drawing.node(30, 0)}, {{"highway", "footway"}, {"name", "Deck"}});
    for (const int id : {high, column, way})
        drawing.relation("<member type='way' ref='" + std::to_string(id) + "' role='buildingpart'/>",
                         {{"type", "level"}, {"level", "2"}});
    const Scene scene = drawing.scene();
    ASSERT_NE(test::room_named(scene, "Deck"), nullptr);
    EXPECT_NEAR(test::room_named(scene, "Deck")->floor_m, 6.0, 1e-6);
    const auto pillar = std::find_if(scene.features.begin(), scene.features.end(),
                                     [](const Feature& feature) { return feature.name == "pillar"; });
    ASSERT_NE(pillar, scene.features.end());
    EXPECT_NEAR(pillar->bounds_m.min_m.z, 6.0, 0.01);
}

}  // namespace osm_stations_test
}  // namespace handrail
