#include "app/core/world/walker.h"

#include <random>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"

namespace handrail {
namespace walker_test {

using test::SceneBuilder;

struct Walked {
    double way_m = 0.0;
    int bumps = 0;
    FeatureId last_bump = kNoFeature;
};

Walked walk(Walker& walker, const Vec3& velocity, double seconds, double hz = 60.0) {
    Walked total;
    for (int i = 0; i < static_cast<int>(std::lround(seconds * hz)); ++i) {
        const WalkResult r = walker.tick(velocity, 1.0 / hz);
        total.way_m += r.walked_m;
        if (r.bump) {
            ++total.bumps;
            total.last_bump = r.bump->feature;
        }
    }
    return total;
}

TEST(Walker, stops_at_its_radius_from_a_wall_and_names_it) {
    SceneBuilder room;
    room.box({-5, -5, -0.2}, {5, 5, 0}, "floor");
    const FeatureId wall = room.box({-5, 4, 0}, {5, 4.2, 2.6}, "north wall");
    const auto scene = room.share();
    const WalkerWorld world(scene);
    Walker walker(world, walker_size(*scene, 0.25));
    walker.place({0, 0, 0});
    const Walked w = walk(walker, {0, 1, 0}, 6.0);
    EXPECT_NEAR(walker.state().feet_m.y, 3.75, 1e-3);
    EXPECT_NEAR(walker.state().feet_m.z, 0.0, 1e-3);
    EXPECT_GT(w.bumps, 0);
    EXPECT_EQ(w.last_bump, wall);
}

TEST(Walker, slides_along_a_wall_met_at_a_slant) {
    SceneBuilder room;
    room.box({-50, -5, -0.2}, {50, 5, 0});
    room.box({-50, 2, 0}, {50, 2.2, 2.6});
    const auto scene = room.share();
    const WalkerWorld world(scene);
    Walker walker(world, walker_size(*scene, 0.25));
    walker.place({0, 0, 0});
    walk(walker, {0.8, 0.6, 0}, 10.0);
    EXPECT_NEAR(walker.state().feet_m.y, 1.75, 1e-3);
    EXPECT_NEAR(walker.state().feet_m.x, 8.0, 0.05);
}

TEST(Walker, climbs_twelve_stairs_of_17_cm_and_walks_down_again) {
    SceneBuilder hall;
    hall.box({-2, -10, -0.2}, {2, 10, 0});
    for (int i = 0; i < 12; ++i) hall.box({-1, 1 + 0.28 * i, 0}, {1, 8, 0.17 * (i + 1)});
    const auto scene = hall.share();
    const WalkerWorld world(scene);
    Walker walker(world, walker_size(*scene, 0.25));
    walker.place({0, 0, 0});
    walk(walker, {0, 1, 0}, 6.0);
    EXPECT_NEAR(walker.state().feet_m.z, 12 * 0.17, 1e-3);
    walk(walker, {0, -1, 0}, 7.0);
    EXPECT_NEAR(walker.state().feet_m.z, 0.0, 1e-3);
    EXPECT_TRUE(walker.state().on_ground);
}

TEST(Walker, climbs_a_half_metre_step_in_a_game_map_but_not_in_a_building) {
    for (const bool game : {true, false}) {
        SceneBuilder world_of;
        world_of.box({-4, -4, -0.2}, {4, 12, 0});
        world_of.box({-4, 2, 0}, {4, 12, 0.5});
        world_of.scene().game_map = game;
        const auto scene = world_of.share();
        const WalkerWorld world(scene);
        Walker walker(world, walker_size(*scene, 0.25));
        walker.place({0, 0, 0});
        walk(walker, {0, 1, 0}, 4.0);
        EXPECT_NEAR(walker.state().feet_m.z, game ? 0.5 : 0.0, 1e-3);
        if (!game) {
            EXPECT_NEAR(walker.state().feet_m.y, 1.75, 1e-3);
        }
    }
}

TEST(Walker, walks_up_a_ramp_and_falls_off_an_edge_at_earth_gravity) {
    SceneBuilder hill;
    hill.box({-2, -4, -0.2}, {2, 0, 0});
    hill.ramp({-2, 0, 0}, {2, 12, 1.0});
    hill.box({-2, 12, 0}, {2, 14, 1.0});
    hill.box({-2, 14, -3.2}, {2, 30, -3.0});
    const auto scene = hill.share();
    const WalkerWorld world(scene);
    Walker walker(world, walker_size(*scene, 0.25));
    walker.place({0, -1, 0});
    walk(walker, {0, 1, 0}, 14.0);
    EXPECT_NEAR(walker.state().feet_m.z, 1.0, 1e-3);
    bool landed = false;
    double fell = 0.0, time = 0.0, air = 0.0;
    for (; time < 4.0 && !landed; time += 1.0 / 60.0) {
        const WalkResult r = walker.tick({0, 1, 0}, 1.0 / 60.0);
        if (!walker.state().on_ground) air += 1.0 / 60.0;
        landed = r.landed;
        fell = r.fell_m;
    }
    EXPECT_TRUE(landed);
    EXPECT_NEAR(fell, 4.0, 1e-2);
    EXPECT_NEAR(air, std::sqrt(2 * 4.0 / 9.81), 0.05);
}

TEST(Walker, passes_a_door_of_90_cm_but_not_one_of_40_cm) {
    for (const double width : {0.9, 0.4}) {
        SceneBuilder rooms;
        rooms.box({-5, -5, -0.2}, {5, 5, 0});
        rooms.box({-5, 1, 0}, {-width / 2, 1.2, 2.6});
        rooms.box({width / 2, 1, 0}, {5, 1.2, 2.6});
        rooms.box({-width / 2, 1, 2.0}, {width / 2, 1.2, 2.6});
        const auto scene = rooms.share();
        const WalkerWorld world(scene);
        Walker walker(world, walker_size(*scene, 0.25));
        walker.place({0, 0, 0});
        walk(walker, {0, 1, 0}, 3.0);
        EXPECT_NEAR(walker.state().feet_m.y, width > 0.5 ? 3.0 : 0.75, 2e-3);
    }
}

// Under the lintel, a full step up would push the head into it.
TEST(Walker, steps_over_a_threshold_of_2_cm_under_a_lintel_that_leaves_it_3_cm) {
    SceneBuilder rooms;
    rooms.box({-5, -5, -0.22}, {5, 1, -0.02}, "outside");
    rooms.box({-5, 1, -0.2}, {5, 5, 0}, "inside");
    rooms.box({-5, 1, 0}, {-0.5, 1.3, 2.6});
    rooms.box({0.5, 1, 0}, {5, 1.3, 2.6});
    rooms.box({-0.5, 1, 1.83}, {0.5, 1.3, 2.6}, "lintel");
    const auto scene = rooms.share();
    const WalkerWorld world(scene);
    Walker walker(world, walker_size(*scene, 0.25));
    walker.place({0, 0, -0.02});
    walk(walker, {0, 1, 0}, 3.0);
    EXPECT_NEAR(walker.state().feet_m.y, 3.0, 2e-3);
    EXPECT_NEAR(walker.state().feet_m.z, 0.0, 1e-3);
}

// In the past, nothing carried a walker between walls that it overlapped, and it fell through its floor.
TEST(Walker, stands_on_the_floor_even_if_it_is_too_wide_for_its_place) {
    SceneBuilder passage;
    passage.box({-5, -5, -0.2}, {5, 5, 0});
    passage.box({-1, 0.5, 0}, {1, 0.7, 2.6});
    passage.box({-1, -0.7, 0}, {1, -0.5, 2.6});
    const auto scene = passage.share();
    const WalkerWorld world(scene);
    for (const double z : {0.0, -0.1}) {
        Walker walker(world, walker_size(*scene, 0.6));
        walker.place({0, 0, z});
        EXPECT_TRUE(walker.state().on_ground) << z;
        walk(walker, {0, 0, 0}, 2.0);
        EXPECT_NEAR(walker.state().feet_m.z, 0.0, 1e-3) << z;
        walk(walker, {1, 0, 0}, 3.0);
        EXPECT_NEAR(walker.state().feet_m.x, 3.0, 0.01) << z;
        EXPECT_FALSE(world.blocked(walker.state().feet_m, walker.shape())) << z;
    }
}

// In the past, solids that a walker overlapped were ignored, so that it walked through the whole wall.
TEST(Walker, walks_out_of_an_overlapping_solid_and_never_deeper_into_it) {
    SceneBuilder passage;
    passage.box({-5, -5, -0.2}, {5, 5, 0});
    const FeatureId wall = passage.box({-3, 0.5, 0}, {3, 0.7, 2.6}, "wall");
    const auto scene = passage.share();
    const WalkerWorld world(scene);
    Walker walker(world, walker_size(*scene, 0.6));
    const double gap = 1e-5;
    for (const double angle : {0.0, 0.5, 1.0, 1.5, -0.5, -1.0, -1.5}) {
        walker.place({0, 0, 0});
        const Walked in = walk(walker, forward_of_heading(angle), 1.0);
        EXPECT_LE(walker.state().feet_m.y, gap) << angle;
        EXPECT_EQ(in.last_bump, std::abs(angle) < 1.2 ? wall : kNoFeature) << angle;
    }
    walker.place({0, 0, 0});
    walk(walker, {0, -1, 0}, 1.0);
    EXPECT_NEAR(walker.state().feet_m.y, -1.0, 1e-3);
    EXPECT_FALSE(world.blocked(walker.state().feet_m, walker.shape()));
    walk(walker, {0, 1, 0}, 3.0);
    EXPECT_NEAR(walker.state().feet_m.y, -0.1, 1e-3);
}

// A crate that comes down at a slant and touches a walker neither lifts nor moves it.
TEST(Walker, stays_in_place_when_something_comes_to_overlap_it) {
    SceneBuilder room;
    room.box({-5, -5, -0.2}, {5, 5, 0});
    room.ramp({0.15, -0.5, 0.3}, {1.5, 0.5, 1.5});
    const auto scene = room.share();
    const WalkerWorld world(scene);
    Walker walker(world, walker_size(*scene, 0.25));
    WalkerMotion stood;
    stood.feet_m = {0, 0, 1e-4};
    stood.on_ground = true;
    walker.resume(stood);
    EXPECT_TRUE(world.blocked(walker.state().feet_m, walker.shape()));
    walk(walker, {0, 0, 0}, 1.0);
    EXPECT_LT(glm::length(walker.state().feet_m - stood.feet_m), 1e-9);
    EXPECT_TRUE(walker.state().on_ground);
    walk(walker, {1, 0, 0}, 1.0);
    EXPECT_LE(walker.state().feet_m.x, 1e-5);
    walk(walker, {-1, 0, 0}, 1.0);
    EXPECT_FALSE(world.blocked(walker.state().feet_m, walker.shape()));
}

// A walker is not trapped in a solid that was placed around it.
TEST(Walker, walks_out_of_a_solid_around_its_centre_in_either_direction) {
    SceneBuilder room;
    room.box({-5, -5, -0.2}, {5, 5, 0});
    room.box({-3, -0.1, 0.001}, {3, 0.1, 2.6});
    const auto scene = room.share();
    const WalkerWorld world(scene);
    for (const double sign : {1.0, -1.0}) {
        Walker walker(world, walker_size(*scene, 0.25));
        walker.place({0, 0.02, 0});
        walk(walker, {0, sign, 0}, 2.0);
        EXPECT_FALSE(world.blocked(walker.state().feet_m, walker.shape())) << sign;
        EXPECT_GT(walker.state().feet_m.y * sign, 0.3) << sign;
    }
}

// The walker is never inside a solid, whatever the person wants and at any frame rate.
TEST(Walker, never_ends_inside_a_solid_in_random_clutter) {
    std::mt19937 random(20);
    std::uniform_real_distribution<double> place(-6, 6), size(0.1, 2.0), angle(0, 2 * kPi);
    for (int round = 0; round < 10; ++round) {
        SceneBuilder clutter;
        clutter.box({-10, -10, -0.5}, {10, 10, 0});
        for (int i = 0; i < 30; ++i) {
            const Vec3 a{place(random), place(random), 0.0};
            if (std::abs(a.x) < 2.5 && std::abs(a.y) < 2.5) continue;
            clutter.box(a, a + Vec3(size(random), size(random), size(random)));
        }
        const auto scene = clutter.share();
        const WalkerWorld world(scene);
        const WalkerWorld& w = world;
        Walker walker(w, walker_size(*scene, 0.25));
        walker.place({0, 0, 0});
        ASSERT_FALSE(world.blocked(walker.state().feet_m, walker.shape()));
        double heading = 0.0;
        for (int i = 0; i < 2000; ++i) {
            if (i % 40 == 0) heading = angle(random);
            walker.tick(forward_of_heading(heading) * 1.4, i % 3 == 0 ? 0.1 : 1.0 / 120.0);
            ASSERT_FALSE(world.blocked(walker.state().feet_m, walker.shape())) << "round " << round << " tick " << i;
        }
    }
}

TEST(WalkerWorld, trace_agrees_with_small_steps_for_random_rays) {
    SceneBuilder some;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-3, 3), size(0.2, 1.5);
    for (int i = 0; i < 15; ++i) {
        const Vec3 a{place(random), place(random), place(random)};
        some.box(a, a + Vec3(size(random), size(random), size(random)));
    }
    some.ramp({-1, -1, 3}, {1, 1, 4});
    const auto scene = some.share();
    const WalkerWorld world(scene);
    for (int i = 0; i < 300; ++i) {
        const Vec3 from{place(random) * 2, place(random) * 2, place(random) * 2},
            to{place(random) * 2, place(random) * 2, place(random) * 2};
        const WalkerShape body{i % 2 ? 0.25 : 0.0, i % 2 ? 0.5 : 0.0};
        if (world.blocked(from, body)) continue;
        const TraceHit hit = world.trace(from, to, body);
        // Brute force: tests a thousand and one places along the path. The exact answer must be within one spacing of
        // the first blocked place.
        double first = 1.0;
        const int parts = 1000;
        for (int k = 0; k <= parts; ++k)
            if (world.blocked(from + (to - from) * (k / static_cast<double>(parts)), body)) {
                first = k / static_cast<double>(parts);
                break;
            }
        EXPECT_LE(hit.fraction, first + 1e-9) << i;
        if (first < 1.0) {
            EXPECT_NEAR(hit.fraction, first, 1.5 / parts + 5e-4) << i;
        }
    }
}

}  // namespace walker_test
}  // namespace handrail
