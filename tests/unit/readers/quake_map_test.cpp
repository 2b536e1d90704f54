#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/unit/readers/reading.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace quake_map_test {

using test::box_brush;
using test::entity;
using test::key;

Scene read(const std::string& text, const ReadOptions& options = {}) {
    return test::reading_of(read_quake_map(text, "test.map", options)).scene;
}

const std::string kCube = box_brush(0, 0, 0, 64, 64, 64);

TEST(ReadQuakeMap, converts_units_to_metres_and_counts_brushes_polygons_and_triangles) {
    const Scene scene = read(entity("worldspawn", {}, box_brush(32, 64, -32, 96, 128, 32)));
    ASSERT_EQ(scene.solids.size(), 1U);
    EXPECT_EQ(scene.bounds_m.min_m, Vec3(1, 2, -1));
    EXPECT_EQ(scene.bounds_m.max_m, Vec3(3, 4, 1));
    EXPECT_EQ(scene.report.brushes, 1);
    EXPECT_EQ(scene.report.polygons, 6);
    EXPECT_EQ(scene.report.triangles, 12);
    EXPECT_EQ(scene.report.warnings_in_all, 0);
    ReadOptions centimetres;
    centimetres.map_metres_per_unit = 0.01;
    EXPECT_NEAR(read(entity("worldspawn", {}, kCube), centimetres).bounds_m.max_m.x, 0.64, 1e-12);
}

TEST(ReadQuakeMap, distinguishes_roles_by_class_and_by_texture) {
    struct Case {
        std::string class_name, keys, texture;
        SolidRole role;
        FeatureKind kind;
        std::string name;
    };
    const std::vector<Case> cases{
        {"func_door", "", "m", SolidRole::Mover, FeatureKind::Door, "door"},
        {"func_plat", "", "m", SolidRole::Mover, FeatureKind::Lift, "lift"},
        {"func_button", "", "m", SolidRole::Mover, FeatureKind::Button, "button"},
        {"func_train", "", "m", SolidRole::Mover, FeatureKind::Mover, "moving platform"},
        {"func_wall", key("name", "Table"), "m", SolidRole::Solid, FeatureKind::Object, "Table"},
        {"func_illusionary", "", "m", SolidRole::Illusion, FeatureKind::Object, "illusion"},
        {"trigger_multiple", key("message", "Mind the step"), "m", SolidRole::Trigger, FeatureKind::Trigger,
         "marked place"},
        {"trigger_teleport", "", "trigger", SolidRole::Trigger, FeatureKind::Teleport, "teleporter"},
        {"thing", key("cs_name", "liquid"), "m", SolidRole::Liquid, FeatureKind::Liquid, "liquid"},
        {"thing", key("cs_name", "dynamic_sphere"), "m", SolidRole::Mover, FeatureKind::Object, "ball"},
        {"worldspawn", "", "*slime0", SolidRole::Liquid, FeatureKind::Liquid, "slime"},
        {"worldspawn", "", "!lava", SolidRole::Liquid, FeatureKind::Liquid, "lava"},
        {"worldspawn", "", "*TELEPORT", SolidRole::Teleport, FeatureKind::Teleport, "teleporter"},
        {"worldspawn", "", "common/trigger", SolidRole::Trigger, FeatureKind::Trigger, "marked place"},
        {"something_new", "", "null", SolidRole::Solid, FeatureKind::Object, "large block"},
    };
    for (const Case& c : cases) {
        const Scene scene = read(entity(c.class_name, c.keys, box_brush(0, 0, 0, 64, 64, 64, c.texture)));
        ASSERT_EQ(scene.solids.size(), 1U) << c.class_name;
        const Solid& solid = scene.solids[0];
        EXPECT_EQ(solid.role, c.role) << c.class_name << ' ' << c.texture;
        const Feature* feature = scene.find(solid.feature);
        ASSERT_NE(feature, nullptr) << c.class_name;
        EXPECT_EQ(feature->kind, c.kind) << c.class_name << ' ' << c.texture;
        EXPECT_EQ(feature->name, c.name) << c.class_name << ' ' << c.texture;
    }
}

TEST(ReadQuakeMap, treats_a_brush_as_special_only_if_all_its_faces_are) {
    std::string brush = box_brush(0, 0, 0, 64, 64, 64, "clip");
    EXPECT_EQ(read(entity("worldspawn", {}, brush)).solids.at(0).role, SolidRole::BodyClip);
    brush.replace(brush.find("clip"), 4, "wood");
    EXPECT_EQ(read(entity("worldspawn", {}, brush)).solids.at(0).role, SolidRole::Solid);
}

TEST(ReadQuakeMap, omits_the_cursor_and_the_helper_brushes_but_counts_them) {
    const Scene scene = read(entity("worldspawn", {}, kCube + box_brush(0, 0, 64, 64, 64, 96, "hint")) +
                             entity("thing", key("cs_name", "PHANTOM"), kCube));
    EXPECT_EQ(scene.solids.size(), 1U);
    EXPECT_EQ(scene.report.brushes, 3);
    EXPECT_EQ(scene.report.polygons, 18);
    EXPECT_EQ(scene.report.left_out.size(), 2U);
}

TEST(ReadQuakeMap, puts_starts_on_the_ground_with_their_heading_and_chooses_one_base) {
    const Scene scene =
        read(entity("worldspawn", {}, kCube) + entity("info_player_deathmatch", key("origin", "0 0 24")) +
             entity("info_player_start", key("origin", "32 64 56") + key("angle", "0")) +
             entity("info_teleport_destination", key("origin", "1 2 3")));
    ASSERT_EQ(scene.starts.size(), 2U);
    EXPECT_EQ(scene.report.starts, 2);
    EXPECT_FALSE(scene.starts[0].base);
    EXPECT_TRUE(scene.starts[1].base);
    EXPECT_EQ(scene.starts[1].feet_m, Vec3(1, 2, 1));
    EXPECT_NEAR(scene.starts[1].heading_rad, kPi / 2,
                1e-12);  // angle 0 faces east
}

TEST(ReadQuakeMap, distinguishes_a_game_map_from_a_building) {
    EXPECT_FALSE(read(entity("worldspawn", {}, kCube)).game_map);
    EXPECT_TRUE(read(entity("worldspawn", key("wad", "base.wad"), kCube)).game_map);
    EXPECT_TRUE(read(entity("worldspawn", {}, kCube) + entity("monster_ogre")).game_map);
    EXPECT_FALSE(read(entity("worldspawn", key("wad", "x.wad") + key("building", "1"), kCube)).game_map);
    EXPECT_FALSE(
        read(entity("worldspawn", key("wad", "x.wad"), kCube) + entity("thing", key("cs_name", "chair"), kCube))
            .game_map);
}

TEST(ReadQuakeMap, uses_the_nearest_legal_value_and_reports_the_line) {
    const Scene scene = read(entity("worldspawn", {}, kCube) +
                             "{\n\"classname\" \"thing\"\n\"stiffness\" \"1.5\"\n\"friction\" "
                             "\"much\"\n\"material\" \"plastre\"\n" +
                             kCube + "}\n");
    ASSERT_EQ(scene.report.warnings.size(), 3U);
    std::vector<std::string> said;
    for (const Diagnostic& warning : scene.report.warnings) said.push_back(warning.sentence());
    EXPECT_THAT(said, testing::Contains("test.map, line 14, column 13: warning: the value 1.5 of the key "
                                        "stiffness is out of range. Allowed: 0 to 1. 1 was used instead."));
    EXPECT_THAT(said, testing::Contains(testing::HasSubstr("line 15, column 12: warning: the value \"much\" of "
                                                           "the key friction is not a number.")));
    EXPECT_THAT(
        said, testing::Contains(testing::HasSubstr("there is no material \"plastre\". The nearest name is plaster.")));
    const Material& material = scene.material(scene.solids.at(1).face_materials.at(0));
    EXPECT_EQ(material.stiffness_fraction, 1.0);
    EXPECT_FALSE(material.friction_mu.has_value());
}

TEST(ReadWorld, reads_every_complete_map_without_a_warning) {
    const auto maps = test::project_root() / "worlds/maps";
    std::vector<std::filesystem::path> ours;
    for (const auto& entry : std::filesystem::directory_iterator(maps))
        if (entry.path().extension() == ".map") ours.push_back(entry.path());
    ASSERT_GE(ours.size(), 4U);
    for (const auto& path :
         test::with_real_worlds(ours, {"agdm01.map", "agtut01.map", "agtut03.map", "agtut05.map", "house.map",
                                       "office.map", "quake-dm3.map", "quake-e1m1.map", "quake-start.map"})) {
        const Result<Scene> scene = read_world(path);
        ASSERT_TRUE(scene.has_value()) << path;
        EXPECT_TRUE(validate(*scene).has_value()) << path;
        EXPECT_EQ(scene->report.warnings_in_all, 0) << path;
        EXPECT_EQ(scene->game_map, path.parent_path() != maps) << path;
    }
}

}  // namespace quake_map_test
}  // namespace handrail
