// Defines a custom force law that the servo thread computes on each tick. docs/developer/examples.md describes this
// example.
#include "haptic/render/haptic_scene.h"
#include "haptic/render/touch.h"

namespace handrail {
namespace new_effect_test {
using namespace render;

// A breeze from the west that rises and falls every two seconds. The servo thread calls this function, so it must not
// allocate, lock, read a clock or throw. It uses only + - x / and the square root, so that every machine computes the
// same numbers.
Vec3 breeze(const EffectPoint& point, const void* data) noexcept {
    const double strongest_n = *static_cast<const double*>(data);
    const double periods = point.time_s / 2.0;
    const double part = periods - static_cast<double>(static_cast<long>(periods));
    return {strongest_n * (part < 0.5 ? 2.0 * part : 2.0 - 2.0 * part), 0.0, 0.0};
}

std::shared_ptr<const HapticScene> breezy_corner() {
    EffectVolume effect;
    effect.feature = FeatureId{7};
    effect.region = SphereRegion{{0.0, 0.0, 1.0}, 0.2};
    // The last argument is the stiffness. It is zero, because the breeze has no spring.
    effect.law = CustomLaw{breeze, std::make_shared<const double>(0.8), 0.0};
    HapticSceneBuilder builder;
    EXPECT_TRUE(builder.add_effect(effect));
    return builder.build();
}

TEST(Example, a_custom_force_acts_on_each_tick_inside_its_region_and_nowhere_else) {
    const auto scene = breezy_corner();
    TouchState inside, outside;
    double strongest_n = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const TouchResult felt = touch_tick(inside, *scene, TouchTuning{}, {0.0, 0.0, 1.0}, 1e-3);
        strongest_n = std::max(strongest_n, felt.force_n.x);
        if (i == 1999) {
            EXPECT_NEAR(felt.force_n.x, 0.0, 2e-3) << "the breeze has died away";
        }
        EXPECT_EQ(touch_tick(outside, *scene, TouchTuning{}, {0.0, 0.0, 1.3}, 1e-3).force_n, Vec3(0.0));
    }
    EXPECT_NEAR(strongest_n, 0.8, 2e-3);
}

}  // namespace new_effect_test
}  // namespace handrail
