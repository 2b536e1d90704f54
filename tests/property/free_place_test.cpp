// Tests "Bring me out", which moves a hand from any place to a place outside all obstacles.
#include "haptic/render/free_place.h"

#include "haptic/compile/compile_haptic.h"
#include "tests/property/replay.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/random_families.h"
#include "tests/support/real_worlds.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace free_place_test {

// The judge checks the found places, in heaps of solids and sheets.
TEST(FreePlace, a_thousand_random_starts_end_outside_every_solid) {
    const auto seed = seed_of_run();
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int inside = 0;
    for (int heap = 0; heap < scaled(10); ++heap) {
        TouchWorld world;
        for (int i = 0; i < 12; ++i)
            world.random_brush(random, {uniform(-0.3, 0.3), uniform(-0.3, 0.3), uniform(-0.3, 0.3)}, uniform(0.05, 0.3),
                               3);
        world.random_triangles(random, 20, 0.3, 0.1);
        const auto scene = world.scene();
        const BruteForce judge = world.judge();
        for (int i = 0; i < 100; ++i) {
            const Vec3 from(uniform(-0.4, 0.4), uniform(-0.4, 0.4), uniform(-0.4, 0.4));
            SCOPED_TRACE(fmt::format("seed {}, heap {}, start {}", seed, heap, i));
            inside += judge.distance(from) < 0.0L;
            const auto out = nearest_free_place(*scene, {}, from, 0.005, 5.0);
            ASSERT_TRUE(out);
            ASSERT_GE(judge.distance(*out), 0.005L - 1e-9L);
            // A proxy that starts at this place has its full radius, is free and feels no force.
            TouchState state;
            const TouchResult r = touch_tick(state, *scene, plain_tuning(0.005), *out, 1e-3);
            ASSERT_FALSE(r.contacts.ghosted);
            ASSERT_EQ(r.radius_m, 0.005);
            ASSERT_EQ(r.force_n, Vec3(0.0));
        }
    }
    EXPECT_GT(inside, scaled(10) * 20) << "most starts should have been inside something";
}

TEST(FreePlace, in_a_single_box_is_at_the_nearest_face) {
    HapticSceneBuilder builder;
    builder.add_box({Vec3(-1, -1, -1), Vec3(1, 1, 1)}, SurfaceLabel{FeatureId{6}, 0, false});
    const auto scene = builder.build();
    const auto out = nearest_free_place(*scene, {}, {0.0, 0.0, 0.9}, 0.01, 10.0);
    ASSERT_TRUE(out);
    EXPECT_NEAR(glm::length(*out - Vec3(0, 0, 0.9)), 0.11, 0.02);
    EXPECT_GE(out->z, 1.01 - 1e-12);
    const Surrounding deep = surrounding_of(*scene, {}, {0.0, 0.0, 0.9}, 1.0);
    EXPECT_NEAR(deep.distance_m, -0.1, 1e-12);
    EXPECT_EQ(deep.feature, FeatureId{6});
    EXPECT_EQ(nearest_free_place(*scene, {}, {0.0, 0.0, 2.0}, 0.01, 10.0), Vec3(0.0, 0.0, 2.0)) << "already out";
    EXPECT_FALSE(nearest_free_place(*scene, {}, {0.0, 0.0, 0.0}, 0.01, 0.5)) << "too far";
}

TEST(FreePlace, considers_a_moved_body_at_its_current_place) {
    HapticSceneBuilder crate;
    crate.add_box({Vec3(-0.1), Vec3(0.1)}, SurfaceLabel{FeatureId{2}, 0, false});
    HapticSceneBuilder builder;
    builder.add_body(FeatureId{2}, crate.build(), {Vec3(5, 0, 0), {}, 1.0});
    const auto scene = builder.build();
    const std::vector<BodyPose> here{{Placement{Vec3(0.02, 0, 0), rotation_about({0, 0, 1}, 0.3), 2.0}, true}};
    EXPECT_EQ(surrounding_of(*scene, {}, Vec3(0.0), 1.0).feature, kNoFeature);
    EXPECT_EQ(surrounding_of(*scene, here, Vec3(0.0), 1.0).feature, FeatureId{2});
    const auto out = nearest_free_place(*scene, here, Vec3(0.0), 0.01, 2.0);
    ASSERT_TRUE(out);
    EXPECT_GE(surrounding_of(*scene, here, *out, 1.0).distance_m, 0.01);
}

void leads_out_of_the_walls_of(const std::filesystem::path& path) {
    const auto scene = read_world(path);
    ASSERT_TRUE(scene) << scene.error().sentence();
    const auto haptic = compile_haptic(*scene, MaterialSource::KeysOnly);
    std::mt19937 random(5);
    int tried = 0;
    for (int i = 0; i < scaled(200); ++i) {
        const Solid& solid = scene->solids[random() % scene->solids.size()];
        if (solid.role != SolidRole::Solid) continue;
        ++tried;
        const auto out = nearest_free_place(*haptic, {}, solid.shape.bounds_m.centre_m(), 0.1, 300.0);
        ASSERT_TRUE(out);
        EXPECT_GE(surrounding_of(*haptic, {}, *out, 1.0).distance_m, 0.1);
    }
    EXPECT_GT(tried, 0);
}

TEST(FreePlace, leads_out_of_the_walls_of_our_school) {
    leads_out_of_the_walls_of(project_root() / "worlds/maps/school.map");
}

TEST(FreePlace, leads_out_of_the_walls_of_a_real_game_level) {
    const auto path = real_world("quake-e1m1.map");
    if (!path) GTEST_SKIP() << needs_real_world("quake-e1m1.map");
    leads_out_of_the_walls_of(*path);
}

}  // namespace free_place_test
}  // namespace handrail::test
