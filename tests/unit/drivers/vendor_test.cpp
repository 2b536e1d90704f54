// Tests the drivers that use the makers' libraries. Stand-in libraries replace those of the makers, and a test can make
// the stand-ins faulty.
#include <dlfcn.h>

#include <chrono>
#include <thread>

#include "haptic/drivers/dhd_device.h"
#include "haptic/drivers/hd_device.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/world_axes.h"
#include "worlds/base/clock.h"

namespace handrail {
namespace vendor_test {

using namespace std::chrono_literals;
using test::eventually;

constexpr double kStiffness = 1000.0, kPush = 2.0;

// Gives the test access to the stand-in library. The test opens the library a second time, so it gets the same instance
// as the driver.
class StandIn {
public:
    explicit StandIn(const std::string& path) : handle_(::dlopen(path.c_str(), RTLD_NOW)) {
        call<void()>("standin_reset")();
    }
    ~StandIn() { ::dlclose(handle_); }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

    template <class Function>
    Function* call(const char* name) const {
        return reinterpret_cast<Function*>(::dlsym(handle_, name));
    }
    void push(double x, double y, double z) const { call<void(double, double, double)>("standin_push")(x, y, z); }
    void place(double x, double y, double z) const { call<void(double, double, double)>("standin_place")(x, y, z); }
    void nan(bool on) const { call<void(int)>("standin_nan")(on); }
    void blocks(bool on) const { call<void(int)>("standin_blocks")(on); }

private:
    void* handle_;
};

struct Dhd : StandIn {
    Dhd() : StandIn(test::built_standin("standin_dhd")) {}
    struct Received {
        Vec3 position{0.0}, force{0.0};
        double largest = 0.0;
        int open = 0, watchdog = 0;
    };
    Received received() const {
        Received t;
        call<void(double*, double*, double*, int*, int*)>("standin_read")(&t.position.x, &t.force.x, &t.largest,
                                                                          &t.open, &t.watchdog);
        return t;
    }
};

struct Hd : StandIn {
    Hd() : StandIn(test::built_standin("standin_hd")) {}
    struct Received {
        Vec3 position_mm{0.0}, force{0.0};
        double largest = 0.0;
        int ticks = 0, disabled = 0, uncalibrated_with_force = 0;
    };
    Received received() const {
        Received t;
        call<void(double*, double*, double*, int*, int*, int*)>("standin_read")(
            &t.position_mm.x, &t.force.x, &t.largest, &t.ticks, &t.disabled, &t.uncalibrated_with_force);
        return t;
    }
};

TEST(DhdDevice, rests_against_a_wall_at_the_exact_static_answer_over_a_thousand_exchanges) {
    const Dhd dhd;
    auto device = open_dhd_device(test::built_standin("standin_dhd"));
    ASSERT_TRUE(device) << device.error().sentence();
    EXPECT_EQ((*device)->spec().name, "omega");
    EXPECT_GT(dhd.received().watchdog, 0) << "the device's own, for when this process dies";
    dhd.push(-kPush, 0.0, 0.0);  // the hand pushes away from the person
    Vec3 force{0.0};
    for (int i = 0; i < 1000; ++i) {
        const DeviceSample sample = (*device)->read(0.0);
        ASSERT_TRUE(sample.fresh && sample.connected);
        force = {0.0, std::min(0.0, -kStiffness * (sample.position_m.y - 0.01)), 0.0};
        (*device)->write({force});
    }
    EXPECT_NEAR((*device)->read(0.0).position_m.y, 0.01 + kPush / kStiffness, 1e-6);
    EXPECT_EQ((*device)->read(0.0).buttons, 2U);
    (*device)->close();
    EXPECT_EQ(dhd.received().force, Vec3(0.0));
    EXPECT_FALSE(dhd.received().open);
}

// Both makers' drivers must give x right, y forward and z up, for positions and for forces.
TEST(VendorDevices, right_forward_up_are_east_north_up_and_a_force_to_the_east_pushes_right) {
    const std::array<Vec3, 3> dhd_axes{Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1)},
        hd_axes{Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0)};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 expected{0.0};
        expected[axis] = 1.0;
        {
            const Dhd dhd;
            auto device = open_dhd_device(test::built_standin("standin_dhd"));
            ASSERT_TRUE(device);
            const Vec3 theirs = dhd_axes[static_cast<std::size_t>(axis)];
            dhd.place(0.01 * theirs.x, 0.01 * theirs.y, 0.01 * theirs.z);
            const DeviceSample seen = (*device)->read(0.0);
            EXPECT_LT(glm::length(seen.position_m - 0.01 * expected), 1e-12) << axis;
            const test::ThroughWorld through = test::through_world((*device)->spec(), seen.position_m, axis);
            test::expect_east_north_up(through, axis, 0.01, 1e-12);
            (*device)->write(through.command);
            EXPECT_LT(glm::length(dhd.received().force - theirs * through.command.force_n[axis]), 1e-9) << axis;
        }
        const Hd hd;
        auto device = open_hd_device(test::built_standin("standin_hd"));
        ASSERT_TRUE(device);
        const Vec3 theirs = hd_axes[static_cast<std::size_t>(axis)];
        hd.place(10.0 * theirs.x, 10.0 * theirs.y, 10.0 * theirs.z);
        DeviceSample seen;
        EXPECT_TRUE(eventually([&] {
            seen = (*device)->read(0.0);
            return glm::length(seen.position_m - 0.01 * expected) < 1e-9;
        })) << axis;
        EXPECT_LT(glm::length(seen.gimbal_rad - Vec3(0.1, 0.2, 0.3)), 1e-12) << "as the library tells them";
        const test::ThroughWorld through = test::through_world((*device)->spec(), seen.position_m, axis);
        test::expect_east_north_up(through, axis, 0.01, 1e-9);
        (*device)->write(through.command);
        const Vec3 pushed = theirs * through.command.force_n[axis];
        EXPECT_TRUE(eventually([&] { return glm::length(hd.received().force - pushed) < 1e-9; })) << axis;
    }
}

TEST(DhdDevice, gives_no_force_for_positions_that_are_not_numbers) {
    const Dhd dhd;
    auto device = open_dhd_device(test::built_standin("standin_dhd"));
    ASSERT_TRUE(device);
    (*device)->read(0.0);
    (*device)->write({{0.0, 2.0, 0.0}});
    EXPECT_GT(glm::length(dhd.received().force), 1.9);
    dhd.nan(true);
    EXPECT_FALSE(is_finite((*device)->read(0.0).position_m)) << "the servo judges it";
    (*device)->write({{0.0, 2.0, 0.0}});
    EXPECT_EQ(dhd.received().force, Vec3(0.0));
    for (const double odd : {std::nan(""), 1e300, 1e9}) {
        dhd.nan(false);
        (*device)->read(0.0);
        (*device)->write({{odd, 0.0, 0.0}});
        EXPECT_LE(glm::length(dhd.received().force), (*device)->spec().peak_force_n * (1.0 + 1e-12));
    }
}

TEST(VendorDevices, name_what_is_missing_in_one_sentence) {
    for (const auto& [opened, words] :
         {std::pair{open_dhd_device("/nowhere/libdhd.so"), "is not installed"},
          {open_hd_device("/nowhere/libHD.so"), "is not installed"},
          {open_dhd_device(test::built_standin("standin_dhd_lacking")), "does not contain dhdSetForce"},
          {open_hd_device(test::built_standin("standin_hd_lacking")), "does not contain hdUnschedule"}}) {
        ASSERT_FALSE(opened);
        EXPECT_THAT(opened.error().sentence(), testing::HasSubstr(words));
        EXPECT_EQ(opened.error().sentence().find('\n'), std::string::npos);
    }
    const Dhd dhd;
    dhd.call<void(int, int)>("standin_devices")(0, 33);
    const auto none = open_dhd_device(test::built_standin("standin_dhd"));
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().sentence(), testing::HasSubstr("plugged in"));
    dhd.call<void(int, int)>("standin_devices")(1, 999);
    const auto strange = open_dhd_device(test::built_standin("standin_dhd"));
    ASSERT_FALSE(strange);
    EXPECT_THAT(strange.error().sentence(), testing::HasSubstr("999"));
    EXPECT_FALSE(dhd.received().open);
    const Hd hd;
    hd.call<void(int)>("standin_present")(0);
    EXPECT_FALSE(open_hd_device(test::built_standin("standin_hd")));
}

TEST(HdDevice, rests_against_a_wall_at_the_exact_static_answer_with_calls_from_the_librarys_thread) {
    const Hd hd;
    auto device = open_hd_device(test::built_standin("standin_hd"));
    ASSERT_TRUE(device) << device.error().sentence();
    EXPECT_EQ((*device)->spec().name, "omni");
    EXPECT_DOUBLE_EQ((*device)->spec().peak_force_n, 3.0) << "the library states less than the table";
    EXPECT_DOUBLE_EQ((*device)->spec().rated_stiffness_n_per_m, 350.0);
    hd.push(0.0, 0.0, -kPush);  // the hand pushes away from the person
    double y = 0.0;
    int answers = 0;
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(test::kPatience_s);
         std::chrono::steady_clock::now() < end && !(answers > 1000 && std::abs(y - 0.012) < 1e-5);
         std::this_thread::sleep_for(200us)) {
        const DeviceSample sample = (*device)->read(0.0);
        ASSERT_TRUE(sample.connected);
        answers += sample.fresh;
        y = sample.position_m.y;
        (*device)->write({{0.0, std::min(0.0, -kStiffness * (y - 0.01)), 0.0}});
    }
    EXPECT_NEAR(y, 0.01 + kPush / kStiffness, 1e-5);
    EXPECT_GT(answers, 1000);
    EXPECT_LE(hd.received().largest, 3.0 + 1e-9);
    (*device)->close();
    EXPECT_EQ(hd.received().force, Vec3(0.0));
    EXPECT_TRUE(hd.received().disabled);
}

TEST(HdDevice, gives_no_force_before_calibration_or_at_invalid_positions) {
    const Hd hd;
    auto device = open_hd_device(test::built_standin("standin_hd"));
    ASSERT_TRUE(device);
    hd.call<void(unsigned)>("standin_calibration")(0x5002);
    std::this_thread::sleep_for(20ms);
    (*device)->write({{0.0, 1.0, 0.0}});
    std::this_thread::sleep_for(20ms);
    EXPECT_FALSE((*device)->read(0.0).homed);
    EXPECT_EQ(hd.received().force, Vec3(0.0));
    EXPECT_EQ(hd.received().uncalibrated_with_force, 0);
    // Requests a calibration update, which the driver then performs.
    hd.call<void(unsigned)>("standin_calibration")(0x5001);
    EXPECT_TRUE(eventually([&] { return (*device)->read(0.0).homed; }));
    EXPECT_TRUE(eventually([&] { return hd.received().force != Vec3(0.0); }));
    hd.nan(true);
    EXPECT_TRUE(eventually([&] { return hd.received().force == Vec3(0.0); }));
}

TEST(HdDevice, a_force_error_of_the_library_disconnects_the_device_and_overheating_is_distinguished) {
    for (const unsigned code : {0x0200U, 0x0202U}) {
        const Hd hd;
        auto device = open_hd_device(test::built_standin("standin_hd"));
        ASSERT_TRUE(device);
        (*device)->write({{0.0, 1.0, 0.0}});
        hd.call<void(unsigned)>("standin_error")(code);
        DeviceSample sample;
        EXPECT_TRUE(eventually([&] { return !(sample = (*device)->read(0.0)).connected; }));
        EXPECT_EQ(sample.hot, code == 0x0200U);
        EXPECT_EQ(sample.failed, code != 0x0200U);
        EXPECT_TRUE(eventually([&] { return hd.received().force == Vec3(0.0); }));
    }
}

// The library blocks. Reads must return immediately without a new sample. In the program, the servo then removes the
// force after 25 ms.
TEST(HdDevice, a_blocked_library_gives_no_new_samples) {
    const Hd hd;
    auto device = open_hd_device(test::built_standin("standin_hd"));
    ASSERT_TRUE(device);
    hd.blocks(true);
    std::this_thread::sleep_for(20ms);
    (*device)->read(0.0);
    const SteadyClock clock;
    const double begun_s = clock.now_s();
    EXPECT_FALSE((*device)->read(0.0).fresh);
    std::printf("a read beside a blocked library takes %.3f ms\n", (clock.now_s() - begun_s) * 1e3);
    hd.blocks(false);
}

}  // namespace vendor_test
}  // namespace handrail
