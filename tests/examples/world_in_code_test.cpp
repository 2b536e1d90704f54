// Makes worlds in code. docs/developer/examples.md describes this example.
#include "haptic/compile/compile_haptic.h"
#include "haptic/render/touch.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace world_in_code_test {
using namespace compile;
using namespace readers;
using namespace render;

// A floor, a step and a slanting sheet. Each has a feature number, by which a contact names it.
std::shared_ptr<const HapticScene> small_world() {
    HapticSceneBuilder builder;
    builder.add_box({{-1.0, -1.0, -0.1}, {1.0, 1.0, 0.0}}, {FeatureId{1}});
    builder.add_box({{0.2, -1.0, 0.0}, {1.0, 1.0, 0.15}}, {FeatureId{2}});
    builder.add_triangle({-1.0, -1.0, 0.0}, {-1.5, 0.0, 0.5}, {-1.0, 1.0, 0.0}, {FeatureId{3}});
    return builder.build();
}

// Lowers a hand by a tenth of a millimetre per tick and returns the contact on the last tick.
TouchResult come_down(const HapticScene& scene, Vec3 hand_m, double to_z_m) {
    TouchState state;  // its constructor allocates, but no tick does
    TouchTuning tuning;
    tuning.radius_m = 0.005;
    TouchResult felt = touch_tick(state, scene, tuning, hand_m, 1e-3);
    while (hand_m.z > to_z_m) {
        hand_m.z = std::max(to_z_m, hand_m.z - 1e-4);
        felt = touch_tick(state, scene, tuning, hand_m, 1e-3);
    }
    return felt;
}

TEST(Example, a_world_made_in_code_is_touched) {
    const auto scene = small_world();
    const TouchResult floor = come_down(*scene, {-0.5, 0.0, 0.05}, 0.002);
    EXPECT_NEAR(floor.force_n.z, 0.003 * 800.0,
                1e-9);  // the proxy's centre stays 5 mm above the floor, while the hand is 3 mm below the floor
    EXPECT_EQ(floor.contacts.contacts[0].feature, FeatureId{1});
    const TouchResult step = come_down(*scene, {0.5, 0.0, 0.2}, 0.15);
    EXPECT_NEAR(step.proxy_m.z, 0.155, 1e-12);
    EXPECT_EQ(step.contacts.contacts[0].feature, FeatureId{2});
}

// A map is text, so a program can write a map. This map is a spiral staircase with a name for each step.
std::string spiral_staircase(int steps) {
    std::string map = "{\n\"classname\" \"worldspawn\"\n\"message\" \"Spiral staircase\"\n}\n";
    for (int i = 0; i < steps; ++i) {
        const double turn = 2.0 * kPi * i / 12.0;
        const double x = 60.0 * std::cos(turn), y = 60.0 * std::sin(turn), top = 6.0 * (i + 1);
        const auto face = [](double a, double b, double c, double d, double e, double f, double g, double h, double k) {
            return fmt::format("( {} {} {} ) ( {} {} {} ) ( {} {} {} ) wood1 0 0 0 1 1\n", a, b, c, d, e, f, g, h, k);
        };
        const double x0 = x - 16, x1 = x + 16, y0 = y - 16, y1 = y + 16;
        map += fmt::format("{{\n\"classname\" \"func_group\"\n\"name\" \"step {}\"\n{{\n", i + 1);
        map += face(x0, y0, 0, x0, y0 + 1, 0, x0, y0, 1) + face(x0, y0, 0, x0, y0, 1, x0 + 1, y0, 0) +
               face(x0, y0, 0, x0 + 1, y0, 0, x0, y0 + 1, 0);
        map += face(x1, y1, top, x1, y1 + 1, top, x1 + 1, y1, top) +
               face(x1, y1, top, x1 + 1, y1, top, x1, y1, top + 1) +
               face(x1, y1, top, x1, y1, top + 1, x1, y1 + 1, top);
        map += "}\n}\n";
    }
    return map;
}

TEST(Example, a_map_written_by_a_program_is_read_named_and_touched) {
    const Result<Scene> scene = read_quake_map(spiral_staircase(12), "spiral.map");
    ASSERT_TRUE(scene) << scene.error().sentence();
    EXPECT_EQ(scene->report.warnings_in_all, 0);
    EXPECT_EQ(scene->solids.size(), 12U);
    const auto haptic = compile_haptic(*scene, MaterialSource::Library);
    // The fourth step is in the north; its top is 24 units of 1/32 m high.
    const TouchResult felt = come_down(*haptic, {0.0, 60.0 / 32, 0.9}, 24.0 / 32);
    ASSERT_GT(felt.contacts.count, 0);
    const Feature* touched = scene->find(felt.contacts.contacts[0].feature);
    ASSERT_NE(touched, nullptr);
    EXPECT_EQ(touched->name, "step 4");
}

}  // namespace world_in_code_test
}  // namespace handrail
