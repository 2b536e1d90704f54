// Tests meshes without a start. The reader must put a start on a floor where a walker has room, never on a table,
// inside a wall or outside everything.
#include "worlds/readers/mesh_start.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace mesh_start_test {

// Quads as in an OBJ file. All of them are sheets.
struct Sheets {
    std::string obj;
    int corners = 0;

    void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        for (const Vec3& p : {a, b, c, d}) obj += fmt::format("v {:.9} {:.9} {:.9}\n", p.x, p.y, p.z);
        obj += fmt::format("f {} {} {} {}\n", corners + 1, corners + 2, corners + 3, corners + 4);
        corners += 4;
    }
    void level(const Vec2& least, const Vec2& most, double z) {
        quad({least.x, least.y, z}, {most.x, least.y, z}, {most.x, most.y, z}, {least.x, most.y, z});
    }
    void upright(const Vec2& from, const Vec2& to, double low, double high) {
        quad({from.x, from.y, low}, {to.x, to.y, low}, {to.x, to.y, high}, {from.x, from.y, high});
    }
    void walls(const Vec2& least, const Vec2& most, double low, double high) {
        upright(least, {most.x, least.y}, low, high);
        upright({most.x, least.y}, most, low, high);
        upright(most, {least.x, most.y}, low, high);
        upright({least.x, most.y}, least, low, high);
    }
    Scene scene() const {
        ReadOptions options;
        options.solid_meshes = false;
        Result<Scene> made = read_obj(obj, "sheets.obj", options);
        EXPECT_TRUE(made) << made.error().sentence();
        return made ? std::move(*made) : Scene();
    }
};

TEST(MeshStart, is_on_the_floor_of_a_room_of_sheets_rather_than_on_its_roof) {
    Sheets room;
    room.level({0, 0}, {6, 5}, 0.0);
    room.level({0, 0}, {6, 5}, 2.6);
    room.walls({0, 0}, {6, 5}, 0.0, 2.6);
    const Scene scene = room.scene();
    ASSERT_EQ(scene.starts.size(), 1U);
    EXPECT_TRUE(scene.starts[0].base);
    EXPECT_NEAR(scene.starts[0].feet_m.z, 0.0, 1e-6);
    EXPECT_NEAR(scene.starts[0].feet_m.x, 3.0, 0.4);
    EXPECT_NEAR(scene.starts[0].feet_m.y, 2.5, 0.4);
    EXPECT_EQ(scene.report.starts, 1);
    EXPECT_FALSE(scene.report.guessed.empty());
}

TEST(MeshStart, is_next_to_the_table_in_the_middle) {
    Sheets room;
    room.level({0, 0}, {6, 5}, 0.0);
    room.level({0, 0}, {6, 5}, 2.6);
    room.walls({0, 0}, {6, 5}, 0.0, 2.6);
    room.level({2, 1.5}, {4, 3.5}, 0.75);
    const Scene scene = room.scene();
    ASSERT_EQ(scene.starts.size(), 1U);
    const Vec3 feet = scene.starts[0].feet_m;
    EXPECT_NEAR(feet.z, 0.0, 1e-6);
    EXPECT_TRUE(feet.x < 1.7 || feet.x > 4.3 || feet.y < 1.2 || feet.y > 3.8) << feet.x << " " << feet.y;
}

TEST(MeshStart, is_on_open_ground_if_there_is_no_roof) {
    Sheets ground;
    ground.level({-20, -20}, {20, 20}, -3.0);
    const Scene scene = ground.scene();
    ASSERT_EQ(scene.starts.size(), 1U);
    EXPECT_NEAR(scene.starts[0].feet_m.z, -3.0, 1e-6);
}

TEST(MeshStart, does_not_exist_on_a_single_table_or_on_walls_without_a_floor) {
    Sheets table;
    table.level({0, 0}, {1.6, 0.8}, 0.75);
    table.upright({0.1, 0.1}, {0.1, 0.2}, 0.0, 0.75);
    EXPECT_TRUE(table.scene().starts.empty());
    Sheets walls;
    walls.walls({0, 0}, {6, 5}, 0.0, 2.6);
    EXPECT_TRUE(walls.scene().starts.empty());
    EXPECT_FALSE(place_to_stand(Scene()));
}

// The walker's box at the start must contain no point of any sheet. The test tries many points of each sheet.
TEST(MeshStart, of_random_rooms_has_room_for_a_body_near_and_far_from_the_origin) {
    std::mt19937 random(3);
    const auto real = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int found = 0;
    const int runs = test::scaled(60);
    for (int run = 0; run < runs; ++run) {
        const double off = run % 3 == 2 ? 3000.0 : 0.0;
        Sheets room;
        const Vec2 least(off, -off), most(off + real(2.0, 9.0), real(2.0, 9.0) - off);
        room.level(least, most, 0.0);
        room.level(least, most, real(2.0, 3.5));
        room.walls(least, most, 0.0, 3.0);
        for (int thing = 0; thing < 6; ++thing) {
            const Vec2 at(real(least.x, most.x), real(least.y, most.y)), size(real(0.2, 1.5), real(0.2, 1.5));
            const double low = real(0.0, 1.0), high = low + real(0.1, 1.5);
            room.level(at, at + size, low);
            room.level(at, at + size, high);
            room.walls(at, at + size, low, high);
        }
        const Scene scene = room.scene();
        if (scene.starts.empty()) continue;
        ++found;
        const Vec3 feet = scene.starts[0].feet_m;
        bool stands = false;
        for (const MeshTriangle& t : scene.triangles)
            for (int i = 0; i <= 60; ++i)
                for (int k = 0; i + k <= 60; ++k) {
                    const Vec3 p = t.a_m + (t.b_m - t.a_m) * (i / 60.0) + (t.c_m - t.a_m) * (k / 60.0) - feet;
                    ASSERT_FALSE(std::abs(p.x) < 0.29 && std::abs(p.y) < 0.29 && p.z > 0.26 && p.z < 1.89)
                        << "run " << run;
                    stands = stands || (std::hypot(p.x, p.y) < 0.3 && std::abs(p.z) < 1e-6);
                }
        EXPECT_TRUE(stands) << "run " << run;
    }
    EXPECT_GT(found, runs / 2);
}

}  // namespace mesh_start_test
}  // namespace handrail
