// Tests the wall between world and desk, which simulated hands cross in many different ways. The wall never drives the
// hand and never knocks, and the hand returns to the place in the world that it left.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "haptic/device/simulated_device.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/support/servo_rig.h"

namespace handrail::test {
namespace personal_space_test {

constexpr double kScale = 60.0;

// A hand on a simulated device. The world is free except for a wall far in the north; the desk has a panel in its
// middle.
class DeskRig {
public:
    explicit DeskRig(const char* device)
        : spec_(*find_device_spec(device)),
          hand_(std::make_shared<SimulatedHand>()),
          device_(spec_, hand_),
          state_(spec_) {
        world_ = wall_scene(1000.0);
        HapticSceneBuilder desk;
        const double reach = spec_.workspace_radius_m;
        desk.add_box({Vec3(-reach, 0.1 * reach, -reach), Vec3(reach, 2.0 * reach, reach)}, SurfaceLabel{FeatureId{0}});
        desk_ = desk.build();
        tuning.personal_space = true;
        tuning.touch.world_m_per_hand_m = kScale;
        tuning.touch.radius_m = 0.12;
        tuning.touch.rated_stiffness_n_per_m = spec_.rated_stiffness_n_per_m;
        tuning.touch.damping_ns_per_m = 5.0;
        tuning.workspace.rim = tuning.workspace.rim_open_behind = true;
        command(HandMode::Move, Vec3(0.0), 0.0);
        tick();
        go(Vec3(0.0, 0.0, 0.005), 0.1);
        go(Vec3(0.0), 0.1);
        rest(1.2);
    }

    void command(HandMode mode, const Vec3& target_m, double speed_m_per_s, std::uint32_t buttons = 0) {
        HandCommand command;
        command.mode = mode;
        command.target_m = target_m;
        command.speed_m_per_s = speed_m_per_s;
        command.buttons = buttons;
        hand_->command.publish(command);
    }
    void tick() {
        now_s_ += kTick;
        pose.time_s = now_s_;
        const DeviceSample sample = device_.read(now_s_);
        const ForceCommand command =
            servo_tick(state_, {world_.get(), tuning, pose, sample, now_s_, nullptr, desk_.get()});
        device_.write(command);
        if (known_) {
            // Energy by the trapezoidal rule over measured positions, which is exact for springs. A sampled wall also
            // adds energy because it holds the force between two ticks; that energy is not counted here.
            given_j_ += glm::dot(0.5 * (command.force_n + force_n_), sample.position_m - place_m_);
            jump_n_ = std::max(jump_n_, glm::length(command.force_n - force_n_));
        }
        known_ = sample.connected;
        force_n_ = command.force_n;
        place_m_ = sample.position_m;
        most_n_ = std::max(most_n_, glm::length(force_n_));
        for (const ContactEvent& event : state_.events()) {
            entered += event.kind == ContactEventKind::DeskEntered;
            left += event.kind == ContactEventKind::DeskLeft;
        }
    }
    void rest(double for_s) {
        for (int i = 0; i < static_cast<int>(for_s / kTick); ++i) tick();
    }
    void go(const Vec3& to_m, double speed_m_per_s) {
        const double way = glm::length(to_m - hand_m());
        command(HandMode::Move, to_m, speed_m_per_s);
        rest(way / speed_m_per_s + 2.0 * kTick);
    }
    Vec3 hand_m() {
        hand_->state.refresh();
        return hand_->state.read().position_m;
    }
    void trouble(const DeviceTrouble& trouble) { hand_->trouble.publish(trouble); }
    void forget() { given_j_ = jump_n_ = most_n_ = 0.0; }
    PersonalWall wall() const {
        return personal_wall_of(spec_, std::min(tuning.force_ceiling_n, spec_.peak_force_n),
                                effective_stiffness_n_per_m(spec_, kTick, tuning.touch.damping_ns_per_m) *
                                    tuning.touch.default_stiffness_fraction);
    }
    const ToolState& tool() const { return state_.tool(); }
    const DeviceSpec& spec() const { return spec_; }
    const Vec3& force_n() const { return force_n_; }
    double given_j() const { return given_j_; }
    double jump_n() const { return jump_n_; }
    double most_n() const { return most_n_; }
    void set_world(std::shared_ptr<const HapticScene> world) { world_ = std::move(world); }
    void take_desk_away() { desk_.reset(); }

    ServoTuning tuning;
    WorkspacePose pose;
    int entered = 0, left = 0;

private:
    DeviceSpec spec_;
    std::shared_ptr<SimulatedHand> hand_;
    SimulatedDevice device_;
    ServoState state_;
    std::shared_ptr<const HapticScene> world_, desk_;
    double now_s_ = 50.0;
    bool known_ = false;
    Vec3 force_n_{0.0}, place_m_{0.0};
    double given_j_ = 0.0, jump_n_ = 0.0, most_n_ = 0.0;
};

class RandomPlaces {
public:
    explicit RandomPlaces(std::uint32_t seed) : random_(seed) {}
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    double speed() {
        return 0.02 * std::pow(50.0, uniform(0.0, 1.0));
    }  // speed of 0.02 to 1 m/s; slow speeds are as frequent as fast ones
    // Returns a random position in the plane across the direction towards the person, where the hand can reach the
    // wall.
    Vec3 across(double reach_m, double y_m) {
        const double far = 0.4 * reach_m * std::sqrt(uniform(0.0, 1.0)), angle = uniform(0.0, 2.0 * kPi);
        return {far * std::cos(angle), y_m, far * std::sin(angle)};
    }

private:
    std::mt19937 random_;
};

const char* const kDevices[] = {"sim-t", "sim-f"};

TEST(PersonalSpace, a_thousand_crossings_give_no_energy_never_knock_and_lead_back_to_the_same_place) {
    const std::uint32_t seed = seed_of_run();
    for (const char* device : kDevices) {
        SCOPED_TRACE(fmt::format("seed {}, {}", seed, device));
        RandomPlaces random(seed);
        DeskRig rig(device);
        const double reach = rig.spec().workspace_radius_m, at = rig.wall().at_m, depth = rig.wall().depth_m;
        const int loops = scaled(500);
        double worst_j = -1e9, sum_j = 0.0, worst_n = 0.0, worst_m = 0.0;
        for (int loop = 0; loop < loops; ++loop) {
            const Vec3 begin = random.across(reach, random.uniform(-0.5, 0.3) * reach);
            rig.go(begin, 0.3);
            rig.forget();
            const int entered = rig.entered, left = rig.left;
            const double in = random.speed(), out = random.speed();
            rig.go(random.across(reach, -at + 0.006), 0.3);
            rig.go(random.across(reach, -at - depth - random.uniform(0.0005, 0.003)), in);
            ASSERT_EQ(rig.entered, entered + 1);
            ASSERT_TRUE(rig.tool().desk.open);
            const Vec3 place_m = rig.tool().proxy_m;
            // Some hands turn back while the force of the broken wall is still decaying.
            const bool at_once = random.uniform(0.0, 1.0) < 0.3;
            if (!at_once) rig.rest(0.3);
            rig.go(random.across(reach, random.uniform(-0.5, -0.1) * reach), at_once ? std::min(in, 0.3) : 0.3);
            EXPECT_EQ(rig.tool().proxy_m, place_m) << "the world did not wait";
            rig.go(random.across(reach, -at + 0.006), 0.3);
            // The hand passes through the wall and is back in the world in the very next tick.
            const Vec3 through = random.across(reach, -at - depth - 0.002);
            rig.command(HandMode::Move, through, out);
            while (rig.left == left) rig.tick();
            worst_m = std::max(worst_m, glm::length(rig.tool().hip_m - place_m) / kScale);
            const Vec3 back_m = rig.tool().hip_m, hand_m = rig.tool().hand_m;
            rig.go(through, out);
            rig.rest(0.2);
            rig.go(begin, 0.3);
            ASSERT_EQ(rig.left, left + 1);
            ASSERT_EQ(rig.entered, entered + 1);
            EXPECT_NEAR(glm::length(rig.tool().hip_m - back_m - kScale * (rig.tool().hand_m - hand_m)), 0.0, 1e-9)
                << "the workspace went on";
            worst_j = std::max(worst_j, rig.given_j());
            sum_j += rig.given_j();
            worst_n = std::max(worst_n, rig.jump_n());
            ASSERT_LE(rig.jump_n(), 0.2) << "in at " << in << ", out at " << out << " m/s";
            ASSERT_LE(rig.given_j(), 1e-9) << "in at " << in << ", out at " << out << " m/s";
        }
        EXPECT_LT(worst_m, 1e-3);
        RecordProperty("worst_loop_j", fmt::format("{:.3g}", worst_j));
        fmt::print(
            "{}: {} crossings, work on the hand per loop {:.2f} mJ in the mean, {:.3f} mJ at most; largest jump {:.3f} "
            "N; back within {:.6f} mm felt\n",
            device, 2 * loops, 1e3 * sum_j / loops, 1e3 * worst_j, worst_n, 1e3 * worst_m);
    }
}

TEST(PersonalSpace, gives_way_at_the_smaller_of_1_5_newtons_and_60_percent_of_the_ceiling) {
    for (const char* device : kDevices) {
        for (const double ceiling_n : {1.2, 2.5, 8.0}) {
            SCOPED_TRACE(fmt::format("{}, {} N", device, ceiling_n));
            DeskRig rig(device);
            rig.tuning.force_ceiling_n = ceiling_n;
            const double at = rig.wall().at_m;
            rig.go(Vec3(0.0, -at + 0.006, 0.0), 0.1);
            rig.forget();
            rig.go(Vec3(0.0, -at - 0.9 * rig.wall().depth_m, 0.0), 0.01);
            EXPECT_FALSE(rig.tool().desk.open);
            rig.go(Vec3(0.0, -at - 1.1 * rig.wall().depth_m, 0.0), 0.01);
            EXPECT_TRUE(rig.tool().desk.open);
            EXPECT_NEAR(rig.most_n(), std::min(1.5, 0.6 * std::min(ceiling_n, rig.spec().peak_force_n)), 0.03);
            rig.rest(0.4);
            EXPECT_LT(glm::length(rig.force_n()), 1e-3);
        }
    }
}

TEST(PersonalSpace, lets_no_wobbling_hand_through_and_gives_it_no_energy) {
    const std::uint32_t seed = seed_of_run();
    RandomPlaces random(seed);
    for (const char* device : kDevices) {
        SCOPED_TRACE(fmt::format("seed {}, {}", seed, device));
        DeskRig rig(device);
        const double reach = rig.spec().workspace_radius_m, at = rig.wall().at_m, depth = rig.wall().depth_m;
        const Vec3 begin(0.0, -at + 0.006, 0.0);
        for (int loop = 0; loop < scaled(50); ++loop) {
            rig.go(begin, 0.1);
            rig.forget();
            for (int i = 0; i < 6; ++i)
                rig.go(random.across(reach, -at + random.uniform(-0.95 * depth, 0.002)), random.uniform(0.02, 0.2));
            rig.go(begin, 0.1);
            EXPECT_EQ(rig.entered, 0);
            // The hand crosses the plane at most 14 times, and each crossing adds an error of the trapezoidal rule
            // (invariant I11).
            EXPECT_LE(rig.given_j(), 14.0 * rig.wall().stiffness_n_per_m * 0.2e-3 * 0.2e-3 / 8.0);
            EXPECT_LE(rig.jump_n(), 0.2);
        }
        // A hand that has passed the wall and trembles about its plane does not go back and forth.
        rig.go(Vec3(0.0, -at - depth - 0.001, 0.0), 0.05);
        EXPECT_EQ(rig.entered, 1);
        for (int i = 0; i < 40; ++i)
            rig.go(Vec3(0.0, -at - depth * (i % 2 ? 1.1 : 0.0) + (i % 2 ? 0.0 : 0.004), 0.0), 0.1);
        EXPECT_EQ(rig.entered, 1);
        EXPECT_EQ(rig.left, 0);
    }
}

TEST(PersonalSpace, a_free_hand_that_pulls_passes_through_without_gaining_energy) {
    for (const char* device : kDevices) {
        SCOPED_TRACE(device);
        DeskRig rig(device);
        const double at = rig.wall().at_m;
        for (int loop = 0; loop < scaled(20); ++loop) {
            rig.forget();
            rig.command(HandMode::Follow, Vec3(0.0, -at - 0.02, 0.0), 0.0);
            rig.rest(0.8);
            EXPECT_EQ(rig.entered + rig.left, loop + 1);
            rig.command(HandMode::Follow, Vec3(0.0, -0.3 * at, 0.0), 0.0);
            rig.rest(0.8);
            EXPECT_LE(rig.given_j(), 1e-6);
            EXPECT_LE(rig.jump_n(), 0.2);
        }
    }
}

// A wall in the path of the pull, as in a small room. At the scale of a room it is in front of the desk's own wall.
class SmallRoom : public DeskRig {
public:
    explicit SmallRoom(const char* device) : DeskRig(device), wall_m(-0.4 * spec().workspace_radius_m) {
        HapticSceneBuilder builder;
        builder.add_box({Vec3(-10.0, -10.0, -10.0), Vec3(10.0, kScale * wall_m - 0.12, 10.0)},
                        SurfaceLabel{FeatureId{1}});
        set_world(builder.build());
        rest(1.2);
    }
    double wall_m;  // position of the hand's centre when its proxy touches the wall
    // Returns the position at which the wall would hold the hand with this force if there were no force ceiling.
    double pulled_m(double force_n) const {
        return wall_m - force_n / (effective_stiffness_n_per_m(spec(), kTick, tuning.touch.damping_ns_per_m) *
                                   tuning.touch.default_stiffness_fraction);
    }
};

TEST(PersonalSpace, a_wall_behind_the_person_lets_a_sustained_pull_through_to_the_desk_and_back) {
    for (const char* device : kDevices)
        for (const double ceiling_n : {1.2, 2.5}) {
            SCOPED_TRACE(fmt::format("{}, {} N", device, ceiling_n));
            SmallRoom rig(device);
            rig.tuning.force_ceiling_n = ceiling_n;
            for (int times = 1; times <= 3; ++times) {
                rig.go(Vec3(0.0, rig.wall_m + 0.004, 0.0), 0.1);
                rig.forget();
                rig.go(Vec3(0.0, rig.pulled_m(1.8), 0.0), 0.05);
                rig.rest(0.6);
                EXPECT_EQ(rig.entered, times - 1);
                const Vec3 before = rig.tool().proxy_m;
                rig.rest(0.4);
                EXPECT_EQ(rig.entered, times);
                EXPECT_TRUE(rig.tool().desk.open);
                rig.rest(0.4);
                EXPECT_LT(glm::length(rig.force_n()), 1e-3) << "nothing is left of the wall";
                EXPECT_LE(rig.jump_n(), 0.2);
                EXPECT_LE(rig.given_j(), 1e-6);
                // The hand goes back through the desk's own wall.
                rig.go(Vec3(0.0, -rig.wall().at_m + 0.008, 0.0), 0.1);
                rig.go(Vec3(0.0, -rig.wall().at_m - 1.1 * rig.wall().depth_m, 0.0), 0.05);
                rig.rest(0.3);
                EXPECT_FALSE(rig.tool().desk.open);
                EXPECT_LT(glm::length(rig.tool().hip_m - before), 1e-3 * kScale);
                rig.go(Vec3(0.0, -rig.wall().at_m + 0.01, 0.0), 0.1);
                ++rig.pose.jump;  // a jump returns the workspace to the person
                rig.rest(1.2);
            }
        }
}

TEST(PersonalSpace, a_wall_behind_the_person_is_explored_like_any_other) {
    for (const char* device : kDevices) {
        SCOPED_TRACE(device);
        SmallRoom rig(device);
        const auto press = [&](double force_n, double x_m, double z_m, double speed) {
            rig.go(Vec3(x_m, rig.pulled_m(force_n), z_m), speed);
        };
        press(1.2, 0.0, 0.0, 0.05);  // the hand presses lightly, for a long time
        rig.rest(5.0);
        EXPECT_EQ(rig.entered, 0);
        // The hand presses firmly and slides along the wall.
        for (int i = 0; i < 6; ++i) press(2.2, i % 2 ? 0.006 : -0.006, 0.0, 0.01);
        for (int i = 0; i < 6; ++i) press(2.2, 0.0, i % 2 ? 0.004 : -0.004, 0.01);
        EXPECT_EQ(rig.entered, 0);
        for (int i = 0; i < 6; ++i) {  // the hand presses hard, as a person does to test how firm a wall is
            press(2.2, 0.0, 0.0, 0.05);
            rig.rest(0.5);
            press(0.2, 0.0, 0.0, 0.05);
        }
        EXPECT_EQ(rig.entered, 0);
        rig.tuning.personal_space = false;
        press(2.2, 0.0, 0.0, 0.05);
        rig.rest(3.0);
        EXPECT_EQ(rig.entered, 0) << "switched off";
    }
}

// When the pull takes the hand to the desk, the hand is pressing against an object of the world. When the hand comes
// back, it is pressing against the desk.
TEST(PersonalSpace, a_contact_on_one_side_is_left_behind_without_a_knock) {
    for (const char* device : kDevices) {
        SCOPED_TRACE(device);
        DeskRig rig(device);
        const double at = rig.wall().at_m, depth = rig.wall().depth_m;
        HapticSceneBuilder builder;  // a wall just behind the hand's start, in the path of the pull
        builder.add_box({Vec3(-10.0, -10.0, -10.0), Vec3(10.0, kScale * (-at + 0.004) - 0.12, 10.0)},
                        SurfaceLabel{FeatureId{1}});
        rig.set_world(builder.build());
        rig.rest(1.5);
        rig.go(Vec3(0.0, -at + 0.006, 0.0), 0.05);
        rig.forget();
        const Vec3 proxy_before = rig.tool().proxy_m;
        rig.go(Vec3(0.0, -at - depth - 0.001, 0.0), 0.02);
        ASSERT_TRUE(rig.tool().desk.open);
        EXPECT_GT(rig.most_n(), 2.0) << "the world did not resist";
        EXPECT_LT(glm::length(rig.tool().proxy_m - proxy_before), 0.13);
        const Vec3 place_m = rig.tool().proxy_m;
        rig.rest(0.4);
        EXPECT_LT(glm::length(rig.force_n()), 1e-3);
        rig.go(Vec3(0.003, -0.3 * at, 0.0), 0.1);
        rig.go(Vec3(0.003, -at - depth - 0.001, 0.004), 0.05);
        ASSERT_FALSE(rig.tool().desk.open);
        EXPECT_LT(glm::length(rig.tool().proxy_m - place_m) / kScale, 2e-3);
        rig.rest(0.4);
        EXPECT_LE(rig.jump_n(), 0.2);
        EXPECT_LE(rig.given_j(), 1e-6);
    }
}

TEST(PersonalSpace, a_fault_at_the_desk_removes_the_force_as_everywhere) {
    for (const char* kind : {"unplug", "stop", "nan", "hot", "error"}) {
        SCOPED_TRACE(kind);
        DeskRig rig("sim-t");
        const double at = rig.wall().at_m, depth = rig.wall().depth_m;
        rig.go(Vec3(0.0, -at - depth - 0.001, 0.0), 0.05);
        // The proxy, of 2 mm, is pressed 3 mm into the panel.
        rig.go(Vec3(0.0, 0.1 * rig.spec().workspace_radius_m + 0.001, 0.0), 0.1);
        rig.rest(0.3);
        ASSERT_TRUE(rig.tool().desk.open);
        ASSERT_GT(glm::length(rig.force_n()), 0.7);
        EXPECT_EQ(rig.tool().desk.touched, FeatureId{0});
        DeviceTrouble trouble;
        const std::string what = kind;
        trouble.unplugged = what == "unplug";
        trouble.hot = what == "hot";
        trouble.failed = what == "error";
        if (what == "nan") trouble.not_a_number_samples = 3;
        if (what == "stop") rig.tuning.panic = true;
        rig.trouble(trouble);
        rig.rest(what == "hot" ? 0.1 : 0.003);
        EXPECT_EQ(glm::length(rig.force_n()), 0.0);
        rig.trouble({});
        rig.rest(0.2);
        EXPECT_EQ(glm::length(rig.force_n()), 0.0);
        if (what == "stop") rig.tuning.panic = false;
        ++rig.tuning.confirm;
        rig.go(Vec3(0.0, -0.1 * at, 0.0), 0.1);
        rig.rest(1.2);
        EXPECT_EQ(rig.tool().fault, Fault::None);
        // After a fault that makes the hand's position invalid, the hand is back in the world.
        EXPECT_EQ(rig.tool().desk.open, what == "stop" || what == "hot" || what == "error");
    }
}

TEST(PersonalSpace, a_teleport_returns_the_hand_to_the_world_and_without_a_desk_there_is_no_wall) {
    DeskRig rig("sim-t");
    const double at = rig.wall().at_m, depth = rig.wall().depth_m;
    rig.go(Vec3(0.0, -at - depth - 0.001, 0.0), 0.05);
    ASSERT_TRUE(rig.tool().desk.open);
    ++rig.pose.jump;
    rig.pose.origin_m = Vec3(5.0, 0.0, 0.0);
    rig.tick();
    EXPECT_FALSE(rig.tool().desk.open);
    EXPECT_EQ(rig.left, 1);
    rig.rest(0.1);
    EXPECT_EQ(glm::length(rig.force_n()), 0.0);

    rig.go(Vec3(0.0), 0.1);
    rig.go(Vec3(0.0, -at - depth - 0.001, 0.0), 0.05);
    ASSERT_TRUE(rig.tool().desk.open);
    const Vec3 place_m = rig.tool().proxy_m;
    rig.tuning.personal_space = false;
    rig.tick();
    EXPECT_FALSE(rig.tool().desk.open);
    EXPECT_NEAR(glm::length(rig.tool().hip_m - place_m), 0.0, 1e-9);
    rig.go(Vec3(0.0), 0.1);
    rig.forget();
    rig.go(Vec3(0.0, -at - depth - 0.001, 0.0), 0.05);
    EXPECT_FALSE(rig.tool().desk.open);
    EXPECT_EQ(rig.most_n(), 0.0);
    rig.tuning.personal_space = true;
    rig.take_desk_away();
    rig.go(Vec3(0.0), 0.1);
    rig.go(Vec3(0.0, -at - depth - 0.001, 0.0), 0.05);
    EXPECT_FALSE(rig.tool().desk.open);
}

TEST(PersonalSpace, a_push_resists_and_gives_way_at_half_its_force) {
    DeskPress press;
    const FeatureId button{3}, other{4};
    press.tick(button, 1.0, false, 1.2);
    EXPECT_FALSE(press.held());
    for (const double n : {1.25, 1.1, 1.3, 0.7, 1.25}) press.tick(button, n, false, 1.2);
    EXPECT_EQ(press.held(), button);
    EXPECT_EQ(press.presses(), 1u);
    press.tick(other, 0.8, false, 1.2);  // the hand slides to another control, and the first one stays pressed
    EXPECT_EQ(press.held(), button);
    press.tick(other, 0.5, false, 1.2);
    EXPECT_FALSE(press.held());
    press.tick(kNoFeature, 0.0, true, 1.2);  // the device button is pressed while nothing is touched
    press.tick(other, 0.3, true, 1.2);
    EXPECT_FALSE(press.held());
    press.tick(other, 0.3, false, 1.2);
    press.tick(other, 0.3, true, 1.2);
    EXPECT_EQ(press.held(), other);
    EXPECT_EQ(press.presses(), 2u);
    press.tick(other, 0.3, false, 1.2);
    EXPECT_FALSE(press.held());
}

}  // namespace personal_space_test
}  // namespace handrail::test
