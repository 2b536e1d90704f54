// Tests how the distance of a walker from a wall is measured while the walker walks along the wall, whatever the wall
// consists of.
#include "app/core/world/wall_at_side.h"

#include <gtest/gtest.h>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace wall_at_side_test {

using test::box_brush;
using test::entity;
using test::key;

// Returns a box of the building, given in metres.
std::string built(double x0, double y0, double z0, double x1, double y1, double z1) {
    return box_brush(32.0 * x0, 32.0 * y0, 32.0 * z0, 32.0 * x1, 32.0 * y1, 32.0 * z1);
}
std::string thing(const std::string& name, double x0, double y0, double z0, double x1, double y1, double z1) {
    return entity("thing", key("name", name), built(x0, y0, z0, x1, y1, z1));
}

// Makes a room of 8 by 6 metres with walls of 0.3 m:
// - north: a window of 1.6 m over a sill of 0.9 m, its pane 0.2 m back, and another window of 1.2 m down to the
//   floor;
// - east: an open door of 1 m;
// - south: a board that hangs on the wall, and a bookshelf 0.4 m deep;
// - west: a gate of 3.2 m;
// - in the middle: a table, a metre from everything.
WalkerWorld room() {
    const double h = 2.6;
    std::string walls = built(-1, -1, -0.2, 9, 7, 0.0) + built(-1, -1, h, 9, 7, h + 0.2);
    walls += built(-0.3, 6.0, 0, 2.0, 6.3, h) + built(2.0, 6.0, 0, 3.6, 6.3, 0.9) + built(2.0, 6.0, 2.0, 3.6, 6.3, h) +
             built(3.6, 6.0, 0, 5.0, 6.3, h) + built(5.0, 6.0, 2.0, 6.2, 6.3, h) + built(6.2, 6.0, 0, 8.3, 6.3, h);
    walls += built(8.0, 0.0, 0, 8.3, 2.5, h) + built(8.0, 2.5, 2.1, 8.3, 3.5, h) + built(8.0, 3.5, 0, 8.3, 6.0, h);
    walls += built(-0.3, -0.3, 0, 8.3, 0.0, h);
    walls += built(-0.3, 3.2, 0, 0.0, 6.0, h);
    auto scene = read_quake_map(
        entity("worldspawn", key("building", "1"), walls) +
            entity("info_player_start", key("origin", "128 96 24") + key("angle", "90")) +
            thing("Pane", 2.0, 6.2, 0.9, 3.6, 6.25, 2.0) + thing("Long pane", 5.0, 6.2, 0.0, 6.2, 6.25, 2.0) +
            thing("Board", 2.0, 0.0, 0.8, 4.0, 0.06, 2.0) + thing("Bookshelf", 5.0, 0.0, 0.0, 7.0, 0.4, 1.8) +
            thing("Table", 3.0, 2.4, 0.0, 4.4, 3.2, 0.75),
        "room.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    return WalkerWorld(std::make_shared<const Scene>(std::move(*scene)));
}

TEST(WallAtSide, continues_across_windows_doors_and_boards) {
    const WalkerWorld world = room();
    for (double x = 0.6; x <= 7.4; x += 0.1) EXPECT_NEAR(wall_at_side_m(world, {x, 5.6, 0.0}), 0.4, 0.02) << x;
    for (double y = 0.6; y <= 5.4; y += 0.1) EXPECT_NEAR(wall_at_side_m(world, {7.6, y, 0.0}), 0.4, 0.02) << y;
    // The board is 6 cm nearer to the walker than its wall.
    for (double x = 0.6; x <= 4.5; x += 0.1) EXPECT_NEAR(wall_at_side_m(world, {x, 0.4, 0.0}), 0.37, 0.04) << x;
}

TEST(WallAtSide, includes_things_against_a_wall_but_not_free_standing_things) {
    const WalkerWorld world = room();
    for (double x = 5.2; x <= 6.8; x += 0.1) EXPECT_NEAR(wall_at_side_m(world, {x, 0.8, 0.0}), 0.4, 0.02) << x;
    for (double x = 3.2; x <= 4.2; x += 0.1) EXPECT_GT(wall_at_side_m(world, {x, 2.0, 0.0}), 1.5) << x;
    EXPECT_GT(wall_at_side_m(world, {4.0, 4.2, 0.0}), 1.7);
}

// A window from corner to corner has no piece of wall next to it.
TEST(WallAtSide, is_a_glass_pane_from_corner_to_corner_but_not_a_pole) {
    std::string walls = built(-1, -1, -0.2, 9, 7, 0.0) + built(-1, -1, 2.6, 9, 7, 2.8) + built(-0.3, 0, 0, 0, 6, 2.6) +
                        built(8, 0, 0, 8.3, 6, 2.6) + built(-0.3, -0.3, 0, 8.3, 0, 2.6);
    auto scene =
        read_quake_map(entity("worldspawn", key("building", "1"), walls) +
                           entity("info_player_start", key("origin", "128 96 24") + key("angle", "90")) +
                           thing("Window", 0.0, 6.15, 0.0, 8.0, 6.2, 2.6) + thing("Pole", 4.0, 3.0, 0.0, 4.1, 3.1, 2.6),
                       "room.map", {});
    ASSERT_TRUE(scene) << scene.error().sentence();
    const WalkerWorld world(std::make_shared<const Scene>(std::move(*scene)));
    for (double x = 2.1; x <= 5.9; x += 0.1) EXPECT_NEAR(wall_at_side_m(world, {x, 5.6, 0.0}), 0.35, 0.05) << x;
    EXPECT_GT(wall_at_side_m(world, {3.6, 3.05, 0.0}), 1.5);
}

TEST(WallAtSide, continues_along_the_windows_of_a_real_building) {
    const auto file = test::real_world("duplex-apartment.ifc");
    if (!file) GTEST_SKIP() << test::needs_real_world("duplex-apartment.ifc");
    auto scene = read_world(*file);
    ASSERT_TRUE(scene) << scene.error().sentence();
    const WalkerWorld world(std::make_shared<const Scene>(std::move(*scene)));
    // The west wall of a bedroom. 3 of its 5 metres are glass down to the floor.
    int near = 0;
    for (int i = 0; i <= 100; ++i) near += wall_at_side_m(world, {0.75, -17.0 + 0.05 * i, 3.12}) < 0.45;
    EXPECT_GE(near, 95) << "of 101";
}

TEST(WallAtSide, ends_where_the_wall_does_not_continue) {
    const WalkerWorld world = room();
    // There is no wall in the gate, nor outside.
    EXPECT_GT(wall_at_side_m(world, {0.4, 1.7, 0.0}), 1.5);
    EXPECT_GT(wall_at_side_m(world, {-0.7, 1.7, 0.0}), 1.5);
    EXPECT_NEAR(wall_at_side_m(world, {0.4, 4.5, 0.0}), 0.4, 0.02);
}

}  // namespace wall_at_side_test
}  // namespace handrail
