#include "tests/emulators/falcon_claims.h"

#include <algorithm>

#include "haptic/drivers/falcon_device.h"
#include "haptic/drivers/falcon_kinematics.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {

void wake_home_and_rest_against_a_wall(std::unique_ptr<ByteLink> link, FalconEmulator& falcon, std::mutex& lock) {
    ASSERT_TRUE(link);
    const auto image = boot_image(8000);
    TemporaryFolder folder;
    FalconOptions options;
    options.firmware_files = {folder.write("falcon.bin", std::string(image.begin(), image.end()))};
    {
        const std::lock_guard guard(lock);
        falcon.firmware_wanted = image.size();
        falcon.frames_until_homed = 50;
    }
    SteadyClock clock;
    FalconDevice device(std::move(link), clock, options);
    const double opening_s = clock.now_s();
    const auto opened = device.open();
    ASSERT_TRUE(opened) << opened.error().sentence();
    std::printf("woken with %zu bytes of firmware in %.0f ms\n", image.size(), (clock.now_s() - opening_s) * 1e3);
    EXPECT_FALSE(device.firmware_was_running());
    {
        const std::lock_guard guard(lock);
        EXPECT_EQ(falcon.firmware, image);
    }

    DeviceSample sample;
    for (int i = 0; i < 2000 && !(sample.fresh && sample.homed && i > 0); ++i) sample = device.read(clock.now_s());
    ASSERT_TRUE(sample.homed);
    {
        const std::lock_guard guard(lock);
        EXPECT_EQ(falcon.frames_before_homed_with_force, 0U);
        falcon.held = false;
        falcon.push_n = {0.0, 0.0, -2.0};
    }
    constexpr int kExchanges = 1000;
    constexpr double kStiffness = 1000.0;
    const double wall_y = falcon_to_device({0.0, 0.0, 0.130}).y;
    Vec3 force{0.0};
    int unanswered = 0;
    std::vector<double> took_s;
    const double begun_s = clock.now_s();
    for (int i = 0; i < kExchanges; ++i) {
        const double at_s = clock.now_s();
        device.write({force});
        sample = device.read(at_s);
        took_s.push_back(clock.now_s() - at_s);
        ASSERT_TRUE(sample.connected && sample.homed);
        if (!sample.fresh) {  // a busy machine may deliver the sample late
            ++unanswered;
            continue;
        }
        force = {0.0, std::min(0.0, -kStiffness * (sample.position_m.y - wall_y)), 0.0};
    }
    const double all_s = clock.now_s() - begun_s;
    std::sort(took_s.begin(), took_s.end());
    std::printf("%d exchanges, %.0f per second, half within %.2f ms, 99 of 100 within %.2f ms, %d unanswered\n",
                kExchanges, kExchanges / all_s, took_s[kExchanges / 2] * 1e3, took_s[kExchanges * 99 / 100] * 1e3,
                unanswered);
    const std::lock_guard guard(lock);
    EXPECT_NEAR(falcon_to_device(falcon.grip_m).y, wall_y + 2.0 / kStiffness, 0.06e-3);
    EXPECT_LE(falcon.largest_force_n, 3.0);
    EXPECT_EQ(falcon.over_range, 0U);
    EXPECT_EQ(falcon.malformed, 0U);
}

}  // namespace handrail::test
