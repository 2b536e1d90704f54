// Tests rumble and a joystick's forces through the kernel's own force feedback. uinput provides the device.
#include <fcntl.h>
#include <linux/uinput.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <initializer_list>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "haptic/drivers/ff_link.h"
#include "haptic/drivers/force_stick.h"
#include "tests/kernel/wait.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace force_feedback_test {

// An emulated force-feedback device. A separate thread answers the kernel; `lock` guards what the device has received.
class UserStick {
public:
    UserStick(const char* name, std::initializer_list<int> effects) : fd_(::open("/dev/uinput", O_RDWR | O_CLOEXEC)) {
        for (const int type : {EV_FF, EV_KEY, EV_ABS}) ::ioctl(fd_, UI_SET_EVBIT, type);
        ::ioctl(fd_, UI_SET_KEYBIT, BTN_TRIGGER);
        for (const int kind : effects) ::ioctl(fd_, UI_SET_FFBIT, kind);
        for (const std::uint16_t axis : {ABS_X, ABS_Y}) {
            uinput_abs_setup setup{};
            setup.code = axis;
            setup.absinfo.minimum = -512;
            setup.absinfo.maximum = 512;
            ::ioctl(fd_, UI_ABS_SETUP, &setup);
        }
        uinput_setup setup{};
        setup.id = {BUS_USB, 0x1234, 0x5678, 1};
        setup.ff_effects_max = 8;
        std::strncpy(setup.name, name, sizeof setup.name - 1);
        if (fd_ < 0 || ::ioctl(fd_, UI_DEV_SETUP, &setup) < 0 || ::ioctl(fd_, UI_DEV_CREATE) < 0)
            throw std::runtime_error("the kernel does not take an input device from here");
        thread_ = std::thread([this] { run(); });
    }
    // The test must close every node of the device before it destroys this object; otherwise the kernel waits until
    // effects are removed.
    ~UserStick() {
        ended_ = true;
        thread_.join();
        ::close(fd_);
    }
    UserStick(const UserStick&) = delete;
    UserStick& operator=(const UserStick&) = delete;

    void send(std::uint16_t type, std::uint16_t code, int value) {
        for (const input_event& event : {make(type, code, value), make(EV_SYN, SYN_REPORT, 0)})
            EXPECT_EQ(::write(fd_, &event, sizeof event), static_cast<ssize_t>(sizeof event));
    }

    std::mutex lock;
    ff_effect effect{};
    int uploads = 0, plays = 0, stops = 0, erased = 0;

private:
    static input_event make(std::uint16_t type, std::uint16_t code, int value) {
        input_event event{};
        event.type = type;
        event.code = code;
        event.value = value;
        return event;
    }
    void run() {
        while (!ended_) {
            pollfd ready{fd_, POLLIN, 0};
            input_event event{};
            if (::poll(&ready, 1, 20) <= 0 || ::read(fd_, &event, sizeof event) != static_cast<ssize_t>(sizeof event))
                continue;
            const std::lock_guard guard(lock);
            if (event.type == EV_UINPUT && event.code == UI_FF_UPLOAD) {
                uinput_ff_upload upload{};
                upload.request_id = static_cast<std::uint32_t>(event.value);
                ::ioctl(fd_, UI_BEGIN_FF_UPLOAD, &upload);
                effect = upload.effect;
                ++uploads;
                ::ioctl(fd_, UI_END_FF_UPLOAD, &upload);
            } else if (event.type == EV_UINPUT && event.code == UI_FF_ERASE) {
                uinput_ff_erase erase{};
                erase.request_id = static_cast<std::uint32_t>(event.value);
                ::ioctl(fd_, UI_BEGIN_FF_ERASE, &erase);
                ++erased;
                ::ioctl(fd_, UI_END_FF_ERASE, &erase);
            } else if (event.type == EV_FF && event.code != FF_GAIN) {
                ++(event.value > 0 ? plays : stops);
            }
        }
    }

    int fd_;
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

std::unique_ptr<FfLink> open_named(const std::string& name) {
    std::unique_ptr<FfLink> link;
    test::wait_until([&] {
        for (const FfDeviceInfo& info : list_ff_devices())
            if (info.name == name)
                if (auto opened = open_ff_link(info.path)) link = std::move(*opened);
        return link != nullptr;
    });
    return link;
}

TEST(KernelForceFeedback, pad_takes_a_thousand_rumble_updates_in_place_and_is_still_after_closing) {
    UserStick pad("Test Pad", {FF_RUMBLE, FF_GAIN});
    {
        const auto link = open_named("Test Pad");
        ASSERT_TRUE(link);
        EXPECT_TRUE(link->abilities().rumble);
        EXPECT_FALSE(link->abilities().constant);
        for (int i = 0; i < 1000; ++i) {
            ASSERT_TRUE(link->rumble(i / 1000.0, 1.0 - i / 1000.0)) << i;
            const std::lock_guard guard(pad.lock);
            ASSERT_EQ(pad.effect.type, FF_RUMBLE);
            ASSERT_EQ(pad.effect.u.rumble.strong_magnitude, std::lround(i / 1000.0 * 0xffff)) << i;
        }
    }
    EXPECT_TRUE(test::wait_until([&] {
        const std::lock_guard guard(pad.lock);
        return pad.erased == 1 && pad.stops >= 1;
    }));
    const std::lock_guard guard(pad.lock);
    EXPECT_EQ(pad.uploads, 1000);
    EXPECT_EQ(pad.plays, 1);
}

// A hand pushes the stick to the right with 2 N against a wall of 150 N/m at the stick's centre.
TEST(KernelForceFeedback, stick_rests_against_a_wall_within_one_axis_step_of_the_static_answer) {
    UserStick stick("Test Stick", {FF_CONSTANT, FF_GAIN});
    {
        auto link = open_named("Test Stick");
        ASSERT_TRUE(link);
        ForceStick device(std::move(link));
        const auto opened = device.open();
        ASSERT_TRUE(opened) << opened.error().sentence();
        constexpr double kWall = 150.0, kPushN = 2.0, kMassKg = 0.3, kDampingNsPerM = 8.0, kStep_s = 0.004;
        const double reach_m = device.spec().workspace_radius_m;
        double x_m = -0.5 * reach_m, speed = 0.0;
        for (int i = 0; i < 1000; ++i) {
            stick.send(EV_ABS, ABS_X, static_cast<int>(std::lround(x_m / reach_m * 512)));
            const DeviceSample sample = device.read(0.0);
            ASSERT_TRUE(sample.connected);
            const double wanted_n = std::min(0.0, -kWall * sample.position_m.x);
            device.write({{wanted_n, 0.0, 0.0}});
            const std::lock_guard guard(stick.lock);
            ASSERT_EQ(stick.effect.type, FF_CONSTANT);
            // The kernel's directions: 0 is down, a quarter turn is left, three quarters (0xC000) are right.
            const double towards = stick.effect.direction == 0xC000 ? 1.0 : -1.0;
            const double force_n = towards * stick.effect.u.constant.level / 0x7fff * device.spec().peak_force_n;
            EXPECT_TRUE(wanted_n == 0.0 || stick.effect.direction == 0x4000) << stick.effect.direction;
            speed += (kPushN + force_n - kDampingNsPerM * speed) / kMassKg * kStep_s;
            x_m += speed * kStep_s;
        }
        EXPECT_NEAR(x_m, kPushN / kWall, reach_m / 512);
    }
    const std::lock_guard guard(stick.lock);
    EXPECT_EQ(stick.effect.u.constant.level, 0);
}

}  // namespace force_feedback_test
}  // namespace handrail
