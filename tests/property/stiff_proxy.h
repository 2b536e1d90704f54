// Makes a tuning with the rated stiffness, for tests that a hand never enters an obstacle.
#pragma once

#include "haptic/render/touch.h"
#include "tests/support/names.h"

namespace handrail::test {

inline TouchTuning stiff_proxy(double radius_m) {
    TouchTuning tuning;
    tuning.radius_m = radius_m;
    tuning.rated_stiffness_n_per_m = 1000.0;
    tuning.default_stiffness_fraction = 1.0;
    return tuning;
}

}  // namespace handrail::test
