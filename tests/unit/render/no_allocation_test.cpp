// Tests that touch_tick neither allocates nor frees memory. Counts every call of operator new and delete in this
// program.
#include "haptic/render/touch.h"
#include "tests/support/count_allocations.h"
#include "tests/support/names.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace no_allocation_test {

TEST(TouchTick, never_allocates_or_frees) {
    long during = 0;
    for (const TouchCase& c : hard_cases()) {
        const auto scene = c.world.scene();
        TouchState state;
        TouchTuning tuning;
        tuning.radius_m = c.radius_m;
        tuning.damping_ns_per_m = 5.0;
        tuning.passivity_guard = true;
        tuning.default_friction_static = tuning.default_friction_kinetic = 0.3;
        for (const Vec3& goal : c.goals_m) {
            const long before = allocations;
            touch_tick(state, *scene, tuning, goal, 1e-3);
            during += allocations - before;
        }
        const long before = allocations;
        state.reset_filters();
        state.reset();
        touch_tick(state, *scene, tuning, c.goals_m.front(), 1e-3);
        during += allocations - before;
    }
    // The hand moves through a pool and through effects of every kind.
    const Aabb cube{Vec3(-0.05), Vec3(0.05)};
    HapticSceneBuilder builder;
    LiquidVolume liquid;
    for (int side = 0; side < 6; ++side) {
        Vec3 normal(0.0);
        normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
        liquid.planes.push_back({normal, 0.05});
    }
    liquid.hidden.assign(6, false);
    liquid.viscosity_ns_per_m = 4.0;
    liquid.buoyancy_n = liquid.film_n = 0.3;
    builder.add_liquid(liquid, cube);
    for (const EffectLaw& law :
         {EffectLaw(MagnetLaw{{{Vec3(0.0)}}}), EffectLaw(DetentLaw{}), EffectLaw(ButtonLaw{}), EffectLaw(FlyPaperLaw{}),
          EffectLaw(InertiaLaw{}), EffectLaw(ForceLaw{}), EffectLaw(VibrationLaw{})})
        for (int copy = 0; copy < 3; ++copy) {
            EffectVolume effect;
            effect.region = cube;
            effect.law = law;
            ASSERT_TRUE(builder.add_effect(effect));
        }
    const auto scene = builder.build();
    TouchState state;
    for (int i = 0; i < 2000; ++i) {
        const long before = allocations;
        const TouchResult r = touch_tick(state, *scene, TouchTuning{}, Vec3(-0.06 + 6e-5 * i, 0.002, 0.01), 1e-3);
        during += allocations - before;
        ASSERT_TRUE(is_finite(r.force_n));
    }
    EXPECT_EQ(during, 0);
    EXPECT_GT(allocations, 1000) << "the count itself works";
}

}  // namespace no_allocation_test
}  // namespace handrail::test
