// Tests floors that end without a wall. Rows of short lines must show the edge, signs must stand on the floor, and the
// sheet must show nothing beyond the edge.
#include "worlds/exports/floor_edges.h"

#include <gtest/gtest.h>

#include "tests/support/lay_floor.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/exports/plans.h"
#include "worlds/exports/openings.h"
#include "worlds/exports/storey_stl.h"
#include "worlds/exports/swell_sheet.h"
#include "worlds/plan/storey_grid.h"

namespace handrail::test {
namespace floor_edges_test {

bool says(const SwellSheet& sheet, const std::string& text) { return sheet.plan.text.find(text) != std::string::npos; }

// Returns two platforms, 8 m apart, with nothing around them.
Storey two_platforms() {
    Storey storey = two_rooms();
    storey.max_m = {20.0, 4.7};
    storey.walls_m.clear();
    storey.gaps.clear();
    storey.portals.clear();
    storey.things.clear();
    StoreyRoom& second = storey.rooms[1];
    second.loops_m = {{{14.0, 0.25}, {19.0, 0.25}, {19.0, 3.75}, {14.0, 3.75}}};
    second.min_m = {14.0, 0.25};
    second.max_m = {19.0, 3.75};
    second.middle_m = {16.5, 2.0};
    lay_floor(storey);
    find_beyond(storey);
    return storey;
}

// Returns the number of the sheet's short lines near the line from `from_m` to `to_m` in the world.
int lines_along(const SwellSheet& sheet, const Vec2& from_m, const Vec2& to_m) {
    int lines = 0;
    for (const SheetShape& shape : sheet.plan.shapes) {
        if (shape.part == kWallPart || shape.loops_mm.size() != 1 || shape.loops_mm[0].size() != 4) continue;
        Vec2 middle(0.0);
        for (const Vec2& p : shape.loops_mm[0]) middle += 0.25 * p;
        constexpr double kNear_m = 0.5;
        if (distance_to_loop_mm({from_m, to_m}, sheet.on_paper.world(middle)) < kNear_m) ++lines;
    }
    return lines;
}

// Returns how many lines along this length an edge should have at least. Some may lack space, at corners and signs.
int enough_lines(const SwellSheet& sheet, double length_m) {
    constexpr double kLineAndGap_mm = 7.5;
    return static_cast<int>(0.7 * length_m * sheet.on_paper.mm_per_m / kLineAndGap_mm);
}

TEST(FloorEdges, are_rows_of_short_lines_where_no_wall_is) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the smaller sheets of this file";
    Storey storey = two_rooms();
    storey.things.clear();
    storey.walls_m.erase(storey.walls_m.begin() + 1);  // removes the north wall
    find_beyond(storey);
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_GE(lines_along(*sheet, {0.0, 4.1}, {9.2, 4.1}), enough_lines(*sheet, 9.2));
    EXPECT_EQ(lines_along(*sheet, {0.5, 0.0}, {8.7, 0.0}), 0) << "a wall is there";
    EXPECT_TRUE(says(*sheet, "edges, where a floor ends without a wall: Kitchen; Room 12.")) << sheet->plan.text;
    EXPECT_FALSE(says(*sheet, "have no lines there")) << sheet->plan.text;
    EXPECT_TRUE(check_gaps(sheet->plan, kLeastGap_mm).narrow_mm.empty());
    EXPECT_TRUE(sheet->broken.empty());
}

TEST(FloorEdges, have_lines_in_every_direction) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the smaller sheets of this file";
    for (const double degrees : {5.0, 20.0, 30.0, 45.0, 70.0}) {
        const double turn = degrees / 180.0 * std::numbers::pi;
        const Vec2 along(std::cos(turn), std::sin(turn)), across(-along.y, along.x), from(5.0, 2.0);
        const std::vector<Vec2> platform{from, from + along * 20.0, from + along * 20.0 + across * 4.0,
                                         from + across * 4.0};
        Storey storey = two_platforms();
        storey.rooms.resize(1);
        storey.rooms[0].loops_m = {platform};
        storey.min_m = storey.max_m = from;
        for (const Vec2& p : platform)
            storey.min_m = glm::min(storey.min_m, p), storey.max_m = glm::max(storey.max_m, p);
        storey.rooms[0].min_m = storey.min_m;
        storey.rooms[0].max_m = storey.max_m;
        storey.rooms[0].middle_m = 0.25 * (platform[0] + platform[1] + platform[2] + platform[3]);
        storey.min_m -= Vec2(1.0);
        storey.max_m += Vec2(1.0);
        lay_floor(storey);
        find_beyond(storey);
        const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
        ASSERT_TRUE(sheet);
        for (std::size_t side = 0; side < 4; ++side) {
            const Vec2 a = platform[side], b = platform[(side + 1) % 4];
            const Vec2 outwards = Vec2(b.y - a.y, a.x - b.x) / glm::distance(a, b) * 0.45;
            EXPECT_GE(lines_along(*sheet, a + outwards, b + outwards), enough_lines(*sheet, glm::distance(a, b)))
                << "side " << side << " at " << degrees << " degrees, 1 to " << sheet->one_to;
        }
    }
}

TEST(FloorEdges, run_along_the_floor_next_to_a_wide_opening_between_rooms) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the smaller sheets of this file";
    // The opening is as wide as the two halves of the platform are long.
    Storey storey = two_platforms();
    storey.max_m = {21.0, 9.0};
    storey.rooms[0].loops_m = {{{0.5, 3.0}, {20.5, 3.0}, {20.5, 5.0}, {0.5, 5.0}}};
    storey.rooms[1].loops_m = {{{0.5, 5.0}, {20.5, 5.0}, {20.5, 7.0}, {0.5, 7.0}}};
    for (StoreyRoom& room : storey.rooms) {
        room.min_m = room.loops_m[0][0];
        room.max_m = room.loops_m[0][2];
        room.middle_m = 0.5 * (room.min_m + room.max_m);
    }
    storey.portals = {{PassageKind::Opening, {0, 1}, {10.5, 5.0}, 20.0}};
    lay_floor(storey);
    find_beyond(storey);
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    for (const double y : {2.6, 7.4})
        EXPECT_GE(lines_along(*sheet, {0.5, y}, {20.5, y}), enough_lines(*sheet, 20.0)) << "edge at " << y;
    EXPECT_TRUE(sheet->broken.empty());
}

TEST(FloorEdges, are_around_a_void_that_walkways_enclose) {
    // Two walkways, each around half of a void of 6 by 6 m, meet at both of their ends.
    Storey storey = two_platforms();
    storey.max_m = {13.0, 13.0};
    storey.rooms[0].loops_m = {
        {{1.0, 1.0}, {6.5, 1.0}, {6.5, 3.5}, {3.5, 3.5}, {3.5, 9.5}, {6.5, 9.5}, {6.5, 12.0}, {1.0, 12.0}}};
    storey.rooms[1].loops_m = {
        {{12.0, 1.0}, {12.0, 12.0}, {6.5, 12.0}, {6.5, 9.5}, {9.5, 9.5}, {9.5, 3.5}, {6.5, 3.5}, {6.5, 1.0}}};
    storey.rooms[0].min_m = {1.0, 1.0};
    storey.rooms[0].max_m = {6.5, 12.0};
    storey.rooms[0].middle_m = {2.2, 6.5};
    storey.rooms[1].min_m = {6.5, 1.0};
    storey.rooms[1].max_m = {12.0, 12.0};
    storey.rooms[1].middle_m = {10.7, 6.5};
    storey.portals = {{PassageKind::Opening, {0, 1}, {6.5, 2.2}, 2.5},
                      {PassageKind::Opening, {0, 1}, {6.5, 10.7}, 2.5}};
    lay_floor(storey);
    find_beyond(storey);
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_FALSE(says(*sheet, "Drawn closed")) << sheet->plan.text;
    EXPECT_GE(lines_along(*sheet, {3.9, 4.5}, {3.9, 8.5}), enough_lines(*sheet, 4.0));
    EXPECT_GE(lines_along(*sheet, {9.1, 4.5}, {9.1, 8.5}), enough_lines(*sheet, 4.0));
    // A table there is no void.
    storey.things.push_back({FeatureId{1}, "Table", {{6.5, 6.5}, {1.0, 0.0}, {2.9, 2.9}}, false});
    find_beyond(storey);
    EXPECT_TRUE(std::count(storey.floor.beyond.begin(), storey.floor.beyond.end(), 1) > 0);
    EXPECT_EQ(storey.floor.beyond[static_cast<std::size_t>(32 * storey.floor.wide + 32)], 0);
}

TEST(FloorEdges, have_no_line_where_a_route_leads_to_another_storey) {
    Storey storey = two_platforms();
    storey.exits.push_back({PassageKind::Opening, 0, "Hall", {3.0, 4.0}, 2.0});
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_EQ(lines_along(*sheet, {2.3, 4.0}, {3.7, 4.0}), 0);
    EXPECT_GT(lines_along(*sheet, {0.3, 0.0}, {5.7, 0.0}), 3);
}

TEST(FloorEdges, part_floors_with_nothing_between_without_a_wall) {
    const Storey storey = two_platforms();
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_FALSE(says(*sheet, "Drawn closed")) << sheet->plan.text;
    for (const SheetShape& shape : sheet->plan.shapes)
        if (shape.part == kWallPart) {
            EXPECT_TRUE(shape.loops_mm.empty());
        }
    for (const RoomSign& sign : sheet->signs) {
        ASSERT_TRUE(sign.on_sheet) << sign.name;
        EXPECT_NE(floor_at(storey, sheet->on_paper.world(sign.at_mm)), kNothing) << sign.name;
    }
}

TEST(FloorEdges, are_not_within_walls_on_one_of_several_sheets) {
    // A pit in the kitchen continues beyond the rim of the sheet, where the sheet has no walls. No door leads into it.
    Storey storey = two_rooms();
    storey.things.clear();
    storey.gaps.clear();
    storey.portals.clear();
    storey.walls_m.push_back({{6.0, 1.5}, {6.2, 1.5}, {6.2, 2.5}, {6.0, 2.5}});
    storey.rooms[0].loops_m = {{{0.25, 0.25}, {2.0, 0.25}, {2.0, 3.75}, {0.25, 3.75}}};
    storey.rooms[0].max_m.x = 2.0;
    storey.rooms[0].middle_m.x = 1.1;
    lay_floor(storey);
    find_beyond(storey);
    SheetPart part;
    part.min_m = storey.min_m;
    part.max_m = {4.0, 4.7};
    part.one_to = 50.0;
    std::vector<std::string> letters;
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1}, part, letters);
    ASSERT_TRUE(sheet);
    EXPECT_EQ(lines_along(*sheet, {2.0, 1.0}, {2.0, 3.0}), 0);
    for (const KeyLine& line : sheet->key_lines) EXPECT_EQ(line.text.find("edges"), std::string::npos) << line.text;
}

TEST(FarWalls, are_not_in_the_plan) {
    Storey storey = two_rooms();
    const std::size_t own = storey.walls_m.size();
    storey.max_m = {30.0, 4.7};
    storey.walls_m.push_back({{9.4, 4.0}, {20.0, 4.0}, {20.0, 4.2}, {9.4, 4.2}});
    storey.walls_m.push_back({{20.0, 0.0}, {20.2, 0.0}, {20.2, 4.0}, {20.0, 4.0}});
    storey.sheets_m.push_back({Vec2(14.0, 1.0), Vec2(14.0, 3.0)});
    storey.sheets_m.push_back({Vec2(10.0, 1.0), Vec2(14.0, 1.0)});
    lay_floor(storey);
    drop_far_walls(storey);
    EXPECT_EQ(storey.walls_m.size(), own + 1) << "the far end of one of them is near no floor, but the wall is";
    ASSERT_EQ(storey.sheets_m.size(), 1U);
    EXPECT_EQ(storey.sheets_m[0][0].x, 10.0);
}

TEST(FloorEdges, are_raised_on_the_plate) {
    Storey storey = two_platforms();
    const Result<StoreyPlate> plate = storey_plate(storey, BrailleTable::EnUebG1);
    storey.floor.beyond.clear();
    const Result<StoreyPlate> without = storey_plate(storey, BrailleTable::EnUebG1);
    ASSERT_TRUE(plate && without);
    EXPECT_GT(plate->triangles.size(), without->triangles.size() + 20 * 10);
}

}  // namespace floor_edges_test
}  // namespace handrail::test
