// Tests places that are too large for fine columns. A walker must still be able to walk in such a place, and the reader
// must report the omitted parts.
#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/osm/drawing.h"
#include "tests/unit/osm/osm_text.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/honest_report.h"

namespace handrail {
namespace large_places_test {

using test::Drawing;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::shared_ptr<Navigation> ways_of(const Scene& scene) {
    const auto made = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    EXPECT_TRUE(made.has_value()) << made.error().sentence();
    return made ? *made : nullptr;
}

TEST(OsmLargePlaces, have_a_route_between_two_stops_600_m_apart) {
    Drawing drawing;
    const int west = drawing.node(20, 3), east = drawing.node(600, 597);
    drawing.box(0, 0, 40, 6, {{"railway", "platform"}, {"ref", "1"}});
    drawing.box(590, 594, 630, 600, {{"railway", "platform"}, {"ref", "2"}});
    drawing.way({west, east}, {{"highway", "footway"}, {"name", "Link"}});
    const Scene scene = drawing.scene();
    const auto ways = ways_of(scene);
    ASSERT_TRUE(ways);
    const StatedRoom *first = test::room_named(scene, "Platform 1"), *second = test::room_named(scene, "Platform 2");
    ASSERT_TRUE(first && second);
    const Route route = ways->plan(first->at_m, second->at_m);
    EXPECT_TRUE(route.reaches);
    const double straight_m = glm::length(second->at_m - first->at_m);
    EXPECT_GE(route.length_m, straight_m - 1.0);
    EXPECT_LE(route.length_m, 1.1 * straight_m);
}

// Returns the number of floors at `at` on which a walker can stand.
std::size_t floors_at(const WalkSpace& space, const Vec2& at) {
    std::size_t floors = 0;
    for (double floor_m = -10.0; floor_m <= 10.0; floor_m += 1.0)
        floors += space.nearest(Vec3(at, floor_m), 1.0, 0.5, 0.5) != kNothing ? 1 : 0;
    return floors;
}

TEST(OsmLargePlaces, omit_ground_far_from_everything_and_report_it) {
    Drawing drawing;
    for (const double at_m : {0.0, 700.0}) {
        drawing.box(at_m, at_m, at_m + 40, at_m + 6,
                    {{"railway", "platform"}, {"ref", std::to_string(static_cast<int>(at_m))}});
    }
    const Scene scene = drawing.scene();
    const auto ways = ways_of(scene);
    ASSERT_TRUE(ways);
    EXPECT_THAT(ways->said(), Contains(HasSubstr("so much ground outdoors")));
    const Vec3 ground = scene.starts[0].feet_m;
    const Vec2 near(scene.starts[0].feet_m);
    EXPECT_GT(floors_at(ways->space(), near), 0U);
    EXPECT_EQ(floors_at(ways->space(), near + Vec2(-300, 350)), 0U) << ground.z;
    EXPECT_LE(ways->space().cell_m, 0.2) << "too coarse for doors";
}

// Returns a station with 20 platforms on 640 by 550 m, and a hall with 1,300 rooms along corridors on 5 levels. A lift
// joins the levels.
Drawing station() {
    Drawing drawing;
    constexpr int kRooms = 130;  // number of rooms on each side of a corridor
    constexpr double kRoom_m = 4.0, kSouth_m = 5.0, kNorth_m = 9.0;
    const double length_m = kRooms * kRoom_m;
    for (int level = -2; level <= 2; ++level) {
        const std::string on = std::to_string(level);
        drawing.box(0, kSouth_m, length_m, kNorth_m,
                    {{"indoor", "corridor"}, {"level", on}, {"name", "Corridor " + on}});
        for (int r = 0; r < kRooms; ++r) {
            const double west_m = r * kRoom_m, east_m = west_m + kRoom_m, door_m = west_m + 0.5 * kRoom_m;
            const std::string number = on + " " + std::to_string(r);
            drawing.box(west_m, 0, east_m, kSouth_m, {{"indoor", "room"}, {"level", on}, {"name", "South " + number}});
            drawing.box(west_m, kNorth_m, east_m, 14, {{"indoor", "room"}, {"level", on}, {"name", "North " + number}});
            drawing.node(door_m, kSouth_m, {{"door", "hinged"}, {"level", on}});
            drawing.node(door_m, kNorth_m, {{"door", "hinged"}, {"level", on}});
        }
    }
    drawing.node(6, 7, {{"highway", "elevator"}, {"level", "-2-2"}, {"name", "Lift"}});
    drawing.node(0, 7, {{"entrance", "main"}, {"door", "sliding"}, {"level", "0"}});
    std::vector<int> spine{drawing.node(-0.5, 7), drawing.node(-5, 7)};
    for (int p = 1; p <= 20; ++p) {
        const double north_m = 25.0 * p + 20.0;
        drawing.box(10, north_m - 3, 630, north_m + 3,
                    {{"railway", "platform"}, {"ref", std::to_string(p)}, {"level", "0"}});
        spine.push_back(drawing.node(-5, north_m));
        drawing.way({spine.back(), drawing.node(11, north_m)}, {{"highway", "footway"}, {"level", "0"}});
    }
    drawing.way(spine, {{"highway", "footway"}, {"name", "Spine"}, {"level", "0"}});
    return drawing;
}

TEST(OsmLargePlaces, can_be_walked_in_a_station_of_20_platforms_and_1300_rooms) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "too large for a sanitizer";
    const Scene scene = station().scene();
    ASSERT_TRUE(scene.stated);
    EXPECT_EQ(scene.stated->lifts, 1);
    EXPECT_GE(honest_report(scene).largest_connected, 1'300 + 5 + 20);
    const auto ways = ways_of(scene);
    ASSERT_TRUE(ways);
    ASSERT_NE(ways->mesh(), nullptr);
    EXPECT_LE(ways->space().cell_m, 0.2) << "too coarse for doors";
    const Vec3 start = scene.starts[0].feet_m;
    for (const char* name :
         {"Platform 1", "Platform 20", "South 0 129", "North 2 64", "South -2 3", "North -1 129", "Corridor 1"}) {
        const StatedRoom* room = test::room_named(scene, name);
        ASSERT_NE(room, nullptr) << name;
        EXPECT_TRUE(ways->plan(start, room->at_m).reaches) << name;
        EXPECT_TRUE(ways->plan(room->at_m, start).reaches) << name;
    }
    const RoomGraph graph = make_rooms(scene, ways->space());
    std::set<std::string> found;
    for (const Room& room : graph.rooms) found.insert(room.map_name);
    std::size_t missed = 0;
    for (const StatedRoom& room : scene.stated->rooms) missed += found.contains(room.name) ? 0 : 1;
    EXPECT_EQ(missed, 0U);
}

// Returns two buildings with one room each, 1 km apart. A footway is in front of each.
Drawing two_buildings() {
    Drawing drawing;
    for (const auto& [east_m, name] : {std::pair(0.0, "Old"), std::pair(1'000.0, "New")}) {
        drawing.box(east_m - 1, -1, east_m + 21, 9, {{"building", "yes"}, {"name", std::string(name) + " House"}});
        for (const int half : {0, 1})
            drawing.box(east_m + 10 * half, 0, east_m + 10 * half + 10, 8,
                        {{"indoor", "room"}, {"level", "0"}, {"name", std::string(name) + (half ? " Hall" : " Room")}});
        drawing.way({drawing.node(east_m, -10), drawing.node(east_m + 20, -10)},
                    {{"highway", "footway"}, {"name", std::string(name) + " Path"}});
    }
    return drawing;
}

TEST(OsmLargePlaces, with_two_buildings_read_one_with_its_surroundings_and_report_the_rest) {
    for (const std::string mine : {"Old", "New"}) {
        const std::string other = mine == "Old" ? "New" : "Old";
        ReadOptions options;
        options.building = mine + " House";
        const Result<Scene> scene = read_osm(two_buildings().text(), "two.osm", options);
        ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
        EXPECT_NE(test::room_named(*scene, mine + " Path"), nullptr);
        EXPECT_EQ(test::room_named(*scene, other + " Path"), nullptr);
        EXPECT_LT(scene->bounds_m.size_m().x, 200.0);
        EXPECT_THAT(scene->report.left_out, Contains(HasSubstr("more than 100 metres from the building")));
    }
}

TEST(OsmWaysOutside, of_a_building_with_doors_can_be_walked_and_indoor_ones_add_nothing) {
    Drawing drawing;
    drawing.box(0, 0, 10, 6, {{"indoor", "room"}, {"level", "0"}, {"name", "Hall"}});
    drawing.box(10, 0, 20, 6, {{"indoor", "room"}, {"level", "0"}, {"name", "Office"}});
    drawing.node(10, 3, {{"door", "yes"}, {"level", "0"}});
    drawing.node(0, 3, {{"door", "yes"}, {"entrance", "main"}, {"level", "0"}});
    drawing.way({drawing.node(-0.2, 3), drawing.node(-20, 3)}, {{"highway", "footway"}, {"name", "Path"}});
    drawing.way({drawing.node(2, 3), drawing.node(8, 3)}, {{"highway", "footway"}, {"name", "Inner"}});
    drawing.box(-30, 0, -20, 4, {{"railway", "platform"}, {"ref", "1"}});
    const Scene scene = drawing.scene();
    EXPECT_NE(test::room_named(scene, "Path"), nullptr);
    EXPECT_NE(test::room_named(scene, "Platform 1"), nullptr);
    EXPECT_EQ(test::room_named(scene, "Inner"), nullptr);
    EXPECT_EQ(honest_report(scene).largest_connected, 4) << "Hall, Office, Path and Platform 1";
    EXPECT_TRUE(scene.report.warnings.empty()) << scene.report.warnings[0].sentence();
}

TEST(OsmWaysOutside, on_the_ground_without_a_footway_are_not_reported_as_closed) {
    Drawing drawing;
    drawing.box(0, 0, 40, 4, {{"railway", "platform"}, {"ref", "1"}});
    drawing.box(0, 8, 40, 12, {{"railway", "platform"}, {"ref", "2"}});
    const Scene scene = drawing.scene();
    EXPECT_TRUE(scene.report.warnings.empty()) << scene.report.warnings[0].sentence();
    EXPECT_THAT(honest_report(scene).check, IsEmpty());
}

TEST(OsmWaysOutside, may_be_a_relation_tagged_indoor_that_is_not_a_room) {
    for (const Drawing::Tags& tags : {Drawing::Tags{{"indoor", "yes"}}, Drawing::Tags{}}) {
        Drawing drawing;
        const int first = drawing.node(0, 0);
        const int outer = drawing.way({first, drawing.node(40, 0), drawing.node(40, 6), drawing.node(0, 6), first}, {});
        Drawing::Tags all = tags;
        all.insert(all.end(), {{"type", "multipolygon"}, {"railway", "platform"}, {"level", "0"}, {"ref", "7"}});
        drawing.relation("<member type='way' ref='" + std::to_string(outer) + "' role='outer'/>", all);
        EXPECT_NE(test::room_named(drawing.scene(), "Platform 7"), nullptr) << tags.size();
    }
}

TEST(OsmLevelsOfWays, do_not_count_a_footway_that_only_slopes_up_to_a_level_as_a_storey) {
    Drawing drawing;
    const int a = drawing.node(0, 0), b = drawing.node(20, 0), c = drawing.node(40, 0);
    drawing.way({a, b}, {{"highway", "footway"}, {"level", "0"}, {"name", "Lower"}});
    drawing.way({b, c}, {{"highway", "footway"}, {"level", "1"}, {"name", "Sloping"}});
    drawing.way({c, drawing.node(60, 0)}, {{"highway", "footway"}, {"level", "0"}, {"name", "Other"}});
    const Scene scene = drawing.scene();
    ASSERT_TRUE(scene.stated);
    ASSERT_EQ(scene.stated->storeys.size(), 1U);
    EXPECT_EQ(scene.stated->storeys[0].name, "Level 0");
    EXPECT_EQ(scene.stated->storeys[0].rooms, 3);
}

// Stairs and a lift between corridors. The mapper has drawn them separately on every level.
TEST(OsmStacks, of_stairs_or_lifts_drawn_on_each_level_join_the_levels) {
    for (const std::string kind : {"stairs", "elevator"}) {
        Drawing drawing;
        for (const char* level : {"-1", "0", "1"}) {
            drawing.box(0, 0, 20, 4, {{"indoor", "corridor"}, {"level", level}, {"name", "Corridor"}});
            Drawing::Tags tags{{"level", level}};
            if (kind == "stairs") tags.emplace_back("stairs", "yes");
            else tags.emplace_back("indoor", kind);
            drawing.box(20, 0, kind == "stairs" ? 27 : 22.5, kind == "stairs" ? 4 : 2.5, tags);
            drawing.node(20, 1.25, {{"door", "sliding"}, {"level", level}});
        }
        const Scene scene = drawing.scene();
        ASSERT_TRUE(scene.stated);
        const HonestReport report = honest_report(scene);
        EXPECT_EQ(report.stairs + report.lifts, 1) << kind;
        EXPECT_EQ(report.largest_connected, static_cast<int>(scene.stated->rooms.size())) << kind;
        const auto ways = ways_of(scene);
        ASSERT_TRUE(ways);
        const Vec3 low = scene.stated->rooms.front().at_m;
        EXPECT_TRUE(ways->reachable(low, Vec3(low.x, low.y, low.z + 6.0))) << kind;
    }
}

TEST(OsmRealFiles, join_the_rooms_of_aachen_across_storeys) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "too large for a sanitizer";
    const auto path = test::real_world("aachen-university.osm");
    if (!path) GTEST_SKIP() << test::needs_real_world("aachen-university.osm");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    const HonestReport report = honest_report(*scene);
    EXPECT_GT(10 * report.largest_connected, 9 * report.rooms) << report.largest_connected << " of " << report.rooms;
}

TEST(OsmRealFiles, of_large_stations_can_be_walked) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "too large for a sanitizer";
    for (const char* name : {"frankfurt-hauptwache.osm", "cologne-central.osm", "london-waterloo.osm.pbf"}) {
        const auto path = test::real_world(name);
        if (!path) GTEST_SKIP() << test::needs_real_world(name);
        const Result<Scene> scene = read_world(*path);
        ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
        const auto ways = ways_of(*scene);
        ASSERT_TRUE(ways) << name;
        EXPECT_LE(ways->space().cell_m, 0.2) << name;
        std::size_t reached = 0;
        for (const StatedRoom& room : scene->stated->rooms)
            reached += ways->reachable(scene->starts[0].feet_m, room.at_m) ? 1 : 0;
        RecordProperty(std::string("reached_of_") + std::to_string(scene->stated->rooms.size()),
                       static_cast<int>(reached));
        EXPECT_GE(reached, 3U) << name;
    }
}

}  // namespace large_places_test
}  // namespace handrail
