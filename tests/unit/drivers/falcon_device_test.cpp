#include "haptic/drivers/falcon_device.h"

#include <limits>

#include "haptic/drivers/falcon_kinematics.h"
#include "haptic/servo/servo_tick.h"
#include "tests/emulators/falcon_emulator.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/support/servo_rig.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/world_axes.h"

namespace handrail {
namespace falcon_device_test {

using test::DirectFalconLink;
using test::FalconEmulator;

constexpr double kEncoderQuantumM = 0.06e-3;

// A Falcon on a simulated USB link, in virtual time.
struct Falcon {
    VirtualClock clock;
    FalconEmulator emulator;
    DirectFalconLink* link = nullptr;
    std::unique_ptr<FalconDevice> device;
    test::TemporaryFolder folder;
    std::vector<std::string> reported;

    explicit Falcon(bool running = true) {
        auto owned = std::make_unique<DirectFalconLink>(emulator, clock);
        link = owned.get();
        FalconOptions options;
        if (running) {
            emulator.stage = FalconEmulator::Stage::Running;
        } else {
            const auto image = test::boot_image(4000);
            emulator.firmware_wanted = image.size();
            options.firmware_files = {folder.write("falcon.bin", std::string(image.begin(), image.end()))};
        }
        options.report = [this](const std::string& sentence) { reported.push_back(sentence); };
        device = std::make_unique<FalconDevice>(std::move(owned), clock, options);
    }
    DeviceSample exchange(const Vec3& force_n) {
        device->write({force_n});
        return device->read(clock.now_s());
    }
    DeviceSample home() {
        DeviceSample sample;
        for (int i = 0; i < 1000 && !(sample.fresh && sample.homed && i > 0); ++i) sample = exchange(Vec3(0.0));
        return sample;
    }
};

Vec3 true_place(const FalconEmulator& emulator) { return falcon_to_device(emulator.grip_m); }

TEST(FalconDevice, starts_up_by_sending_its_firmware_and_comparing_every_echo) {
    Falcon falcon(false);
    falcon.emulator.leading_zero = true;
    falcon.emulator.frames_until_homed = 60;
    const auto opened = falcon.device->open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_FALSE(falcon.device->firmware_was_running());
    const auto image = test::boot_image(4000);
    EXPECT_EQ(falcon.emulator.firmware, image);
    EXPECT_THAT(falcon.reported,
                testing::ElementsAre(testing::HasSubstr("needs waking"), testing::HasSubstr("towards you")));
    EXPECT_EQ(falcon.emulator.latency_ms, 1U);
}

// A link on which writing each piece takes a while.
class SlowLink final : public ByteLink {
public:
    SlowLink(std::unique_ptr<ByteLink> wire, VirtualClock& clock, double write_s)
        : wire_(std::move(wire)), clock_(clock), write_s_(write_s) {}
    bool control(std::uint8_t request, std::uint16_t value) noexcept override { return wire_->control(request, value); }
    int write(std::span<const std::uint8_t> bytes, double timeout_s) noexcept override {
        clock_.advance_s(write_s_);
        return wire_->write(bytes, timeout_s);
    }
    int read(std::span<std::uint8_t> room, double timeout_s) noexcept override { return wire_->read(room, timeout_s); }

private:
    std::unique_ptr<ByteLink> wire_;
    VirtualClock& clock_;
    double write_s_;
};

// The driver must report progress after two seconds and then every five seconds. The upload has 4000 bytes, in pieces
// that take a third of a second each.
TEST(FalconDevice, reports_progress_of_a_slow_firmware_upload) {
    VirtualClock clock;
    FalconEmulator emulator;
    const test::TemporaryFolder folder;
    const auto image = test::boot_image(4000);
    emulator.firmware_wanted = image.size();
    std::vector<std::string> reported;
    std::vector<double> reported_s;
    FalconOptions options;
    options.firmware_files = {folder.write("falcon.bin", std::string(image.begin(), image.end()))};
    options.report = [&](const std::string& sentence) {
        if (sentence.find("percent") == std::string::npos) return;
        reported.push_back(sentence);
        reported_s.push_back(clock.now_s());
    };
    auto wire = std::make_unique<SlowLink>(std::make_unique<DirectFalconLink>(emulator, clock), clock, 1.0 / 3.0);
    FalconDevice device(std::move(wire), clock, options);
    const auto opened = device.open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    ASSERT_GE(reported.size(), 2U);
    EXPECT_THAT(reported.front(), testing::ContainsRegex("^Sending the Falcon's firmware, [0-9]+ percent\\.$"));
    EXPECT_NE(reported[0], reported[1]);
    for (std::size_t i = 1; i < reported_s.size(); ++i) EXPECT_NEAR(reported_s[i] - reported_s[i - 1], 5.0, 0.5);
}

TEST(FalconDevice, needs_no_firmware_file_if_its_firmware_already_runs) {
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    EXPECT_TRUE(falcon.device->firmware_was_running());
}

TEST(FalconDevice, reports_each_leg_that_has_found_its_zero) {
    Falcon falcon;
    falcon.emulator.homes_by_moving = true;
    ASSERT_TRUE(falcon.device->open());
    const auto legs_at = [&](double out_m) {
        falcon.emulator.grip_m.z = out_m;
        falcon.exchange(Vec3(0.0));
        const DeviceSample sample = falcon.exchange(Vec3(0.0));
        EXPECT_EQ(sample.homed, sample.homed_legs == 7);
        return sample.homed_legs;
    };
    EXPECT_EQ(legs_at(0.13), 0);
    EXPECT_EQ(legs_at(0.16), 3);
    EXPECT_EQ(legs_at(0.11), 7);
}

TEST(FalconDevice, retries_after_a_wrong_echo_and_reports_it) {
    Falcon falcon(false);
    falcon.emulator.wrong_echo_at_byte = 1234;
    ASSERT_TRUE(falcon.device->open());
    EXPECT_THAT(falcon.reported, testing::Contains(testing::HasSubstr("Attempt 2")));
    EXPECT_EQ(falcon.emulator.firmware, test::boot_image(4000));
}

TEST(FalconDevice, explains_each_failure_to_open_in_one_sentence) {
    {
        Falcon falcon(false);
        falcon.emulator.deaf = true;
        const auto opened = falcon.device->open();
        ASSERT_FALSE(opened);
        EXPECT_THAT(opened.error().sentence(), testing::HasSubstr("power supply"));
    }
    const auto image = test::boot_image(4000);
    const std::string whole(image.begin(), image.end());
    for (const auto& [content, words] : {std::pair<std::string, std::string>{whole.substr(0, 2001), "incomplete"},
                                         {"GIF89a", "does not begin as it should"},
                                         {whole + "x", "does not end where it should"}}) {
        VirtualClock clock;
        FalconEmulator emulator;
        test::TemporaryFolder folder;
        FalconOptions options;
        options.firmware_files = {folder.write("f.bin", content)};
        FalconDevice device(std::make_unique<DirectFalconLink>(emulator, clock), clock, options);
        const auto opened = device.open();
        ASSERT_FALSE(opened);
        EXPECT_THAT(opened.error().sentence(), testing::HasSubstr(words));
        EXPECT_TRUE(emulator.firmware.empty()) << "nothing may reach the device";
    }
    VirtualClock clock;
    FalconEmulator emulator;
    FalconDevice device(std::make_unique<DirectFalconLink>(emulator, clock), clock, {});
    const auto opened = device.open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().sentence(),
                testing::AllOf(testing::HasSubstr("nvent_firmware.bin"), testing::HasSubstr("falcon")));
}

TEST(FalconDevice, a_damaged_firmware_file_does_not_hide_an_intact_one) {
    VirtualClock clock;
    FalconEmulator emulator;
    const auto image = test::boot_image(400);
    emulator.firmware_wanted = image.size();
    test::TemporaryFolder folder;
    FalconOptions options;
    options.firmware_files = {folder.write("a.bin", "junk"),
                              folder.write("b.bin", std::string(image.begin(), image.end()))};
    FalconDevice device(std::make_unique<DirectFalconLink>(emulator, clock), clock, options);
    EXPECT_TRUE(device.open());
}

TEST(FalconDevice, commands_no_force_before_all_legs_are_homed) {
    Falcon falcon;
    falcon.emulator.frames_until_homed = 60;
    ASSERT_TRUE(falcon.device->open());
    int unhomed = 0;
    for (int i = 0; i < 100; ++i) {
        const DeviceSample sample = falcon.exchange({1.0, 2.0, -1.0});
        ASSERT_TRUE(sample.fresh);
        if (!sample.homed) ++unhomed;
        else EXPECT_LT(glm::length(sample.position_m - true_place(falcon.emulator)), kEncoderQuantumM);
    }
    EXPECT_GT(unhomed, 40);
    EXPECT_EQ(falcon.emulator.frames_before_homed_with_force, 0U);
    EXPECT_GT(falcon.emulator.largest_force_n, 2.0) << "and the force does come then";
}

// Right, forward and up on the device must be east, north and up in the world.
TEST(FalconDevice, right_forward_up_are_east_north_up_and_a_force_to_the_east_pushes_right) {
    const std::array<Vec3, 3> falcon_axes{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, -1.0},
                                          // The Falcon's axes for right, away from the person, and up.
                                          Vec3{0.0, 1.0, 0.0}};
    for (int axis = 0; axis < 3; ++axis) {
        Falcon falcon;
        falcon.emulator.grip_m = kFalconMiddleM;
        ASSERT_TRUE(falcon.device->open());
        const Vec3 middle = falcon.home().position_m;
        EXPECT_LT(glm::length(middle), kEncoderQuantumM);
        falcon.emulator.grip_m += 0.01 * falcon_axes[static_cast<std::size_t>(axis)];
        falcon.exchange(Vec3(0.0));
        Vec3 expected{0.0};
        expected[axis] = 0.01;
        const DeviceSample moved = falcon.exchange(Vec3(0.0));
        EXPECT_LT(glm::length(moved.position_m - expected), 2.0 * kEncoderQuantumM) << axis;

        // Checks the whole conversion into the world and back.
        const test::ThroughWorld through = test::through_world(falcon.device->spec(), moved.position_m, axis);
        test::expect_east_north_up(through, axis, 0.01, 2.0 * kEncoderQuantumM);

        falcon.emulator.held = false;
        falcon.emulator.velocity_m_per_s = Vec3(0.0);
        const Vec3 before = true_place(falcon.emulator);
        const Vec3 push = through.command.force_n / through.command.force_n[axis];
        for (int i = 0; i < 20; ++i) falcon.exchange(push);
        const Vec3 way = true_place(falcon.emulator) - before;
        EXPECT_GT(way[axis], 0.0005) << axis;
        EXPECT_GT(way[axis] / glm::length(way), 0.99) << axis;
    }
}

TEST(FalconDevice, gives_the_requested_force_and_never_exceeds_its_ceiling) {
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    falcon.home();
    falcon.exchange({0.3, -0.4, 1.2});
    EXPECT_LT(glm::length(falcon.emulator.force_on_hand_n() - turn_device_to_falcon({0.3, -0.4, 1.2})), 0.02);
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(-1.0, 1.0), within(-0.02, 0.02), power(-3.0, 9.0);
    for (int i = 0; i < test::scaled(3000); ++i) {
        falcon.emulator.grip_m = kFalconMiddleM + Vec3(within(random), within(random), within(random));
        falcon.exchange(Vec3(0.0));
        Vec3 force = Vec3(unit(random), unit(random), unit(random)) * std::pow(10.0, power(random));
        if (i % 10 == 0) force[i % 3] = i % 20 ? nan : inf;
        falcon.exchange(force);
        const Vec3 felt = falcon.emulator.force_on_hand_n();
        if (!is_finite(force)) {
            EXPECT_EQ(falcon.emulator.motors, (std::array<int, 3>{}));
        } else if (glm::length(force) > 0.5) {
            const Vec3 wanted = turn_device_to_falcon(force) / glm::length(force);
            EXPECT_GT(glm::dot(felt, wanted) / glm::length(felt), 0.999);
        }
    }
    EXPECT_LE(falcon.emulator.largest_force_n, 3.0);
    EXPECT_EQ(falcon.emulator.over_range, 0U);
    falcon.exchange({1e9, 1e9, -1e9});
    EXPECT_NEAR(glm::length(falcon.emulator.force_on_hand_n()), 0.95 * 3.0, 0.02);
}

// A wall of 1000 N/m across z = 0.130. The hand presses with less than the ceiling of 3 N. So the hand must come to
// rest behind the wall at a depth of force / stiffness.
TEST(FalconDevice, rests_against_a_wall_at_the_exact_static_answer_over_a_thousand_exchanges) {
    constexpr double kStiffness = 1000.0, kPush = 2.0;
    const double wall_y = falcon_to_device({0.0, 0.0, 0.130}).y;
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    falcon.home();
    falcon.emulator.held = false;
    falcon.emulator.push_n = {0.0, 0.0, -kPush};  // the hand pushes away from the person
    Vec3 force{0.0};
    for (int i = 0; i < 1000; ++i) {
        const DeviceSample sample = falcon.exchange(force);
        ASSERT_TRUE(sample.fresh && sample.connected && sample.homed) << i;
        ASSERT_LT(glm::length(sample.position_m - true_place(falcon.emulator)), 3.0 * kEncoderQuantumM)
            << i;  // the hand moved while the device answered, so three encoder steps are allowed
        force = {0.0, std::min(0.0, -kStiffness * (sample.position_m.y - wall_y)), 0.0};
    }
    EXPECT_NEAR(true_place(falcon.emulator).y, wall_y + kPush / kStiffness, kEncoderQuantumM);
    EXPECT_NEAR(true_place(falcon.emulator).x, 0.0, 0.5e-3);
    EXPECT_NEAR(true_place(falcon.emulator).z, 0.0, 0.5e-3);
    EXPECT_LT(glm::length(falcon.emulator.velocity_m_per_s), 0.01);
}

// A fault of the link: its name, the function that causes it, and how many of 5000 exchanges may fail because of it.
struct WireFault {
    const char* name;
    void (*make)(Falcon&);
    int most_failures;
};

class FalconWire : public testing::TestWithParam<WireFault> {};

TEST_P(FalconWire, never_gives_a_wrong_position_or_too_much_force) {
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    falcon.home();
    GetParam().make(falcon);
    const int exchanges = test::scaled(5000);
    int failures = 0;
    Vec3 older = true_place(falcon.emulator), old = older;
    for (int i = 0; i < exchanges; ++i) {
        falcon.emulator.grip_m =
            kFalconMiddleM + Vec3(0.02 * std::sin(0.01 * i), 0.02 * std::cos(0.007 * i), 0.01 * std::sin(0.013 * i));
        const DeviceSample sample = falcon.exchange({9.0, -9.0, 4.0});
        const Vec3 now = true_place(falcon.emulator);
        ASSERT_TRUE(sample.connected);
        if (!sample.fresh) {
            ++failures;
        } else {
            // The reported position must be that of this exchange. If an answer was late, the position may be that of
            // one of the two previous exchanges.
            const double off = std::min({glm::length(sample.position_m - now), glm::length(sample.position_m - old),
                                         glm::length(sample.position_m - older)});
            ASSERT_LT(off, kEncoderQuantumM) << GetParam().name << ", exchange " << i;
        }
        older = old;
        old = now;
        ASSERT_LE(falcon.emulator.largest_force_n, 3.0);
    }
    EXPECT_LE(failures, GetParam().most_failures * exchanges / 5000 + 1) << GetParam().name;
    EXPECT_EQ(falcon.emulator.over_range, 0U);
    EXPECT_EQ(falcon.emulator.malformed, 0U);
    std::printf("%s: %d of %d exchanges failed, %lu bytes skipped\n", GetParam().name, failures, exchanges,
                static_cast<unsigned long>(falcon.device->skipped_bytes()));
}

INSTANTIATE_TEST_SUITE_P(
    Faults, FalconWire,
    testing::Values(WireFault{"sound", [](Falcon&) {}, 0},
                    WireFault{"fragments", [](Falcon& f) { f.link->in_fragments = true; }, 10},
                    WireFault{"garbage", [](Falcon& f) { f.emulator.garbage_before_every_nth = 10; }, 0},
                    WireFault{"lost_answers", [](Falcon& f) { f.emulator.lose_every_nth_answer = 50; }, 100},
                    WireFault{"torn_answers", [](Falcon& f) { f.emulator.torn_every_nth_answer = 50; }, 100},
                    WireFault{"late_answers", [](Falcon& f) { f.emulator.late_every_nth_answer = 50; }, 200},
                    WireFault{"everything_at_once",
                              [](Falcon& f) {
                                  f.link->in_fragments = true;
                                  f.emulator.garbage_before_every_nth = 7;
                                  f.emulator.lose_every_nth_answer = 31;
                                  f.emulator.torn_every_nth_answer = 43;
                                  f.emulator.late_every_nth_answer = 57;
                              },
                              800}),
    [](const auto& fault) { return std::string(fault.param.name); });

TEST(FalconDevice, unplugging_is_detected_at_once_and_permanent) {
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    falcon.home();
    EXPECT_TRUE(falcon.exchange({0.0, 1.0, 0.0}).connected);
    falcon.link->unplugged = true;
    EXPECT_FALSE(falcon.exchange({0.0, 1.0, 0.0}).connected);
    falcon.link->unplugged = false;
    EXPECT_FALSE(falcon.exchange({0.0, 1.0, 0.0}).connected);
}

TEST(FalconDevice, withdraws_its_force_after_20_ms_without_commands) {
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    falcon.home();
    falcon.exchange({0.0, 2.0, 0.0});
    ASSERT_GT(glm::length(falcon.emulator.force_on_hand_n()), 1.9);
    falcon.emulator.lose_every_nth_answer = 1;
    const double silent_since_s = falcon.clock.now_s();
    while (glm::length(falcon.emulator.force_on_hand_n()) > 0.0) {
        EXPECT_FALSE(falcon.exchange({0.0, 2.0, 0.0}).fresh);
        ASSERT_LT(falcon.clock.now_s() - silent_since_s, 0.030);
    }
    falcon.emulator.lose_every_nth_answer = 0;
    EXPECT_TRUE(falcon.exchange({0.0, 2.0, 0.0}).fresh);
}

// The device has three encoders for three directions, so one position alone cannot reveal a stuck encoder; only the
// changes over time can. Until the driver detects it, the reported position is wrong by a few millimetres. The force
// must end before the error is greater.
TEST(FalconDevice, a_stuck_encoder_is_detected_within_millimetres_and_ends_the_force) {
    for (int leg = 0; leg < 3; ++leg) {
        Falcon falcon;
        ASSERT_TRUE(falcon.device->open());
        falcon.home();
        falcon.emulator.stuck_leg = leg;
        double farthest_off = 0.0, full_until = 0.0, force_until = 0.0;
        DeviceSample sample;
        for (int i = 0; i < 300; ++i) {
            falcon.emulator.grip_m = Vec3(0.0, 0.0, 0.145 - 0.0001 * i);
            sample = falcon.exchange({0.0, 2.0, 0.0});
            if (!is_finite(sample.position_m)) break;
            farthest_off = std::max(farthest_off, glm::length(sample.position_m - true_place(falcon.emulator)));
            const double force = glm::length(falcon.emulator.force_on_hand_n());
            if (force > 1.9) full_until = farthest_off;
            if (force > 0.0) force_until = farthest_off;
        }
        EXPECT_LT(full_until, 0.004);
        EXPECT_LT(force_until, 0.006);
        EXPECT_LT(force_until, farthest_off);
        EXPECT_FALSE(is_finite(sample.position_m));
        EXPECT_LT(farthest_off, 0.012);
        std::printf("leg %d stuck: force goes down from %.1f mm off, is gone at %.1f, noticed at %.1f\n", leg,
                    full_until * 1e3, force_until * 1e3, farthest_off * 1e3);
        falcon.exchange({0.0, 2.0, 0.0});
        EXPECT_EQ(falcon.emulator.motors, (std::array<int, 3>{}));
    }
}

TEST(FalconDevice, moving_along_a_line_on_which_one_leg_stays_still_interrupts_force_briefly_without_a_fault) {
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    falcon.home();
    falcon.emulator.stuck_leg = 1;
    int i = 0;
    for (; glm::length(falcon.emulator.force_on_hand_n()) > 1.0 || i < 2; ++i) {
        falcon.emulator.grip_m = Vec3(0.0, 0.0, 0.145 - 0.0001 * i);
        ASSERT_TRUE(is_finite(falcon.exchange({0.0, 2.0, 0.0}).position_m));
    }
    falcon.emulator.stuck_leg = -1;
    double last = glm::length(falcon.emulator.force_on_hand_n());
    for (int answers = 0; answers < 25; ++answers) {
        falcon.emulator.grip_m.z -= 0.0001;
        EXPECT_TRUE(is_finite(falcon.exchange({0.0, 2.0, 0.0}).position_m));
        const double force = glm::length(falcon.emulator.force_on_hand_n());
        EXPECT_LE(force, last + 0.15) << "no knock";
        last = force;
    }
    EXPECT_GT(last, 1.9);
}

// Runs the whole chain over a link on which anything can go wrong at any time, while the hand presses against a wall.
// Whatever arrives, the driver must never accept a wrong position or exceed the force ceiling, not even if a leg is
// stuck.
TEST(FalconDevice, no_fault_under_the_servo_gives_a_wrong_position_or_a_force_above_the_ceiling) {
    const std::uint64_t seed = test::seed_of_run();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937_64 random(seed);
    constexpr double kCeilingN = 2.0;
    double strongest_n = 0.0;
    for (int run = 0; run < test::scaled(30); ++run) {
        Falcon falcon(random() % 2 == 0);
        if (random() % 2) falcon.emulator.wrong_echo_at_byte = static_cast<int>(random() % 4000);
        ASSERT_TRUE(falcon.device->open());
        falcon.home();
        falcon.emulator.held = true;
        test::ServoRig rig(*find_device_spec("falcon"));
        rig.scene = test::wall_scene(0.01);
        rig.tuning.force_ceiling_n = kCeilingN;
        Vec3 older = true_place(falcon.emulator), old = older;
        bool leg_was_stuck = false;
        ForceCommand command;
        for (int i = 0; i < 1500; ++i) {
            if (random() % 100 == 0) {
                const auto every = [&] { return random() % 2 ? 0 : static_cast<int>(2 + random() % 50); };
                falcon.link->in_fragments = random() % 2;
                falcon.emulator.garbage_before_every_nth = every();
                falcon.emulator.lose_every_nth_answer = every();
                falcon.emulator.torn_every_nth_answer = every();
                falcon.emulator.late_every_nth_answer = every();
            }
            if (i > 700 && random() % 2000 == 0) falcon.link->unplugged = true;
            if (i > 700 && random() % 400 == 0) falcon.emulator.stuck_leg = static_cast<int>(random() % 3);
            leg_was_stuck = leg_was_stuck || falcon.emulator.stuck_leg >= 0;
            if (random() % 50 == 0) ++rig.tuning.confirm;
            falcon.emulator.grip_m = kFalconMiddleM + Vec3(0.01 * std::sin(0.011 * i), 0.01 * std::cos(0.007 * i),
                                                           -0.02 * std::sin(0.005 * i));
            const DeviceSample sample = falcon.exchange(command.force_n);
            const Vec3 now = true_place(falcon.emulator);
            if (sample.fresh && sample.homed && is_finite(sample.position_m)) {
                const double off = std::min({glm::length(sample.position_m - now), glm::length(sample.position_m - old),
                                             glm::length(sample.position_m - older)});
                // A hand that moves only the stuck leg looks like a resting hand, so the test cannot check positions
                // then.
                ASSERT_TRUE(leg_was_stuck || off < 2.0 * kEncoderQuantumM)
                    << "run " << run << ", exchange " << i << ", off by " << off;
            }
            older = old;
            old = now;
            rig.sample = sample;
            command = rig.tick_raw(sample.position_m, test::kTick);
            strongest_n = std::max(strongest_n, glm::length(command.force_n));
            // A stuck leg also turns the force that reaches the hand. The force may then be somewhat more than
            // requested, but never more than the driver allows.
            ASSERT_LE(falcon.emulator.largest_force_n, leg_was_stuck ? 3.0 : 1.05 * kCeilingN)
                << "run " << run << ", exchange " << i;
        }
    }
    EXPECT_LE(strongest_n, kCeilingN * (1 + 1e-12));
    EXPECT_GT(strongest_n, 0.95 * kCeilingN) << "the wall was pressed";
}

TEST(FalconDevice, a_resting_or_trembling_hand_does_not_count_as_a_stuck_encoder) {
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    falcon.home();
    std::mt19937 random(2);
    std::normal_distribution<double> tremor(0.0, 0.05e-3);
    Vec3 place = falcon.emulator.grip_m;
    for (int i = 0; i < test::scaled(4000); ++i) {
        if (i % 1000 > 500) place += Vec3(0.00002, -0.00001, -0.00003);
        falcon.emulator.grip_m =
            place + (i % 1000 > 500 ? Vec3(tremor(random), tremor(random), tremor(random)) : Vec3(0.0));
        ASSERT_TRUE(is_finite(falcon.exchange(Vec3(0.0)).position_m)) << i;
    }
}

TEST(FalconDevice, leaves_the_motors_at_zero_on_closing) {
    Falcon falcon;
    ASSERT_TRUE(falcon.device->open());
    falcon.home();
    falcon.exchange({1.0, 1.0, 1.0});
    ASSERT_NE(falcon.emulator.motors, (std::array<int, 3>{}));
    falcon.device->close();
    EXPECT_EQ(falcon.emulator.motors, (std::array<int, 3>{}));
    falcon.device->close();
}

}  // namespace falcon_device_test
}  // namespace handrail
