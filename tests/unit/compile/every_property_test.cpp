// Reads the map that has every property that a world can have. The reader must read each property without a warning,
// and the hand must feel each property.
#include <optional>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/tick_math.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace every_property_test {

class EveryProperty : public testing::Test {
protected:
    static void SetUpTestSuite() {
        ReadOptions options;
        options.guess_materials = false;
        Result<Scene> read = read_world(test::project_root() / "tests/scenarios/worlds/every_property.map", options);
        ASSERT_TRUE(read.has_value()) << read.error().sentence();
        scene = std::make_unique<Scene>(std::move(*read));
        haptic = compile_haptic(*scene, MaterialSource::KeysOnly);
    }
    static void TearDownTestSuite() {
        haptic.reset();
        scene.reset();
    }

    // Computes the force on a hand that rests at `at_m` for `rest_ticks` and then moves by `step_m` in each of
    // `move_ticks`. Computes it as the `touch` command does, at scale 1. Returns the force in newtons.
    static Vec3 felt(const Vec3& at_m, int rest_ticks = 1, const Vec3& step_m = Vec3(0.0), int move_ticks = 0) {
        TouchState state;
        TouchResult r;
        for (int i = 0; i < rest_ticks; ++i) r = touch_tick(state, *haptic, TouchTuning{}, at_m, 1e-3);
        for (int i = 1; i <= move_ticks; ++i)
            r = touch_tick(state, *haptic, TouchTuning{}, at_m + step_m * double(i), 1e-3);
        return r.force_n;
    }

    static inline std::unique_ptr<Scene> scene;
    static inline std::shared_ptr<const HapticScene> haptic;
};

TEST_F(EveryProperty, is_read_without_a_warning) {
    for (const Diagnostic& warning : scene->report.warnings) ADD_FAILURE() << warning.sentence();
    EXPECT_EQ(haptic->effects.size(), scene->effects.size()) << "none was refused when the scene was built";
}

TEST_F(EveryProperty, liquids_drag_lift_hold_and_flow) {
    const Vec3 step(2e-4, 0, 0);  // 0.2 m/s at 1,000 ticks a second
    EXPECT_NEAR(felt({3, 3, -0.6}, 1, step, 400).x, -4.0 * 0.2, 1e-6);
    EXPECT_NEAR(felt({7.5, 3.5, -0.6}, 200).z, 0.6, 1e-9);
    EXPECT_EQ(felt({7.5, 3.5, -0.6}, 200, step, 100).x, 0.0) << "no viscosity, no drag";
    EXPECT_NEAR(felt({7.5, 3.5, 0.0}, 200).z, 0.3, 1e-9)
        << "half of the buoyancy at the surface, where the film is at rest";
    const double off = 0.004 / std::sqrt(2.0),
                 lift = 0.6 * (smooth_step(0.5 + off / 0.02) - smooth_step(0.5 - off / 0.02));
    EXPECT_NEAR(felt({7.5, 3.5, -off}, 200).z - felt({7.5, 3.5, off}, 200).z, 2.0 * 0.3 + lift, 1e-6)
        << "and draws back from both sides";
    EXPECT_NEAR(felt({11.5, 3.5, -0.6}, 400).x, 0.8, 1e-6)
        << "eight newton seconds per metre, a tenth of a metre per second";
}

TEST_F(EveryProperty, each_effect_is_felt_as_its_keys_say) {
    EXPECT_NEAR(felt({2.02, 9, 3}).x, -1.5, 1e-6) << "magnet, strongest at its width";
    EXPECT_NEAR(felt({5.3, 9, 3.01}).z, 1.0, 1e-6) << "pushes away from the line";
    EXPECT_EQ(felt({5.3, 9, 3}), Vec3(0.0)) << "on it";
    EXPECT_NEAR(felt({8.3, 9.4, 3.01}).z, -2.0, 1e-6) << "draws to the middle plane";
    EXPECT_NEAR(felt({11.005, 9, 3}).x, -1.0, 1e-6) << "a quarter of the way to the next notch";
    EXPECT_NEAR(felt({11.02, 9, 3}).x, 0.0, 1e-9) << "in it";
    EXPECT_NEAR(felt({14, 9, 3.0 + 0.01 / std::sqrt(3.0)}).z, 1.0, 1e-6) << "snaps on";
    EXPECT_NEAR(felt({17, 9, 3}, 2, {1e-4, 0, 0}, 49).x, -400.0 * 0.0049, 1e-9) << "sticks";
    EXPECT_LT(glm::length(felt({17, 9, 3}, 2, {1e-4, 0, 0}, 60)), 2.0) << "and tears";
    EXPECT_LT(felt({20, 9, 3}, 2, {1e-4, 0, 0}, 10).x, -0.01) << "a mass does not want to go";
    EXPECT_NEAR(felt({23, 9, 3}, 200).y, 1.5, 1e-9) << "wind";
    EXPECT_NEAR(felt({23, 9, 3.985}, 200).y, 0.75, 1e-9) << "half of it halfway through the edge of 30 mm";
    EXPECT_NEAR(felt({26, 9, 3}, 25).x, 0.4, 1e-6) << "a quarter of a wave after 5 ms of each 20";
    EXPECT_LT(felt({31.015, 9, 2}).x, -0.5) << "draws to the pillar's side";
    EXPECT_NEAR(felt({35, 9, 3}, 200).z, 0.5, 1e-9) << "a ball of wind, up by default";
    EXPECT_EQ(felt({35, 9, 4.001}, 200), Vec3(0.0)) << "as large as its radius";
    EXPECT_NEAR(felt({37, 10.5, 3}, 200).z, -0.5, 1e-9) << "a capsule of wind";
    EXPECT_EQ(felt({37, 12.5, 3}, 200), Vec3(0.0));
    EXPECT_EQ(felt({20, 5, 3}, 200), Vec3(0.0)) << "nothing elsewhere";
}

TEST_F(EveryProperty, soft_sides_yield_as_their_keys_say) {
    // Tests a cushion with its top at 1 m, which is soft down to 0.4 m. Its stiffness is a quarter of 1,000 N/m at
    // first. While the hand rests, the force relaxes to about two thirds.
    const double radius = TouchTuning{}.radius_m;
    EXPECT_NEAR(felt({17, 3, 1.0 + radius - 0.004}).z, 250.0 * 0.004, 0.02);
    EXPECT_NEAR(felt({17, 3, 1.0 + radius - 0.004}, 5000).z, 250.0 * 0.004 * 0.64, 0.1);
    EXPECT_EQ(felt({17, 3, 1.0 + radius + 0.001}), Vec3(0.0));
    // Tests clay with its south side at y = 2. The clay has 400 N/m up to half a newton and yields above that force.
    EXPECT_NEAR(felt({21, 2.0 - radius + 0.001, 1}).y, -400.0 * 0.001, 0.01);
    EXPECT_LT(std::abs(felt({21, 2.0 - radius + 0.02, 1}, 300).y), 3.5)
        << "it has given way, and 8 newtons would be the spring's";
    EXPECT_EQ(haptic->soft_patches.size(), 2U);
}

TEST_F(EveryProperty, an_effect_belongs_to_the_named_thing) {
    const auto magnet = std::find_if(scene->effects.begin(), scene->effects.end(),
                                     [](const Effect& e) { return e.pull == MagnetPull::Object; });
    ASSERT_NE(magnet, scene->effects.end());
    EXPECT_EQ(scene->find(magnet->belongs_to)->name, "Pillar");
}

}  // namespace every_property_test
}  // namespace handrail::test
