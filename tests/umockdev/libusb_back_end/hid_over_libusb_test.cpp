// Tests a DualSense and a SpaceMouse through hidapi's libusb back end, on a bus that umockdev emulates. A system
// without hidraw has only this back end.
#include "tests/emulators/hid_claims.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/umockdev/mock_usb.h"

namespace handrail {
namespace hid_over_libusb_test {

class OverHidapiLibusb : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0";
    }

    std::unique_ptr<HidLink> open(std::uint16_t vendor) {
        for (const HidDeviceInfo& info : list_hid_devices())
            if (info.vendor == vendor)
                if (auto link = open_hid_link(info)) return std::move(*link);
        return nullptr;
    }

    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
    test::PadEmulator pad_{true, false};
    test::PuckEmulator puck_;
    test::HidOnUsb pad_function_{pad_, 0x054c, 0x0ce6, "DualSense Wireless Controller"};
    test::HidOnUsb puck_function_{puck_, 0x046d, 0xc626, "SpaceNavigator"};
    test::MockUsbDevice pad_device_{bed_.bed, pad_function_, 8};
    test::MockUsbDevice puck_device_{bed_.bed, puck_function_, 9};
};

TEST_F(OverHidapiLibusb, both_devices_are_listed_by_their_bus_information) {
    const auto listed = list_hid_devices();
    ASSERT_EQ(listed.size(), 2U);
    EXPECT_EQ(listed[0].product, 0x0ce6);
    EXPECT_EQ(listed[0].product_name, "DualSense Wireless Controller");
    EXPECT_FALSE(listed[0].bluetooth);
    EXPECT_EQ(listed[1].product, 0xc626);
}

TEST_F(OverHidapiLibusb, a_dual_sense_loses_none_of_a_thousand_reports) {
    test::exchange_a_thousand_reports(open(0x054c), PadBus::Usb, pad_, pad_device_.lock, [] {});
}

TEST_F(OverHidapiLibusb, a_space_mouse_steers_the_walker) {
    test::steer_with_a_space_mouse(open(0x046d), puck_, puck_device_.lock, [] {});
}

// The back end reads on a separate thread, which must end when the device is unplugged.
TEST_F(OverHidapiLibusb, an_unplugged_pad_counts_as_lost_without_waiting) {
    PlaystationPad pad(open(0x054c), PadModel::DualSense, PadBus::Usb);
    ASSERT_TRUE(pad.open());
    {
        const std::lock_guard guard(pad_device_.lock);
        pad_device_.unplugged = true;
    }
    EXPECT_FALSE(pad.write({}));
    for (int i = 0; i < 100 && !pad.lost(); ++i) pad.read(0.1);
    EXPECT_TRUE(pad.lost());
}

}  // namespace hid_over_libusb_test
}  // namespace handrail
