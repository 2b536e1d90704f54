// The Falcon's driver through the libusb that people have, on a bus that umockdev plays.
#include <algorithm>

#include "haptic/drivers/falcon_device.h"
#include "haptic/drivers/falcon_kinematics.h"
#include "haptic/drivers/usb_link.h"
#include "tests/support/precompiled.h"
#include "tests/support/temporary_folder.h"
#include "tests/umockdev/mock_usb.h"

namespace handrail {
namespace {

constexpr UsbId kFalcon{0x0403, 0xcb48};

class FalconOverLibusb : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0"; }

    std::unique_ptr<ByteLink> open_link() {
        const std::array wanted{kFalcon};
        const auto found = list_usb_devices(wanted);
        if (!found || found->empty()) return nullptr;
        auto link = open_usb_link(found->front());
        return link ? std::move(*link) : nullptr;
    }

    // The bed first: everything after lives in its world.
    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
    test::MockFalconBus bus_{bed_.bed};
    SteadyClock clock_;
};

TEST_F(FalconOverLibusb, is_found_by_its_numbers_and_nothing_else_is) {
    const std::array both{kFalcon, UsbId{0x1451, 0}};
    const auto found = list_usb_devices(both);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 1U);
    EXPECT_EQ(found->front().bus, test::MockFalconBus::kBus);
    EXPECT_EQ(found->front().address, test::MockFalconBus::kAddress);
    EXPECT_TRUE(found->front().permitted);
    const std::array other{UsbId{0x1451, 0}};
    EXPECT_TRUE(list_usb_devices(other)->empty());
}

TEST_F(FalconOverLibusb, wakes_homes_and_rests_against_a_wall_at_the_exact_static_answer) {
    const auto image = test::boot_image(8000);
    test::TemporaryFolder folder;
    FalconOptions options;
    options.firmware_files = {folder.write("falcon.bin", std::string(image.begin(), image.end()))};
    {
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.firmware_wanted = image.size();
        bus_.falcon.frames_until_homed = 50;
    }
    auto link = open_link();
    ASSERT_TRUE(link);
    FalconDevice device(std::move(link), clock_, options);
    const double opening_s = clock_.now_s();
    const auto opened = device.open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    std::printf("woken with %zu bytes of firmware in %.0f ms\n", image.size(), (clock_.now_s() - opening_s) * 1e3);
    EXPECT_FALSE(device.firmware_was_running());
    {
        const std::lock_guard guard(bus_.lock);
        EXPECT_EQ(bus_.falcon.firmware, image);
    }

    DeviceSample sample;
    for (int i = 0; i < 2000 && !(sample.fresh && sample.homed && i > 0); ++i) sample = device.read(clock_.now_s());
    ASSERT_TRUE(sample.homed);
    {
        const std::lock_guard guard(bus_.lock);
        EXPECT_EQ(bus_.falcon.frames_before_homed_with_force, 0U);
        bus_.falcon.held = false;
        bus_.falcon.push_n = {0.0, 0.0, -2.0};
    }
    constexpr int kExchanges = 1000;
    constexpr double kStiffness = 1000.0;
    const double wall_y = falcon_to_device({0.0, 0.0, 0.130}).y;
    Vec3 force{0.0};
    int unanswered = 0;
    std::vector<double> took_s;
    const double begun_s = clock_.now_s();
    for (int i = 0; i < kExchanges; ++i) {
        const double at_s = clock_.now_s();
        device.write({force});
        sample = device.read(at_s);
        took_s.push_back(clock_.now_s() - at_s);
        ASSERT_TRUE(sample.connected && sample.homed);
        if (!sample.fresh) {  // a machine busy with other things
            ++unanswered;
            continue;
        }
        force = {0.0, std::min(0.0, -kStiffness * (sample.position_m.y - wall_y)), 0.0};
    }
    const double all_s = clock_.now_s() - begun_s;
    std::sort(took_s.begin(), took_s.end());
    std::printf("%d exchanges, %.0f per second, half within %.2f ms, 99 of 100 within %.2f ms, %d unanswered\n", kExchanges, kExchanges / all_s,
                took_s[kExchanges / 2] * 1e3, took_s[kExchanges * 99 / 100] * 1e3, unanswered);
    const std::lock_guard guard(bus_.lock);
    EXPECT_NEAR(falcon_to_device(bus_.falcon.grip_m).y, wall_y + 2.0 / kStiffness, 0.06e-3);
    EXPECT_LE(bus_.falcon.largest_force_n, 3.0);
    EXPECT_EQ(bus_.falcon.over_range, 0U);
    EXPECT_EQ(bus_.falcon.malformed, 0U);
}

TEST_F(FalconOverLibusb, is_unplugged_within_one_exchange) {
    {
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.stage = test::FalconEmulator::Stage::Running;
    }
    FalconDevice device(open_link(), clock_, {});
    ASSERT_TRUE(device.open());
    EXPECT_TRUE(device.read(clock_.now_s()).connected);
    {
        const std::lock_guard guard(bus_.lock);
        bus_.unplugged = true;
    }
    device.write({Vec3(0.0)});
    EXPECT_FALSE(device.read(clock_.now_s()).connected);
}

TEST_F(FalconOverLibusb, leaves_the_motors_at_zero_when_let_go) {
    {
        const std::lock_guard guard(bus_.lock);
        bus_.falcon.stage = test::FalconEmulator::Stage::Running;
    }
    {
        FalconDevice device(open_link(), clock_, {});
        ASSERT_TRUE(device.open());
        for (int i = 0; i < 5; ++i) device.read(clock_.now_s());
        device.write({{0.0, 2.0, 0.0}});
        const std::lock_guard guard(bus_.lock);
        EXPECT_NE(bus_.falcon.motors, (std::array<int, 3>{}));
    }
    const std::lock_guard guard(bus_.lock);
    EXPECT_EQ(bus_.falcon.motors, (std::array<int, 3>{}));
}

}  // namespace
}  // namespace handrail
