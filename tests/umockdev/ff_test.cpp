// Rumble pads and force-feedback sticks through the kernel's event interface, played by umockdev.
#include <errno.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <umockdev.h>

#include <cstring>
#include <deque>
#include <mutex>
#include <stdexcept>

#include "haptic/drivers/ff_link.h"
#include "haptic/drivers/force_stick.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace {

// The kernel's side of one event node with force feedback, and the hand on its stick.
class MockStick {
public:
    MockStick(UMockdevTestbed* bed, bool constant) : constant_(constant) {
        const std::string device =
            "P: /devices/virtual/input/input5/event5\nN: input/event5\nE: DEVNAME=/dev/input/event5\nE: SUBSYSTEM=input\nE: MAJOR=13\nE: MINOR=69\n";
        GError* error = nullptr;
        if (!umockdev_testbed_add_from_string(bed, device.c_str(), &error)) throw std::runtime_error(error->message);
        handler_ = umockdev_ioctl_base_new();
        g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(on_ioctl), this);
        g_signal_connect(handler_, "handle-read", G_CALLBACK(on_read), this);
        g_signal_connect(handler_, "handle-write", G_CALLBACK(on_write), this);
        if (!umockdev_testbed_attach_ioctl(bed, "/dev/input/event5", handler_, &error)) throw std::runtime_error(error->message);
    }
    ~MockStick() {
        g_signal_handlers_disconnect_by_data(handler_, this);
        g_object_unref(handler_);
    }
    MockStick(const MockStick&) = delete;
    MockStick& operator=(const MockStick&) = delete;

    void tell(std::uint16_t type, std::uint16_t code, int value) {
        const std::lock_guard guard(lock);
        input_event event{};
        event.type = type;
        event.code = code;
        event.value = value;
        events.push_back(event);
    }

    std::mutex lock;
    std::deque<input_event> events;
    ff_effect effect{};
    bool loaded = false, playing = false, unplugged = false;
    int uploads = 0, gain = -1, bad_uploads = 0;

private:
    static gboolean complete(UMockdevIoctlClient* client, long result, int error) {
        umockdev_ioctl_client_complete(client, result, error);
        return TRUE;
    }
    static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        auto& stick = *static_cast<MockStick*>(self);
        const std::lock_guard guard(stick.lock);
        const auto request = static_cast<unsigned long>(umockdev_ioctl_client_get_request(client));
        if (_IOC_TYPE(request) != 'E') return FALSE;
        if (stick.unplugged) return complete(client, -1, ENODEV);
        const unsigned number = _IOC_NR(request);
        const std::size_t size = _IOC_SIZE(request);
        UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
        if (number == _IOC_NR(EVIOCRMFF)) {
            stick.loaded = stick.playing = false;
            return complete(client, 0, 0);
        }
        UMockdevIoctlData* data = umockdev_ioctl_data_resolve(argument, 0, size, nullptr);
        if (!data) return complete(client, -1, EFAULT);
        if (number == 0x20 + EV_FF) {
            std::memset(data->data, 0, size);
            const auto set = [&](unsigned bit) { data->data[bit / 8] = static_cast<guint8>(data->data[bit / 8] | 1U << (bit % 8)); };
            set(FF_RUMBLE);
            if (stick.constant_) set(FF_CONSTANT);
            set(FF_GAIN);
            return complete(client, static_cast<long>(size), 0);
        }
        if (number == 0x40 + ABS_X || number == 0x40 + ABS_Y) {
            if (!stick.constant_) return complete(client, -1, EINVAL);
            input_absinfo axis{};
            axis.minimum = -512;
            axis.maximum = 512;
            std::memcpy(data->data, &axis, sizeof axis);
            return complete(client, 0, 0);
        }
        if (number == 0x06) {
            std::memcpy(data->data, "Test Stick", 11);
            return complete(client, 11, 0);
        }
        if (number == _IOC_NR(EVIOCSFF)) {
            ff_effect wanted{};
            std::memcpy(&wanted, data->data, sizeof wanted);
            if (wanted.id < -1 || wanted.id > 0 || (wanted.id == 0 && !stick.loaded)) {
                ++stick.bad_uploads;
                return complete(client, -1, EINVAL);
            }
            wanted.id = 0;
            stick.effect = wanted;
            stick.loaded = true;
            ++stick.uploads;
            std::memcpy(data->data, &wanted, sizeof wanted);
            return complete(client, 0, 0);
        }
        return complete(client, -1, EINVAL);
    }
    static gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        auto& stick = *static_cast<MockStick*>(self);
        UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
        const std::lock_guard guard(stick.lock);
        if (stick.unplugged) return complete(client, -1, ENODEV);
        if (stick.events.empty()) return complete(client, -1, EAGAIN);
        std::size_t size = 0;
        for (; !stick.events.empty() && size + sizeof(input_event) <= static_cast<std::size_t>(data->data_len); size += sizeof(input_event)) {
            std::memcpy(data->data + size, &stick.events.front(), sizeof(input_event));
            stick.events.pop_front();
        }
        return complete(client, static_cast<long>(size), 0);
    }
    static gboolean on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        auto& stick = *static_cast<MockStick*>(self);
        UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
        const std::lock_guard guard(stick.lock);
        if (stick.unplugged) return complete(client, -1, ENODEV);
        input_event event{};
        std::memcpy(&event, data->data, sizeof event);
        if (event.type == EV_FF && event.code == FF_GAIN) stick.gain = event.value;
        else if (event.type == EV_FF && event.code == 0) stick.playing = event.value > 0;
        return complete(client, static_cast<long>(data->data_len), 0);
    }

    bool constant_;
    UMockdevIoctlBase* handler_ = nullptr;
};

class OverEvdev : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0"; }
    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
};

TEST_F(OverEvdev, rumble_pad_rumbles_as_told_and_stops_when_let_go) {
    MockStick pad(bed_.bed, false);
    const auto listed = list_ff_devices();
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_EQ(listed[0].name, "Test Stick");
    EXPECT_TRUE(listed[0].abilities.rumble);
    EXPECT_FALSE(listed[0].abilities.constant);
    {
        auto link = open_ff_link(listed[0].path);
        ASSERT_TRUE(link);
        for (int i = 0; i <= 100; ++i) ASSERT_TRUE((*link)->rumble(i / 100.0, 1.0 - i / 100.0));
        const std::lock_guard guard(pad.lock);
        EXPECT_TRUE(pad.playing);
        EXPECT_EQ(pad.effect.type, FF_RUMBLE);
        EXPECT_EQ(pad.effect.u.rumble.strong_magnitude, 0xffff);
        EXPECT_EQ(pad.effect.u.rumble.weak_magnitude, 0);
        EXPECT_EQ(pad.uploads, 101) << "one effect, replaced in place";
        EXPECT_EQ(pad.bad_uploads, 0);
    }
    const std::lock_guard guard(pad.lock);
    EXPECT_FALSE(pad.playing);
    EXPECT_FALSE(pad.loaded);
}

// S126 in the plane: right is x, away from the person is y; a force right has the kernel's direction right, and so on.
TEST_F(OverEvdev, stick_right_and_forward_are_x_and_y_and_forces_point_the_same_way) {
    MockStick stick(bed_.bed, true);
    auto link = open_ff_link("/dev/input/event5");
    ASSERT_TRUE(link);
    ForceStick device(std::move(*link));
    const auto opened = device.open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    {
        const std::lock_guard guard(stick.lock);
        EXPECT_EQ(stick.gain, 0xffff);
    }
    stick.tell(EV_ABS, ABS_X, 512);
    stick.tell(EV_KEY, BTN_TRIGGER, 1);
    DeviceSample sample = device.read(0.0);
    EXPECT_EQ(sample.position_m, Vec3(device.spec().workspace_radius_m, 0.0, 0.0));
    EXPECT_EQ(sample.buttons, 1U);
    stick.tell(EV_ABS, ABS_X, 0);
    stick.tell(EV_ABS, ABS_Y, -512);  // pushed away
    stick.tell(EV_KEY, BTN_TRIGGER, 0);
    sample = device.read(0.0);
    EXPECT_EQ(sample.position_m, Vec3(0.0, device.spec().workspace_radius_m, 0.0));
    EXPECT_EQ(sample.buttons, 0U);
    const double half = 0.5 * device.spec().peak_force_n;
    for (const auto& [force, direction] : {std::pair<Vec3, int>{{-half, 0, 0}, 0x4000}, {{0, half, 0}, 0x8000}, {{half, 0, 0}, 0xC000}, {{0, -half, 0}, 0}}) {
        device.write({force});
        const std::lock_guard guard(stick.lock);
        EXPECT_EQ(stick.effect.type, FF_CONSTANT);
        EXPECT_EQ(stick.effect.direction, direction);
        EXPECT_NEAR(stick.effect.u.constant.level, 0x4000, 1);
        EXPECT_TRUE(stick.playing);
    }
}

TEST_F(OverEvdev, stick_never_pushes_harder_than_it_can_and_lets_go_at_zero) {
    MockStick stick(bed_.bed, true);
    {
        ForceStick device(std::move(*open_ff_link("/dev/input/event5")));
        ASSERT_TRUE(device.open());
        for (const Vec3& odd : {Vec3(1e9, 0, 0), Vec3(-1e9, 1e9, 0)}) {
            device.write({odd});
            const std::lock_guard guard(stick.lock);
            EXPECT_EQ(stick.effect.u.constant.level, 0x7fff);
        }
        for (const Vec3& odd : {Vec3(NAN, 0, 0), Vec3(0, INFINITY, 0), Vec3(0, 0, 5)}) {
            device.write({odd});
            const std::lock_guard guard(stick.lock);
            EXPECT_EQ(stick.effect.u.constant.level, 0);
        }
        device.write({{1, 0, 0}});
    }
    const std::lock_guard guard(stick.lock);
    EXPECT_EQ(stick.effect.u.constant.level, 0);
    EXPECT_FALSE(stick.playing);
}

TEST_F(OverEvdev, unplugged_stick_is_seen_at_once) {
    MockStick stick(bed_.bed, true);
    ForceStick device(std::move(*open_ff_link("/dev/input/event5")));
    ASSERT_TRUE(device.open());
    EXPECT_TRUE(device.read(0.0).connected);
    {
        const std::lock_guard guard(stick.lock);
        stick.unplugged = true;
    }
    EXPECT_FALSE(device.read(0.0).connected);
}

TEST_F(OverEvdev, a_pad_that_only_rumbles_is_no_hand) {
    MockStick pad(bed_.bed, false);
    ForceStick device(std::move(*open_ff_link("/dev/input/event5")));
    const auto opened = device.open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().sentence(), testing::HasSubstr("no constant force"));
}

}  // namespace
}  // namespace handrail
