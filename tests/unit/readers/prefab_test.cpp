// Tests furniture that a map places with a single key. The furniture must be at the stated place, face the stated
// direction, and have its own name and materials.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/material.h"
#include "worlds/scene/prefab.h"

namespace handrail {
namespace prefab_test {

using test::entity;
using test::key;

Scene room_with(const std::string& furniture) {
    auto scene = read_quake_map(entity("worldspawn", "", test::room_brushes(-160, -160, 0, 160, 160, 96)) +
                                    entity("info_player_start", key("origin", "-128 -128 24")) + furniture,
                                "room.map");
    EXPECT_TRUE(scene);
    return scene ? std::move(*scene) : Scene{};
}
std::string piece(std::string_view name, const std::string& more = {}) {
    return entity("thing", key("prefab", std::string(name)) + key("origin", "32 64 0") + more);
}
const Feature* called(const Scene& scene, const std::string& name) {
    for (const Feature& feature : scene.features)
        if (spoken_name(feature) == name) return &feature;
    return nullptr;
}
std::vector<Solid> solids_of(const Scene& scene, const Feature& feature) {
    const FeatureId id{static_cast<std::uint32_t>(&feature - scene.features.data())};
    std::vector<Solid> own;
    for (const Solid& solid : scene.solids)
        if (solid.feature == id) own.push_back(solid);
    return own;
}

TEST(Prefabs, are_placed_and_turned_as_written_with_each_part_in_its_material) {
    for (const Prefab& prefab : prefabs()) {
        SCOPED_TRACE(prefab.name);
        for (const double angle_deg : {0.0, 90.0, 180.0, 270.0, 37.0}) {
            SCOPED_TRACE(angle_deg);
            const Scene scene = room_with(piece(prefab.name, key("angle", std::to_string(angle_deg))));
            const Feature* feature = called(scene, spoken_kind(prefab.name));
            ASSERT_NE(feature, nullptr);
            const std::vector<Solid> solids = solids_of(scene, *feature);
            ASSERT_EQ(solids.size(), prefab.parts.size());
            EXPECT_EQ(scene.report.warnings.size(), 0U);
            // The map's angle is counter-clockwise from east. The front of a piece of furniture is its +y side.
            const double turn = radians_from_degrees(angle_deg - 90.0);
            const auto placed = [&](const Vec3& p) {
                return Vec3(1.0 + p.x * std::cos(turn) - p.y * std::sin(turn),
                            2.0 + p.x * std::sin(turn) + p.y * std::cos(turn), p.z);
            };
            for (std::size_t i = 0; i < solids.size(); ++i) {
                const Aabb& box = prefab.parts[i].box_m;
                const Vec3 size = box.size_m();
                EXPECT_NEAR(solids[i].shape.bounds_m.size_m().z, size.z, 1e-6);
                // Tests points just inside and just outside each side of the furniture.
                for (const Vec3& side :
                     {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
                    EXPECT_TRUE(contains(solids[i].shape, placed(box.centre_m() + side * (0.5 * size - 1e-4))));
                    EXPECT_FALSE(contains(solids[i].shape, placed(box.centre_m() + side * (0.5 * size + 1e-4))));
                }
                for (const MaterialId material : solids[i].face_materials)
                    EXPECT_EQ(scene.material(material).name, prefab.parts[i].material);
                EXPECT_NE(find_material(prefab.parts[i].material), nullptr);
            }
        }
    }
}

TEST(Prefabs, accept_a_name_a_material_and_a_landmark_and_may_be_free_bodies) {
    const Scene scene =
        room_with(piece("Chair", key("name", "Grandfather's chair") + key("landmark", "1") + key("material", "metal")) +
                  piece("table", key("free", "1") + key("mass", "12")));
    const Feature* chair = called(scene, "Grandfather's chair");
    ASSERT_NE(chair, nullptr);
    EXPECT_TRUE(chair->landmark);
    for (const Solid& solid : solids_of(scene, *chair))
        EXPECT_EQ(scene.material(solid.face_materials.front()).name, "metal");
    ASSERT_EQ(scene.bodies.size(), 1U);
    EXPECT_NEAR(scene.bodies.front().mass_kg, 12.0, 1e-9);
    const test::InLanguage german("de");
    EXPECT_NE(called(scene, "Tisch"), nullptr);
}

TEST(Prefabs, that_cannot_be_placed_are_reported_with_their_line_and_the_nearest_name) {
    const auto warned = [](const std::string& furniture) {
        const Scene scene = room_with(furniture);
        return scene.report.warnings.empty() ? std::string() : scene.report.warnings.front().message;
    };
    EXPECT_THAT(warned(piece("chiar")),
                testing::HasSubstr("\"chiar\" is not a piece of furniture; the nearest is chair."));
    EXPECT_THAT(warned(entity("thing", key("prefab", "bed"))), testing::HasSubstr("bed has no origin."));
    EXPECT_THAT(
        warned(entity("thing", key("prefab", "bed") + key("origin", "0 0 0"), test::box_brush(0, 0, 0, 32, 32, 32))),
        testing::HasSubstr("bed is a ready-made piece of furniture, so it must not have brushes."));
    EXPECT_EQ(find_prefab("Chair"), nullptr) << "names are in lower case";
}

TEST(Prefabs, are_listed_in_the_authors_guide_with_their_sizes) {
    std::ifstream file((test::project_root() / "docs/map-authors-guide/furniture.md").string());
    std::stringstream guide;
    guide << file.rdbuf();
    for (const Prefab& prefab : prefabs()) {
        Aabb box;
        for (const PrefabPart& one : prefab.parts) box.include(one.box_m);
        const Vec3 size = box.size_m();
        EXPECT_THAT(guide.str(), testing::HasSubstr(fmt::format("| `{}` | {:.2f} by {:.2f} m, {:.2f} m high |",
                                                                prefab.name, size.x, size.y, size.z)));
    }
}

}  // namespace prefab_test
}  // namespace handrail
