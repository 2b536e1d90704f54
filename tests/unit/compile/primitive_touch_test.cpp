// Tests exact shapes from the scene to the force on the hand. Each shape must become the matching obstacle. If a shape
// is moved, rotated and scaled, its force must change accordingly.
#include <random>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/support/touch_worlds.h"
#include "worlds/scene/models.h"

namespace handrail::test {
namespace primitive_touch_test {

Scene scene_of(const Primitive& primitive) {
    Scene scene;
    scene.materials.emplace_back();
    scene.features.emplace_back().name = "thing";
    Solid solid = make_solid(primitive).value();
    solid.feature = FeatureId{0};
    solid.face_features.assign(solid.face_features.size(), FeatureId{0});
    scene.solids.push_back(std::move(solid));
    return scene;
}

TEST(CompileHaptic, turns_every_exact_shape_into_its_obstacle_whether_static_or_a_body) {
    const std::array kinds{ObstacleKind::Box, ObstacleKind::Sphere, ObstacleKind::Cylinder, ObstacleKind::Cone,
                           ObstacleKind::Capsule};
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const Primitive primitive{static_cast<PrimitiveKind>(k), Vec3(1.0), Vec3(1.0), {{3, 4, 5}, {}, 1.0}};
        Scene scene = scene_of(primitive);
        scene.placed.push_back({FeatureId{0}, *primitive_model(primitive), kDefaultMaterial, {{0, 0, 9}, {}, 2.0}});
        const auto compiled = compile_haptic(scene, MaterialSource::KeysOnly);
        for (const HapticScene* part : {compiled.get(), compiled->bodies.at(0).shape.get()}) {
            ASSERT_EQ(part->obstacles.size(), 1U) << k;
            EXPECT_EQ(part->obstacles[0].kind, kinds[k]) << k;
            EXPECT_EQ(part->obstacle_counts()[static_cast<std::size_t>(kinds[k])], 1U);
        }
        EXPECT_EQ(compiled->surface(0, {0, 0, 1}).feature, FeatureId{0});
    }
    Primitive turned{PrimitiveKind::Box, Vec3(1.0), Vec3(1.0), {}};
    turned.at.rotation = rotation_about({0, 0, 1}, 0.3);
    EXPECT_EQ(compile_haptic(scene_of(turned), MaterialSource::KeysOnly)->obstacles.at(0).kind, ObstacleKind::Brush)
        << "a turned box is a brush";
}

// Compares the force and the proxy along a hand path, once at the original shape and once at the placed shape. The
// results at the placed shape are transformed back into that shape's own frame.
TEST(CompileHaptic, moved_turned_and_scaled_shapes_push_like_the_transformed_originals) {
    const std::uint32_t seed0 = test::seed_of_run();
    std::size_t touched = 0;  // contacts of all rounds together; a single path may miss a thin shape
    for (int round = 0; round < scaled(20); ++round) {
        std::mt19937 random(seed0 + static_cast<std::uint32_t>(round));
        const auto kind = static_cast<PrimitiveKind>(round % 5);
        const Primitive here{kind, {0.06, 0.06, kind == PrimitiveKind::Sphere ? 0.06 : 0.08}, Vec3(1.0), {}};
        Primitive there = here;
        const auto part = [&] { return (random() % 2001) / 1000.0 - 1.0; };
        there.at.rotation = normalized({part(), part(), part(), part()});
        there.at.position_m = {100.0 * part(), 100.0 * part(), 10.0 * part()};
        there.at.scale = 0.2 + (random() % 100) / 20.0;
        const double s = there.at.scale;
        std::vector<Vec3> way{{0, 0, 0.09}};
        for (int i = 0; i < 12; ++i) way.emplace_back(0.06 * part(), 0.06 * part(), 0.06 * part());
        way.emplace_back(0, 0, 0.09);
        const std::vector<Vec3> goals = hand_path(way, 0.2);
        // The hand's tuning is scaled with the world, so that the hand follows the corresponding path in both scenes.
        TouchTuning tuning, scaled_tuning;
        tuning.slide_cap_hand_m = scaled_tuning.slide_cap_hand_m = 1.0;
        tuning.default_friction_static = tuning.default_friction_kinetic = scaled_tuning.default_friction_static =
            scaled_tuning.default_friction_kinetic = 0.3;
        scaled_tuning.radius_m = tuning.radius_m * s;
        scaled_tuning.world_m_per_hand_m = s;
        const auto scene = compile_haptic(scene_of(here), MaterialSource::KeysOnly),
                   moved = compile_haptic(scene_of(there), MaterialSource::KeysOnly);
        const PlacedFrame frame(there.at);
        TouchState a, b;
        double worst_n = 0.0, worst_m = 0.0;
        std::size_t differ = 0;
        for (const Vec3& goal : goals) {
            const TouchResult one = touch_tick(a, *scene, tuning, goal, 1e-3),
                              other = touch_tick(b, *moved, scaled_tuning, frame.to_world(goal), 1e-3);
            touched += one.contacts.count > 0 ? 1 : 0;
            if (!one.contacts.converged || !other.contacts.converged) continue;
            const double difference_n = glm::length(frame.turned_back(other.force_n) - one.force_n);
            worst_n = std::max(worst_n, difference_n);
            differ += difference_n > 1e-5 ? 1 : 0;
            worst_m = std::max(worst_m, glm::length(frame.to_own(other.proxy_m) - one.proxy_m));
        }
        // The solver's iterations end within 1e-8 m of the exact solution, measured in the world. Friction preserves
        // that error. Rims and tips multiply the error, and so does a hand that is about to slip off.
        const bool edges = kind != PrimitiveKind::Sphere && kind != PrimitiveKind::Capsule;
        EXPECT_LE(worst_n, 0.1) << "seed " << seed0 + static_cast<std::uint32_t>(round) << " kind "
                                << static_cast<int>(kind);
        EXPECT_LE(worst_m, 1e-4);
        EXPECT_LE(differ, goals.size() / (edges ? 5 : 50))
            << "seed " << seed0 + static_cast<std::uint32_t>(round) << " kind " << static_cast<int>(kind);
    }
    EXPECT_GT(touched, 100U);
}

}  // namespace primitive_touch_test
}  // namespace handrail::test
