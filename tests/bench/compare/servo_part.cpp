// The servo as in the program: its own thread in real time, and a simulated device whose hand leans on walls.
#include <cmath>

#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_loop.h"
#include "tests/bench/compare/bench.h"

namespace handrail::bench {

ServoThread run_servo_thread(double seconds) {
    SteadyClock clock;
    auto hand = std::make_shared<SimulatedHand>();
    ServoLoop loop(std::make_unique<SimulatedDevice>(*find_device_spec("sim-f"), hand), clock);
    ServoThread out;
    if (!loop.open()) return out;
    HapticSceneBuilder builder;
    builder.add_box({{-2, -2, -2}, {2, 2, -0.02}});
    builder.add_box({{0.02, -2, -2}, {2, 2, 2}});
    ServoTuning tuning;
    tuning.touch.damping_ns_per_m = 5.0;
    tuning.touch.default_friction_static = tuning.touch.default_friction_kinetic = 0.3;
    loop.set_tuning(tuning);
    loop.set_pose({});
    loop.set_scene(builder.build());
    const double begun_s = clock.now_s();
    loop.start();
    // The hand circles through both walls once a second.
    while (clock.now_s() - begun_s < seconds) {
        const double turn = 2.0 * kPi * (clock.now_s() - begun_s);
        hand->command.publish({HandMode::Follow,
                               Vec3(0.03 * std::sin(turn), 0.01 * std::cos(turn), 0.03 * std::cos(turn)), 0.0,
                               Vec3(0.0), 0});
        clock.sleep_until_s(clock.now_s() + 0.016);
    }
    loop.stop();
    const ServoReport& report = loop.report();
    out.seconds = seconds;
    out.ticks = loop.tool().ticks;
    out.overruns = report.overruns;
    out.period_p50_s = report.counters.periods.quantile_s(0.5);
    out.period_p99_s = report.counters.periods.quantile_s(0.99);
    out.period_worst_s = report.counters.periods.worst_s;
    out.tick_p99_s = report.durations.quantile_s(0.99);
    out.tick_worst_s = report.durations.worst_s;
    out.scheduling = scheduling_sentence(report.scheduling);
    return out;
}

}  // namespace handrail::bench
