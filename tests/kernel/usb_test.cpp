// Tests drivers on the kernel's own USB core: libusb over usbfs, and hidapi over usbhid and hidraw. USB/IP plugs the
// emulated devices in.
#include "haptic/drivers/falcon_device.h"
#include "haptic/drivers/usb_link.h"
#include "tests/emulators/falcon_claims.h"
#include "tests/emulators/hid_claims.h"
#include "tests/kernel/usbip_plug.h"
#include "tests/kernel/wait.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace usb_test {

std::unique_ptr<ByteLink> open_falcon_link() {
    const std::array wanted{UsbId{0x0403, 0xcb48}};
    std::unique_ptr<ByteLink> link;
    test::wait_until([&] {
        const auto found = list_usb_devices(wanted);
        if (!found || found->empty() || !found->front().permitted) return false;
        auto opened = open_usb_link(found->front());
        if (opened) link = std::move(*opened);
        return link != nullptr;
    });
    return link;
}

TEST(KernelUsb, falcon_starts_up_homes_and_rests_against_a_wall_at_the_exact_static_answer) {
    test::FalconAndItsChip falcon;
    test::UsbIpPlug plug(falcon.chip, 0, test::UsbIpPlug::Speed::Full);
    test::wake_home_and_rest_against_a_wall(open_falcon_link(), falcon.falcon, plug.lock);
    std::printf("%llu transfers\n", static_cast<unsigned long long>(plug.transfers));
}

TEST(KernelUsb, detects_unplugging_and_replugging_of_a_falcon) {
    test::FalconAndItsChip falcon;
    falcon.falcon.stage = test::FalconEmulator::Stage::Running;
    SteadyClock clock;
    for (int times = 0; times < 2; ++times) {
        test::UsbIpPlug plug(falcon.chip, 1, test::UsbIpPlug::Speed::Full);
        FalconDevice device(open_falcon_link(), clock, {});
        const auto opened = device.open();
        ASSERT_TRUE(opened) << opened.error().sentence();
        ASSERT_TRUE(device.read(clock.now_s()).connected);
        plug.unplug();
        EXPECT_TRUE(test::wait_until([&] {
            device.write({Vec3(0.0)});
            return !device.read(clock.now_s()).connected;
        }));
    }
}

TEST(KernelUsb, loses_none_of_a_thousand_dual_sense_reports_over_hidraw) {
    test::PadEmulator pad(true, false);
    test::HidOnUsb function(pad, 0x054c, 0x0ce6, "DualSense Wireless Controller");
    test::UsbIpPlug plug(function, 2, test::UsbIpPlug::Speed::Full);
    test::exchange_a_thousand_reports(test::open_hid(0x054c), PadBus::Usb, pad, plug.lock, [] {});
}

TEST(KernelUsb, space_mouse_steers_the_walker) {
    test::PuckEmulator puck;
    // This SpaceMouse has the identifier of 3Dconnexion, because the kernel has its own driver for Logitech's
    // SpaceMice.
    test::HidOnUsb function(puck, 0x256f, 0xc635, "SpaceMouse Compact");
    test::UsbIpPlug plug(function, 3, test::UsbIpPlug::Speed::Full);
    test::steer_with_a_space_mouse(test::open_hid(0x256f), puck, plug.lock, [] {});
}

}  // namespace usb_test
}  // namespace handrail
