// Tests a bundled house. It is small enough to work out the expected values by hand, and always available.
#include <gmock/gmock.h>

#include <map>

#include "tests/support/names.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail {
namespace small_house_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

Scene scene_of(const std::string& text) {
    Result<Scene> scene = read_ifc(text, "house.ifc");
    EXPECT_TRUE(scene.has_value()) << scene.error().sentence();
    if (!scene) return {};
    const Result<void> valid = validate(*scene);
    EXPECT_TRUE(valid.has_value()) << valid.error().sentence();
    return std::move(*scene);
}
std::vector<std::string> rooms_of(const Scene& scene, const StatedPortal& portal) {
    std::vector<std::string> names;
    for (const std::uint32_t r : portal.rooms) names.push_back(scene.stated->rooms[r].name);
    return names;
}

TEST(SmallHouse, has_the_rooms_doors_and_storeys_that_the_file_states) {
    for (const char* file : {"small_house.ifc", "small_house_millimetres.ifc"}) {
        SCOPED_TRACE(file);
        const Scene scene = scene_of(test::small_house(file));
        ASSERT_TRUE(scene.stated);
        const StatedBuilding& stated = *scene.stated;
        EXPECT_EQ(scene.name, "Häuschen");
        ASSERT_EQ(stated.storeys.size(), 1U);
        EXPECT_EQ(stated.storeys[0].name, "Ground floor");
        EXPECT_EQ(stated.storeys[0].rooms, 2);
        ASSERT_EQ(stated.rooms.size(), 2U);
        EXPECT_EQ(stated.rooms[0].name, "Küche");
        EXPECT_NEAR(stated.rooms[0].area_m2, 3.95 * 4.0, 1e-6);
        EXPECT_NEAR(stated.rooms[1].height_m, 2.5, 1e-6);
        ASSERT_EQ(stated.portals.size(), 2U);
        EXPECT_THAT(rooms_of(scene, stated.portals[0]), ElementsAre("Küche"));
        EXPECT_THAT(rooms_of(scene, stated.portals[1]), ElementsAre("Küche", "Living room"));
        EXPECT_NEAR(stated.portals[1].width_m, 0.9, 1e-6);
        EXPECT_EQ(stated.openings, 3);
        EXPECT_EQ(stated.openings_cut, 3);
        EXPECT_EQ(stated.windows.size(), 1U);
        EXPECT_EQ(stated.furnishings.size(), 1U);
        for (const StatedPortal& portal : stated.portals) {
            EXPECT_TRUE(portal.passable);
            EXPECT_FALSE(portal.opened_by_box);
        }
    }
}

TEST(SmallHouse, is_not_named_by_a_file_path) {
    const std::string text = test::small_house(), named = R"('H\X2\00E4\X0\uschen')";
    const std::size_t at = text.find(named);
    ASSERT_NE(at, std::string::npos);
    for (const auto& [path, name] :
         {std::pair(R"('D:\\temp\\Town_hall.ifc')", "Town hall"), std::pair("'/projects/Town_hall.rvt'", "Town hall"),
          std::pair("'Hall 1/2'", "Hall 1/2")})
        EXPECT_EQ(scene_of(std::string(text).replace(at, named.size(), path)).name, name) << path;
}

TEST(SmallHouse, is_solid_in_walls_and_free_in_door_openings) {
    const Scene scene = scene_of(test::small_house());
    EXPECT_TRUE(test::in_a_solid(scene, {0.5, -0.1, 1.0})) << "south wall";
    EXPECT_FALSE(test::in_a_solid(scene, {1.5, -0.1, 1.0})) << "front door";
    EXPECT_TRUE(test::in_a_solid(scene, {1.5, -0.1, 2.2})) << "above it";
    EXPECT_TRUE(test::in_a_solid(scene, {4.0, 0.5, 1.0})) << "wall between";
    EXPECT_FALSE(test::in_a_solid(scene, {4.0, 1.5, 1.0})) << "inner door";
    EXPECT_TRUE(test::in_a_solid(scene, {5.5, 4.1, 0.5})) << "under the window";
    EXPECT_TRUE(test::in_a_solid(scene, {5.5, 4.1, 1.5})) << "its pane";
    EXPECT_FALSE(test::in_a_solid(scene, {5.5, 4.18, 1.5})) << "before the pane";
    EXPECT_TRUE(test::in_a_solid(scene, {6.5, 2.4, 0.5})) << "table";
    EXPECT_FALSE(test::in_a_solid(scene, {2.0, 2.0, 1.0})) << "kitchen";
    EXPECT_TRUE(test::in_a_solid(scene, {-3.0, -3.0, -0.1})) << "ground outside";
}

TEST(SmallHouse, has_leaves_that_swing_as_ifc_defines) {
    const Scene scene = scene_of(test::small_house());
    ASSERT_EQ(scene.movers.size(), 2U);
    // The x axis of the front door points east. The door opens to the north about its west edge, so it turns
    // counter-clockwise.
    EXPECT_NEAR(scene.movers[0].swing_rad, 0.5 * kPi, 1e-12);
    EXPECT_NEAR(scene.movers[0].pivot_m.x, 1.005, 1e-6);
    EXPECT_EQ(scene.features[scene.movers[0].feature.value].hinge, "west");
    EXPECT_EQ(scene.features[scene.movers[1].feature.value].hinge, "south");
    EXPECT_EQ(scene.features[scene.movers[0].feature.value].kind, FeatureKind::Door);
}

TEST(SmallHouse, can_be_walked_through_by_the_rooms_of_its_file) {
    const Scene scene = scene_of(test::small_house());
    const auto navigation = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(navigation.has_value()) << navigation.error().sentence();
    const RoomGraph graph = make_rooms(scene, (*navigation)->space());
    std::vector<std::string> names;
    for (const Room& room : graph.rooms) names.push_back(room.name);
    EXPECT_THAT(names, UnorderedElementsAre("ground outside", "Küche", "Living room"));
    ASSERT_EQ(graph.portals.size(), 2U);
    for (const Portal& portal : graph.portals)
        EXPECT_EQ(portal.kind, PassageKind::Door)
            << graph.rooms[portal.rooms[0]].name << " and " << graph.rooms[portal.rooms[1]].name << " at "
            << portal.place_m.x << " " << portal.place_m.y;
    ASSERT_EQ(scene.starts.size(), 1U);
    EXPECT_TRUE((*navigation)->reachable(scene.starts[0].feet_m, scene.stated->rooms[1].at_m));
}

// Describes a building for comparisons: its rooms, what joins them, and route lengths between fixed places. `shift_m`
// is the position of the building's zero.
struct FoundInIt {
    std::vector<std::string> rooms, joins;
    std::vector<Vec3> doors_m;
    std::vector<double> widths_m, ways_m;
};
FoundInIt found_in(const Scene& scene, const Vec3& shift_m) {
    FoundInIt found;
    const auto navigation = Navigation::make(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    EXPECT_TRUE(navigation.has_value()) << navigation.error().sentence();
    if (!navigation) return found;
    const RoomGraph graph = make_rooms(scene, (*navigation)->space());
    for (const Room& room : graph.rooms) found.rooms.push_back(room.name);
    std::sort(found.rooms.begin(), found.rooms.end());
    std::vector<Portal> portals = graph.portals;
    std::sort(portals.begin(), portals.end(),
              [](const Portal& a, const Portal& b) { return a.place_m.x < b.place_m.x; });
    for (const Portal& portal : portals) {
        const auto names = std::minmax(graph.rooms[portal.rooms[0]].name, graph.rooms[portal.rooms[1]].name);
        found.joins.push_back(fmt::format("{} {} {} {}", static_cast<int>(portal.kind), names.first, names.second,
                                          scene.find(portal.feature) ? scene.features[portal.feature.value].name : ""));
        found.doors_m.push_back(portal.place_m - shift_m);
        found.widths_m.push_back(portal.width_m);
    }
    const std::vector<Vec3> places{{1.5, -1.2, 0.0}, {1.2, 3.0, 0.0}, {7.2, 0.8, 0.0}, {7.5, 3.5, 0.0}};
    for (std::size_t a = 0; a < places.size(); ++a)
        for (std::size_t b = a + 1; b < places.size(); ++b) {
            const Route route =
                (*navigation)->plan(places[a] + shift_m, places[b] + shift_m, RoutePreference::Shortest);
            double length = 0.0;
            for (std::size_t i = 1; i < route.points_m.size(); ++i)
                length += glm::length(route.points_m[i] - route.points_m[i - 1]);
            found.ways_m.push_back(length);
        }
    return found;
}

// The same house as another program writes it. The file uses IFC 4 and feet, the site is elsewhere, and walls have
// centre lines. Openings are in the coordinates of their walls, a table is a mapped tessellation, and spaces are shells
// with boundaries. All instances are in another order.
TEST(SmallHouse, exported_by_another_program_has_the_same_rooms_doors_joins_and_routes) {
    constexpr double kSame_m = 0.05;
    const Scene one = scene_of(test::small_house()),
                other = scene_of(test::small_house("small_house_other_program.ifc"));
    const Vec3 shift_m(1200.0, -350.0, 80.0);
    ASSERT_TRUE(one.stated && other.stated);
    EXPECT_EQ(other.stated->schema, "IFC4");
    ASSERT_EQ(other.stated->rooms.size(), one.stated->rooms.size());
    for (std::size_t r = 0; r < one.stated->rooms.size(); ++r) {
        const StatedRoom& a = one.stated->rooms[r];
        const auto same = std::find_if(other.stated->rooms.begin(), other.stated->rooms.end(),
                                       [&](const StatedRoom& room) { return room.name == a.name; });
        ASSERT_NE(same, other.stated->rooms.end()) << a.name;
        const StatedRoom& b = *same;
        EXPECT_EQ(b.number, a.number);
        EXPECT_LT(glm::length(b.at_m - shift_m - a.at_m), kSame_m);
        EXPECT_NEAR(b.area_m2, a.area_m2, 0.05);
        EXPECT_NEAR(b.height_m, a.height_m, kSame_m);
    }
    ASSERT_EQ(other.stated->portals.size(), one.stated->portals.size());
    for (const StatedPortal& door : one.stated->portals) {
        const auto same = std::find_if(other.stated->portals.begin(), other.stated->portals.end(),
                                       [&](const StatedPortal& portal) { return portal.name == door.name; });
        ASSERT_NE(same, other.stated->portals.end()) << door.name;
        EXPECT_EQ(same->kind, door.kind);
        EXPECT_THAT(rooms_of(other, *same), testing::UnorderedElementsAreArray(rooms_of(one, door)));
        EXPECT_LT(glm::length(same->place_m - shift_m - door.place_m), kSame_m);
        EXPECT_NEAR(same->width_m, door.width_m, kSame_m);
        EXPECT_TRUE(same->passable && !same->opened_by_box);
        EXPECT_NE(same->by_boundaries, door.by_boundaries) << "one file has boundaries, the other has none";
    }
    EXPECT_EQ(other.stated->windows.size(), one.stated->windows.size());
    EXPECT_EQ(other.stated->furnishings.size(), one.stated->furnishings.size());
    EXPECT_EQ(other.stated->openings_cut, one.stated->openings_cut);
    ASSERT_EQ(other.movers.size(), one.movers.size());
    for (std::size_t m = 0; m < one.movers.size(); ++m) EXPECT_EQ(other.movers[m].swing_rad, one.movers[m].swing_rad);
    const FoundInIt a = found_in(one, Vec3(0.0)), b = found_in(other, shift_m);
    EXPECT_EQ(b.rooms, a.rooms);
    EXPECT_EQ(b.joins, a.joins);
    ASSERT_EQ(a.joins.size(), 2U);
    ASSERT_EQ(b.doors_m.size(), a.doors_m.size());
    for (std::size_t i = 0; i < a.doors_m.size(); ++i) {
        EXPECT_LT(glm::length(b.doors_m[i] - a.doors_m[i]), kSame_m);
        EXPECT_NEAR(b.widths_m[i], a.widths_m[i], kSame_m);
    }
    ASSERT_EQ(b.ways_m.size(), 6U);
    for (std::size_t i = 0; i < a.ways_m.size(); ++i) {
        EXPECT_GT(a.ways_m[i], 1.0);
        EXPECT_NEAR(b.ways_m[i], a.ways_m[i], kSame_m);
    }
}

TEST(SmallHouse, joins_rooms_with_a_border_but_no_wall_in_the_file) {
    // Both rooms reach to the middle of the wall between them. The test uses three variants of the file: with the wall,
    // without the wall, and with the wall and a virtual border.
    std::string walled = test::small_house();
    for (const char* corner : {"#159=IFCCARTESIANPOINT((3.95,0.))", "#160=IFCCARTESIANPOINT((3.95,4.))",
                               "#168=IFCCARTESIANPOINT((4.05,0.))", "#171=IFCCARTESIANPOINT((4.05,4.))"})
        walled = test::replaced(walled, corner, std::string(corner, 24) + "4." + std::string(corner + 28));
    walled = test::with_instances(walled,
                                  "#90001=IFCRELSPACEBOUNDARY('b1',$,$,$,#167,$,$,.VIRTUAL.,.INTERNAL.);\n"
                                  "#90002=IFCRELSPACEBOUNDARY('b2',$,$,$,#177,$,$,.VIRTUAL.,.INTERNAL.);\n");
    const auto without = [](std::string text, const std::string& instance) {
        const std::size_t at = text.find("\n" + instance) + 1;
        return text.erase(at, text.find('\n', at) + 1 - at);
    };
    std::string shut = test::replaced(walled, ",#108,#124,", ",#108,");
    for (const char* instance : {"#122=", "#123=", "#124=", "#125="}) shut = without(shut, instance);
    std::string open = without(shut, "#67=");
    for (const char* among : {"(#27,#37,#47,#57,#67)", "(#27,#37,#47,#57,#67,#80,"})
        open = test::replaced(open, among, std::string(among, 16) + std::string(among + 20));
    const auto openings = [](const Scene& scene) {
        std::vector<StatedPortal> found;
        for (const StatedPortal& portal : scene.stated->portals)
            if (portal.kind == StatedPortalKind::Opening) found.push_back(portal);
        return found;
    };
    const Scene scene = scene_of(open);
    const std::vector<StatedPortal> found = openings(scene);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_THAT(rooms_of(scene, found[0]), ElementsAre("Küche", "Living room"));
    EXPECT_NEAR(found[0].place_m.x, 4.0, 1e-9);
    EXPECT_NEAR(found[0].place_m.y, 2.0, 0.5);
    EXPECT_NEAR(found[0].width_m, 4.0, 1e-9);
    EXPECT_GT(found[0].source.line, 0);
    EXPECT_TRUE(openings(scene_of(shut)).empty()) << "nobody goes through a wall";
    EXPECT_TRUE(openings(scene_of(walled)).empty()) << "the door joins them already";
    EXPECT_TRUE(openings(scene_of(test::small_house())).empty());
}

// Many files contain walls and doors but no rooms.
TEST(SmallHouse, without_rooms_starts_in_front_of_a_door_and_without_doors_on_the_ground) {
    const auto without = [](std::string text, const std::string& kind) {
        for (std::size_t at = text.find(kind); at != std::string::npos; at = text.find(kind)) {
            const std::size_t line = text.rfind('\n', at) + 1;
            text.erase(line, text.find('\n', at) + 1 - line);
        }
        return text;
    };
    const std::string no_rooms = without(test::small_house(), "=IFCSPACE(");
    for (const bool doors : {true, false}) {
        const Result<Scene> scene = read_ifc(doors ? no_rooms : without(no_rooms, "=IFCDOOR("), "house.ifc");
        ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
        EXPECT_TRUE(scene->stated->rooms.empty());
        EXPECT_EQ(scene->report.doors, doors ? 2 : 0);
        ASSERT_FALSE(scene->starts.empty());
        const Start& start = scene->starts.front();
        EXPECT_TRUE(start.base);
        EXPECT_FALSE(test::in_a_solid(*scene, start.feet_m + Vec3(0, 0, 0.1)));
        EXPECT_TRUE(test::in_a_solid(*scene, start.feet_m - Vec3(0, 0, 0.05)));
        const auto ways = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
        ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
        EXPECT_TRUE((*ways)->reachable(start.feet_m, {6, 2, 0})) << "through the front door into the hall";
        if (doors) {
            EXPECT_EQ(start.name, "front door");
        }
    }
}

TEST(SmallHouse, gets_assumed_wall_materials_which_are_reported) {
    const Scene scene = scene_of(test::small_house());
    EXPECT_TRUE(std::any_of(scene.materials.begin(), scene.materials.end(),
                            [](const Material& m) { return m.name == "brick" && m.guessed; }));
    ASSERT_FALSE(scene.report.guessed.empty());
    EXPECT_THAT(scene.report.guessed[0], HasSubstr("Ziegel"));
}

TEST(SmallHouse, keeps_its_place_if_its_site_is_thousands_of_kilometres_away) {
    const std::string text = test::small_house();
    // Among the placements, only this one is below the site. Its point moves to a place near Karlsruhe in Gauss-Krueger
    // metres.
    const std::size_t line = text.find("=IFCLOCALPLACEMENT($,#");
    ASSERT_NE(line, std::string::npos);
    const std::string axis = text.substr(line + 22, text.find(')', line) - line - 22);
    const std::size_t of_axis = text.find(axis + "=IFCAXIS2PLACEMENT3D(");
    ASSERT_NE(of_axis, std::string::npos);
    const std::string axis_line = text.substr(of_axis, text.find(';', of_axis) - of_axis);
    const std::string point = axis_line.substr(axis_line.find('(') + 1, axis_line.find(',') - axis_line.find('(') - 1);
    const Scene far = scene_of(test::replaced(text, point + "=IFCCARTESIANPOINT((0.,0.,0.))",
                                              point + "=IFCCARTESIANPOINT((3457000.125,5432000.25,115.))"));
    const Scene near = scene_of(text);
    ASSERT_EQ(far.solids.size(), near.solids.size());
    EXPECT_EQ(far.stated->openings_cut, 3);
    for (std::size_t i = 0; i < far.solids.size(); ++i)
        EXPECT_LT(glm::length(far.solids[i].shape.bounds_m.min_m - near.solids[i].shape.bounds_m.min_m), 1e-5)
            << "solid " << i;
}

TEST(SmallHouse, gets_a_blocked_door_cut_open_with_a_box_and_names_door_and_obstacle) {
    // Adds a beam with the place and shape of the wall between the rooms. The beam has no opening.
    const std::string text = test::small_house();
    const std::size_t at = text.find("'middle'");
    ASSERT_NE(at, std::string::npos);
    const std::size_t begin = text.rfind('\n', at) + 1, end = text.find('\n', at);
    std::string wall = text.substr(begin, end - begin + 1);
    wall = "#90001" + wall.substr(wall.find('='));
    const std::string beam = test::replaced(test::replaced(wall, "'middle'", "'forgotten beam'"), "IFCWALL", "IFCBEAM");
    const Scene scene = scene_of(test::with_instances(text, beam));
    EXPECT_TRUE(scene.stated->portals[1].opened_by_box);
    EXPECT_TRUE(scene.stated->portals[1].passable);
    EXPECT_FALSE(scene.stated->portals[0].opened_by_box);
    ASSERT_EQ(scene.report.warnings.size(), 1U);
    EXPECT_THAT(scene.report.warnings[0].sentence(), AllOf(HasSubstr("inner door"), HasSubstr("forgotten beam")));
    EXPECT_FALSE(test::in_a_solid(scene, {4.0, 1.45, 1.0}));
    // A second wall at the same place is treated as the same wall, so it must not block the door.
    const Scene twice = scene_of(test::with_instances(text, wall));
    EXPECT_FALSE(twice.stated->portals[1].opened_by_box);
    EXPECT_TRUE(twice.stated->portals[1].passable);
}

// If a file contains the same wall several times, the reader must cut the wall's openings, whichever copy comes first.
TEST(SmallHouse, is_felt_once_if_its_file_contains_a_wall_many_times) {
    const std::string house = test::small_house();
    const Result<Scene> once = read_ifc(house, "once.ifc");
    ASSERT_TRUE(once.has_value());
    const std::size_t at = house.find("=IFCWALL(");
    const std::string wall = house.substr(at, house.find(';', at) + 1 - at) + "\n";
    std::string more;
    for (int i = 0; i < 500; ++i) more += "#" + std::to_string(100'000 + i) + wall;
    const std::size_t line = house.rfind('\n', at) + 1;
    const std::string first = house.substr(0, line) + "#99999" + wall + house.substr(line);
    for (const std::string& text : {test::with_instances(house, more), test::with_instances(first, more)}) {
        const Result<Scene> often = read_ifc(text, "often.ifc");
        ASSERT_TRUE(often.has_value()) << often.error().sentence();
        EXPECT_EQ(often->solids.size(), once->solids.size());
        EXPECT_EQ(often->stated->openings_cut, once->stated->openings_cut);
        for (std::size_t i = 0; i < once->solids.size(); ++i)
            EXPECT_EQ(often->solids[i].shape.bounds_m.min_m, once->solids[i].shape.bounds_m.min_m) << i;
        EXPECT_THAT(often->report.left_out,
                    ::testing::Contains(::testing::HasSubstr("exactly the same positions as others")));
    }
    EXPECT_THAT(once->report.left_out,
                ::testing::Not(::testing::Contains(::testing::HasSubstr("exactly the same position"))));
}

TEST(SmallHouse, gives_the_same_scene_for_the_same_bytes) {
    const Scene a = scene_of(test::small_house()), b = scene_of(test::small_house());
    ASSERT_EQ(a.solids.size(), b.solids.size());
    for (std::size_t i = 0; i < a.solids.size(); ++i) {
        ASSERT_EQ(a.solids[i].shape.planes.size(), b.solids[i].shape.planes.size());
        for (std::size_t k = 0; k < a.solids[i].shape.planes.size(); ++k)
            EXPECT_EQ(a.solids[i].shape.planes[k].offset_m, b.solids[i].shape.planes[k].offset_m);
    }
    EXPECT_EQ(a.features.size(), b.features.size());
}

}  // namespace small_house_test
}  // namespace handrail
