// Measures the servo thread while a hand presses into a corner of two walls with friction and damping.
#include "tests/bench/compare/bench.h"
#include "tests/support/names.h"

namespace handrail::bench {

Result<ServoMeasured> run_servo_thread(double seconds) {
    HapticSceneBuilder builder;
    builder.add_box({{-2, -2, -2}, {2, 2, -0.02}});
    builder.add_box({{0.02, -2, -2}, {2, 2, 2}});
    ServoTuning tuning;
    tuning.touch.damping_ns_per_m = 5.0;
    tuning.touch.default_friction_static = tuning.touch.default_friction_kinetic = 0.3;
    return measure_servo(builder.build(), {}, tuning, seconds);
}

}  // namespace handrail::bench
