// Tests gamepads and SpaceMouse pucks through the installed hidapi, on hidraw nodes that umockdev emulates.
#include <nlohmann/json.hpp>

#include "haptic/drivers/found_device.h"
#include "haptic/drivers/playstation_pad.h"
#include "tests/emulators/hid_claims.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/umockdev/mock_hidraw.h"

namespace handrail {
namespace hid_test {

using test::MockHidraw;

class OverHidapi : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0";
    }

    std::unique_ptr<HidLink> open(std::uint16_t vendor, bool bluetooth) {
        for (const HidDeviceInfo& info : list_hid_devices())
            if (info.vendor == vendor && info.bluetooth == bluetooth)
                if (auto link = open_hid_link(info)) return std::move(*link);
        return nullptr;
    }

    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
    test::PadEmulator usb_pad_{true, false}, bluetooth_pad_{true, true};
    test::PuckEmulator puck_;
    MockHidraw usb_node_{bed_.bed, usb_pad_, {0, false, 0x054c, 0x0ce6, "DualSense Wireless Controller"}};
    MockHidraw bluetooth_node_{bed_.bed, bluetooth_pad_, {1, true, 0x054c, 0x0ce6, "Wireless Controller"}};
    MockHidraw puck_node_{bed_.bed, puck_, {2, false, 0x046d, 0xc626, "SpaceNavigator"}};
};

TEST_F(OverHidapi, all_three_devices_are_listed_with_their_known_facts) {
    const auto listed = list_hid_devices();
    ASSERT_EQ(listed.size(), 3U);
    EXPECT_FALSE(listed[0].bluetooth);
    EXPECT_TRUE(listed[1].bluetooth);
    EXPECT_EQ(listed[2].usage_page, 1);
    EXPECT_EQ(listed[2].usage, 8);
    EXPECT_EQ(listed[0].product_name, "DualSense Wireless Controller");
}

TEST_F(OverHidapi, a_dual_sense_loses_none_of_a_thousand_reports_over_usb_and_bluetooth) {
    for (const bool bluetooth : {false, true}) {
        test::PadEmulator& emulator = bluetooth ? bluetooth_pad_ : usb_pad_;
        MockHidraw& node = bluetooth ? bluetooth_node_ : usb_node_;
        test::exchange_a_thousand_reports(open(0x054c, bluetooth), bluetooth ? PadBus::Bluetooth : PadBus::Usb,
                                          emulator, node.lock, [&] { node.ring(); });
        EXPECT_EQ(node.writes, 1002U) << "one on opening and one on letting go";
    }
}

TEST_F(OverHidapi, a_bluetooth_report_with_a_wrong_checksum_is_rejected) {
    PlaystationPad pad(open(0x054c, true), PadModel::DualSense, PadBus::Bluetooth);
    ASSERT_TRUE(pad.open());
    {
        const std::lock_guard guard(bluetooth_node_.lock);
        bluetooth_pad_.send_wrong_checksum();
    }
    bluetooth_node_.ring();
    EXPECT_FALSE(pad.read(0.2));
    EXPECT_FALSE(pad.lost());
}

TEST_F(OverHidapi, a_space_mouse_steers_the_walker) {
    test::steer_with_a_space_mouse(open(0x046d, false), puck_, puck_node_.lock, [&] { puck_node_.ring(); });
}

TEST_F(OverHidapi, the_devices_command_lists_pads_and_space_mice) {
    test::ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"devices", "--json"};
    const test::ProgramRun run = test::run_program(call);
    ASSERT_EQ(run.exit_status, 0) << run.err;
    const auto devices = nlohmann::json::parse(run.out)["devices"];
    ASSERT_EQ(devices.size(), 3U) << run.out;
    EXPECT_EQ(devices[0]["name"], "dualsense");
    EXPECT_EQ(devices[0]["kind"], "cues");
    EXPECT_EQ(devices[0]["firmware"], "2.24");
    EXPECT_EQ(devices[0]["rate_hz"], 250.0);
    EXPECT_EQ(devices[1]["connection"], "Bluetooth, /dev/hidraw1");
    EXPECT_EQ(devices[2]["name"], "spacemouse");
    EXPECT_EQ(devices[2]["kind"], "navigation");
    EXPECT_TRUE(devices[2]["force_limit_n"].is_null());
}

}  // namespace hid_test
}  // namespace handrail
