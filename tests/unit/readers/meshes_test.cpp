// Tests glTF, PLY and STL: axes, units, names, which parts are solid, and faults of damaged files.
#include <cstring>
#include <random>

#include "tests/support/block_mesh.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace meshes_test {

using testing::HasSubstr;

std::string seed(const std::string& path) {
    return test::content_of((test::project_root() / "tests/fuzz/inputs/").string() + path);
}

TEST(ReadGltf, turns_y_up_into_z_up_and_places_things_as_the_file_says) {
    // The file contains a cube of 1 m, scaled to twice its width. The cube is moved 1 m east and 2 m along the file's z
    // axis, which points south.
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

TEST(ReadGltf, reads_files_with_embedded_or_external_buffers) {
    const std::string within = seed("gltf/seeds/table.gltf");
    const Result<Scene> scene = read_gltf(within, "table.gltf");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_NEAR(scene->bounds_m.size_m().y, 2.0, 1e-6) << "turned by a quarter about the upright axis";
    std::string beside = within;
    const std::size_t from = beside.find("data:"), to = beside.find('"', from);
    beside.replace(from, to - from, "table.bin");
    ReadOptions options;
    const std::string glb = seed("gltf/seeds/table.glb");
    options.read_next_to = [&](const std::string& name) -> Result<std::string> {
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

// Encodes numbers as base64.
std::string base64(const std::string& bytes) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (int shift = 18; shift >= 0; shift -= 6) text += kLetters[three >> shift & 63U];
    }
    return text;
}

// Returns a glTF file with one triangle: 0 0 0, 2 0 0 and 0 2 0, as numbers of type T times `unit`. The other arguments
// add text to the node and to the file.
template <class T>
std::string triangle_gltf(int type, T unit, bool normalized, const std::string& in_node, const std::string& required,
                          const std::string& more_bytes = {}, const std::string& more_accessors = {}) {
    std::string bytes;
    for (const std::array<int, 3>& p : {std::array{0, 0, 0}, std::array{2, 0, 0}, std::array{0, 2, 0}}) {
        std::array<T, 4> row{};
        for (std::size_t k = 0; k < 3; ++k) row[k] = static_cast<T>(static_cast<T>(p[k]) * unit);
        bytes.append(reinterpret_cast<const char*>(row.data()), sizeof(row));
    }
    const std::size_t points = bytes.size();
    bytes += more_bytes;
    return R"({"asset":{"version":"2.0"},"extensionsRequired":[)" + required +
           R"(],"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" + in_node +
           R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"count":3,)" +
           R"("type":"VEC3","componentType":)" + std::to_string(type) + (normalized ? R"(,"normalized":true)" : "") +
           "}" + more_accessors + R"(],"bufferViews":[{"buffer":0,"byteLength":)" + std::to_string(points) +
           R"(,"byteStride":)" + std::to_string(4 * sizeof(T)) + R"(},{"buffer":0,"byteOffset":)" +
           std::to_string(points) + R"(,"byteLength":)" + std::to_string(bytes.size() - points) +
           R"(}],"buffers":[{"byteLength":)" + std::to_string(bytes.size()) +
           R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) + "\"}]}";
}

TEST(ReadGltf, reads_points_in_every_number_format) {
    const std::string name = "\"KHR_mesh_quantization\"", scaled = ",\"scale\":[0.5,0.5,0.5]";
    const auto size_of = [](const std::string& file) {
        const Result<Scene> scene = read_gltf(file, "triangle.gltf");
        EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().sentence());
        return scene ? scene->bounds_m.size_m().x : 0.0;
    };
    EXPECT_NEAR(size_of(triangle_gltf<std::int8_t>(5120, 10, false, scaled, name)), 10.0, 1e-9);
    EXPECT_NEAR(size_of(triangle_gltf<std::uint8_t>(5121, 100, false, scaled, name)), 100.0, 1e-9);
    EXPECT_NEAR(size_of(triangle_gltf<std::int16_t>(5122, 1000, false, scaled, name)), 1000.0, 1e-9);
    EXPECT_NEAR(size_of(triangle_gltf<std::uint16_t>(5123, 20000, false, scaled, name)), 20000.0, 1e-9);
    EXPECT_NEAR(size_of(triangle_gltf<float>(5126, 1.5F, false, scaled, name)), 1.5, 1e-9);
    EXPECT_NEAR(size_of(triangle_gltf<std::uint8_t>(5121, 102, true, ",\"scale\":[5,5,5]", name)), 4.0, 1e-9);
    EXPECT_NEAR(size_of(triangle_gltf<std::int16_t>(5122, 16383, true, ",\"scale\":[5,5,5]", name)),
                5.0 * 32766.0 / 32767.0, 1e-9);
}

TEST(ReadGltf, places_copies_at_instances) {
    std::string shifts;
    for (const float x : {0.0F, 10.0F, 20.0F})
        for (const float value : {x, 0.0F, 0.0F}) shifts.append(reinterpret_cast<const char*>(&value), sizeof(value));
    const Result<Scene> scene = read_gltf(
        triangle_gltf<float>(
            5126, 1.0F, false, R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":1}}})",
            "\"EXT_mesh_gpu_instancing\"", shifts, R"(,{"bufferView":1,"count":3,"type":"VEC3","componentType":5126})"),
        "copies.gltf");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->triangles.size(), 3U);
    EXPECT_NEAR(scene->bounds_m.size_m().x, 22.0, 1e-6);
}

TEST(ReadGltf, names_a_required_extension_that_it_cannot_read) {
    const Result<Scene> other =
        read_gltf(triangle_gltf<float>(5126, 1.0F, false, "", "\"VENDOR_other_shapes\""), "a.gltf");
    ASSERT_FALSE(other.has_value());
    EXPECT_THAT(other.error().message, HasSubstr("VENDOR_other_shapes"));
    EXPECT_TRUE(
        read_gltf(triangle_gltf<float>(5126, 1.0F, false, "", "\"KHR_materials_unlit\""), "a.gltf").has_value());
}

TEST(ReadStl, accepts_keywords_in_any_letter_case) {
    for (const bool upper : {false, true}) {
        std::string text =
            "solid Roof\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 4 0 0\nvertex 0 4 0\nendloop\n"
            "endfacet\nendsolid\n";
        if (upper)
            for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        const Result<Scene> scene = read_stl(text, "roof.stl");
        ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
        EXPECT_EQ(scene->triangles.size(), 1U);
    }
}

// Returns a part of a text STL: a cube from `low` to `high`.
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

TEST(ReadStl, makes_solids_of_closed_convex_meshes_and_sheets_of_meshes_that_contain_others) {
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

bool in_a_solid(const Scene& scene, const Vec3& at_m, double grow_m = 0.0) {
    return std::any_of(scene.solids.begin(), scene.solids.end(),
                       [&](const Solid& solid) { return contains(solid.shape, at_m, grow_m); });
}

// A table, a horseshoe of counters and a hollow chest, each turned by another angle. They are in a room that is seen
// from inside.
struct Furnished {
    std::vector<std::pair<std::string, test::BlockMesh>> things;

    Furnished() {
        const auto at = [](double turn, const Vec3& middle, double size) {
            return [=](const Vec3& p) {
                return middle + size * Vec3(p.x * std::cos(turn) - p.y * std::sin(turn),
                                            p.x * std::sin(turn) + p.y * std::cos(turn), p.z);
            };
        };
        test::BlockMesh room = test::block_mesh({{0, 0, 0}}, [](const Vec3& p) { return p * Vec3(10, 8, 3); });
        for (auto& triangle : room.triangles) std::swap(triangle[1], triangle[2]);
        things.emplace_back("room", room);
        things.emplace_back("table", test::block_mesh(test::table_blocks(), at(0.3, {1.5, 1, 0}, 0.2)));
        things.emplace_back("counters", test::block_mesh(test::horseshoe_blocks(5, 2), at(-0.2, {5, 4, 0}, 0.5)));
        things.emplace_back("chest", test::block_mesh(test::hollow_blocks(4), at(0.0, {7, 1, 0}, 0.25)));
    }
    std::string stl() const {
        std::string text;
        for (const auto& [name, mesh] : things) text += mesh.stl(name);
        return text;
    }
    std::string obj() const {
        std::string text;
        std::size_t points = 0;
        for (const auto& [name, mesh] : things) text += mesh.obj(name, points);
        return text;
    }
};

TEST(Meshes, that_are_closed_are_solid_exactly_at_points_that_ray_casts_call_inside) {
    const Furnished furnished;
    for (const bool as_obj : {false, true}) {
        SCOPED_TRACE(as_obj ? "obj" : "stl");
        const Result<Scene> scene =
            as_obj ? read_obj(furnished.obj(), "home.obj") : read_stl(furnished.stl(), "home.stl");
        ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
        EXPECT_TRUE(validate(*scene).has_value());
        EXPECT_EQ(scene->triangles.size(), 12U) << "the room's sides, seen from inside";
        EXPECT_THAT(scene->report.guessed, testing::Contains(HasSubstr("3 of 4 meshes are closed")));
        std::mt19937 random(20261125);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        std::array<int, 4> met{};
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 at = Vec3(10, 8, 1.2) * Vec3(unit(random), unit(random), unit(random));
            int inside = 0;
            bool near = false;
            for (std::size_t t = 1; t < 4; ++t) {
                const test::BlockMesh& mesh = furnished.things[t].second;
                near = near || mesh.distance_m(at) < 1e-3;
                const bool in = mesh.holds(at);
                inside += in ? 1 : 0;
                met[t] += in ? 1 : 0;
            }
            if (near) continue;
            ASSERT_EQ(in_a_solid(*scene, at), inside == 1) << at.x << " " << at.y << " " << at.z;
        }
        for (std::size_t t = 1; t < 4; ++t) EXPECT_GT(met[t], 20) << furnished.things[t].first;
        // The visible area of each thing must be the area of its outer surface. Cuts inside a thing are not surfaces.
        for (std::size_t t = 1; t < 4; ++t) {
            const test::BlockMesh& mesh = furnished.things[t].second;
            double area_m2 = 0.0;
            for (const auto& [a, b, c] : mesh.triangles)
                area_m2 += 0.5 * glm::length(glm::cross(mesh.points_m[b] - mesh.points_m[a],
                                                        mesh.points_m[c] - mesh.points_m[a]));
            const auto feature = std::find_if(scene->features.begin(), scene->features.end(),
                                              [&](const Feature& f) { return f.name == furnished.things[t].first; });
            ASSERT_NE(feature, scene->features.end());
            EXPECT_NEAR(feature->area_m2, area_m2, 1e-3) << feature->name;
        }
    }
    ReadOptions replay;
    replay.solid_meshes = false;
    const Result<Scene> as_filed = read_obj(furnished.obj(), "home.obj", replay);
    ASSERT_TRUE(as_filed.has_value());
    EXPECT_TRUE(as_filed->solids.empty()) << "a replay touches the file's triangles";
}

TEST(ReadStl, separates_the_things_in_one_mesh_and_finds_a_start_between_thick_walls) {
    // One closed mesh: walls 0.5 m thick around 6 by 4 m, with an exit. The start must be between the walls, not inside
    // one.
    std::set<test::Block> blocks;
    for (int x = 0; x < 14; ++x)
        for (int y = 0; y < 10; ++y) {
            blocks.insert({x, y, 0});
            for (int z = 1; z < 6; ++z)
                if ((x == 0 || x == 13 || y == 0 || y == 9) && !(y == 0 && x >= 4 && x <= 6)) blocks.insert({x, y, z});
        }
    const test::BlockMesh house = test::block_mesh(blocks, [](const Vec3& p) { return 0.5 * p; });
    const test::BlockMesh stool =
        test::block_mesh(test::table_blocks(), [](const Vec3& p) { return Vec3(1, 1, 0.5) + 0.1 * p; });
    std::string text = house.stl("house");
    const std::size_t end = text.rfind("endsolid");
    const std::string of_stool = stool.stl("house");
    text.insert(end, of_stool.substr(of_stool.find('\n') + 1, of_stool.rfind("endsolid") - of_stool.find('\n') - 1));
    const Result<Scene> scene = read_stl(text, "house.stl");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_TRUE(scene->triangles.empty());
    EXPECT_EQ(scene->features.size(), 1U) << "one mesh is one thing";
    ASSERT_EQ(scene->starts.size(), 1U);
    const Vec3 feet = scene->starts[0].feet_m;
    EXPECT_NEAR(feet.z, 0.5, 1e-6) << "on the floor";
    for (const double up : {0.3, 0.9, 1.7}) EXPECT_FALSE(in_a_solid(*scene, feet + Vec3(0, 0, up), 0.2));
    EXPECT_GT(feet.x, 0.5);
    EXPECT_LT(feet.x, 6.5);
}

TEST(Meshes, that_are_too_fine_to_be_filled_are_felt_from_outside_only) {
    std::string text = block("table", 2.0, 3.0);
    test::BlockMesh ball;
    constexpr int kSides = 40;
    for (int i = 0; i <= kSides; ++i)
        for (int k = 0; k < 2 * kSides; ++k) {
            const double up = kPi * i / kSides, turn = i % kSides == 0 ? 0.0 : kPi * k / kSides,
                         round = i % kSides == 0 ? 0.0 : std::sin(up);
            ball.points_m.emplace_back(round * std::cos(turn), round * std::sin(turn), -std::cos(up));
        }
    const auto at = [](int i, int k) { return static_cast<std::uint32_t>(2 * i * kSides + k % (2 * kSides)); };
    for (int i = 0; i < kSides; ++i)
        for (int k = 0; k < 2 * kSides; ++k) {
            if (i < kSides - 1) ball.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
            if (i > 0) ball.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
        }
    text += ball.stl("ball");
    const Result<Scene> scene = read_stl(text, "two.stl");
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->solids.size(), 1U) << "the table";
    ASSERT_EQ(scene->triangles.size(), ball.triangles.size());
    for (const MeshTriangle& triangle : scene->triangles) {
        ASSERT_EQ(triangle.side, TouchSide::Front);
        ASSERT_GT(glm::dot(glm::cross(triangle.b_m - triangle.a_m, triangle.c_m - triangle.a_m), triangle.a_m), 0.0)
            << "the front looks out";
    }
    EXPECT_THAT(scene->report.simplified, testing::Contains(HasSubstr("felt from the outside only")));
}

TEST(ReadStl, reads_binary_files_and_uses_the_unit_that_the_person_chose) {
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

TEST(ReadWorld, warns_about_the_unit_of_a_very_wide_mesh_that_states_none) {
    const test::TemporaryFolder folder;
    const Result<Scene> scene = read_world(folder.write("house.stl", block("house", 0.0, 9000.0)));
    ASSERT_TRUE(scene.has_value());
    ASSERT_FALSE(scene->report.warnings.empty());
    EXPECT_THAT(scene->report.warnings.front().sentence(), HasSubstr("millimetres"));
}

TEST(ReadPly, reads_text_and_both_byte_orders) {
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

TEST(Meshes, cut_at_every_byte_become_a_world_or_one_error_sentence) {
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
    if (!path) GTEST_SKIP() << test::needs_real_world("room.glb");
    const Result<Scene> scene = read_world(*path);
    ASSERT_TRUE(scene.has_value()) << scene.error().sentence();
    EXPECT_EQ(scene->features.size(), 17U) << "a room and sixteen spheres";
    ASSERT_EQ(scene->starts.size(), 1U);
    const Aabb room = scene->features[0].bounds_m;
    EXPECT_NEAR(scene->starts[0].feet_m.z, room.min_m.z + 0.05, 1e-6) << "on its floor, which is as thick as its walls";
    EXPECT_NEAR(room.centre_m().z, 1.0, 1.5) << "upright";
    EXPECT_THAT(scene->materials, testing::Contains(testing::Field(&Material::name, "glass")));
}

}  // namespace meshes_test
}  // namespace handrail
