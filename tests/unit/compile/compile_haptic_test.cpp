#include "haptic/compile/compile_haptic.h"

#include <gmock/gmock.h>

#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/sphere_mesh.h"

namespace handrail {
namespace compile_haptic_test {

Solid box_solid(const Vec3& low, const Vec3& high, SolidRole role, FeatureId feature,
                MaterialId material = kDefaultMaterial) {
    Solid solid;
    solid.role = role;
    solid.feature = feature;
    solid.shape.bounds_m = {low, high};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 n(0.0);
        n[axis] = 1.0;
        solid.shape.planes.push_back({n, high[axis]});
        solid.shape.planes.push_back({-n, -low[axis]});
    }
    solid.face_features.assign(6, kNoFeature);
    solid.face_materials.assign(6, material);
    solid.face_hidden.assign(6, false);
    return solid;
}

TEST(CompileHaptic, makes_obstacles_of_solids_and_movers_and_volumes_of_liquids_and_skips_the_rest) {
    Scene scene;
    scene.materials.resize(1);
    scene.features.resize(10);
    for (const SolidRole role : {SolidRole::Solid, SolidRole::Mover, SolidRole::BodyClip, SolidRole::Liquid,
                                 SolidRole::Trigger, SolidRole::Teleport, SolidRole::Illusion})
        scene.solids.push_back(box_solid({0, 0, 0}, {1, 1, 1}, role, FeatureId{static_cast<std::uint32_t>(role)}));
    scene.solids[3].viscosity_ns_per_m = 2.5;
    scene.triangles.push_back({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, FeatureId{9}, 0});
    const auto compiled = compile_haptic(scene, MaterialSource::KeysOnly);
    EXPECT_EQ(compiled->boxes.size(), 2U) << "axis-aligned brushes are boxes";
    EXPECT_EQ(compiled->planes.size(), 0U);
    EXPECT_EQ(compiled->mesh.triangles.size(), 1U);
    EXPECT_EQ(compiled->obstacles.size(), 3U);
    ASSERT_EQ(compiled->liquids.size(), 1U);
    EXPECT_EQ(compiled->liquids[0].viscosity_ns_per_m, 2.5);
    EXPECT_EQ(compiled->liquids[0].feature, FeatureId{static_cast<std::uint32_t>(SolidRole::Liquid)});
    EXPECT_EQ(compiled->surface(1, {0, 0, 1}).feature, FeatureId{static_cast<std::uint32_t>(SolidRole::Mover)});
    EXPECT_EQ(compiled->surface(2, {0, 0, 1}).feature, FeatureId{9});
}

TEST(CompileHaptic, keeps_the_touchable_side_of_sheets_even_after_joining_them) {
    Scene scene;
    scene.materials.resize(1);
    scene.features.resize(1);
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
    for (const TouchSide side : {TouchSide::Front, TouchSide::Back, TouchSide::Both}) {
        scene.triangles = {{a, b, c, FeatureId{0}, 0, side}, {a, c, d, FeatureId{0}, 0, side}};
        const auto compiled = compile_haptic(scene, MaterialSource::KeysOnly);
        ASSERT_EQ(compiled->obstacles.size(), 1U) << "one square";
        EXPECT_EQ(compiled->obstacles[0].side, side);
        EXPECT_EQ(compiled->one_sided_sheets, side != TouchSide::Both);
    }
    scene.triangles[1].side = TouchSide::Front;
    EXPECT_EQ(compile_haptic(scene, MaterialSource::KeysOnly)->obstacles.size(), 2U)
        << "different sides are different surfaces";
}

TEST(CompileHaptic, applies_textures_and_shading_to_moving_and_static_things_alike) {
    // A slightly bent sheet, thin along x, made of four facets about an axis.
    auto model = std::make_shared<Scene>();
    model->materials.resize(1);
    const auto at = [](int k, double z) { return Vec3(0.1 * std::cos(0.1 * k), 0.1 * std::sin(0.1 * k), z); };
    for (int k = -2; k < 2; ++k) {
        model->triangles.push_back({at(k, 0.0), at(k + 1, 0.0), at(k + 1, 0.1)});
        model->triangles.push_back({at(k, 0.0), at(k + 1, 0.1), at(k, 0.1)});
    }
    Scene scene;
    scene.materials.resize(2);
    scene.materials[1].wave = TextureWave{};
    scene.materials[1].wave->shape = WaveShape::Sine;
    scene.materials[1].wave->depth_hand_m = 4e-4;
    scene.materials[1].wave->period_hand_m = 0.01;
    scene.features.resize(1);
    PlacedModel placed;
    placed.feature = FeatureId{0};
    placed.material = 1;
    placed.model = model;
    scene.placed.push_back(placed);
    const auto felt = compile_haptic(scene, exploring(0.0)), replayed = compile_haptic(scene, MaterialSource::KeysOnly);
    ASSERT_EQ(felt->bodies.size(), 1U);
    EXPECT_GT(felt->bodies[0].shape->shading.highest_m, 1e-5) << "curved";
    EXPECT_EQ(replayed->bodies[0].shape->shading.highest_m, 0.0) << "a replay meets the facets";
    ASSERT_EQ(felt->relief_axis.size(), 1U);
    EXPECT_EQ(felt->relief_axis[0], 0) << "along its own x";
    // The relief pattern is fixed to the body. So a body at another place must exert the same force at the same point
    // of the body.
    const auto press = [&](const Vec3& moved_m) {
        TouchState state;
        TouchTuning tuning;
        const BodyPose pose{Placement{moved_m}, true};
        TouchResult r;
        for (int i = 0; i < 300; ++i)
            r = touch_tick(state, *felt, tuning, moved_m + Vec3(0.115 - 6e-5 * i, 0.003, 0.0531), 1e-3, Vec3(0.0),
                           {std::span(&pose, 1), 1});
        EXPECT_GT(glm::length(r.force_n), 1.0);
        return r.force_n;
    };
    const Vec3 here = press(Vec3(0.0));
    EXPECT_LE(glm::length(press({0.25, -0.5, 0.125}) - here), 1e-6);
    EXPECT_LE(glm::length(press({0.003, 0.0041, 0.0017}) - here), 1e-6);
}

std::vector<MeshTriangle> dense_sphere(FeatureId feature) {
    const TriangleMesh sphere = test::sphere_mesh(23, 0.5);  // 10,580 triangles
    std::vector<MeshTriangle> triangles;
    for (const Corners& t : sphere.triangles)
        triangles.push_back({sphere.points_m[t[0]], sphere.points_m[t[1]], sphere.points_m[t[2]], feature, 0});
    return triangles;
}

TEST(CompileHaptic, makes_dense_meshes_coarser_within_the_tolerance_and_says_which) {
    Scene scene;
    scene.materials.resize(1);
    scene.features.resize(3);
    scene.triangles = dense_sphere(FeatureId{1});
    scene.triangles.push_back({{2, 0, 0}, {3, 0, 0}, {2, 1, 0}, FeatureId{0}, 0});
    auto model = std::make_shared<Scene>();
    model->materials.resize(1);
    model->triangles = dense_sphere(kNoFeature);
    PlacedModel placed;
    placed.feature = FeatureId{2};
    placed.at.scale = 2.0;
    placed.model = model;
    scene.placed.push_back(placed);
    ASSERT_TRUE(has_dense_mesh(scene));
    const auto obstacles = [](const HapticScene& felt) {
        return std::pair(felt.obstacles.size(), felt.bodies[0].shape->obstacles.size());
    };
    EXPECT_EQ(obstacles(*compile_haptic(scene, exploring(0.0))),
              std::pair(scene.triangles.size(), model->triangles.size()));
    constexpr double kTolerance_m = 0.006;
    CompileOptions options = exploring(0.0, 0, kTolerance_m);
    std::vector<std::pair<FeatureId, std::size_t>> begun;
    options.simplifies = [&](FeatureId feature, std::size_t triangles) { begun.emplace_back(feature, triangles); };
    CompileReport report;
    const auto felt = compile_haptic(scene, options, &report);
    EXPECT_THAT(begun, testing::ElementsAre(std::pair(FeatureId{1}, std::size_t{10'580}),
                                            std::pair(FeatureId{2}, std::size_t{10'580})));
    ASSERT_EQ(report.coarser.size(), 2U);
    for (const CoarserMesh& mesh : report.coarser) {
        EXPECT_EQ(mesh.before, 10'580U);
        EXPECT_LT(mesh.after, mesh.before / 4);
        EXPECT_LE(mesh.off_m, kTolerance_m) << "also in the world of the larger one";
        EXPECT_GT(mesh.off_m, 0.3 * kTolerance_m);
    }
    EXPECT_EQ(report.coarser[0].feature, FeatureId{1});
    EXPECT_EQ(report.coarser[1].feature, FeatureId{2});
    EXPECT_GT(report.coarser[1].after, report.coarser[0].after) << "the larger one may be less far off in its own size";
    EXPECT_EQ(obstacles(*felt), std::pair(report.coarser[0].after + 1, report.coarser[1].after));
    std::stop_source stop;
    options.stop = stop.get_token();
    options.simplifies = [&](FeatureId, std::size_t) { stop.request_stop(); };
    EXPECT_EQ(compile_haptic(scene, options), nullptr);
}

TEST(CompileHaptic, counts_the_triangles_of_each_thing_before_it_calls_a_mesh_dense) {
    Scene scene;
    scene.features.resize(2);
    scene.triangles = dense_sphere(FeatureId{0});
    for (std::size_t t = 0; t < 700; ++t) scene.triangles[t].feature = FeatureId{1};
    EXPECT_FALSE(has_dense_mesh(scene)) << "9,880 and 700";
    scene.triangles[0].feature = FeatureId{0};
    scene.triangles.resize(kDenseFrom + 700);
    EXPECT_FALSE(has_dense_mesh(scene));
}

TEST(CompileHaptic, keeps_slanted_solids_as_brushes_with_named_faces) {
    Scene scene;
    scene.materials.resize(3);
    Solid wedge = box_solid({0, 0, 0}, {1, 1, 1}, SolidRole::Solid, kNoFeature);
    wedge.shape.planes.push_back({glm::normalize(Vec3(1, 0, 1)), 1.0});
    wedge.face_features.push_back(FeatureId{4});
    wedge.face_materials.push_back(2);
    wedge.face_hidden.push_back(false);
    scene.solids.push_back(wedge);
    const auto compiled = compile_haptic(scene, MaterialSource::KeysOnly);
    ASSERT_EQ(compiled->planes.size(), 7U);
    EXPECT_EQ(compiled->surface(0, glm::normalize(Vec3(1, 0, 1))).feature, FeatureId{4});
    EXPECT_EQ(compiled->surface(0, glm::normalize(Vec3(1, 0, 1))).material, 2);
    EXPECT_EQ(compiled->surface(0, {0, 0, -1}).feature, kNoFeature);
}

TEST(CompileHaptic, uses_only_explicit_keys_for_replay_and_falls_back_to_the_library_for_exploring) {
    Scene scene;
    scene.materials.resize(3);
    scene.materials[1].stiffness_fraction = 0.25;
    const MaterialSpec& row =
        material_library().empty() ? throw std::runtime_error("no materials") : material_library().front();
    scene.materials[2].name = std::string(row.name);
    scene.materials[2].friction_mu = 0.77;
    const auto keys = compile_haptic(scene, MaterialSource::KeysOnly);
    ASSERT_EQ(keys->materials.size(), 3U);
    EXPECT_LT(keys->materials[0].stiffness_fraction, 0.0);
    EXPECT_EQ(keys->materials[1].stiffness_fraction, 0.25);
    EXPECT_LT(keys->materials[2].stiffness_fraction, 0.0);
    EXPECT_EQ(keys->materials[2].friction_kinetic, 0.77);
    const auto library = compile_haptic(scene, MaterialSource::Library);
    EXPECT_EQ(library->materials[2].stiffness_fraction, row.stiffness_fraction);
    EXPECT_EQ(library->materials[2].friction_static, 0.77);
    EXPECT_NE(keys->generation, library->generation);
}

TEST(CompileHaptic, applies_library_texture_and_damping_only_for_exploring_and_explicit_values_always) {
    Scene scene;
    scene.materials.resize(3);
    scene.materials[1].name = "steel grille";
    scene.materials[2].wave = TextureWave{WaveShape::Sine, 1e-3, 0.02, 0.1};
    scene.materials[2].damping_ns_per_m = 7.0;
    scene.materials[2].friction_mu = 0.4;
    scene.materials[2].friction_static = 0.5;
    const auto keys = compile_haptic(scene, MaterialSource::KeysOnly);
    ASSERT_EQ(keys->reliefs.size(), 1U);
    EXPECT_EQ(keys->materials[1].relief, -1);
    EXPECT_EQ(keys->materials[2].relief, 0);
    EXPECT_EQ(keys->materials[2].damping_ns_per_m, 7.0);
    EXPECT_EQ(keys->materials[2].friction_static, 0.5);
    EXPECT_EQ(keys->materials[2].friction_kinetic, 0.4);
    const auto library = compile_haptic(scene, MaterialSource::Library);
    ASSERT_EQ(library->reliefs.size(), 2U);
    EXPECT_EQ(library->reliefs[0].kind, ReliefKind::Square);
    EXPECT_EQ(library->reliefs[0].period_hand_m, 0.01);
    EXPECT_EQ(library->reliefs[1].kind, ReliefKind::Sine);
    scene.materials.resize(1);
    EXPECT_FALSE(compile_haptic(scene, MaterialSource::Library)->has_fields())
        << "nothing is paid for what no surface has";
}

TEST(CompileHaptic, moves_the_origin_only_for_buildings_far_away) {
    Scene near, far;
    near.materials.resize(1);
    far.materials.resize(1);
    near.solids.push_back(box_solid({-900, 0, 0}, {900, 1, 1}, SolidRole::Solid, kNoFeature));
    far.solids.push_back(box_solid({500000, 0, 0}, {500001, 1, 1}, SolidRole::Solid, kNoFeature));
    EXPECT_EQ(compile_haptic(near, MaterialSource::KeysOnly)->origin_m, Vec3(0.0));
    const auto moved = compile_haptic(far, MaterialSource::KeysOnly);
    EXPECT_NEAR(moved->origin_m.x, 500000.5, 1.0);
    EXPECT_NEAR(moved->origin_m.x + moved->boxes[0].max_m.x, 500001.0, 1e-9);
}

}  // namespace compile_haptic_test
}  // namespace handrail
