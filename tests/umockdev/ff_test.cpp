// Tests rumble pads and force-feedback sticks through the kernel's event interface, which umockdev emulates.
#include "tests/umockdev/mock_stick.h"

#include "haptic/drivers/ff_link.h"
#include "haptic/drivers/force_stick.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/world_axes.h"

namespace handrail {
namespace ff_test {

using test::MockStick;

class OverEvdev : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0";
    }
    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
};

TEST_F(OverEvdev, a_rumble_pad_follows_commands_and_stops_when_closed) {
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

// The stick moves in a plane: x is right, and y is away from the person. For a force to the right, the driver must send
// the kernel's direction "right", and so on.
TEST_F(OverEvdev, a_stick_maps_right_and_forward_to_east_and_north_and_pushes_right_for_a_force_east) {
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
    stick.send(EV_ABS, ABS_X, 512);
    stick.send(EV_KEY, BTN_TRIGGER, 1);
    DeviceSample sample = device.read(0.0);
    EXPECT_EQ(sample.position_m, Vec3(device.spec().workspace_radius_m, 0.0, 0.0));
    EXPECT_EQ(sample.buttons, 1U);
    stick.send(EV_ABS, ABS_X, 0);
    stick.send(EV_ABS, ABS_Y, -512);  // the person pushes the stick away
    stick.send(EV_KEY, BTN_TRIGGER, 0);
    sample = device.read(0.0);
    EXPECT_EQ(sample.position_m, Vec3(0.0, device.spec().workspace_radius_m, 0.0));
    EXPECT_EQ(sample.buttons, 0U);
    // Checks the directions through the whole conversion to the world and back. The stick moves by half of its travel
    // to the right or away. The hand is then 2 mm inside a surface, which must push it east or north.
    for (const auto& [axis, code, value, direction] :
         {std::tuple{0, ABS_X, 256, 0xC000}, std::tuple{1, ABS_Y, -256, 0x8000}}) {
        stick.send(EV_ABS, ABS_X, 0);
        stick.send(EV_ABS, ABS_Y, 0);
        stick.send(EV_ABS, static_cast<std::uint16_t>(code), value);
        const DeviceSample seen = device.read(0.0);
        const test::ThroughWorld through = test::through_world(device.spec(), seen.position_m, axis);
        test::expect_east_north_up(through, axis, 0.5 * device.spec().workspace_radius_m, 1e-9);
        device.write(through.command);
        const std::lock_guard guard(stick.lock);
        EXPECT_EQ(stick.effect.direction, direction);
        EXPECT_GT(stick.effect.u.constant.level, 0);
    }
    const double half = 0.5 * device.spec().peak_force_n;
    for (const auto& [force, direction] : {std::pair<Vec3, int>{{-half, 0, 0}, 0x4000},
                                           {{0, half, 0}, 0x8000},
                                           {{half, 0, 0}, 0xC000},
                                           {{0, -half, 0}, 0}}) {
        device.write({force});
        const std::lock_guard guard(stick.lock);
        EXPECT_EQ(stick.effect.type, FF_CONSTANT);
        EXPECT_EQ(stick.effect.direction, direction);
        EXPECT_NEAR(stick.effect.u.constant.level, 0x4000, 1);
        EXPECT_TRUE(stick.playing);
    }
}

TEST_F(OverEvdev, a_stick_never_exceeds_its_maximum_force_and_ends_at_zero) {
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

TEST_F(OverEvdev, an_unplugged_stick_is_detected_at_once) {
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

TEST_F(OverEvdev, a_rumble_only_pad_is_not_offered_as_a_hand) {
    MockStick pad(bed_.bed, false);
    ForceStick device(std::move(*open_ff_link("/dev/input/event5")));
    const auto opened = device.open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().sentence(), testing::HasSubstr("cannot give a constant force"));
}

}  // namespace ff_test
}  // namespace handrail
