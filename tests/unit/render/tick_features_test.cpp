// Tests that the compiler builds the tick with and without optional features. Checks which scenes use which version,
// and that omitting unused features changes no result.
#include "haptic/render/tick_features.h"

#include <cstring>

#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace tick_features_test {

TouchTuning rough() {
    TouchTuning tuning;
    tuning.damping_ns_per_m = 5.0;
    tuning.default_friction_static = 0.35;
    tuning.default_friction_kinetic = 0.3;
    return tuning;
}

bool same_bits(const Vec3& a, const Vec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expect_same_bits(const HapticScene& scene, const TouchTuning& tuning, const std::vector<Vec3>& goals,
                      const std::string& name) {
    TouchState with, without;
    for (std::size_t i = 0; i < goals.size(); ++i) {
        const TouchResult a = touch_tick_with<AllFeatures>(with, scene, tuning, goals[i], 1e-3, Vec3(0.0), {});
        const TouchResult b = touch_tick(without, scene, tuning, goals[i], 1e-3);
        ASSERT_TRUE(same_bits(a.force_n, b.force_n) && same_bits(a.proxy_m, b.proxy_m) &&
                    same_bits(a.slide_m, b.slide_m))
            << name << ", tick " << i;
        ASSERT_EQ(a.contacts.count, b.contacts.count) << name << ", tick " << i;
        ASSERT_EQ(a.liquid, b.liquid) << name << ", tick " << i;
    }
}

TEST(TickFeatures, skipping_absent_features_changes_no_bit) {
    for (const TouchCase& c : hard_cases()) {
        const auto scene = c.world.scene();
        ASSERT_TRUE(scene->plain) << c.name;
        TouchTuning tuning = rough();
        tuning.radius_m = c.radius_m;
        expect_same_bits(*scene, tuning, c.goals_m, c.name);
    }
}

// Damping values at which the guard is active, at its limit, and idle; the last is the default.
TEST(TickFeatures, the_passivity_guard_runs_on_the_plain_path_too_and_changes_no_bit) {
    for (const TouchCase& c : hard_cases()) {
        const auto scene = c.world.scene();
        for (const double damping : {0.0, 2.0, 5.0}) {
            TouchTuning tuning = rough();
            tuning.radius_m = c.radius_m;
            tuning.passivity_guard = true;
            tuning.damping_ns_per_m = damping;
            ASSERT_TRUE(scene->plain) << c.name;
            expect_same_bits(*scene, tuning, c.goals_m, c.name);
        }
    }
}

TEST(TickFeatures, liquids_drag_the_same_wherever_the_hand_comes_from) {
    // One pool is on the floor at x = 0, the other at x = 1. The hand starts far from both pools and passes above the
    // first one. Then it moves into the first pool, along its floor, out again, and into the second pool.
    HapticSceneBuilder builder;
    const auto box = [](const Vec3& low, const Vec3& high) {
        return std::vector<Plane>{{{-1, 0, 0}, -low.x}, {{1, 0, 0}, high.x},  {{0, -1, 0}, -low.y},
                                  {{0, 1, 0}, high.y},  {{0, 0, -1}, -low.z}, {{0, 0, 1}, high.z}};
    };
    builder.add_box({{-2, -2, -1}, {2, 2, 0}});
    for (const double x : {0.0, 1.0}) {
        LiquidVolume pool;
        const Vec3 low(x - 0.2, -0.2, 0), high(x + 0.2, 0.2, 0.1);
        pool.planes = box(low, high);
        pool.hidden.assign(6, false);
        pool.feature = FeatureId{static_cast<std::uint32_t>(7 + x)};
        pool.viscosity_ns_per_m = 4.0 + x;
        builder.add_liquid(pool, {low, high});
    }
    const auto scene = builder.build();
    ASSERT_TRUE(scene->plain);
    const std::vector<Vec3> goals = hand_path({{-1, 0, 0.3},
                                               {0, 0, 0.115},
                                               {0.3, 0, 0.115},
                                               {0.1, 0, -0.003},
                                               {0.1, 0.1, -0.003},
                                               {0.5, 0, 0.2},
                                               {1, 0, 0.05}},
                                              0.3);
    expect_same_bits(*scene, rough(), goals, "two pools");
    TouchState state;
    std::array<int, 2> dragged{};
    for (const Vec3& goal : goals) {
        const TouchResult r = touch_tick(state, *scene, rough(), goal, 1e-3);
        if (r.liquid == FeatureId{7}) dragged[0] += glm::length(r.force_n - r.contact_force_n) > 0.1;
        if (r.liquid == FeatureId{8}) dragged[1] += glm::length(r.force_n - r.contact_force_n) > 0.1;
    }
    EXPECT_GT(dragged[0], 100);
    EXPECT_GT(dragged[1], 100);
}

TEST(TickFeatures, a_scene_with_any_optional_content_uses_the_full_tick) {
    const auto plain_with = [](const auto& add) {
        HapticSceneBuilder builder;
        builder.add_box({{-1, -1, -1}, {1, 1, 0}});
        add(builder);
        return builder.build()->plain;
    };
    LiquidVolume pool;
    pool.planes = {{{-1, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, -1, 0}, 1}, {{0, 1, 0}, 1}, {{0, 0, -1}, 1}, {{0, 0, 1}, 1}};
    pool.hidden.assign(6, false);
    pool.viscosity_ns_per_m = 2.0;
    const Aabb room{Vec3(-1.0), Vec3(1.0)};
    EXPECT_TRUE(plain_with([](HapticSceneBuilder&) {}));
    EXPECT_TRUE(plain_with([](HapticSceneBuilder& b) { b.add_sphere({Vec3(0, 0, 2), 0.5}); }));
    EXPECT_TRUE(plain_with([](HapticSceneBuilder& b) { b.add_triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1}); }));
    EXPECT_TRUE(plain_with([&](HapticSceneBuilder& b) { b.add_liquid(pool, room); })) << "drag is part of every tick";
    LiquidVolume floating = pool, filmed = pool;
    floating.buoyancy_n = 0.5;
    filmed.film_n = 0.3;
    EXPECT_FALSE(plain_with([&](HapticSceneBuilder& b) { b.add_liquid(floating, room); }));
    EXPECT_FALSE(plain_with([&](HapticSceneBuilder& b) { b.add_liquid(filmed, room); }));
    EXPECT_FALSE(plain_with([](HapticSceneBuilder& b) {
        b.add_triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {}, TouchSide::Front);
    }));
    EXPECT_FALSE(plain_with([](HapticSceneBuilder& b) { b.set_reliefs({Relief{}}); }));
    EXPECT_FALSE(plain_with([](HapticSceneBuilder& b) {
        HapticSceneBuilder crate;
        crate.add_box({Vec3(-0.1), Vec3(0.1)});
        ASSERT_TRUE(b.add_body(FeatureId{1}, crate.build(), Placement{}));
    }));
    EXPECT_FALSE(plain_with([&](HapticSceneBuilder& b) {
        EffectVolume wind;
        wind.region = room;
        wind.law = ForceLaw{};
        ASSERT_TRUE(b.add_effect(wind));
    }));
    EXPECT_FALSE(plain_with([](HapticSceneBuilder& b) {
        SoftPatch cushion;
        cushion.size_u_m = cushion.size_v_m = 0.2;
        cushion.depth_m = 0.02;
        ASSERT_TRUE(b.add_soft(cushion));
    }));
}

}  // namespace tick_features_test
}  // namespace handrail::test
