// Tests how the placed models of a Scene become bodies: which are free, which are driven, and what they weigh.
#include "haptic/compile/compile_dynamics.h"

#include <gtest/gtest.h>

#include "haptic/compile/compile_haptic.h"
#include "tests/support/names.h"

namespace handrail {
namespace compile_dynamics_test {

Solid solid_of(const DynamicsPiece& piece, FeatureId feature) {
    Solid solid;
    solid.shape = piece.solid;
    solid.round = piece.round;
    solid.feature = feature;
    solid.face_features.assign(piece.solid.planes.size(), feature);
    solid.face_materials.assign(piece.solid.planes.size(), kDefaultMaterial);
    solid.face_hidden.assign(piece.solid.planes.size(), false);
    return solid;
}

// Returns a scene with a floor, a pool above it, and three crates of 0.4 m. The last crate is scaled to twice the size.
Scene crates() {
    Scene scene;
    scene.materials.resize(1);
    scene.features.resize(5);
    scene.solids.push_back(solid_of(make_box_piece({Vec3(-5, -5, -1), Vec3(5, 5, 0)}), FeatureId{0}));
    scene.solids.push_back(solid_of(make_box_piece({Vec3(-5, -5, 0), Vec3(5, 5, 1)}), FeatureId{1}));
    scene.solids.back().role = SolidRole::Liquid;
    auto model = std::make_shared<Scene>();
    model->materials.resize(1);
    model->solids.push_back(solid_of(make_box_piece({Vec3(-0.2), Vec3(0.2)}), FeatureId{0}));
    for (std::uint32_t i = 0; i < 3; ++i)
        scene.placed.push_back({FeatureId{2 + i}, model, kDefaultMaterial, {Vec3(i, 0, 0.5), {}, i == 2 ? 2.0 : 1.0}});
    return scene;
}

TEST(CompileDynamics, creates_bodies_for_free_things_and_leaves_the_rest_driven) {
    const Scene scene = crates();
    FreeThing first, last;
    first.placed = 0;
    first.nature.mass_kg = 4.0;
    last.placed = 2;
    last.density_kg_per_m3 = 600.0;
    DynamicsReport report;
    const auto made = compile_dynamics(scene, std::vector{first, last}, Vec3(0, 0, 100), &report);
    ASSERT_TRUE(made);
    EXPECT_TRUE(report.refused.empty());
    EXPECT_EQ(made->building.size(), 1U) << "liquids stop nothing";
    EXPECT_EQ(made->building[0].feature, FeatureId{0});
    ASSERT_EQ(made->bodies.size(), 2U);
    EXPECT_EQ(report.bodies, (std::vector<std::uint32_t>{0, kNoBody, 1}));
    EXPECT_EQ(report.driven, (std::vector<std::uint32_t>{kNoBody, 0, kNoBody}));
    EXPECT_EQ(made->bodies[1].haptic, 2U);
    EXPECT_EQ(made->bodies[1].feature, FeatureId{4});
    EXPECT_NEAR(report.mass_kg[0], 4.0, 1e-12);
    EXPECT_NEAR(report.mass_kg[1], 600.0 * 0.8 * 0.8 * 0.8, 1e-9);
    EXPECT_NEAR(made->bodies[0].inertia_kg_m2.x, 4.0 * 2 * 0.16 / 12.0, 1e-12);
    EXPECT_NEAR(made->bodies[1].inertia_kg_m2.x, report.mass_kg[1] * 2 * 0.64 / 12.0, 1e-9);
    EXPECT_NEAR(made->bodies[0].start.position_m.z, 0.5 - 100.0, 1e-12) << "local to the origin";
    // The body of the physics engine must be at the place where the hand feels the crate.
    const auto felt = compile_haptic(scene, MaterialSource::KeysOnly);
    const Placement thing = thing_of(made->bodies[1], made->bodies[1].start);
    EXPECT_LT(glm::length(thing.position_m + made->origin_m - felt->bodies[2].start.position_m), 1e-12);
    EXPECT_EQ(thing.scale, felt->bodies[2].start.scale);
}

TEST(CompileDynamics, returns_nothing_if_no_body_is_free) {
    const Scene scene = crates();
    EXPECT_FALSE(compile_dynamics(scene, {}, Vec3(0.0)));
    FreeThing bad;
    bad.placed = 1;
    bad.nature.mass_kg = 0.0;
    DynamicsReport report;
    EXPECT_FALSE(compile_dynamics(scene, std::vector{bad}, Vec3(0.0), &report));
    ASSERT_EQ(report.refused.size(), 1U);
    EXPECT_EQ(report.refused[0].fault, BodyFault::BadMass);
}

TEST(CompileDynamics, refuses_a_density_without_volume_and_too_many_bodies) {
    Scene scene = crates();
    auto sheet = std::make_shared<Scene>();
    sheet->triangles.push_back({Vec3(0.0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
    scene.placed[0].model = sheet;
    FreeThing paper;
    paper.density_kg_per_m3 = 600.0;
    FreeThing again;
    again.placed = 1;
    DynamicsReport report;
    ASSERT_TRUE(compile_dynamics(scene, std::vector{paper, again, again}, Vec3(0.0), &report));
    ASSERT_EQ(report.refused.size(), 1U);
    EXPECT_EQ(report.refused[0].fault, BodyFault::NoVolume);
    EXPECT_EQ(report.mass_kg.size(), 1U) << "one thing named twice is one body";
    EXPECT_EQ(report.driven[0], kNoBody);

    constexpr std::size_t kMany = DynamicsScene::kMostBodies + 72;
    for (std::size_t i = 0; i < kMany; ++i) scene.placed.push_back(scene.placed[1]);
    std::vector<FreeThing> many(kMany);
    for (std::size_t i = 0; i < many.size(); ++i) many[i].placed = 3 + i;
    const auto made = compile_dynamics(scene, many, Vec3(0.0), &report);
    EXPECT_EQ(made->bodies.size(), DynamicsScene::kMostBodies);
    EXPECT_EQ(report.refused.size(), 72U);
    EXPECT_EQ(report.refused.back().fault, BodyFault::TooMany);
}

}  // namespace compile_dynamics_test
}  // namespace handrail
