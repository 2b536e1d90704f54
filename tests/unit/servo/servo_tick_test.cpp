#include "haptic/servo/servo_switches.h"

#include <limits>
#include <random>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/random_families.h"
#include "tests/support/servo_rig.h"

namespace handrail {
namespace servo_tick_test {

using test::kTick;
using test::ServoRig;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Position of the hand at which it presses 2 mm into the wall of 800 N/m, which gives 1.6 N.
const Vec3 kPressed(0.0, ServoRig::kWallY - 0.005 + 0.002, 0.0);
constexpr double kPressN = 1.6;

TEST(ServoTick, gives_no_force_before_the_hand_has_moved) {
    ServoRig rig;
    const Vec3 start = kPressed - Vec3(0, 0.006, 0);  // the hand is 4 mm before the contact
    for (int i = 0; i < 3000; ++i)
        ASSERT_EQ(rig.tick(start + Vec3(0, 0, 0.0029 * std::sin(0.01 * i))).force_n, Vec3(0.0));
    EXPECT_TRUE(rig.tool().waiting_for_hand);
    EXPECT_EQ(rig.tool().force_gain, 0.0);
    rig.tick(start + Vec3(0, 0, 0.0031));
    EXPECT_FALSE(rig.tool().waiting_for_hand);
    EXPECT_NEAR(rig.tool().force_gain, 1e-3, 1e-12);
}

TEST(ServoTick, ramps_in_over_one_second_and_then_presses_with_the_walls_stiffness) {
    ServoRig rig;
    rig.arm();
    rig.go(kPressed);
    const double start_gain = rig.tool().force_gain;
    const double start_s = rig.now_s;
    while (rig.tool().force_gain < 1.0) {
        const Vec3 force = rig.tick(kPressed).force_n;
        ASSERT_NEAR(force.y, -kPressN * rig.tool().force_gain, 1e-9);
        ASSERT_NEAR(rig.tool().force_gain, std::min(1.0, start_gain + (rig.now_s - start_s)), 1e-9);
    }
    EXPECT_NEAR(rig.tick(kPressed).force_n.y, -kPressN, 1e-9);
    EXPECT_EQ(rig.tool().force_n.y, rig.last.force_n.y);
    EXPECT_EQ(rig.tool().contacts.count, 1);
}

TEST(ServoTick, one_or_two_bad_samples_give_zero_at_once_and_the_force_returns_over_20_ms) {
    const Vec3 jump = kPressed + Vec3(0.06, 0, 0);
    for (const Vec3& bad : {Vec3(kNan, 0, 0), Vec3(0, kInf, 0), Vec3(0, 0, -kInf), Vec3(1e30), jump,
                            Vec3(kPressed.x, kPressed.y - 0.021, 0)})
        for (const int run : {1, 2}) {
            ServoRig rig;
            rig.press(kPressed);
            for (int i = 0; i < run; ++i) {
                EXPECT_EQ(rig.tick(bad).force_n, Vec3(0.0));
                EXPECT_NE(rig.tool().fault, Fault::None);
            }
            for (int i = 1; i <= 20; ++i) ASSERT_NEAR(rig.tick(kPressed).force_n.y, -kPressN * i / 20.0, 1e-6);
            EXPECT_NEAR(rig.tick(kPressed).force_n.y, -kPressN, 1e-9);
            EXPECT_EQ(rig.tool().fault, Fault::None);
            EXPECT_EQ(rig.state.counters().bad_samples, static_cast<std::uint64_t>(run));
            EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 0);
        }
}

TEST(ServoTick, three_bad_samples_in_a_row_latch_until_confirmation_and_then_ramp) {
    struct Case {
        Vec3 bad;
        Fault fault;
    };
    for (const Case& c : {Case{Vec3(0, kNan, 0), Fault::BadSample}, Case{Vec3(1e30), Fault::BadSample},
                          Case{kPressed + Vec3(0.05, 0, 0), Fault::Jump}}) {
        ServoRig rig;
        rig.press(kPressed);
        for (int i = 0; i < 3; ++i) EXPECT_EQ(rig.tick(c.bad).force_n, Vec3(0.0));
        EXPECT_TRUE(rig.tool().fault_latched);
        EXPECT_EQ(rig.tool().fault, c.fault);
        for (int i = 0; i < 500; ++i) ASSERT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
        EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 1);
        EXPECT_EQ(rig.tool().fault, c.fault);
        EXPECT_TRUE(is_finite(rig.tool().proxy_m));

        ++rig.tuning.confirm;
        rig.tick(kPressed);
        EXPECT_EQ(rig.tool().fault, Fault::None);
        EXPECT_EQ(rig.count(ContactEventKind::FaultCleared), 1);
        EXPECT_NEAR(rig.tool().force_gain, 1e-3, 1e-9);
        for (int i = 0; i < 1000; ++i) rig.tick(kPressed);
        EXPECT_EQ(rig.tool().force_gain, 1.0);
    }
}

TEST(ServoTick, a_tool_position_that_jumps_and_stays_is_a_jump_fault) {
    ServoRig rig;
    rig.press(kPressed);
    const Vec3 elsewhere = kPressed + Vec3(0.05, 0, 0);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(rig.tick(elsewhere).force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().fault, Fault::Jump);
    // After 3 bad samples, the servo accepts the new place as the place to compare with.
    EXPECT_EQ(rig.state.counters().bad_samples, 3u);
}

TEST(ServoTick, a_fast_hand_does_not_count_as_a_jump) {
    ServoRig rig;
    rig.arm();
    for (int i = 0; i < 200; ++i) rig.tick(Vec3(i % 2 ? 0.0095 : -0.0095, 0, 0));
    EXPECT_EQ(rig.state.counters().bad_samples, 0u);
}

TEST(ServoTick, holds_the_force_while_the_device_is_silent_and_resumes_without_a_jump) {
    ServoRig rig;
    rig.press(kPressed);
    for (int i = 0; i < 20; ++i) ASSERT_NEAR(rig.silent_tick().force_n.y, -kPressN, 1e-9);
    // While the device was silent, the hand has moved 1 mm deeper, so the renderer requests 0.8 N more. The additional
    // force must come in with a time constant of 80 ms.
    const Vec3 deeper = kPressed + Vec3(0, 0.001, 0);
    EXPECT_NEAR(rig.tick(deeper).force_n.y, -kPressN, 1e-6);
    double last = -kPressN;
    for (int i = 0; i < 800; ++i) {
        const double force = rig.tick(deeper).force_n.y;
        ASSERT_LE(force, last + 1e-12);
        ASSERT_GE(force, -kPressN - 0.8 - 1e-9);
        last = force;
    }
    EXPECT_NEAR(last, -kPressN - 0.8, 1e-3);
    EXPECT_EQ(rig.state.counters().held_gaps, 1u);
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 0);
}

TEST(ServoTick, a_device_silent_for_more_than_25_ms_gives_zero_force_and_ramps_when_it_answers) {
    ServoRig rig;
    rig.press(kPressed);
    for (int i = 1; i <= 40; ++i) {
        const Vec3 force = rig.silent_tick().force_n;
        if (i <= 25) {
            ASSERT_NEAR(force.y, -kPressN, 1e-9) << i;
        } else if (i >= 27) {
            ASSERT_EQ(force, Vec3(0.0)) << i;
        }
    }
    EXPECT_EQ(rig.tool().fault, Fault::DeviceSilent);
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 1);
    rig.tick(kPressed);
    EXPECT_EQ(rig.tool().fault, Fault::None);
    EXPECT_EQ(rig.count(ContactEventKind::FaultCleared), 1);
    EXPECT_LE(rig.tool().force_gain, 2e-3);
    const double gain = rig.tool().force_gain;
    for (int i = 0; i < 500; ++i) rig.tick(kPressed);
    EXPECT_NEAR(rig.tool().force_gain, gain + 0.5, 1e-6);
}

TEST(ServoTick, a_gap_between_ticks_up_to_25_ms_resumes_from_the_held_force) {
    ServoRig rig;
    rig.press(kPressed);
    const Vec3 deeper = kPressed + Vec3(0, 0.001, 0);
    EXPECT_NEAR(rig.tick(deeper, 0.024).force_n.y, -kPressN, 1e-6);
    EXPECT_EQ(rig.state.counters().held_gaps, 1u);
    EXPECT_EQ(rig.tool().fault, Fault::None);
    for (int i = 0; i < 800; ++i) rig.tick(deeper);
    EXPECT_NEAR(rig.last.force_n.y, -kPressN - 0.8, 1e-3);
}

TEST(ServoTick, a_longer_gap_gives_zero_force_is_announced_and_ramps_automatically) {
    ServoRig rig;
    rig.press(kPressed);
    EXPECT_EQ(rig.tick(kPressed, 0.030).force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().fault, Fault::Stalled);
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 1);
    rig.tick(kPressed);
    EXPECT_EQ(rig.tool().fault, Fault::None);
    EXPECT_NEAR(rig.tool().force_gain, 1e-3, 1e-9);
    for (int i = 0; i < 1000; ++i) rig.tick(kPressed);
    EXPECT_NEAR(rig.last.force_n.y, -kPressN, 1e-9);
}

TEST(ServoTick, a_rate_too_slow_for_20_ms_fades_to_zero_within_100_ms_of_its_onset_and_latches) {
    for (const double rate_hz : {590.0, 500.0, 200.0, 100.0, 60.0, 42.0}) {
        ServoRig rig;
        rig.press(kPressed);
        const double onset_s = rig.now_s;
        double zero_s = -1.0, last = kPressN;
        while (rig.now_s < onset_s + 0.2) {
            const double force = glm::length(rig.tick(kPressed, 1.0 / rate_hz).force_n);
            ASSERT_LE(force, last * 1.2 + 1e-9) << rate_hz;
            if (force == 0.0 && zero_s < 0.0) zero_s = rig.now_s - onset_s;
            last = force;
        }
        EXPECT_GT(zero_s, 0.02) << rate_hz;
        EXPECT_LE(zero_s, 0.1) << rate_hz;
        EXPECT_EQ(rig.tool().fault, Fault::LateLoop);
        EXPECT_TRUE(rig.tool().fault_latched);
        EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 1) << rate_hz;
        for (int i = 0; i < 300; ++i) ASSERT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
        ++rig.tuning.confirm;
        for (int i = 0; i < 1001; ++i) rig.tick(kPressed);
        EXPECT_EQ(rig.tool().fault, Fault::None);
        EXPECT_EQ(rig.tool().force_gain, 1.0);
    }
}

TEST(ServoTick, a_rate_above_the_minimum_of_the_device_keeps_the_force) {
    ServoRig rig;
    rig.press(kPressed);
    for (int i = 0; i < 200; ++i) rig.tick(kPressed, 1.0 / 610);
    EXPECT_EQ(rig.tool().fault, Fault::None);
    EXPECT_EQ(rig.tool().force_gain, 1.0);
}

TEST(ServoTick, an_unhomed_device_gets_no_force_and_moves_only_once_its_position_is_known) {
    ServoRig rig;
    rig.press(Vec3(0.0, 0.03, 0.0));
    ASSERT_GT(glm::length(rig.last.force_n), 1.0);
    rig.sample.homed = false;
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(glm::length(rig.tick(Vec3(0.5, 0.5, 0.5)).force_n), 0.0) << "where it says it is means nothing";
    EXPECT_EQ(rig.tool().fault, Fault::Unhomed);
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 1);
    rig.sample.homed = true;
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(glm::length(rig.tick(Vec3(0.0, 0.03, 0.0)).force_n), 0.0) << "inside the wall and still";
    EXPECT_EQ(rig.tool().fault, Fault::None);
    EXPECT_TRUE(rig.tool().waiting_for_hand);
    rig.go(Vec3(0.0));
    rig.go(Vec3(0.0, 0.03, 0.0));
    EXPECT_LT(glm::length(rig.last.force_n), 0.5) << "ramps in";
    for (int i = 0; i < 1100; ++i) rig.tick(Vec3(0.0, 0.03, 0.0));
    EXPECT_GT(glm::length(rig.last.force_n), 1.0);
}

TEST(ServoTick, reports_whether_an_unheld_device_may_push_regardless_of_earlier_latched_faults) {
    ServoRig rig;
    rig.press(kPressed);
    rig.sample.hot = true;
    rig.tick(Vec3(0.0));
    ASSERT_EQ(rig.tool().fault, Fault::TooHot);
    rig.sample.hot = false;
    rig.sample.loss = DeviceLoss::MayPush;
    EXPECT_EQ(rig.unplugged_tick().force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().fault, Fault::MayPush);
    rig.sample.loss = DeviceLoss::ForceOff;
    EXPECT_EQ(rig.unplugged_tick().force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().fault, Fault::ForceOff);
    EXPECT_TRUE(rig.tool().fault_latched);
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 3);
}

TEST(ServoTick, unplugging_gives_zero_on_that_tick_and_the_force_returns_only_by_confirmation_and_ramp) {
    ServoRig rig;
    rig.press(kPressed);
    const Vec3 proxy = rig.tool().proxy_m;
    EXPECT_EQ(rig.unplugged_tick().force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().fault, Fault::Unplugged);
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 1);
    EXPECT_EQ(rig.count(ContactEventKind::End), 1);
    EXPECT_EQ(rig.tool().proxy_m, proxy);
    ++rig.tuning.confirm;  // the confirmation must have no effect, because the device is still disconnected
    for (int i = 0; i < 100; ++i) ASSERT_EQ(rig.unplugged_tick().force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().fault, Fault::Unplugged);
    // The device is connected again, with the hand at any place. Until somebody confirms, the hand must feel nothing,
    // not even when it moves.
    for (int i = 0; i < 500; ++i) ASSERT_EQ(rig.tick(Vec3(0.05, 0.0001 * (i % 100), 0)).force_n, Vec3(0.0));
    ++rig.tuning.confirm;
    rig.tick(Vec3(0.05, 0, 0));
    EXPECT_EQ(rig.tool().fault, Fault::None);
    EXPECT_LE(rig.tool().force_gain, 1e-3 + 1e-9);
}

TEST(ServoTick, panic_gives_zero_on_the_same_tick_and_the_force_returns_with_the_ramp) {
    ServoRig rig;
    rig.press(kPressed);
    rig.tuning.panic = true;
    EXPECT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
    for (int i = 0; i < 50; ++i) ASSERT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
    rig.tuning.panic = false;
    EXPECT_NEAR(rig.tick(kPressed).force_n.y, -kPressN * 1e-3, 1e-9);
}

// Checks that the force fades to zero within 76 ticks and never rises while it fades.
void expect_fade_to_zero(ServoRig& rig, double from_n) {
    double last = from_n;
    for (int i = 0; i < 76; ++i) {
        const double force = glm::length(rig.tick(kPressed).force_n);
        ASSERT_LE(force, last + 1e-12) << i;
        last = force;
    }
    ASSERT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
}

TEST(ServoTick, motors_that_report_heat_lose_their_force_within_100_ms_and_need_confirmation_when_cool) {
    ServoRig rig;
    rig.press(kPressed);
    rig.sample.hot = true;
    expect_fade_to_zero(rig, kPressN);
    EXPECT_EQ(rig.tool().fault, Fault::TooHot);
    EXPECT_TRUE(rig.tool().fault_latched && rig.tool().fault_lasts);
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 1);
    ++rig.tuning.confirm;  // the confirmation must have no effect, because the motors are still hot
    for (int i = 0; i < 50; ++i) ASSERT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
    rig.sample.hot = false;
    for (int i = 0; i < 50; ++i) ASSERT_EQ(rig.tick(kPressed).force_n, Vec3(0.0)) << "cool, and not confirmed";
    EXPECT_FALSE(rig.tool().fault_lasts);
    ++rig.tuning.confirm;
    EXPECT_NEAR(rig.tick(kPressed).force_n.y, -kPressN * 1e-3, 1e-9);
    EXPECT_EQ(rig.tool().fault, Fault::None);
}

TEST(ServoTick, motors_without_heat_reports_are_protected_by_the_heat_budget) {
    ServoRig rig;  // the peak force is 3.3 N, of which the motors can sustain 80 %
    rig.tuning.force_ceiling_n = 100.0;
    rig.press(kPressed);
    const Vec3 hard = kPressed + Vec3(0, 0.005, 0);
    rig.go(hard);
    const double began_s = rig.now_s;
    while (rig.tool().fault == Fault::None && rig.now_s < began_s + 60.0) rig.tick(hard);
    EXPECT_EQ(rig.tool().fault, Fault::TooHot);
    EXPECT_NEAR(rig.now_s - began_s, -10.0 * std::log(1.0 - 0.64), 1.0);
    for (int i = 0; i < 77; ++i) rig.tick(hard);
    EXPECT_EQ(rig.last.force_n, Vec3(0.0));
    ++rig.tuning.confirm;
    rig.tick(hard);
    EXPECT_EQ(rig.tool().fault, Fault::TooHot) << "not cooled yet";
    for (int i = 0; i < 7100; ++i) ASSERT_EQ(rig.tick(hard).force_n, Vec3(0.0));
    EXPECT_FALSE(rig.tool().fault_lasts);
    ++rig.tuning.confirm;
    rig.tick(hard);
    EXPECT_EQ(rig.tool().fault, Fault::None);
}

TEST(ServoTick, a_driver_error_gives_zero_force_on_that_tick_and_latches) {
    ServoRig rig;
    rig.press(kPressed);
    rig.sample.failed = true;
    EXPECT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().fault, Fault::DriverError);
    rig.sample.failed = false;
    for (int i = 0; i < 50; ++i) ASSERT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
    ++rig.tuning.confirm;
    EXPECT_NEAR(rig.tick(kPressed).force_n.y, -kPressN * 1e-3, 1e-9);
}

TEST(ServoTick, an_overheated_device_that_disconnects_is_reported_as_hot_rather_than_unplugged) {
    ServoRig rig;
    rig.press(kPressed);
    rig.sample.hot = true;
    EXPECT_EQ(rig.unplugged_tick().force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().fault, Fault::TooHot);
    EXPECT_TRUE(rig.tool().waiting_for_hand);
    rig.sample.hot = false;
    ++rig.tuning.confirm;
    for (int i = 0; i < 50; ++i) ASSERT_EQ(rig.unplugged_tick().force_n, Vec3(0.0));
    EXPECT_TRUE(rig.tool().fault_lasts) << "not back yet";
    rig.tick(kPressed);
    EXPECT_FALSE(rig.tool().fault_lasts);
}

TEST(ServoTick, in_dead_man_mode_force_needs_a_held_button_and_ends_100_ms_after_its_release) {
    ServoRig rig;
    rig.tuning.button_to_feel = true;
    rig.press(kPressed);
    EXPECT_EQ(rig.last.force_n, Vec3(0.0));
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 0) << "nothing was taken away yet";
    rig.sample.buttons = 2;  // pressing any button is enough
    for (int i = 0; i < 1000; ++i) rig.tick(kPressed);
    EXPECT_NEAR(rig.last.force_n.y, -kPressN, 1e-6);
    rig.sample.buttons = 0;
    expect_fade_to_zero(rig, kPressN);
    EXPECT_EQ(rig.count(ContactEventKind::FaultRaised), 1);
    EXPECT_EQ(rig.first(ContactEventKind::FaultRaised).fault, Fault::ButtonReleased);
    EXPECT_EQ(rig.tool().fault, Fault::None) << "nothing is broken";
    EXPECT_EQ(rig.tool().pause, Fault::ButtonReleased);
    rig.sample.buttons = 1;
    EXPECT_NEAR(rig.tick(kPressed).force_n.y, -kPressN * 1e-3, 1e-6);
    EXPECT_EQ(rig.count(ContactEventKind::FaultCleared), 1);
}

TEST(ServoTick, without_the_keyboard_the_force_fades_and_returns_with_it_only_by_the_ramp) {
    ServoRig rig;
    rig.press(kPressed);
    rig.tuning.focused = false;
    expect_fade_to_zero(rig, kPressN);
    EXPECT_EQ(rig.first(ContactEventKind::FaultRaised).fault, Fault::FocusLost);
    EXPECT_EQ(rig.tool().contacts.count, 1) << "the wall is still met, and heard";
    rig.tuning.focused = true;
    for (int i = 1; i <= 1000; ++i) ASSERT_NEAR(rig.tick(kPressed).force_n.y, -kPressN * std::min(1.0, i * 1e-3), 1e-6);
}

TEST(ServoSwitches, only_remove_force_and_respect_a_stop_that_follows_a_released_one) {
    ServoSwitches switches;
    ServoTuning tuning;
    EXPECT_FALSE(with_switches(tuning, switches).panic);
    switches.stop();
    EXPECT_TRUE(with_switches(tuning, switches).panic);
    tuning.stops_let_go = 1;
    EXPECT_FALSE(with_switches(tuning, switches).panic);
    switches.stop();  // the person presses the stop key again while the app releases the first press
    EXPECT_TRUE(with_switches(tuning, switches).panic);
    tuning.stops_let_go = 2;
    tuning.panic = true;
    EXPECT_TRUE(with_switches(tuning, switches).panic);
    switches.focused = false;
    EXPECT_FALSE(with_switches(tuning, switches).focused);
    switches.focused = true;
    tuning.focused = false;
    EXPECT_FALSE(with_switches(tuning, switches).focused);
}

TEST(ServoTick, switching_forces_off_fades_over_75_ms_and_on_ramps_over_a_second) {
    ServoRig rig;
    rig.press(kPressed);
    rig.tuning.forces_on = false;
    for (int i = 1; i <= 74; ++i) ASSERT_NEAR(rig.tick(kPressed).force_n.y, -kPressN * (1.0 - i / 75.0), 1e-9);
    rig.tick(kPressed);
    EXPECT_NEAR(rig.tick(kPressed).force_n.y, 0.0, 1e-12);
    // The servo must still report the contact with the wall, so that the sounds can announce it.
    EXPECT_EQ(rig.tool().contacts.count, 1);
    rig.tuning.forces_on = true;
    for (int i = 1; i <= 1000; ++i) ASSERT_NEAR(rig.tick(kPressed).force_n.y, -kPressN * std::min(1.0, i * 1e-3), 1e-6);
}

TEST(ServoTick, a_new_scene_a_teleport_and_a_new_scale_ramp_from_zero) {
    for (int change = 0; change < 3; ++change) {
        ServoRig rig;
        rig.press(kPressed);
        if (change == 0) rig.scene = test::wall_scene(ServoRig::kWallY);
        if (change == 1) {
            ++rig.pose.jump;
            rig.pose.origin_m.x += 0.5;
        }
        if (change == 2) rig.tuning.touch.world_m_per_hand_m = 1.01;
        rig.tick(kPressed);
        EXPECT_NEAR(rig.tool().force_gain, 1e-3, 1e-9) << change;
        EXPECT_LE(glm::length(rig.last.force_n), 0.01) << change;
    }
}

TEST(ServoTick, without_a_scene_there_is_no_force_and_no_contact) {
    ServoRig rig;
    rig.press(kPressed);
    rig.scene = nullptr;
    EXPECT_EQ(rig.tick(kPressed).force_n, Vec3(0.0));
    EXPECT_EQ(rig.tool().contacts.count, 0);
    EXPECT_EQ(rig.count(ContactEventKind::End), 1);
    EXPECT_EQ(rig.tool().proxy_m, rig.tool().hip_m);
}

TEST(ServoTick, respects_the_persons_ceiling_and_the_devices_peak) {
    const Vec3 deep(0.0, ServoRig::kWallY - 0.005 + 0.019, 0.0);
    for (const auto& [ceiling, expected] :
         {std::pair{1.2, 1.2}, std::pair{2.5, 2.5}, std::pair{100.0, 3.3}, std::pair{kInf, 3.3}}) {
        ServoRig rig;
        rig.tuning.force_ceiling_n = ceiling;
        rig.press(kPressed);
        rig.go(deep);
        for (int i = 0; i < 50; ++i) rig.tick(deep);
        EXPECT_NEAR(rig.last.force_n.y, -expected, 1e-9);
    }
}

TEST(ServoTick, softens_walls_to_the_stiffness_that_the_device_supports_at_the_measured_rate) {
    DeviceSpec spec = *find_device_spec("sim-f");
    const auto stiffness = [&](double rate_hz) {
        ServoRig rig(spec);
        rig.tuning.touch.rated_stiffness_n_per_m = 1e9;
        rig.tuning.touch.damping_ns_per_m = 5.0;
        rig.tuning.force_ceiling_n = 8.0;
        rig.press(kPressed);
        for (int i = 0; i < 10000; ++i) rig.tick(kPressed, 1.0 / rate_hz);
        return -rig.last.force_n.y / 0.002;
    };
    EXPECT_NEAR(stiffness(1000.0), 0.8 * effective_stiffness_n_per_m(spec, 1e-3, 5.0), 1.0);
    spec.min_rate_hz = 300.0;
    EXPECT_NEAR(stiffness(500.0), 0.8 * effective_stiffness_n_per_m(spec, 2e-3, 5.0), 1.0);
}

TEST(ServoTick, in_walk_frame_the_wall_pushes_along_the_hands_own_axes) {
    ServoRig rig;
    rig.pose.heading_rad = kPi / 2;  // the walker faces east, so the wall in the north is on the left
    const Vec3 pressed(-kPressed.y, 0, 0);
    rig.press(pressed);
    EXPECT_NEAR(rig.last.force_n.x, kPressN, 1e-9);
    EXPECT_NEAR(rig.last.force_n.y, 0.0, 1e-9);
    EXPECT_NEAR(rig.tool().force_n.y, -kPressN, 1e-9);
    EXPECT_NEAR(glm::length(rig.tool().hip_m - kPressed), 0.0, 1e-12);
}

TEST(ServoTick, reports_touch_slide_and_end_with_feature_and_time) {
    ServoRig rig;
    rig.press(kPressed);
    ASSERT_EQ(rig.count(ContactEventKind::Begin), 1);
    EXPECT_EQ(rig.first(ContactEventKind::Begin).feature, ServoRig::kWall);
    for (int i = 0; i < 200; ++i) rig.tick(kPressed + Vec3(5e-5 * i, 0, 0));  // the hand slides at 5 cm/s
    EXPECT_GE(rig.count(ContactEventKind::Slide), 15);
    EXPECT_NEAR(rig.events.back().speed_m_per_s, 0.05, 0.002);
    rig.go(kPressed + Vec3(0.01, -0.01, 0));
    for (int i = 0; i < 30; ++i) rig.tick(kPressed + Vec3(0.01, -0.01, 0));
    EXPECT_EQ(rig.count(ContactEventKind::End), 1);
}

TEST(ServoTick, counts_contact_time_rate_and_buttons) {
    ServoRig rig;
    rig.press(kPressed);
    const double before = rig.tool().contact_s;
    rig.sample.buttons = 5;
    for (int i = 0; i < 2000; ++i) rig.tick(kPressed);
    EXPECT_NEAR(rig.tool().contact_s - before, 2.0, 1e-9);
    EXPECT_NEAR(rig.tool().rate_hz, 1000.0, 1.0);
    EXPECT_EQ(rig.tool().buttons, 5u);
    EXPECT_EQ(rig.tool().scene_generation, rig.scene->generation);
    EXPECT_EQ(rig.state.counters().periods.total(), rig.tool().ticks - 1);
    EXPECT_EQ(rig.state.counters().periods.quantile_s(0.99), 0.0011);
}

// Whatever a device sends, the force must be finite and below the ceiling, and the tool must stay where a hand can be.
TEST(ServoTick, is_finite_and_bounded_for_every_input) {
    const std::uint64_t seed = test::seed_of_run();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto wild = [&]() -> double {
        switch (random() % 12) {
            case 0:
                return kNan;
            case 1:
                return kInf;
            case 2:
                return -kInf;
            case 3:
                return 1e30;
            case 4:
                return -1e308;
            case 5:
                return std::numeric_limits<double>::denorm_min();
            case 6:
                return 0.3 * unit(random);
            default:
                return 0.02 * unit(random);
        }
    };
    ServoRig rig;
    rig.arm();
    for (int i = 0; i < 20000; ++i) {
        if (random() % 200 == 0) ++rig.tuning.confirm;
        if (random() % 50 == 0) rig.pose.origin_m = Vec3(wild(), wild(), 0.0);
        if (random() % 500 == 0) rig.tuning.force_ceiling_n = random() % 2 ? 2.5 : wild();
        rig.sample.fresh = random() % 10 != 0;
        rig.sample.connected = random() % 1000 != 0;
        rig.sample.hot = random() % 700 == 0;
        rig.sample.failed = random() % 900 == 0;
        rig.sample.buttons = static_cast<std::uint32_t>(random() % 3);
        if (random() % 400 == 0) rig.tuning.button_to_feel = !rig.tuning.button_to_feel;
        if (random() % 400 == 0) rig.tuning.focused = !rig.tuning.focused;
        const Vec3 sane = Vec3(0.0, 0.03 * std::sin(i * 0.005), 0.0);
        rig.tick_raw(random() % 4 == 0 ? Vec3(wild(), wild(), wild()) : sane, random() % 300 == 0 ? 0.05 : kTick);
        ASSERT_TRUE(is_finite(rig.last.force_n));
        ASSERT_LE(glm::length(rig.last.force_n), 3.3 * (1 + 1e-12));
        ASSERT_TRUE(is_finite(rig.tool().proxy_m) && is_finite(rig.tool().hip_m) && is_finite(rig.tool().hand_m));
    }
}

}  // namespace servo_tick_test
}  // namespace handrail
