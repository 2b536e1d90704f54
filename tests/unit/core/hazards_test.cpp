#include "app/core/world/hazards.h"

#include <cmath>
#include <random>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"

namespace handrail {
namespace hazards_test {

using test::SceneBuilder;

struct Ground {
    explicit Ground(SceneBuilder& b, bool game = false) {
        b.scene().game_map = game;
        scene = b.share();
        world = std::make_unique<WalkerWorld>(scene);
        rules = ground_rules(*scene, walker_size(*scene, 0.25));
    }
    GroundAhead ahead(const Vec3& feet, double heading, double range = 6.3) const {
        return ground_ahead(*world, feet, heading, rules, range);
    }
    std::shared_ptr<const Scene> scene;
    std::unique_ptr<WalkerWorld> world;
    GroundRules rules;
};

// Adds stairs with `risers` steps north of `y0`, on a floor of 40 by 40 metres around `at`.
void stairs(SceneBuilder& b, const Vec3& at, double y0, int risers, double rise, double tread) {
    b.box(at + Vec3(-20, -20, -3), at + Vec3(20, 20, 0), "floor");
    for (int i = 0; i < risers; ++i)
        b.box(at + Vec3(-1, y0 + i * tread, 0), at + Vec3(1, y0 + risers * tread + 2.0, (i + 1) * rise), "stair");
}

TEST(Hazards, stairs_are_counted_and_measured_at_any_place_and_steepness) {
    std::mt19937 random(static_cast<unsigned>(test::seed_of_run()));
    for (int run = 0; run < 60; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const int risers = std::uniform_int_distribution(3, 24)(random);
        const double rise = between(0.09, 0.24), tread = between(0.22, 0.45), y0 = between(0.4, 6.0);
        const Vec3 at(run % 3 == 0 ? 0.0 : between(-5000, 5000), between(-5000, 5000), between(-50, 50));
        SceneBuilder b;
        stairs(b, at, y0, risers, rise, tread);
        const Ground ground(b);
        const GroundAhead up = ground.ahead(at, 0.0);
        ASSERT_TRUE(up.stairs) << run;
        EXPECT_TRUE(up.stairs->up);
        EXPECT_EQ(up.stairs->risers, risers);
        EXPECT_NEAR(up.stairs->distance_m, y0, 0.051);
        EXPECT_NEAR(up.stairs->height_m, risers * rise, 1e-2);
        EXPECT_FALSE(up.drop);
        // From above, the last riser is the first one.
        const double top_m = y0 + risers * tread;
        const GroundAhead down = ground.ahead(at + Vec3(0, top_m, risers * rise), kPi);
        ASSERT_TRUE(down.stairs) << run;
        EXPECT_FALSE(down.stairs->up);
        EXPECT_EQ(down.stairs->risers, risers);
        EXPECT_NEAR(down.stairs->distance_m, tread, 0.051);
        EXPECT_FALSE(down.drop);
    }
}

TEST(Hazards, two_steps_are_not_stairs_and_stairs_behind_a_wall_or_out_of_range_are_not_announced) {
    SceneBuilder two;
    stairs(two, Vec3(0.0), 2.0, 2, 0.17, 0.3);
    EXPECT_FALSE(Ground(two).ahead(Vec3(0.0), 0.0).stairs);
    SceneBuilder far;
    stairs(far, Vec3(0.0), 7.0, 8, 0.17, 0.3);
    EXPECT_FALSE(Ground(far).ahead(Vec3(0.0), 0.0).stairs);
    SceneBuilder hidden;
    stairs(hidden, Vec3(0.0), 4.0, 8, 0.17, 0.3);
    hidden.box({-20, 3, 0}, {20, 3.1, 2.5}, "wall");
    EXPECT_FALSE(Ground(hidden).ahead(Vec3(0.0), 0.0).stairs);
}

TEST(Hazards, a_drop_is_a_gap_into_which_the_body_would_fall_and_not_one_that_it_spans) {
    std::mt19937 random(static_cast<unsigned>(test::seed_of_run()));
    for (int run = 0; run < 200; ++run) {
        const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const double edge = between(0.5, 5.5), gap = between(0.05, 1.5), depth = between(0.05, 3.0);
        SceneBuilder b;
        b.box({-5, -5, -4}, {5, edge, 0}, "floor");
        b.box({-5, edge, -4}, {5, edge + gap, -depth}, "pit");
        b.box({-5, edge + gap, -4}, {5, 12, 0}, "floor behind");
        const Ground ground(b);
        const GroundAhead seen = ground.ahead(Vec3(0.0), 0.0);
        // For comparison, a walker goes to the edge and falls or does not fall.
        Walker walker(*ground.world, ground.rules.body);
        walker.place(Vec3(0.0));
        double lowest = 0.0;
        for (int i = 0; i < 60 * 14; ++i) {
            walker.tick({0.0, 0.5, 0.0}, 1.0 / 60.0);
            lowest = std::min(lowest, walker.state().feet_m.z);
        }
        // If the gap is about as wide as the walker, tiny differences decide whether the walker crosses the gap or
        // falls.
        if (std::abs(gap - 0.5) < 0.12 || std::abs(depth - ground.rules.drop_m) < 0.02) continue;
        const bool falls = lowest < -ground.rules.drop_m;
        EXPECT_EQ(seen.drop.has_value(), falls) << "gap " << gap << ", deep " << depth << ", edge at " << edge;
        if (!seen.drop || !falls) continue;
        EXPECT_NEAR(seen.drop->distance_m, edge, 0.051);
        EXPECT_NEAR(seen.drop->depth_m.value_or(-1.0), depth, 1e-2);
        EXPECT_TRUE(over_drop(*ground.world, {0.0, edge + 0.01, 0.0}, 0.0, ground.rules));
        EXPECT_FALSE(over_drop(*ground.world, {0.0, edge - 0.01, 0.0}, 0.0, ground.rules));
    }
}

TEST(Hazards, games_count_as_drops_only_what_is_deeper_than_two_of_their_steps) {
    for (const double depth : {0.5, 1.0, 1.5}) {
        SceneBuilder b;
        b.box({-5, -5, -4}, {5, 2, 0}, "floor");
        b.box({-5, 2, -4}, {5, 12, -depth}, "below");
        EXPECT_EQ(Ground(b, true).ahead(Vec3(0.0), 0.0).drop.has_value(), depth > 1.2) << depth;
    }
}

TEST(Hazards, missing_ground_is_a_drop_without_a_depth) {
    SceneBuilder b;
    b.box({-5, -5, -4}, {5, 2, 0}, "floor");
    const GroundAhead seen = Ground(b).ahead(Vec3(0.0), 0.0);
    ASSERT_TRUE(seen.drop);
    EXPECT_FALSE(seen.drop->depth_m);
}

TEST(Hazards, slopes_are_measured_as_rise_per_metre_of_path_and_never_count_as_stairs_or_drops) {
    SceneBuilder b;
    b.box({-5, -5, -1}, {5, 0, 0}, "floor");
    b.ramp({-5, 0, 0}, {5, 12, 1}, "ramp");
    const Ground ground(b);
    const Vec3 on(0.0, 6.0, 0.5);
    EXPECT_NEAR(ground_slope(*ground.world, on, 0.0), 1.0 / 12.0, 1e-9);
    EXPECT_NEAR(ground_slope(*ground.world, on, kPi), -1.0 / 12.0, 1e-9);
    EXPECT_NEAR(ground_slope(*ground.world, on, kPi / 2.0), 0.0, 1e-9);
    EXPECT_EQ(ground_slope(*ground.world, {0.0, -2.0, 0.0}, 0.0), 0.0);
    EXPECT_FALSE(ground.ahead({0.0, -1.0, 0.0}, 0.0).stairs);
    EXPECT_FALSE(ground.ahead({0.0, -1.0, 0.0}, 0.0).drop);
}

TEST(Hazards, the_beat_quickens_towards_the_edge) {
    for (double d = 0.1; d <= kDropWarning_m; d += 0.1) EXPECT_GT(drop_beat_s(d), drop_beat_s(d - 0.1));
}

}  // namespace hazards_test
}  // namespace handrail
