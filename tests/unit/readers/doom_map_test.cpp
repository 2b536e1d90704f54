// Tests maps of Doom 3. They contain planes instead of points, and their shapes are relative to the origin of the
// entity.
#include "tests/support/names.h"
#include "tests/unit/readers/reading.h"

namespace handrail {
namespace doom_map_test {

using test::reading_of;

// Returns a box as a brushDef3, in units.
std::string box(const Vec3& least, const Vec3& most) {
    std::string text = "{\nbrushDef3\n{\n";
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            Vec3 normal(0.0);
            normal[axis] = side;
            const double off = side > 0.0 ? -most[axis] : least[axis];
            text += " ( " + std::to_string(normal.x) + " " + std::to_string(normal.y) + " " + std::to_string(normal.z) +
                    " " + std::to_string(off) + " ) ( ( 0.01 0 0 ) ( 0 0.01 0 ) ) \"textures/a/b\" 0 0 0\n";
        }
    return text + "}\n}\n";
}

std::string with_world(const std::string& version, const std::string& more) {
    return version + "// entity 0\n{\n\"classname\" \"worldspawn\"\n// primitive 0\n" +
           box({-320, -320, -32}, {320, 320, 0}) + "}\n" + more;
}

TEST(DoomMaps, are_read_with_their_version_and_planes) {
    const test::Reading reading = reading_of(read_quake_map(with_world("Version 2\n", ""), "doom.map"));
    EXPECT_TRUE(reading.said.empty()) << reading.said.front();
    ASSERT_EQ(reading.scene.solids.size(), 1U);
    EXPECT_EQ(reading.scene.solids[0].shape.bounds_m.min_m, Vec3(-10.0, -10.0, -1.0));
    EXPECT_EQ(reading.scene.solids[0].shape.bounds_m.max_m, Vec3(10.0, 10.0, 0.0));
}

TEST(DoomMaps, place_shapes_relative_to_the_origin_of_their_entity) {
    for (const auto& [version, x_m] :
         {std::pair{"", 0.0}, std::pair{"Version 1\n", 0.0}, std::pair{"Version 2\n", 4.0}}) {
        const test::Reading reading = reading_of(
            read_quake_map(with_world(version, "{\n\"classname\" \"func_static\"\n\"origin\" \"128 64 32\"\n" +
                                                   box({-16, -16, -16}, {16, 16, 16}) + "}\n"),
                           "doom.map"));
        ASSERT_EQ(reading.scene.solids.size(), 2U);
        EXPECT_NEAR(reading.scene.solids[1].shape.bounds_m.centre_m().x, x_m, 1e-9) << version;
    }
}

TEST(DoomMaps, lose_the_brush_whose_plane_has_no_direction) {
    std::string map = with_world("Version 2\n", "");
    map.insert(map.rfind('}'), box({0, 0, 0}, {32, 32, 32}));
    const std::size_t at = map.find("( -1.000000");
    map.replace(at, std::string("( -1.000000").size(), "( 0");
    const test::Reading reading = reading_of(read_quake_map(map, "doom.map"));
    EXPECT_EQ(reading.scene.solids.size(), 1U);
    ASSERT_FALSE(reading.said.empty());
    EXPECT_THAT(reading.said.front(), testing::HasSubstr("no direction"));
}

// The file requests a very fine patch, a sine with many control points. The reader must not make the patch finer than
// its own limit.
TEST(DoomMaps, limit_how_fine_a_patch_becomes) {
    std::string patch = "{\npatchDef3\n{\n\"textures/a/b\"\n( 3 3 9999 9999 0 0 0 )\n(\n";
    for (int row = 0; row < 3; ++row) {
        patch += "(";
        for (int column = 0; column < 3; ++column)
            patch += " ( " + std::to_string(64 * row) + " " + std::to_string(64 * column) + " " +
                     std::to_string(row == 1 ? 64 : 0) + " 0 0 )";
        patch += " )\n";
    }
    std::string map = with_world("Version 2\n", "");
    map.insert(map.rfind('}'), patch + ")\n}\n}\n");
    const test::Reading reading = reading_of(read_quake_map(map, "doom.map"));
    EXPECT_GT(reading.scene.triangles.size(), 4U);
    EXPECT_LT(reading.scene.triangles.size(), 10'000U);
}

}  // namespace doom_map_test
}  // namespace handrail
