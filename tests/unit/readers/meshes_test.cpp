// glTF, PLY and STL: axes, units, names, what is solid, and what is wrong with damaged ones.
#include <cstring>

#include "tests/support/real_worlds.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace meshes_test {

using testing::HasSubstr;

std::string seed(const std::string& path) {
    return test::content_of(std::string(HANDRAIL_SOURCE_DIR) + "/tests/fuzz/inputs/" + path);
}

TEST(ReadGltf, turns_y_up_to_z_up_and_places_things_as_the_file_says) {
    // A cube of 1 m, twice as wide, moved 1 m east and 2 m along the file's z, which is south.
    const Result<Scene> scene = read_gltf(seed("gltf/seeds/table.glb"), "table.glb");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->report.format, "gltf");
    ASSERT_EQ(scene->features.size(), 1U);
    EXPECT_EQ(scene->features[0].name, "Table");
    EXPECT_EQ(scene->triangles.size(), 12U);
    EXPECT_NEAR(scene->bounds_m.min_m.x, 1.0, 1e-9);
    EXPECT_NEAR(scene->bounds_m.max_m.x, 3.0, 1e-9);
    EXPECT_NEAR(scene->bounds_m.min_m.y, -3.0, 1e-9);
    EXPECT_NEAR(scene->bounds_m.max_m.y, -2.0, 1e-9);
    EXPECT_NEAR(scene->bounds_m.min_m.z, 0.0, 1e-9);
    EXPECT_NEAR(scene->bounds_m.max_m.z, 1.0, 1e-9);
    EXPECT_TRUE(validate(*scene).has_value());
}

TEST(ReadGltf, reads_a_description_with_its_numbers_in_it_or_beside_it) {
    const std::string within = seed("gltf/seeds/table.gltf");
    const Result<Scene> scene = read_gltf(within, "table.gltf");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_NEAR(scene->bounds_m.size_m().y, 2.0, 1e-6) << "turned by a quarter about the upright axis";
    std::string beside = within;
    const std::size_t from = beside.find("data:"), to = beside.find('"', from);
    beside.replace(from, to - from, "table.bin");
    ReadOptions options;
    const std::string glb = seed("gltf/seeds/table.glb");
    options.read_beside = [&](const std::string& name) -> Result<std::string> {
        EXPECT_EQ(name, "table.bin");
        return glb.substr(glb.size() - 168);
    };
    const Result<Scene> other = read_gltf(beside, "table.gltf", options);
    ASSERT_TRUE(other.has_value()) << other.error().sentence();
    EXPECT_EQ(other->triangles.size(), 12U);
    const Result<Scene> none = read_gltf(beside, "table.gltf");
    ASSERT_FALSE(none.has_value());
    EXPECT_THAT(none.error().message, HasSubstr("table.bin"));
}

// Parts of one STL in words: a block of these sides.
std::string block(const std::string& name, double low, double high) {
    std::string text = "solid " + name + "\n";
    const auto at = [&](int corner, int axis) { return corner >> axis & 1 ? high : low; };
    for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{{0, 2, 1},
                                                                 {1, 2, 3},
                                                                 {4, 5, 6},
                                                                 {5, 7, 6},
                                                                 {0, 1, 4},
                                                                 {1, 5, 4},
                                                                 {2, 6, 3},
                                                                 {3, 6, 7},
                                                                 {0, 4, 2},
                                                                 {2, 4, 6},
                                                                 {1, 3, 5},
                                                                 {3, 7, 5}}) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : {a, b, c})
            text += fmt::format("vertex {} {} {}\n", at(corner, 0), at(corner, 1), at(corner, 2));
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid\n";
}

TEST(ReadStl, makes_solids_of_closed_convex_meshes_and_sheets_of_what_holds_others) {
    const Result<Scene> scene = read_stl(block("room", 0.0, 10.0) + block("table", 2.0, 3.0), "room.stl");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    ASSERT_EQ(scene->solids.size(), 1U) << "the table; the room holds it";
    EXPECT_EQ(scene->triangles.size(), 12U) << "the room";
    EXPECT_EQ(scene->features[scene->solids[0].feature.value].name, "table");
    EXPECT_NEAR(scene->features[scene->solids[0].feature.value].area_m2, 6.0, 1e-6);
    EXPECT_TRUE(validate(*scene).has_value());
    ASSERT_EQ(scene->starts.size(), 1U) << "on the room's floor, near its middle, outside the table";
    EXPECT_NEAR(scene->starts[0].feet_m.z, 0.0, 1e-9);
    EXPECT_LT(glm::length(Vec2(scene->starts[0].feet_m) - Vec2(5.0, 5.0)), 1.0);
    const Result<Scene> alone = read_stl(block("table", 2.0, 3.0), "table.stl");
    ASSERT_TRUE(alone.has_value());
    EXPECT_TRUE(alone->solids.empty()) << "one may stand in it";
    EXPECT_TRUE(alone->starts.empty());
}

TEST(ReadStl, reads_binary_files_and_takes_the_unit_that_a_person_says) {
    ReadOptions millimetres;
    millimetres.obj_metres_per_unit = 0.001;
    const Result<Scene> scene = read_stl(seed("stl/seeds/table.stl"), "table.stl", millimetres);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_NEAR(scene->bounds_m.size_m().x, 0.001, 1e-12);
    EXPECT_EQ(scene->triangles.size(), 12U);
    const Result<Scene> cut = read_stl(seed("stl/seeds/table.stl").substr(0, 200), "table.stl");
    ASSERT_FALSE(cut.has_value());
    EXPECT_THAT(cut.error().message, HasSubstr("cut short"));
}

TEST(ReadWorld, asks_for_the_unit_of_a_mesh_that_states_none_where_it_is_very_wide) {
    const test::TemporaryFolder folder;
    const Result<Scene> scene = read_world(folder.write("house.stl", block("house", 0.0, 9000.0)));
    ASSERT_TRUE(scene.has_value());
    ASSERT_FALSE(scene->report.warnings.empty());
    EXPECT_THAT(scene->report.warnings.front().sentence(), HasSubstr("millimetres"));
}

TEST(ReadPly, reads_words_and_both_byte_orders) {
    const Result<Scene> words = read_ply(seed("ply/seeds/table.ply"), "table.ply");
    ASSERT_TRUE(words.has_value()) << words.error().sentence();
    EXPECT_EQ(words->triangles.size(), 12U);
    const Result<Scene> big = read_ply(seed("ply/seeds/sheet.ply"), "sheet.ply");
    ASSERT_TRUE(big.has_value()) << big.error().sentence();
    EXPECT_EQ(big->triangles.size(), 2U) << "a square";
    EXPECT_NEAR(big->bounds_m.max_m.y, 1.0, 1e-12);
    EXPECT_NEAR(big->features[0].area_m2, 1.0, 1e-12);
    const Result<Scene> head = read_ply("ply\nformat ascii 1.0\nelement vertex many\nend_header\n", "a.ply");
    ASSERT_FALSE(head.has_value());
    EXPECT_EQ(head.error().line, 3);
}

TEST(Meshes, cut_at_every_byte_end_in_a_world_or_one_sentence) {
    for (const char* path : {"gltf/seeds/table.glb", "gltf/seeds/table.gltf", "ply/seeds/table.ply",
                             "ply/seeds/sheet.ply", "stl/seeds/table.stl", "stl/seeds/words.stl"}) {
        const std::string whole = seed(path);
        const std::string name = std::filesystem::path(path).filename().string();
        const auto read = name.ends_with(".ply") ? read_ply : name.ends_with(".stl") ? read_stl : read_gltf;
        for (std::size_t length = 1; length < whole.size(); ++length) {
            const Result<Scene> scene = read(std::string_view(whole).substr(0, length), name, {});
            if (scene) EXPECT_TRUE(validate(*scene).has_value()) << path << " " << length;
            else EXPECT_FALSE(scene.error().message.empty()) << path << " " << length;
        }
    }
}

TEST(ReadGltf, reads_a_real_room_with_its_things) {
    const auto path = test::real_world("room.glb");
    if (!path) GTEST_SKIP() << "no room.glb";
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->features.size(), 17U) << "a room and sixteen spheres";
    ASSERT_EQ(scene->starts.size(), 1U);
    const Aabb room = scene->features[0].bounds_m;
    EXPECT_NEAR(scene->starts[0].feet_m.z, room.min_m.z, 1e-9) << "on its floor";
    EXPECT_NEAR(room.centre_m().z, 1.0, 1.5) << "upright";
    EXPECT_THAT(scene->materials, testing::Contains(testing::Field(&Material::name, "glass")));
}

}  // namespace meshes_test
}  // namespace handrail
