// Tests a loop that stalls repeatedly while a hand presses in and out. Runs the whole servo tick with its limiter.
#include "haptic/servo/servo_tick.h"
#include "tests/support/names.h"
#include "tests/unit/loop/loop_rig.h"

namespace handrail::test {
namespace stall_test {

struct Sweep {
    double peak_n = 0.0;
    double work_j = 0.0;
    double largest_step_n = 0.0;
    double fastest_m_per_s = 0.0;
};

// Moves the hand in and out by 20 mm at 2 Hz for six seconds, with half of the path inside the wall. Measures after the
// first 1.5 s. If `silent` is true, the device stops answering while the servo continues. Otherwise the servo itself
// stalls, and the motor keeps its force.
Sweep sweep(const TiltedWall& wall, double stall_s, bool silent, std::uint32_t seed) {
    DeviceSpec spec = *find_device_spec("sim-f");
    spec.peak_force_n = 1e9;  // a motor limit would hide the force peaks
    LoopSettings settings;
    settings.hand.mass_kg = 0.4;
    settings.hand.damping_ns_per_m = 3.2;
    settings.hand.spring_n_per_m = 300.0;
    settings.encoder_quantum_m = spec.encoder_quantum_m;
    settings.delay_s = spec.delay_s;
    settings.seed = seed;
    if (!silent) {
        settings.stall_every_s = 0.4;
        settings.stall_s = stall_s;
    }
    ServoState servo(spec);
    ServoTuning tuning;
    tuning.touch = loop_tuning(1500.0);
    tuning.force_ceiling_n = 100.0;
    ServoState* state = &servo;
    const ClosedLoop::Render render = [&, state](const Vec3& measured_m, double now_s, double) {
        DeviceSample sample;
        sample.position_m = measured_m;
        if (silent && stall_s > 0.0 && now_s > 0.4) sample.fresh = std::fmod(now_s + 1e-9, 0.4) >= stall_s;
        return servo_tick(*state, {wall.scene.get(), tuning, WorkspacePose{}, sample, now_s}).force_n;
    };
    const Vec3 rest = wall.to_world({tuning.touch.radius_m, 0.0, 0.0});
    ClosedLoop loop(settings, rest + wall.out * 0.01);
    Sweep seen;
    double begun_j = 0.0, last_n = 0.0;
    for (int i = 0; i < 6000; ++i) {
        const LoopTick tick = loop.tick(
            [&](double t) {
                return HandIntent{rest + wall.out * (-0.01 + 0.02 * std::cos(2.0 * kPi * 2.0 * t)), Vec3(0.0)};
            },
            render);
        const double force_n = glm::length(tick.commanded_n);
        if (i == 1500) begun_j = tick.work_j;
        if (i > 1500) {
            seen.peak_n = std::max(seen.peak_n, force_n);
            seen.largest_step_n = std::max(seen.largest_step_n, std::abs(force_n - last_n));
            seen.fastest_m_per_s = std::max(seen.fastest_m_per_s, glm::length(tick.velocity_m_per_s));
        }
        last_n = force_n;
        seen.work_j = tick.work_j - begun_j;
    }
    return seen;
}

TEST(Stalls, neither_jerk_the_hand_nor_add_energy) {
    for (const std::uint32_t seed : {0U, 41U, 42U}) {
        const TiltedWall wall(seed);
        const Sweep undisturbed = sweep(wall, 0.0, false, seed);
        EXPECT_GT(undisturbed.peak_n, 3.0);
        for (const bool silent : {false, true})
            for (const double stall_s : {0.010, 0.020, 0.050}) {
                const Sweep seen = sweep(wall, stall_s, silent, seed);
                SCOPED_TRACE(fmt::format(
                    "{} of {} s, seed {}: peak {:.2f} N of {:.2f}, work {:.4f} J, step {:.2f} N, {:.2f} m/s of {:.2f}",
                    silent ? "silence of the device" : "stall of the loop", stall_s, seed, seen.peak_n,
                    undisturbed.peak_n, seen.work_j, seen.largest_step_n, seen.fastest_m_per_s,
                    undisturbed.fastest_m_per_s));
                EXPECT_LE(seen.peak_n, 1.5 * undisturbed.peak_n);
                EXPECT_LE(seen.work_j, 0.0);
                EXPECT_LE(seen.fastest_m_per_s, 1.5 * undisturbed.fastest_m_per_s);
            }
    }
}

}  // namespace stall_test
}  // namespace handrail::test
