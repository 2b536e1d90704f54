// Makes a material in code. docs/developer/examples.md describes this example.
#include "haptic/render/haptic_scene.h"
#include "haptic/render/touch.h"

namespace handrail {
namespace new_material_test {
using namespace render;

// Snow on one side, the default wall on the other. A surface refers to its material by index in the scene's list.
std::shared_ptr<const HapticScene> snow_and_wall() {
    HapticMaterial snow;
    snow.stiffness_fraction = 0.15;  // fraction of the stiffness that the device can render
    snow.friction_static = snow.friction_kinetic = 0.05;
    HapticSceneBuilder builder({HapticMaterial{}, snow});
    builder.add_box({{-1.0, -1.0, -1.0}, {0.0, 1.0, 0.0}}, {FeatureId{1}, MaterialId{1}});
    builder.add_box({{0.0, -1.0, -1.0}, {1.0, 1.0, 0.0}}, {FeatureId{2}, kDefaultMaterial});
    return builder.build();
}

TEST(Example, a_material_made_in_code_is_as_soft_and_slippery_as_it_says) {
    const auto scene = snow_and_wall();
    TouchTuning tuning;
    tuning.default_friction_static = tuning.default_friction_kinetic = 0.5;
    const auto slide = [&](double x) {
        TouchState state;
        TouchResult felt;
        for (int i = 0; i < 300; ++i)
            felt = touch_tick(state, *scene, tuning,
                              {x, 1e-4 * std::max(0, i - 100), std::max(0.001, 0.011 - 1e-4 * i)}, 1e-3);
        return felt;
    };
    const TouchResult snow = slide(-0.5), wall = slide(0.5);
    EXPECT_NEAR(snow.force_n.z, 0.004 * 150.0, 1e-9);
    EXPECT_NEAR(wall.force_n.z, 0.004 * 800.0, 1e-9);
    EXPECT_NEAR(-snow.force_n.y / snow.force_n.z, 0.05, 1e-6);
    EXPECT_NEAR(-wall.force_n.y / wall.force_n.z, 0.5, 1e-6);
    EXPECT_EQ(snow.contacts.contacts[0].material, MaterialId{1});
}

}  // namespace new_material_test
}  // namespace handrail
