// Tests what a single tick of touch guarantees, in worlds that are small enough to calculate by hand.
#include "haptic/render/touch.h"

#include <limits>

#include "haptic/render/proxy_solver.h"
#include "tests/support/names.h"
#include "tests/support/solver_probe.h"
#include "tests/support/sphere_mesh.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace touch_test {

constexpr double kTick_s = 1e-3;
const FeatureId kFloor{7}, kWall{8}, kPool{9};

// Returns a floor z <= 0 and a wall x >= 0.1, both as boxes.
std::shared_ptr<const HapticScene> floor_and_wall(std::vector<HapticMaterial> materials = {}) {
    HapticSceneBuilder builder(std::move(materials));
    builder.add_box({{-1, -1, -1}, {1, 1, 0}}, SurfaceLabel{kFloor, 0, false});
    builder.add_box({{0.1, -1, -1}, {1, 1, 1}}, SurfaceLabel{kWall, 1, false});
    return builder.build();
}

TouchResult hold(TouchState& state, const HapticScene& scene, const TouchTuning& tuning, const Vec3& goal, int ticks) {
    TouchResult result;
    for (int i = 0; i < ticks; ++i) result = touch_tick(state, scene, tuning, goal, kTick_s);
    return result;
}

// Moves the hand straight down onto the floor at 0.1 m/s, to `depth_m`, and then holds the hand there.
TouchResult press_floor(TouchState& state, const HapticScene& scene, const TouchTuning& tuning, double depth_m) {
    TouchResult result;
    for (double z = 0.02; z > -depth_m; z -= 1e-4) result = touch_tick(state, scene, tuning, {0, 0, z}, kTick_s);
    return hold(state, scene, tuning, {0, 0, -depth_m}, 200);
}

TEST(TouchTick, gives_stiffness_times_depth_per_metre_of_hand_movement) {
    const auto scene = floor_and_wall();
    for (const double scale : {1.0, 10.0, 60.0}) {
        TouchTuning tuning;
        tuning.world_m_per_hand_m = scale;
        TouchState state;
        for (double z = 0.03; z > 0.0; z -= 1e-4 * scale) touch_tick(state, *scene, tuning, {0, 0, z}, kTick_s);
        // The proxy's centre rests 5 mm above the floor, measured in the world. The hand is 3 mm of its own travel
        // below that, at 800 N/m.
        const TouchResult r = hold(state, *scene, tuning, {0, 0, 0.005 - 0.003 * scale}, 400);
        EXPECT_NEAR(r.force_n.z, 2.4, 1e-9) << scale;
        EXPECT_EQ(r.force_n.x, 0.0);
        EXPECT_NEAR(r.proxy_m.z, 0.005, 1e-9);
        EXPECT_EQ(r.contacts.count, 1);
        EXPECT_EQ(r.contacts.contacts[r.contacts.strongest].feature, kFloor);
        EXPECT_EQ(r.contacts.contacts[0].normal, Vec3(0, 0, 1));
    }
}

TEST(TouchTick, names_the_surface_with_the_strongest_contact) {
    const auto scene = floor_and_wall();
    TouchState state;
    TouchTuning tuning;
    hold(state, *scene, tuning, {0, 0, 0.02}, 1);
    for (int i = 0; i < 200; ++i) touch_tick(state, *scene, tuning, {5e-4 * i, 0, 0.02 - 1e-4 * i}, kTick_s);
    const TouchResult r = hold(state, *scene, tuning, {0.11, 0, -0.003}, 50);
    ASSERT_EQ(r.contacts.count, 2);
    EXPECT_EQ(r.contacts.contacts[r.contacts.strongest].feature, kWall);
    EXPECT_NEAR(r.contacts.contacts[0].share + r.contacts.contacts[1].share, 1.0, 1e-12);
    EXPECT_NEAR(r.proxy_m.x, 0.095, 1e-9);
    EXPECT_NEAR(r.proxy_m.z, 0.005, 1e-9);
}

TEST(TouchTick, names_a_contact_by_its_visible_faces_first) {
    HapticSceneBuilder builder;
    std::array<SurfaceLabel, 6> labels;
    for (std::uint32_t i = 0; i < 6; ++i) labels[i].feature = FeatureId{i};
    labels[5].hidden = true;
    builder.add_box({{-1, -1, -1}, {1, 1, 0}}, labels);
    const auto scene = builder.build();
    EXPECT_EQ(scene->surface(0, glm::normalize(Vec3(0.1, 0, 1))).feature, FeatureId{1});
    EXPECT_EQ(scene->surface(0, {0, -1, 0}).feature, FeatureId{2});
}

TEST(TouchTick, blends_materials_by_how_hard_they_are_pressed) {
    const auto scene = floor_and_wall({HapticMaterial{0.5, -1, -1}, HapticMaterial{1.0, -1, -1}});
    TouchState state;
    TouchTuning tuning;
    hold(state, *scene, tuning, {0.08, 0, 0.02}, 1);
    // The hand moves into the corner. It stops 2 mm below the proxy's resting place on the floor, and 2 mm beyond that
    // place towards the wall. Floor and wall have equal shares, so K = 750 N/m.
    for (int i = 0; i <= 100; ++i)
        touch_tick(state, *scene, tuning,
                   Vec3(0.08, 0, 0.02) + (Vec3(0.097, 0, 0.003) - Vec3(0.08, 0, 0.02)) * (i / 100.0), kTick_s);
    const TouchResult r = hold(state, *scene, tuning, {0.097, 0, 0.003}, 20);
    ASSERT_EQ(r.contacts.count, 2);
    EXPECT_NEAR(r.force_n.z, 1.5, 1e-6);
    EXPECT_NEAR(r.force_n.x, -1.5, 1e-6);
}

TEST(TouchTick, applies_overrides_before_materials_and_materials_before_defaults) {
    const auto scene = floor_and_wall({HapticMaterial{0.5, -1, -1}});
    TouchState state;
    TouchTuning tuning;
    EXPECT_NEAR(press_floor(state, *scene, tuning, 0.0).force_n.z, 0.005 * 500.0, 1e-9);
    tuning.override_stiffness_n_per_m = 1234.0;
    EXPECT_NEAR(hold(state, *scene, tuning, {0, 0, 0}, 1).force_n.z, 0.005 * 1234.0, 1e-9);
}

// Tests invariant I12 of tests/property/invariants_test.cpp.
TEST(TouchTick, sticks_inside_the_friction_cone_and_slides_on_it) {
    const auto scene = floor_and_wall();
    for (const double mu : {0.2, 0.4, 1.5}) {
        TouchState state;
        TouchTuning tuning;
        tuning.override_friction_static = tuning.override_friction_kinetic = mu;
        press_floor(state, *scene, tuning, 0.0);  // the hand presses 5 mm deep
        // Stick: the hand pulls sideways with less than mu times the pressing force, and trembles, for 10 s. The proxy
        // must not move.
        double drift = 0.0;
        const Vec3 rest = hold(state, *scene, tuning, {0, 0, 0}, 1).proxy_m;
        for (int i = 0; i < 10000; ++i) {
            const Vec3 goal(0.5 * mu * 0.005 + 5e-5 * std::sin(0.06 * i), 5e-5 * std::sin(0.07 * i),
                            5e-5 * std::sin(0.05 * i));
            drift = std::max(drift, glm::length(Vec2(touch_tick(state, *scene, tuning, goal, kTick_s).proxy_m - rest)));
        }
        EXPECT_EQ(drift, 0.0) << mu;
        // Slide: the tangential force must be exactly mu times the normal force.
        for (int i = 0; i < 300; ++i) {
            const TouchResult r = touch_tick(state, *scene, tuning, {-2e-4 * i, 1e-4 * i, 0.0}, kTick_s);
            const double tangential = glm::length(Vec2(r.force_n));
            EXPECT_LE(tangential, mu * r.force_n.z * (1 + 1e-6));
            if (i > 200) {
                EXPECT_NEAR(tangential, mu * r.force_n.z, 1e-6 * r.force_n.z);
            }
            EXPECT_NEAR(r.proxy_m.z, 0.005, 1e-9);
        }
    }
}

TEST(TouchTick, weakens_static_friction_with_the_slid_distance_and_restores_it_at_rest) {
    const auto scene = floor_and_wall();
    TouchState state;
    TouchTuning tuning;
    tuning.override_friction_static = 0.5;
    tuning.override_friction_kinetic = 0.4;
    press_floor(state, *scene, tuning, 0.0);
    double largest = 0.0, largest_drop = 0.0, last = 0.0;
    TouchResult r;
    for (int i = 0; i < 2000; ++i) {
        r = touch_tick(state, *scene, tuning, {1e-5 * i, 0, 0}, kTick_s);
        const double ratio = -r.force_n.x / r.force_n.z;
        largest = std::max(largest, ratio);
        largest_drop = std::max(largest_drop, last - ratio);
        last = ratio;
    }
    EXPECT_NEAR(largest, 0.5, 0.005);
    EXPECT_NEAR(last, 0.4, 0.001);
    EXPECT_LT(largest_drop, 0.02);
    const Vec3 rest = r.proxy_m;
    // After 2 s of rest, static friction is complete again.
    hold(state, *scene, tuning, rest - Vec3(0, 0, 0.005), 2000);
    largest = 0.0;
    for (int i = 0; i < 600; ++i) {
        r = touch_tick(state, *scene, tuning, rest + Vec3(1e-5 * i, 0, -0.005), kTick_s);
        largest = std::max(largest, -r.force_n.x / r.force_n.z);
    }
    EXPECT_NEAR(largest, 0.5, 0.01);
}

TEST(TouchTick, damps_only_along_the_normal_and_never_pulls) {
    const auto scene = floor_and_wall();
    TouchState state;
    TouchTuning tuning;
    tuning.damping_ns_per_m = 5.0;
    press_floor(state, *scene, tuning, 0.0);
    double z = 0.0;
    TouchResult r;
    for (int i = 0; i < 100; ++i) r = touch_tick(state, *scene, tuning, {2e-4 * i, 0, z -= 5e-5}, kTick_s);
    // The hand moves in at 0.05 m/s for 0.1 s, which is much longer than the time constant of the 50 Hz filter. The
    // damping of 5 Ns/m adds to the spring force.
    EXPECT_NEAR(r.force_n.z, 800.0 * (0.005 - z) + 5.0 * 0.05, 1e-6);
    EXPECT_NEAR(r.force_n.x, 0.0, 1e-12);
    for (int i = 0; i < 400; ++i) {
        r = touch_tick(state, *scene, tuning, {0.02, 0, z += 3e-4}, kTick_s);
        EXPECT_GE(r.force_n.z, 0.0);
    }
    EXPECT_EQ(r.force_n, Vec3(0.0));
}

TEST(TouchTick, limits_sliding_speed_but_not_a_fast_hand_in_the_air) {
    const auto scene = floor_and_wall();
    TouchState state;
    TouchTuning tuning;
    hold(state, *scene, tuning, {0, 0, 0.5}, 1);
    for (int i = 1; i <= 40; ++i) {
        const Vec3 goal(0, 0.01 * i, 0.5);  // the hand moves at 10 m/s
        EXPECT_EQ(touch_tick(state, *scene, tuning, goal, kTick_s).proxy_m, goal);
    }
}

TEST(TouchTick, ignores_all_solids_around_the_start_until_the_hand_has_left_them) {
    HapticSceneBuilder builder;
    builder.add_box({{-1, -1, -1}, {1, 1, 0}}, SurfaceLabel{kFloor});
    builder.add_box({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.3}}, SurfaceLabel{kWall});
    const auto scene = builder.build();
    TouchState state;
    TouchTuning tuning;
    TouchResult r = hold(state, *scene, tuning, {0, 0, -0.1}, 10);  // the hand starts inside both solids
    EXPECT_TRUE(r.contacts.ghosted);
    EXPECT_EQ(r.force_n, Vec3(0.0));
    for (double z = -0.1; z < 0.3048; z += 5e-4) {
        r = touch_tick(state, *scene, tuning, {0, 0, z}, kTick_s);
        EXPECT_EQ(r.force_n, Vec3(0.0));
        EXPECT_EQ(r.proxy_m, Vec3(0, 0, z));
        EXPECT_TRUE(r.contacts.ghosted);
    }
    for (double z = 0.3052; z < 0.32; z += 5e-4) r = touch_tick(state, *scene, tuning, {0, 0, z}, kTick_s);
    EXPECT_FALSE(r.contacts.ghosted);
    for (double z = 0.32; z > 0.29; z -= 5e-4) r = touch_tick(state, *scene, tuning, {0, 0, z}, kTick_s);
    EXPECT_GT(r.force_n.z, 0.0);
    EXPECT_EQ(r.contacts.contacts[0].feature, kWall);
}

// Formerly, if the hand had started inside a solid, the solid let it in again while the hand was out by less than 1 mm.
TEST(TouchTick, never_reenters_a_solid_that_the_whole_proxy_has_left) {
    HapticSceneBuilder builder;
    builder.add_box({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.3}}, SurfaceLabel{kWall});
    const auto scene = builder.build();
    TouchState state;
    TouchTuning tuning;
    TouchResult r = hold(state, *scene, tuning, {0, 0, 0.29}, 10);
    EXPECT_TRUE(r.contacts.ghosted);
    const double out = 0.3 + tuning.radius_m + 2e-4;
    for (double z = 0.29; z < out; z += 5e-5) r = touch_tick(state, *scene, tuning, {0, 0, z}, kTick_s);
    EXPECT_EQ(r.force_n, Vec3(0.0));
    double before_n = 0.0;
    for (double z = out; z > 0.2; z -= 5e-5) {
        r = touch_tick(state, *scene, tuning, {0, 0, z}, kTick_s);
        ASSERT_GE(r.proxy_m.z, 0.3 + tuning.radius_m - 1e-9) << z;
        ASSERT_LE(r.force_n.z - before_n, 0.0401) << z;  // 50 um at 0.8 kN/m, so the contact must begin without a step
        before_n = r.force_n.z;
    }
    EXPECT_EQ(r.contacts.contacts[0].feature, kWall);
}

// A ramp lifts the proxy out of the solid, while the hand always stays below the solid's top.
TEST(TouchTick, never_reenters_a_solid_that_the_proxy_but_not_the_hand_has_left) {
    HapticSceneBuilder builder;
    builder.add_box({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.3}}, SurfaceLabel{kFloor});
    const std::vector<Vec3> ramp{{-0.1, -0.5, 0.39}, {0.1, -0.5, 0.19}, {0.1, 0.5, 0.19}, {-0.1, 0.5, 0.39}};
    builder.add_polygon(ramp, SurfaceLabel{kWall});
    const auto scene = builder.build();
    TouchState state;
    TouchTuning tuning;
    TouchResult r = hold(state, *scene, tuning, {0.03, 0, 0.297}, 10);
    EXPECT_TRUE(r.contacts.ghosted);
    Vec3 before_n = r.force_n;
    bool out = false;
    for (int i = 0; i < 1200; ++i) {
        const double x = 0.03 - 1e-4 * (i < 600 ? i : 1200 - i);
        r = touch_tick(state, *scene, tuning, {x, 0, 0.297}, kTick_s);
        // The tolerance is a movement of 0.1 mm at 0.8 kN/m, in a wedge of 45 degrees.
        ASSERT_LE(glm::length(r.force_n - before_n), 0.17) << i;
        before_n = r.force_n;
        out = out || r.proxy_m.z > 0.3 + tuning.radius_m;
        if (out) {
            ASSERT_GE(r.proxy_m.z, 0.3 + tuning.radius_m - 1e-9) << i;
        }
    }
    EXPECT_TRUE(out);
    EXPECT_FALSE(r.contacts.ghosted);
    EXPECT_EQ(r.contacts.contacts[0].feature, kFloor);
}

// Tests case T20 of tests/property/bodies_test.cpp.
TEST(TouchTick, starts_with_a_small_proxy_in_a_tight_place_and_grows_it_smoothly) {
    const auto scene = floor_and_wall();
    TouchState state;
    TouchTuning tuning;
    tuning.override_stiffness_n_per_m = 1000.0;
    TouchResult r = touch_tick(state, *scene, tuning, {0, 0, 0.002}, kTick_s);
    EXPECT_NEAR(r.radius_m, 0.002, 3e-5);
    double last = r.force_n.z;
    for (int i = 0; i < 400; ++i) {
        r = touch_tick(state, *scene, tuning, {0, 0, 0.002}, kTick_s);
        EXPECT_LE(std::abs(r.force_n.z - last), 0.0201);  // the proxy may move at 20 mm/s, at 1 kN/m
        EXPECT_GE(r.proxy_m.z, r.radius_m - 1e-9);
        last = r.force_n.z;
    }
    EXPECT_EQ(r.radius_m, 0.005);
    EXPECT_NEAR(r.force_n.z, 3.0, 1e-9);
}

TEST(TouchTick, treats_a_radius_of_zero_as_a_hundredth_of_a_millimetre) {
    const auto scene = floor_and_wall();
    TouchState state;
    TouchTuning tuning;
    tuning.radius_m = 0.0;
    const TouchResult r = press_floor(state, *scene, tuning, 0.002);
    EXPECT_NEAR(r.proxy_m.z, 1e-5, 1e-12);
}

TEST(TouchTick, keeps_the_old_proxy_when_a_new_scene_arrives) {
    const auto scene = floor_and_wall();
    HapticSceneBuilder builder;
    builder.add_box({{-1, -1, -1}, {1, 1, 0.004}});  // in the new scene the floor is 4 mm higher
    const auto risen = builder.build();
    TouchState state;
    TouchTuning tuning;
    press_floor(state, *scene, tuning, 0.0);
    TouchResult r = touch_tick(state, *risen, tuning, {0, 0, 0}, kTick_s);
    EXPECT_LT(r.radius_m, 0.0011);
    EXPECT_GE(r.proxy_m.z, 0.005 - 1e-9);
    r = hold(state, *risen, tuning, {0, 0, 0}, 400);
    EXPECT_NEAR(r.proxy_m.z, 0.009, 1e-9);
}

TEST(TouchTick, keeps_its_contact_if_only_filters_are_reset) {
    const auto scene = floor_and_wall();
    TouchState state;
    TouchTuning tuning;
    const TouchResult before = press_floor(state, *scene, tuning, 0.003);
    state.reset_filters();
    const TouchResult after = touch_tick(state, *scene, tuning, {0, 0, -0.003}, kTick_s);
    EXPECT_EQ(after.proxy_m, before.proxy_m);
    EXPECT_EQ(after.force_n, before.force_n);
    state.reset();
    EXPECT_EQ(touch_tick(state, *scene, tuning, {0, 0, -0.003}, kTick_s).force_n, Vec3(0.0));
}

// Returns a pool from z = -1 to 0. The pool consists of two halves that share the face x = 0.
std::shared_ptr<const HapticScene> pool(double viscosity) {
    HapticSceneBuilder builder;
    for (const double side : {-1.0, 0.0}) {
        const Aabb box{{side, -1, -1}, {side + 1, 1, 0}};
        LiquidVolume liquid;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 n(0.0);
            n[axis] = 1.0;
            liquid.planes.push_back({n, box.max_m[axis]});
            liquid.planes.push_back({-n, -box.min_m[axis]});
        }
        liquid.hidden.assign(6, false);
        liquid.feature = FeatureId{kPool.value + (side < 0.0 ? 0U : 1U)};
        liquid.viscosity_ns_per_m = viscosity;
        builder.add_liquid(liquid, box);
    }
    return builder.build();
}

TEST(TouchTick, drags_in_a_liquid_as_viscosity_times_hand_speed_and_up_to_four_newtons) {
    for (const double viscosity : {2.0, 8.0}) {
        const auto scene = pool(viscosity);
        TouchState state;
        TouchTuning tuning;
        TouchResult r;
        for (int i = 0; i < 1500; ++i) {
            r = touch_tick(state, *scene, tuning, {-0.3 + 2e-4 * i, 0, -0.5},
                           kTick_s);  // the hand moves at 0.2 m/s and ends on the shared face
            if (i > 300) {
                EXPECT_NEAR(r.force_n.x, -viscosity * 0.2, 1e-3 * viscosity) << i;
            }
        }
        EXPECT_EQ(r.contacts.count, 0);
        EXPECT_EQ(r.contact_force_n, Vec3(0.0));
        for (int i = 0; i < 100; ++i)
            r = touch_tick(state, *scene, tuning, {0.5 + 5e-3 * (i % 2), 0, -0.5 + 5e-3 * i}, kTick_s);
        EXPECT_LE(glm::length(r.force_n), 4.0 + 1e-9);
        hold(state, *scene, tuning, {0.5, 0, -0.5}, 300);
        EXPECT_LT(glm::length(hold(state, *scene, tuning, {0.5, 0, -0.5}, 1).force_n), 1e-3);
        EXPECT_EQ(hold(state, *scene, tuning, {0.5, 0, 0.5}, 3).force_n, Vec3(0.0));
        EXPECT_EQ(hold(state, *scene, tuning, {0.5, 0, 0.5}, 1).liquid, kNoFeature);
        EXPECT_EQ(hold(state, *scene, tuning, {0.5, 0, -0.5}, 1).liquid, FeatureId{kPool.value + 1});
        EXPECT_EQ(hold(state, *scene, tuning, {0.0, 0, -0.5}, 1).liquid, FeatureId{kPool.value + 1})
            << "the last one listed";
    }
}

TEST(TouchTick, gives_no_force_in_a_liquid_without_viscosity) {
    const auto scene = pool(0.0);
    TouchState state;
    TouchTuning tuning;
    TouchResult r;
    for (int i = 0; i < 200; ++i) r = touch_tick(state, *scene, tuning, {1e-3 * i, 0, -0.5}, kTick_s);
    EXPECT_EQ(r.force_n, Vec3(0.0));
    EXPECT_EQ(r.liquid, FeatureId{kPool.value + 1});
}

TEST(TouchTick, never_gives_energy_in_a_liquid) {
    const auto scene = pool(6.0);
    TouchState state;
    TouchTuning tuning;
    double energy = 0.0;
    Vec3 last_goal(0.0), last_force(0.0);
    for (int i = 0; i <= 4000; ++i) {  // the hand follows a closed loop across the pool's surface
        const double t = 2 * kPi * i / 2000.0;
        const Vec3 goal(0.1 * std::sin(t), 0.05 * std::sin(2 * t), -0.03 + 0.05 * std::cos(3 * t));
        const TouchResult r = touch_tick(state, *scene, tuning, goal, kTick_s);
        if (i > 0) energy += glm::dot((r.force_n + last_force) * 0.5, goal - last_goal);
        last_goal = goal;
        last_force = r.force_n;
    }
    EXPECT_LT(energy, 0.0);
}

TEST(TouchTick, keeps_the_nearest_if_there_are_too_many_candidates) {
    // 3000 sheets are at nearly the same place. The proxy must pass through none of them, and the result must report
    // that there were too many.
    HapticSceneBuilder builder;
    for (int i = 0; i < 3000; ++i) builder.add_triangle({-1, -1, -1e-7 * i}, {1, -1, -1e-7 * i}, {0, 2, -1e-7 * i});
    const auto scene = builder.build();
    TouchState state;
    TouchTuning tuning;
    bool truncated = false;
    for (double z = 0.02; z > -0.02; z -= 1e-4) {
        const TouchResult r = touch_tick(state, *scene, tuning, {0, 0, z}, kTick_s);
        truncated = truncated || r.contacts.truncated;
        ASSERT_GE(r.proxy_m.z, 0.005 - 1e-9);
    }
    EXPECT_TRUE(truncated);
    for (double z = -0.02; z < 0.03; z += 1e-4) touch_tick(state, *scene, tuning, {0, 0, z}, kTick_s);
    EXPECT_EQ(touch_tick(state, *scene, tuning, {0, 0, 0.03}, kTick_s).force_n, Vec3(0.0))
        << "and the hand is free again above them";
}

TEST(TouchTick, survives_every_finite_input) {  // tests invariant I1 of tests/property/invariants_test.cpp
    const auto scene = floor_and_wall();
    TouchState state;
    TouchTuning tuning;
    tuning.damping_ns_per_m = 5.0;
    tuning.passivity_guard = true;
    for (const double x : {0.0, 1e-310, -0.0, 1e6, -1e6, 0.05, 1e-9, std::numeric_limits<double>::denorm_min()})
        for (const double z : {0.01, -0.01, 1e6, -1e6, 0.0})
            for (const double dt : {1e-3, 1e-9, 10.0}) {
                const TouchResult r = touch_tick(state, *scene, tuning, {x, 0, z}, dt);
                EXPECT_TRUE(is_finite(r.proxy_m) && is_finite(r.force_n)) << x << ' ' << z << ' ' << dt;
            }
}

TEST(TouchTick, examines_a_limited_number_of_triangles_at_a_start_among_thousands) {
    // A spherical room of 20,480 triangles, which is smaller than the proxy. All triangles are equally far from the
    // room's centre.
    HapticSceneBuilder builder;
    builder.add_mesh(sphere_mesh(32, 0.004));
    const auto scene = builder.build();
    TouchState state;
    TouchTuning tuning;
    for (int i = 0; i < 200; ++i) {
        const TouchResult r = touch_tick(state, *scene, tuning, Vec3(0.0), kTick_s);
        ASSERT_LE(SolverProbe(state.solver()).looks(), 4 * ProxySolver::kMostLooks) << "tick " << i;
        ASSERT_LE(glm::length(r.proxy_m) + r.radius_m, 0.004 + 1e-9) << "nothing of the ball is outside, tick " << i;
        ASSERT_GT(r.radius_m, 0.0);
    }
}

TEST(TouchTick, feels_nothing_in_an_empty_scene) {
    const auto scene = HapticSceneBuilder().build();
    TouchState state;
    EXPECT_EQ(touch_tick(state, *scene, TouchTuning{}, {1, 2, 3}, kTick_s).force_n, Vec3(0.0));
    EXPECT_EQ(touch_tick(state, *scene, TouchTuning{}, {1, 2, 3.5}, kTick_s).proxy_m, Vec3(1, 2, 3.5));
}

}  // namespace touch_test
}  // namespace handrail::test
