// Tests the groups of an editor: they can be listed, hidden from touch, and given one material.
#include <gmock/gmock.h>

#include <filesystem>

#include "app/core/kept/kept_groups.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/render/haptic_scene.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"
#include "worlds/base/files.h"
#include "worlds/scene/groups.h"

namespace handrail {
namespace groups_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

// Returns the map of a room with a group of furniture, as TrenchBroom writes it, with a group of shelves inside it. A
// crate of the group stands on a block that is in no group.
std::string furnished() {
    using test::box_brush;
    using test::key;
    return test::entity("worldspawn", key("building", "1"),
                        test::room_brushes(0, 0, 0, 200, 200, 96) + box_brush(20, 20, 0, 40, 40, 20)) +
           test::entity(
               "func_group",
               key("_tb_type", "_tb_group") + key("_tb_name", "Shelves") + key("_tb_id", "2") + key("_tb_group", "1"),
               box_brush(120, 20, 0, 160, 40, 60)) +
           test::entity("func_group", key("_tb_type", "_tb_group") + key("_tb_name", "Furniture") + key("_tb_id", "1"),
                        box_brush(20, 20, 20, 40, 40, 40)) +
           test::entity("func_group", key("_tb_type", "_tb_layer") + key("_tb_name", "Layer") + key("_tb_id", "3"),
                        box_brush(20, 160, 0, 40, 180, 20)) +
           test::entity("thing", key("name", "Table") + key("_tb_group", "1"), box_brush(80, 120, 0, 120, 160, 60)) +
           test::entity("info_player_start", key("origin", "100 60 24"));
}

Scene read(const std::string& text) {
    const test::TemporaryFolder folder;
    auto scene = read_world(folder.write("flat.map", text));
    EXPECT_TRUE(scene);
    return scene ? std::move(*scene) : Scene{};
}

TEST(Groups, are_read_with_their_names_and_what_is_inside_them) {
    const Scene scene = read(furnished());
    ASSERT_EQ(scene.groups.size(), 2U) << "a layer is no group";
    EXPECT_EQ(scene.groups[0].name, "Furniture");
    EXPECT_EQ(scene.groups[1].name, "Shelves");
    EXPECT_EQ(scene.groups[1].inside, 0U);
    EXPECT_EQ(solids_in_group(scene, 0), 3U);
    EXPECT_EQ(solids_in_group(scene, 1), 1U);
    EXPECT_TRUE(read(test::entity("worldspawn", "", test::room_brushes(0, 0, 0, 200, 200, 96))).groups.empty());
}

TEST(Groups, that_contain_each_other_because_the_file_is_faulty_are_read_as_outer_groups) {
    const auto group = [](const char* name, const char* id, const char* in) {
        return test::entity("func_group",
                            test::key("_tb_name", name) + test::key("_tb_id", id) + test::key("_tb_group", in));
    };
    const Scene scene = read(test::entity("worldspawn", "", test::room_brushes(0, 0, 0, 200, 200, 96)) +
                             group("One", "1", "2") + group("Two", "2", "1") + group("Self", "3", "3"));
    ASSERT_EQ(scene.groups.size(), 3U);
    for (const Group& one : scene.groups) EXPECT_EQ(one.inside, kNoGroup) << one.name;
}

// Hiding a group must leave no open face behind: what it covered is felt instead.
TEST(Groups, that_are_hidden_are_not_felt_and_uncover_what_was_under_them) {
    Scene scene = read(furnished());
    const auto before = compile::compile_haptic(scene, compile::exploring(0.0));
    scene.groups[0].hidden = true;
    const auto after = compile::compile_haptic(scene, compile::exploring(0.0));
    EXPECT_EQ(before->obstacles.size() - after->obstacles.size(), 3U);
    const auto felt = without_hidden_groups(scene);
    ASSERT_TRUE(felt);
    for (const Solid& solid : felt->solids) {
        if (is_in_group(scene, solid, 0)) {
            EXPECT_EQ(solid.role, SolidRole::Illusion);
        }
        const Vec3 size = solid.shape.bounds_m.size_m();
        if (solid.role == SolidRole::Solid && size.x < 1.0 && size.y < 1.0 && solid.shape.bounds_m.min_m.z > -0.01) {
            EXPECT_THAT(solid.face_hidden, testing::Contains(false).Times(5)) << "all but the face on the floor";
        }
    }
    scene.groups[0].hidden = false;
    EXPECT_FALSE(without_hidden_groups(scene));
}

struct Person : test::AppSession {
    explicit Person(const fs::path& world) {
        app.apply(WorldEntered{make_ready(test::world_in(world)), SideFile::of_world(world, {})}, now);
        run(0.1);
    }
};

TEST(Groups, are_listed_hidden_and_given_a_material_by_a_person) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.write("flat.map", furnished());
    {
        Person p(world);
        EXPECT_THAT(p.request(Command::Groups), HasSubstr("Furniture, 3 parts"));
        p.line("furniture");
        EXPECT_EQ(p.line("hide"), "Your hand no longer feels Furniture. You still cannot walk through it.");
        p.request(Command::Groups);
        EXPECT_THAT(p.said.back(), HasSubstr("Furniture, hidden from touch, 3 parts"));
        p.line("furniture");
        EXPECT_EQ(p.line("feel"), "Your hand feels Furniture again.");
        p.request(Command::Groups);
        p.line("shelves");
        p.line("material");
        EXPECT_EQ(p.line("rubber"), "Shelves is now made of rubber.");
    }
    Person p(world);
    EXPECT_FALSE(p.app.scene()->groups[0].hidden);
    for (const Solid& solid : p.app.scene()->solids) {
        const bool rubber = p.app.scene()->material(solid.face_materials[0]).name == "rubber";
        EXPECT_EQ(rubber, is_in_group(*p.app.scene(), solid, 1));
    }
}

TEST(Groups, say_that_a_world_has_none) {
    const test::TemporaryFolder folder;
    Person p(folder.write("flat.map", test::entity("worldspawn", "", test::room_brushes(0, 0, 0, 200, 200, 96)) +
                                          test::entity("info_player_start", test::key("origin", "100 60 24"))));
    EXPECT_THAT(p.request(Command::Groups), StartsWith("This world has no groups."));
}

}  // namespace groups_test
}  // namespace handrail
