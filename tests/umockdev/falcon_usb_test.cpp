// Tests the Falcon's driver with the installed libusb, on a bus that umockdev emulates.
#include "haptic/drivers/falcon_device.h"
#include "haptic/drivers/usb_link.h"
#include "tests/emulators/falcon_claims.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/umockdev/mock_usb.h"

namespace handrail {
namespace falcon_usb_test {

constexpr UsbId kFalcon{0x0403, 0xcb48};

class FalconOverLibusb : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0";
    }

    std::unique_ptr<ByteLink> open_link() {
        const std::array wanted{kFalcon};
        const auto found = list_usb_devices(wanted);
        if (!found || found->empty()) return nullptr;
        auto link = open_usb_link(found->front());
        return link ? std::move(*link) : nullptr;
    }

    // The testbed must be the first member, because the other members connect to it.
    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
    test::MockFalconBus bus_{bed_.bed};
    SteadyClock clock_;
};

TEST_F(FalconOverLibusb, is_found_by_its_usb_numbers_and_nothing_else_is) {
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

TEST_F(FalconOverLibusb, starts_up_homes_and_rests_against_a_wall_at_the_exact_static_answer) {
    test::wake_home_and_rest_against_a_wall(open_link(), bus_.falcon, bus_.lock);
}

TEST_F(FalconOverLibusb, unplugging_is_detected_within_one_exchange) {
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

TEST_F(FalconOverLibusb, leaves_the_motors_at_zero_when_closed) {
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

}  // namespace falcon_usb_test
}  // namespace handrail
