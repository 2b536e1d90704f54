// Tests whole buildings: the bundled office, and real buildings if HANDRAIL_REAL_WORLDS contains them.
#include <gmock/gmock.h>

#include <set>

#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/real_worlds.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail {
namespace real_files_test {

using ::testing::Contains;
using ::testing::HasSubstr;

std::string rooms_of(const Scene& scene, const StatedPortal& portal) {
    std::string numbers;
    for (const std::uint32_t r : portal.rooms) numbers += (numbers.empty() ? "" : " ") + scene.stated->rooms[r].number;
    return numbers;
}

TEST(Duplex, matches_the_description_of_its_authors) {
    const auto path = test::real_world("duplex-apartment.ifc");
    if (!path) GTEST_SKIP() << test::needs_real_world("duplex-apartment.ifc");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    const Result<void> valid = validate(*scene);
    ASSERT_TRUE(valid.has_value()) << valid.error().sentence();
    const StatedBuilding& stated = *scene->stated;
    EXPECT_EQ(stated.schema, "IFC2X3");
    EXPECT_EQ(stated.rooms.size(), 21U);
    EXPECT_EQ(scene->report.doors, 14);
    EXPECT_EQ(stated.windows.size(), 24U);
    EXPECT_EQ(stated.stairs, 2);
    EXPECT_EQ(stated.furnishings.size(), 61U);
    EXPECT_EQ(stated.storeys.size(), 4U);
    // Expected doors, counted by hand from the 265 space boundaries of the file: 10 doors between two rooms, 4 doors to
    // the outside.
    std::multiset<std::string> doors;
    for (const StatedPortal& portal : stated.portals)
        if (portal.kind == StatedPortalKind::Door) {
            doors.insert(rooms_of(*scene, portal));
            EXPECT_TRUE(portal.passable) << portal.name;
            EXPECT_FALSE(portal.opened_by_box) << portal.name;
        }
    EXPECT_EQ(doors, (std::multiset<std::string>{"A101", "B101", "A102", "B102", "A101 A104", "B104 B101", "A201 A202",
                                                 "A201 A203", "A201 A204", "A205 A204", "B201 B202", "B201 B203",
                                                 "B201 B204", "B205 B204"}));
    // In open-plan flats, borders that are not walls must join rooms, so that each flat is connected.
    int openings = 0;
    for (const StatedPortal& portal : stated.portals)
        if (portal.kind == StatedPortalKind::Opening) {
            ++openings;
            EXPECT_EQ(portal.rooms.size(), 2U);
            EXPECT_EQ(rooms_of(*scene, portal)[0], rooms_of(*scene, portal)[5]) << "of one flat: " << portal.name;
        }
    EXPECT_EQ(openings, 8);
    EXPECT_EQ(largest_connected(stated), 10);
    // The stairs of flat B are in a space called Room.
    std::vector<std::string> odd;
    for (const Diagnostic& warning : scene->report.warnings) odd.push_back(warning.sentence());
    EXPECT_THAT(odd, Contains(HasSubstr("B105")));
    EXPECT_THAT(odd, Not(Contains(HasSubstr("A105"))));
    for (const StatedRoom& room : stated.rooms)
        EXPECT_EQ(room.holds_stairs, room.number == "A105" || room.number == "B105") << room.number;
}

TEST(Office, is_read_as_generated_and_every_room_can_be_walked_to_from_the_front_door) {
    const test::OfficeIfc office = test::office_ifc({2, 1, 3});
    const Result<Scene> scene = read_ifc(office.text, "office.ifc");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    const Result<void> valid = validate(*scene);
    ASSERT_TRUE(valid.has_value()) << valid.error().sentence();
    const StatedBuilding& stated = *scene->stated;
    EXPECT_EQ(static_cast<int>(stated.rooms.size()), office.rooms);
    EXPECT_EQ(scene->report.doors, office.doors);
    EXPECT_EQ(static_cast<int>(stated.windows.size()), office.windows);
    EXPECT_EQ(stated.stairs, office.flights);
    EXPECT_EQ(stated.openings_cut, stated.openings);
    EXPECT_EQ(stated.storeys.size(), 2U);
    ASSERT_FALSE(scene->starts.empty());
    const auto navigation = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(navigation.has_value()) << navigation.error().sentence();
    for (const StatedRoom& room : stated.rooms)
        EXPECT_TRUE((*navigation)->reachable(scene->starts[0].feet_m, room.at_m)) << room.name << room.number;
}

TEST(Duplex, can_be_walked_from_the_front_door_to_the_bedrooms) {
    const auto path = test::real_world("duplex-apartment.ifc");
    if (!path) GTEST_SKIP() << test::needs_real_world("duplex-apartment.ifc");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    const auto navigation = Navigation::make(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
    ASSERT_TRUE(navigation.has_value()) << navigation.error().sentence();
    ASSERT_EQ(scene->starts.size(), 4U);
    const RoomGraph graph = make_rooms(*scene, (*navigation)->space());
    int reached = 0;
    for (const Room& room : graph.rooms)
        if (room.map_name.starts_with("Bedroom")) {
            ++reached;
            EXPECT_TRUE((*navigation)->reachable(scene->starts[0].feet_m, room.middle_m)) << room.name;
        }
    EXPECT_EQ(reached, 4);
}

TEST(RealIfc, houses_of_ifc_4_and_4x3_are_read_completely) {
    const auto house = test::real_world("fzk-haus.ifc"), parts = test::real_world("wall-door-column-ifc4x3.ifc");
    if (!house) GTEST_SKIP() << test::needs_real_world("fzk-haus.ifc");
    if (!parts) GTEST_SKIP() << test::needs_real_world("wall-door-column-ifc4x3.ifc");
    const Result<Scene> scene = read_world(*house);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->stated->rooms.size(), 7U);
    EXPECT_EQ(scene->report.doors, 5);
    EXPECT_EQ(scene->stated->windows.size(), 11U);
    EXPECT_EQ(scene->stated->openings, scene->stated->openings_cut);
    const Result<Scene> few = read_world(*parts);
    ASSERT_TRUE(few.has_value()) << few.error().sentence();
    EXPECT_EQ(few->stated->schema.substr(0, 6), "IFC4X3");
    EXPECT_EQ(few->report.doors, 1);
    EXPECT_GE(few->report.brushes, 3);
    // The file states no room, so the start may be in front of any door.
    ASSERT_EQ(few->starts.size(), 1U);
    const auto ways = Navigation::make(*few, walker_measures(*few, 0.25, 1.8, 0.25));
    ASSERT_TRUE(ways.has_value()) << ways.error().sentence();
    const StatedPortal& door = few->stated->portals[0];
    EXPECT_LT(glm::length(few->starts[0].feet_m - door.place_m), 2.0);
    EXPECT_TRUE((*ways)->reachable(few->starts[0].feet_m, door.place_m));
}

}  // namespace real_files_test
}  // namespace handrail
