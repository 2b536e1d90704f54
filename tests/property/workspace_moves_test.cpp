// Tests random hands among solids that move their workspace by rim, by grabbing and by keys. The moving workspace never
// knocks, never drives the hand and never gives it energy.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/support/servo_rig.h"

namespace handrail::test {
namespace workspace_moves_test {

struct RandomWorld {
    std::shared_ptr<const HapticScene> scene;
    Aabb limits_m{Vec3(-6.0), Vec3(6.0)};
};

// Returns a world with boxes around a free start. If `walls` is false, the world has no obstacle within reach.
RandomWorld world_of(std::mt19937& random, bool walls) {
    if (!walls) return {wall_scene(1000.0)};
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    HapticSceneBuilder builder;
    for (int i = 0; i < 25; ++i) {
        const Vec3 centre(uniform(-6.0, 6.0), uniform(-6.0, 6.0), uniform(-6.0, 6.0));
        const Vec3 half(uniform(0.1, 1.5), uniform(0.1, 1.5), uniform(0.1, 1.5));
        const Vec3 gap = glm::max(glm::abs(centre) - half, Vec3(0.0));
        if (glm::length(gap) < 0.3) continue;
        builder.add_box({centre - half, centre + half}, {FeatureId{static_cast<std::uint32_t>(i) + 1}});
    }
    return {builder.build()};
}

// A hand that moves from place to place at up to 0.12 m/s and accelerates gently. It often passes the rim, and presses
// the button and the keys at random.
class RandomHand {
public:
    explicit RandomHand(std::mt19937& random, double reach_m) : random_(random), reach_m_(reach_m) {}
    Vec3 step(double dt_s) {
        if (glm::length(goal_m_ - at_m_) < 1e-3) {
            const Vec3 way = glm::normalize(Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
            goal_m_ = way * (reach_m_ * uniform(0.2, 1.0));
            speed_ = uniform(0.02, 0.12);
        }
        const Vec3 wanted = glm::normalize(goal_m_ - at_m_) * speed_;
        velocity_ += (wanted - velocity_) * (dt_s / 0.03);
        at_m_ += velocity_ * dt_s;
        return at_m_;
    }
    void play(ServoRig& rig) {
        if (uniform(0, 1) < 1.0 / 400.0) rig.sample.buttons ^= 1U;
        if (uniform(0, 1) < 1.0 / 600.0)
            rig.tuning.workspace.push_hand_m_per_s =
                uniform(0, 1) < 0.6 ? Vec3(0.0)
                                    : Vec3(uniform(-0.03, 0.03), uniform(-0.03, 0.03), uniform(-0.03, 0.03));
    }
    const Vec3& at_m() const { return at_m_; }

private:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    std::mt19937& random_;
    double reach_m_;
    Vec3 at_m_{0.0}, goal_m_{0.0}, velocity_{0.0};
    double speed_ = 0.05;
};

TEST(WorkspaceMoves, neither_knock_nor_push_nor_feed_energy_to_a_random_hand) {
    const std::uint32_t seed = seed_of_run();
    std::mt19937 random(seed);
    int moved_ticks = 0, touched_while_moving = 0;
    for (int run = 0; run < scaled(12); ++run) {
        for (const char* device : {"sim-t", "sim-f", "force-stick"}) {
            const bool walls = run % 4 != 0;
            SCOPED_TRACE(fmt::format("seed {}, run {}, {}", seed, run, device));
            ServoRig rig(*find_device_spec(device));
            const RandomWorld world = world_of(random, walls);
            rig.scene = world.scene;
            rig.tuning.touch.world_m_per_hand_m = 60.0;
            rig.tuning.touch.radius_m = 0.12;
            rig.tuning.touch.rated_stiffness_n_per_m = rig.state.spec().rated_stiffness_n_per_m;
            rig.tuning.workspace.rim = true;
            rig.tuning.workspace.grab_buttons = 1;
            rig.tuning.workspace.limits_m = world.limits_m;
            rig.arm();
            for (int i = 0; i < 1100; ++i) rig.tick(Vec3(0.0));
            RandomHand hand(random, rig.state.spec().workspace_radius_m);
            const double stiffness = effective_stiffness_n_per_m(rig.state.spec(), kTick, 0.0);
            double given_j = 0.0, most_given_j = 0.0, allowed_n = 0.0;
            bool still = true;
            Vec3 force_before(0.0), hand_before(0.0), shift_before = rig.tool().workspace_shift_m;
            for (int tick = 0; tick < 20000; ++tick) {
                hand.play(rig);
                rig.tick(hand.step(kTick));
                const Vec3 force = rig.last.force_n;
                const ToolState& tool = rig.tool();
                const bool moved =
                    tool.workspace_motion != WorkspaceMotion::Still && tool.workspace_shift_m != shift_before;
                // Energy by the trapezoidal rule, which is exact for springs. A sampled wall also adds energy because
                // it holds the force between two ticks; that energy is not counted here.
                given_j += glm::dot(0.5 * (force + force_before), hand.at_m() - hand_before);
                most_given_j = std::max(most_given_j, given_j);
                // While the workspace stands still, only a wall can act.
                if (tool.workspace_motion != WorkspaceMotion::Still) {
                    // The previous force fades first, within 75 ms. While the workspace moves, the force is below 0.2
                    // N, and only the hand's own motion changes it quickly.
                    if (still) allowed_n = glm::length(force_before);
                    allowed_n = std::max(WorkspaceMover::kMovingForceN, allowed_n - 33.0 * kTick);
                    ASSERT_LE(glm::length(force), allowed_n + 1e-9) << "at tick " << tick;
                    // With a wall, there are two more reasons for a change: the hand's own motion, and a step of the
                    // proxy around an edge before the force has faded.
                    const bool going = allowed_n > WorkspaceMover::kMovingForceN;
                    const double own_n = stiffness * (glm::length(hand.at_m() - hand_before) +
                                                      (going ? rig.tuning.touch.slide_cap_hand_m : 0.0));
                    ASSERT_LE(glm::length(force - force_before), 0.2 + own_n) << "at tick " << tick;
                }
                still = tool.workspace_motion == WorkspaceMotion::Still;
                // Yielding to a contact may move the workspace out of its limits. Moving in free space never does.
                for (int axis = 0; axis < 3 && tool.contacts.count == 0; ++axis) {
                    const double out_m = std::abs(tool.workspace_shift_m[axis]);
                    ASSERT_LE(out_m, std::max(6.0, std::abs(shift_before[axis])) + 1e-12) << "at tick " << tick;
                }
                moved_ticks += moved;
                touched_while_moving += moved && tool.contacts.count > 0;
                force_before = force;
                hand_before = hand.at_m();
                shift_before = tool.workspace_shift_m;
            }
            // Rim and grip alone give no energy. Among walls, the proxy's steps around edges give a little. Energy that
            // is pumped would accumulate over the presses of 20 s.
            const double press_j = rig.tuning.force_ceiling_n * rig.tuning.force_ceiling_n / (2.0 * stiffness);
            EXPECT_LT(most_given_j, walls ? press_j : 2e-4) << "the hand was given energy";
        }
    }
    EXPECT_GT(moved_ticks, scaled(12) * 3 * 2000);
    EXPECT_GE(touched_while_moving, scaled(12) == 12 ? 12 * 3 * 50 : 0) << "too few hands came to a wall";
}

}  // namespace workspace_moves_test
}  // namespace handrail::test
