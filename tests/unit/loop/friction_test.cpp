// Tests friction and light touch with the hand's tremor, encoder steps, noise and delay, in open and in closed loop.
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/loop/loop_rig.h"

namespace handrail::test {
namespace friction_test {

constexpr double kStiffness = 1000.0;  // stiffness in N/m: a depth of a millimetre gives a newton

TouchTuning rubbing(double mu_static, double mu_kinetic) {
    TouchTuning tuning = loop_tuning(kStiffness);
    tuning.default_friction_static = mu_static;
    tuning.default_friction_kinetic = mu_kinetic;
    return tuning;
}

struct Rub {
    std::vector<double> along_n;        // force along the direction in which the hand moves
    std::vector<double> speed_m_per_s;  // speed of the hand in that direction
    std::vector<double> place_m;
};

// Presses a hand of 300 N/m against the wall with 10 N and moves it slowly along the wall. Returns what the hand felt
// once it slid steadily.
Rub creep(const TiltedWall& wall, const TouchTuning& tuning, double speed_m_per_s, double seconds, std::uint32_t seed) {
    LoopSettings settings;
    settings.hand.mass_kg = 0.4;
    settings.hand.damping_ns_per_m = 4.2;
    settings.hand.spring_n_per_m = 300.0;
    settings.tremor_m = 0.05e-3;
    settings.seed = seed;
    const Vec3 rest = wall.to_world({tuning.radius_m, 0.0, 0.0});
    const double press_m = 10.0 / 300.0 + 10.0 / kStiffness;
    ClosedLoop loop(settings, rest + wall.out * 0.001);
    const ClosedLoop::Render render = touch_renderer(wall.scene, tuning);
    Rub rub;
    for (int i = 0; i < static_cast<int>(seconds * 1000); ++i) {
        const LoopTick tick = loop.tick(
            [&](double t) {
                return HandIntent{rest - wall.out * (press_m * std::min(1.0, t / 0.5)) +
                                      wall.along * (speed_m_per_s * std::max(0.0, t - 1.0)),
                                  Vec3(0.0)};
            },
            render);
        // At first the hand sticks, until its spring is stretched to the friction force.
        if (i * 1e-3 < 2.0 + 4.0 / 300.0 / std::max(speed_m_per_s, 1e-4)) continue;
        rub.along_n.push_back(glm::dot(tick.commanded_n, wall.along));
        rub.speed_m_per_s.push_back(glm::dot(tick.velocity_m_per_s, wall.along));
        rub.place_m.push_back(glm::dot(tick.hand_m, wall.along));
    }
    return rub;
}

TEST(Friction, a_creeping_press_of_ten_newtons_does_not_chatter) {  // in closed loop
    std::uint32_t seed = 0;
    for (const double speed : {0.001, 0.002, 0.005})
        for (const auto& [mu_static, mu_kinetic] : {std::pair{0.4, 0.4}, {0.3, 0.3}, {0.5, 0.4}}) {
            ++seed;
            const double seconds = 2.0 + 4.0 / 300.0 / speed + 4.0 * std::max(0.25, kSanitizerScale);
            const Rub rub = creep(TiltedWall(seed), rubbing(mu_static, mu_kinetic), speed, seconds, seed);
            SCOPED_TRACE(fmt::format("{} m/s, mu {} and {}, seed {}", speed, mu_static, mu_kinetic, seed));
            const double rms = rms_above(rub.along_n, 30.0, 1e-3);
            RecordProperty(fmt::format("rms_n_above_30_hz_seed_{}", seed), fmt::format("{:.4f}", rms));
            EXPECT_LE(rms, 0.02);
            EXPECT_EQ(sign_changes(rub.along_n), 0);
            double mean = 0.0;
            for (const double f : rub.along_n) mean -= f / static_cast<double>(rub.along_n.size());
            EXPECT_NEAR(mean, 10.0 * mu_kinetic, 0.15 * 10.0 * mu_kinetic) << "it is not sliding";
        }
}

TEST(Friction, of_a_trembling_guided_hand_is_steady) {  // in open loop
    for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) {
        const TiltedWall wall(seed);
        TouchTuning tuning = rubbing(0.4, 0.4);
        TouchState state;
        std::mt19937 random(seed);
        double phases[9];
        for (double& phase : phases) phase = 2.0 * kPi * static_cast<double>(random()) / 4294967296.0;
        std::vector<double> along_n;
        for (int i = 0; i < 6000; ++i) {
            const auto tremor = [&](int k) {
                double sum = 0.0;
                for (int j = 0; j < 3; ++j) sum += std::sin(2.0 * kPi * (8.0 + 2.0 * j) * 1e-3 * i + phases[3 * k + j]);
                return 0.05e-3 / std::sqrt(3.0) * sum;
            };
            const double depth_m = 0.010 * std::min(1.0, i / 500.0);
            const Vec3 hand =
                encoded_m({tuning.radius_m - depth_m + tremor(0), 5e-6 * i + tremor(1), tremor(2)}, 0.06e-3);
            const Vec3 force =
                wall.motion.back(touch_tick(state, *wall.scene, tuning, wall.to_world(hand), 1e-3).force_n);
            if (i > 2000) along_n.push_back(force.y);
        }
        EXPECT_LE(rms_above(along_n, 30.0, 1e-3), 0.02) << "seed " << seed;
        EXPECT_EQ(sign_changes(along_n), 0) << "seed " << seed;
    }
}

TEST(Friction, holds_against_a_steady_pull_with_tremor_for_a_minute) {  // the hand may drift only a little
    for (const std::uint32_t seed : {7U, 8U}) {
        const TiltedWall wall(seed);
        const TouchTuning tuning = rubbing(0.4, 0.4);
        LoopSettings settings;
        settings.hand.mass_kg = 0.4;
        settings.hand.damping_ns_per_m = 4.2;
        settings.seed = seed;
        const Vec3 rest = wall.to_world({tuning.radius_m, 0.0, 0.0});
        ClosedLoop loop(settings, rest);
        const ClosedLoop::Render render = touch_renderer(wall.scene, tuning);
        const int ticks = scaled(60000);
        double settled_m = 0.0, last_m = 0.0;
        for (int i = 0; i < ticks; ++i) {
            const LoopTick tick = loop.tick(
                [&](double t) {
                    const double pull =
                        2.0 * std::clamp(t - 0.5, 0.0, 1.0) + (t > 0.5 ? 0.2 * std::sin(2.0 * kPi * 10.0 * t) : 0.0);
                    return HandIntent{Vec3(0.0), wall.out * (-10.0 * std::min(1.0, t / 0.3) *
                                                             (1.0 + 0.02 * std::sin(2.0 * kPi * 11.0 * t))) +
                                                     wall.along * pull};
                },
                render);
            // Averages the hand's place over whole periods of the tremor.
            const double place = glm::dot(tick.hand_m, wall.along) / 1000.0;
            if (i >= ticks / 2 - 1000 && i < ticks / 2) settled_m += place;
            if (i >= ticks - 1000) last_m += place;
        }
        const double minutes = ticks / 2 * 1e-3 / 60.0;
        EXPECT_LE(std::abs(last_m - settled_m) / minutes, 0.1e-3) << "seed " << seed;
        EXPECT_LT(std::abs(last_m), 5e-3) << "it slid away";
    }
}

TEST(LightTouch, responds_to_the_smallest_movement_and_does_not_amplify_noise) {
    std::uint32_t seed = 20;
    for (const double mu : {0.3, 0.4, 0.8}) {
        ++seed;
        const TiltedWall wall(seed);
        TouchTuning tuning = rubbing(mu, mu);
        TouchState state;
        const double depth_m = 0.5e-3;  // at this depth, the force is half a newton
        const auto force_at = [&](double deep_m, double way_m) {
            return wall.motion.back(
                touch_tick(state, *wall.scene, tuning, wall.to_world({tuning.radius_m - deep_m, way_m, 0.0}), 1e-3)
                    .force_n);
        };
        for (int i = 0; i <= 100; ++i) force_at(depth_m * i / 100, 0.0);
        // Friction has no dead band: a micrometre along the wall must give a millinewton, in both directions and
        // through zero.
        for (int i = 0; i < 200; ++i) force_at(depth_m, 0.0);  // waits until the speed filter is at rest
        for (const double way_m : {1e-6, 5e-6, 20e-6, 5e-6, -1e-6, -20e-6, 0.0})
            EXPECT_NEAR(force_at(depth_m, way_m).y, -kStiffness * way_m, 1e-9) << mu;
        // While the proxy slides, the friction is at the limit of the friction cone. After a stop, the proxy must stick
        // where it is and immediately act like a spring.
        double way_m = 0.0;
        for (; way_m < 5e-3; way_m += 10e-6) force_at(depth_m, way_m);
        for (int i = 0; i < 50; ++i) force_at(depth_m, way_m);
        const double sliding = force_at(depth_m, way_m).y;
        EXPECT_NEAR(sliding, -mu * kStiffness * depth_m, 1e-9);
        for (int i = 1; i <= 20; ++i)
            EXPECT_NEAR(force_at(depth_m, way_m - i * 1e-6).y, sliding + kStiffness * i * 1e-6, 1e-9) << "re-stick";
    }
}

TEST(LightTouch, does_not_chatter_with_tremor_and_white_noise) {
    for (const std::uint32_t seed : {31U, 32U, 33U, 34U}) {
        const TiltedWall wall(seed);
        for (const double speed : {0.0, 0.002, 0.02}) {
            LoopSettings settings;
            settings.hand.mass_kg = 0.3;
            settings.hand.damping_ns_per_m = 3.2;
            settings.hand.spring_n_per_m = 300.0;
            settings.tremor_m = 0.05e-3;
            settings.noise_m = 0.01e-3;
            settings.seed = seed;
            const TouchTuning tuning = rubbing(0.4, 0.4);
            const Vec3 rest = wall.to_world({tuning.radius_m, 0.0, 0.0});
            ClosedLoop loop(settings, rest);
            const ClosedLoop::Render render = touch_renderer(wall.scene, tuning);
            const double press_m = 0.5 / 300.0 + 0.5e-3;
            std::vector<double> out_n, along_n, noise_out_n, noise_along_n;
            Vec3 last_true(0.0);
            for (int i = 0; i < 4000; ++i) {
                last_true = i == 0 ? rest : last_true;
                const LoopTick tick = loop.tick(
                    [&](double t) {
                        return HandIntent{rest - wall.out * (press_m * std::min(1.0, t)) +
                                              wall.along * (speed * std::max(0.0, t - 1.0)),
                                          Vec3(0.0)};
                    },
                    render);
                if (i > 1500) {
                    out_n.push_back(glm::dot(tick.commanded_n, wall.out));
                    along_n.push_back(glm::dot(tick.commanded_n, wall.along));
                    noise_out_n.push_back(kStiffness * glm::dot(tick.measured_m - last_true, wall.out));
                    noise_along_n.push_back(kStiffness * glm::dot(tick.measured_m - last_true, wall.along));
                }
                last_true = tick.hand_m;
            }
            SCOPED_TRACE(fmt::format("seed {}, {} m/s", seed, speed));
            // The output noise may contain only the sensor's noise times the stiffness, and what the damping adds.
            const double noise_out = rms_above(noise_out_n, 30.0, 1e-3),
                         noise_along = rms_above(noise_along_n, 30.0, 1e-3);
            EXPECT_LE(rms_above(along_n, 30.0, 1e-3), 1.1 * std::max(noise_out, noise_along));
            EXPECT_LE(rms_above(out_n, 30.0, 1e-3), 2.5 * noise_out);
            EXPECT_GT(*std::min_element(out_n.begin(), out_n.end()), 0.0) << "contact was lost";
            if (speed > 0.01) {
                EXPECT_EQ(sign_changes(along_n), 0);
            }
        }
    }
}

}  // namespace friction_test
}  // namespace handrail::test
