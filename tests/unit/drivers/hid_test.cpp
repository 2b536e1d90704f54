#include <random>

#include "haptic/drivers/playstation_pad.h"
#include "haptic/drivers/space_mouse.h"
#include "tests/emulators/hid_emulators.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace hid_test {

using test::DirectHidLink;
using test::PadEmulator;
using test::PuckEmulator;

struct PadCase {
    PadModel model;
    PadBus bus;
};

class Pad : public testing::TestWithParam<PadCase> {
protected:
    PadEmulator emulator{GetParam().model == PadModel::DualSense, GetParam().bus == PadBus::Bluetooth};
    PlaystationPad pad{std::make_unique<DirectHidLink>(emulator), GetParam().model, GetParam().bus};
};

TEST_P(Pad, reports_sticks_triggers_and_buttons) {
    ASSERT_TRUE(pad.open());
    emulator.sticks = {255, 0, 128, 191};
    emulator.triggers = {51, 255};
    emulator.keys = {0x20 | 2, 0x81, 0x03};
    emulator.yaw = -1600;  // 100 degrees a second to the right
    emulator.send();
    const auto input = pad.read(0.0);
    ASSERT_TRUE(input);
    EXPECT_DOUBLE_EQ(input->left_x, 1.0);
    EXPECT_DOUBLE_EQ(input->left_y, 1.0) << "pushed away from the person is forward";
    EXPECT_DOUBLE_EQ(input->right_x, 0.0);
    EXPECT_NEAR(input->right_y, -63.0 / 127.0, 1e-12);
    EXPECT_DOUBLE_EQ(input->left_trigger, 0.2);
    EXPECT_DOUBLE_EQ(input->right_trigger, 1.0);
    EXPECT_NEAR(input->yaw_right_rad_per_s, radians_from_degrees(100.0), 1e-4);
    EXPECT_EQ(input->hat, 2);
    EXPECT_EQ(input->buttons, 0b11'1000'0001'0010U);  // the pressed keys: cross, L1, R3, PS, touch pad
}

TEST_P(Pad, takes_two_thousand_valid_outputs_and_is_at_rest_at_the_end) {
    ASSERT_TRUE(pad.open());
    for (int i = 0; i < 2000; ++i) {
        PadOutput output;
        output.strong = static_cast<std::uint8_t>(i);
        output.weak = static_cast<std::uint8_t>(255 - i);
        output.right = trigger_resists(i % 10, 1 + i % 8);
        output.left = trigger_vibrates(2, 4, 30);
        ASSERT_TRUE(pad.write(output));
        ASSERT_EQ(emulator.strong, output.strong);
        ASSERT_EQ(emulator.weak, output.weak);
        if (GetParam().model == PadModel::DualSense) {
            ASSERT_EQ(emulator.right_effect, output.right);
            ASSERT_EQ(emulator.left_effect, output.left);
        }
    }
    EXPECT_EQ(emulator.bad, 0U);
    EXPECT_EQ(emulator.sequence_breaks, 0);
    pad.close();
    EXPECT_EQ(emulator.strong, 0);
    EXPECT_EQ(emulator.weak, 0);
    EXPECT_TRUE(GetParam().model != PadModel::DualSense || emulator.right_effect == trigger_off());
}

TEST_P(Pad, rejects_reports_with_a_wrong_checksum_and_incomplete_reports) {
    ASSERT_TRUE(pad.open());
    emulator.sticks = {255, 255, 255, 255};
    if (GetParam().bus == PadBus::Bluetooth) {
        emulator.send_wrong_checksum();
        EXPECT_FALSE(pad.read(0.0));
    }
    emulator.send();
    const std::vector<std::uint8_t> whole = emulator.to_host.front();
    emulator.to_host.clear();
    for (std::size_t cut = 0; cut < whole.size(); ++cut)
        EXPECT_FALSE(parse_pad_input(GetParam().model, GetParam().bus, std::span(whole).first(cut)));
    EXPECT_TRUE(parse_pad_input(GetParam().model, GetParam().bus, whole));
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::uint8_t> bytes(random() % 100);
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
        if (const auto input = parse_pad_input(GetParam().model, GetParam().bus, bytes)) {
            EXPECT_LE(std::abs(input->left_x), 1.0);
            EXPECT_LE(input->hat, 8);
        }
    }
}

TEST_P(Pad, returns_the_newest_of_many_reports) {
    ASSERT_TRUE(pad.open());
    for (const std::uint8_t trigger : {10, 20, 51}) {
        emulator.triggers = {trigger, 0};
        emulator.send();
    }
    EXPECT_DOUBLE_EQ(pad.read(0.0)->left_trigger, 0.2);
    EXPECT_FALSE(pad.read(0.0));
}

TEST_P(Pad, counts_as_lost_when_unplugged) {
    ASSERT_TRUE(pad.open());
    emulator.unplugged = true;
    EXPECT_FALSE(pad.read(0.0));
    EXPECT_TRUE(pad.lost());
    EXPECT_FALSE(pad.write({}));
}

INSTANTIATE_TEST_SUITE_P(Models, Pad,
                         testing::Values(PadCase{PadModel::DualSense, PadBus::Usb},
                                         PadCase{PadModel::DualSense, PadBus::Bluetooth},
                                         PadCase{PadModel::DualShock4, PadBus::Usb},
                                         PadCase{PadModel::DualShock4, PadBus::Bluetooth}));

TEST(DualSense, requests_full_reports_over_bluetooth_and_reads_its_firmware) {
    PadEmulator emulator(true, true);
    emulator.version = 0x0236;
    PlaystationPad pad(std::make_unique<DirectHidLink>(emulator), PadModel::DualSense, PadBus::Bluetooth);
    ASSERT_TRUE(pad.open());
    EXPECT_TRUE(emulator.full_reports);
    EXPECT_EQ(pad.firmware(), "2.36");
    EXPECT_TRUE(emulator.rumbles_improved);
    PadEmulator old(true, false);
    old.version = 0x0210;
    PlaystationPad older(std::make_unique<DirectHidLink>(old), PadModel::DualSense, PadBus::Usb);
    ASSERT_TRUE(older.open());
    EXPECT_FALSE(old.rumbles_improved);
}

TEST(TriggerEffects, match_the_published_bytes) {
    EXPECT_EQ(trigger_resists(3, 8), (TriggerEffect{0x21, 0xF8, 0x03, 0x00, 0xFE, 0xFF, 0x3F, 0, 0, 0, 0}));
    EXPECT_EQ(trigger_clicks(2, 5, 8), (TriggerEffect{0x25, 0x24, 0x00, 7}));
    EXPECT_EQ(trigger_vibrates(9, 2, 40), (TriggerEffect{0x26, 0x00, 0x02, 0, 0, 0, 0x08, 0, 0, 40, 0}));
    for (const int odd : {-1000, -1, 0, 9, 1000})
        for (const TriggerEffect& effect :
             {trigger_resists(odd, odd), trigger_clicks(odd, odd, odd), trigger_vibrates(odd, odd, odd)}) {
            EXPECT_TRUE(effect[0] == 0x21 || effect[0] == 0x25 || effect[0] == 0x26) << "never a factory mode";
            EXPECT_LE(effect[2], 3);
        }
}

TEST(PadCues, grow_with_nearness_and_hardness_and_click_at_doorways) {
    EXPECT_EQ(pad_output_for({}).right, trigger_off());
    FingerCue wall;
    wall.nearness = 1.0;
    EXPECT_EQ(pad_output_for(wall).right, trigger_resists(2, 8));
    wall.hardness = 0.0;
    EXPECT_EQ(pad_output_for(wall).right, trigger_resists(2, 3));
    wall.material_hz = 60.0;
    EXPECT_EQ(pad_output_for(wall).right, trigger_vibrates(2, 3, 60));
    wall.doorway = true;
    EXPECT_EQ(pad_output_for(wall).right[0], 0x25);
    FingerCue odd;
    odd.nearness = odd.hardness = odd.slope = odd.knock = odd.material_hz = std::nan("");
    EXPECT_EQ(pad_output_for(odd).right, trigger_off());
    EXPECT_EQ(pad_output_for(odd).strong, 0);
}

struct Puck {
    PuckEmulator emulator;
    SpaceMouse mouse{std::make_unique<DirectHidLink>(emulator)};
};

// Pushes to the right, away from the person and up must give positive x, y and z.
TEST(SpaceMouse, right_forward_up_are_x_y_z_and_rotations_follow_the_right_hand_rule) {
    Puck puck;
    puck.emulator.send(1, {350, 0, 0});
    EXPECT_EQ(puck.mouse.poll(0.0).move, Vec3(1.0, 0.0, 0.0));
    puck.emulator.send(1, {0, -350, 0});
    EXPECT_EQ(puck.mouse.poll(0.0).move, Vec3(0.0, 1.0, 0.0));
    puck.emulator.send(1, {0, 0, -350});
    EXPECT_EQ(puck.mouse.poll(0.0).move, Vec3(0.0, 0.0, 1.0));
    puck.emulator.send(2, {0, 0, 350});
    EXPECT_EQ(puck.mouse.poll(0.0).turn, Vec3(0.0, 0.0, -1.0))
        << "about its own down axis, so clockwise seen from above";
    puck.emulator.send_all({350, 0, 0, 0, 0, -350});
    EXPECT_EQ(puck.mouse.poll(0.0).move, Vec3(1.0, 0.0, 0.0));
    EXPECT_EQ(puck.mouse.poll(0.0).turn, Vec3(0.0, 0.0, 1.0));
}

TEST(SpaceMouse, is_at_rest_inside_its_dead_band_and_when_it_falls_silent) {
    Puck puck;
    puck.emulator.send(1, {27, -27, 20});
    EXPECT_EQ(puck.mouse.poll(0.0).move, Vec3(0.0));
    puck.emulator.send(1, {200, 0, 0});
    const double half = puck.mouse.poll(1.0).move.x;
    EXPECT_GT(half, 0.1);
    EXPECT_LT(half, 0.3) << "finer than straight";
    EXPECT_EQ(puck.mouse.poll(1.09).move.x, half);
    EXPECT_EQ(puck.mouse.poll(1.11).move.x, 0.0);
    puck.emulator.send(1, {30000, -30000, 0});
    EXPECT_EQ(puck.mouse.poll(2.0).move, Vec3(1.0, 1.0, 0.0));
}

TEST(SpaceMouse, has_buttons_and_a_light_and_ignores_truncated_reports) {
    Puck puck;
    puck.emulator.send_buttons(0x80000002);
    EXPECT_EQ(puck.mouse.poll(0.0).buttons, 0x80000002U);
    EXPECT_TRUE(puck.mouse.light(true));
    EXPECT_TRUE(puck.emulator.light);
    for (const std::vector<std::uint8_t>& odd :
         {std::vector<std::uint8_t>{}, {1}, {1, 2, 3, 4, 5, 6}, {2, 0}, {0x17, 50}, {9, 9, 9, 9, 9, 9, 9, 9}})
        EXPECT_FALSE(puck.mouse.take(odd, 0.0));
    puck.emulator.unplugged = true;
    EXPECT_EQ(puck.mouse.poll(0.0).buttons, 0U);
    EXPECT_TRUE(puck.mouse.lost());
}

}  // namespace hid_test
}  // namespace handrail
