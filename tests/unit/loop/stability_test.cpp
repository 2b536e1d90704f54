// Tests hands of every mass and grip on walls with the greatest stiffness that the stability rule allows. The loop has
// delay, encoder steps and dry friction.
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/loop/loop_rig.h"

namespace handrail::test {
namespace stability_test {

TEST(Stability, a_hand_that_presses_six_newtons_comes_to_rest_at_the_recommended_stiffness) {
    std::uint32_t seed = 0;
    for (const double mass_kg : {0.1, 0.3, 0.5})
        for (const double grip : {1.0, 3.0, 10.0})
            for (const double delay_s : {0.0, 1e-3, 2e-3}) {
                // Applies the stability rule with and without damping by the renderer. Without that damping, the
                // passivity guard must make the loop stable.
                for (const double damping : {5.0, 0.0}) {
                    ++seed;
                    SCOPED_TRACE(fmt::format("mass {} kg, grip {} Ns/m, delay {} s, damping {} Ns/m, seed {}", mass_kg,
                                             grip, delay_s, damping, seed));
                    const TiltedWall wall(seed);
                    LoopSettings settings;
                    settings.hand.mass_kg = mass_kg + 0.1;
                    settings.hand.damping_ns_per_m = grip + 0.2;
                    settings.hand.spring_n_per_m = 300.0;
                    settings.delay_s = delay_s;
                    settings.seed = seed;
                    TouchTuning tuning = loop_tuning(safe_stiffness_n_per_m(delay_s, damping), damping);
                    tuning.passivity_guard = true;
                    tuning.force_delay_s = delay_s;
                    const Vec3 rest = wall.to_world({tuning.radius_m, 0.0, 0.0});
                    ClosedLoop loop(settings, rest + wall.out * 0.01);
                    const ClosedLoop::Render render = touch_renderer(wall.scene, tuning);
                    const HandIntent leaning{rest - wall.out * (6.0 / 300.0), Vec3(0.0)};
                    std::vector<double> places;
                    double given_j = 0.0;
                    const int ticks = 6000;
                    for (int i = 0; i < ticks; ++i) {
                        const LoopTick tick = loop.tick([&](double) { return leaning; }, render);
                        given_j = std::max(given_j, tick.work_j);
                        if (i > 2 * ticks / 3) places.push_back(glm::dot(tick.hand_m - rest, wall.out));
                    }
                    EXPECT_LT(peak_to_peak(places), 0.3e-3);
                    if (damping > 0.0) {  // without damping, a hand that flies into the wall may bounce before it rests
                        EXPECT_LT(given_j, 1e-3);
                    }
                    EXPECT_LT(places.back(), 0.0) << "it never touched";
                }
            }
}

TEST(Stability, holds_at_twice_the_recommended_stiffness_and_is_lost_at_ten_times) {
    for (const double delay_s : {0.0, 1e-3, 2e-3}) {
        LoopSettings settings;
        settings.hand.mass_kg = 0.4;
        settings.hand.damping_ns_per_m = 1.2;
        settings.hand.spring_n_per_m = 300.0;
        settings.delay_s = delay_s;
        const TiltedWall wall(0);
        const double limit = stable_stiffness_n_per_m(
            settings,
            [&](double stiffness) {
                TouchTuning tuning = loop_tuning(stiffness);
                tuning.radius_m = 0.0;
                return touch_renderer(wall.scene, tuning);
            },
            6.0, 4.0);
        const double rule = safe_stiffness_n_per_m(delay_s, 5.0);
        RecordProperty(fmt::format("limit_at_delay_{}_us", delay_s * 1e6),
                       fmt::format("{:.0f} N/m, rule {:.0f}", limit, rule));
        EXPECT_GT(limit, 1.5 * rule) << "delay " << delay_s;
        EXPECT_LT(limit, 10.0 * rule) << "delay " << delay_s << ": the loop cannot tell an unstable wall";
    }
}

TEST(PassivityGuard, lets_an_undamped_wall_be_stiffer_without_force_jumps) {
    const TiltedWall wall(0);
    LoopSettings settings;
    settings.hand.damping_ns_per_m = 1.2;
    settings.hand.spring_n_per_m = 300.0;
    settings.delay_s = 1e-3;
    double limit[2];
    for (const bool guard : {false, true})
        limit[guard] = stable_stiffness_n_per_m(
            settings,
            [&](double stiffness) {
                TouchTuning tuning = loop_tuning(stiffness, 0.0);
                tuning.radius_m = 0.0;
                tuning.passivity_guard = guard;
                tuning.force_delay_s = settings.delay_s;
                return touch_renderer(wall.scene, tuning);
            },
            6.0, 6.0);
    EXPECT_GE(limit[1], 1.25 * limit[0]) << limit[0] << " without, " << limit[1] << " with";

    // Sweeps a hand smoothly in and out, with and without encoder steps. The force that the passivity guard adds must
    // change only gradually.
    for (const double quantum_m : {0.0, 0.06e-3}) {
        TouchState plain, guarded;
        TouchTuning tuning = loop_tuning(1500.0, 0.0);
        std::vector<double> added;
        for (int i = 0; i < 4000; ++i) {
            const Vec3 hand = encoded_m(
                Vec3(tuning.radius_m + 0.003 - 0.006 * (0.5 - 0.5 * std::cos(2.0 * kPi * 2e-3 * i)), 0.0, 0.0),
                quantum_m);
            tuning.passivity_guard = false;
            const double without = touch_tick(plain, *wall.scene, tuning, hand, 1e-3).force_n.x;
            tuning.passivity_guard = true;
            added.push_back(touch_tick(guarded, *wall.scene, tuning, hand, 1e-3).force_n.x - without);
        }
        EXPECT_LE(largest_step(added), 0.005) << "encoder step " << quantum_m;
    }
}

TEST(PassivityGuard, leaves_damped_surfaces_bit_identical) {
    const TiltedWall wall(5);
    LoopSettings settings;
    settings.hand.damping_ns_per_m = 1.2;
    settings.hand.spring_n_per_m = 300.0;
    // The surface is so stiff that the loop rings and that the passivity guard would have to act if nothing damped the
    // surface.
    TouchTuning tuning = loop_tuning(4000.0, 2.0);
    std::vector<Vec3> forces[2];
    for (const bool guard : {false, true}) {
        tuning.passivity_guard = guard;
        ClosedLoop loop(settings, wall.out * 0.01);
        const ClosedLoop::Render render = touch_renderer(wall.scene, tuning);
        for (int i = 0; i < 1000; ++i)
            forces[guard].push_back(loop.tick(
                                            [&](double) {
                                                return HandIntent{wall.out * -0.02, Vec3(0.0)};
                                            },
                                            render)
                                        .commanded_n);
    }
    EXPECT_EQ(forces[0], forces[1]);
}

}  // namespace stability_test
}  // namespace handrail::test
