// The haptic view of a building: what a hand can touch and nothing else. Immutable once compiled, so the servo thread reads it
// without locks. World metres in double, stored relative to origin_m so that far-away buildings lose nothing.
// Features are named by FeatureId; ask Scene on the app thread for words. Built by compile_haptic (haptic/compile).
#pragma once

#include <cstdint>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/base/vec.h"
#include "worlds/geometry/convex.h"

namespace handrail {

// Negative: the tuning's default holds.
struct HapticMaterial {
    double stiffness_fraction = -1.0;
    double friction_static = -1.0;
    double friction_kinetic = -1.0;
};

struct HapticScene;  // completed by the owner of haptic/render

}  // namespace handrail
