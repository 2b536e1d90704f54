#include "audio-cues/sinks/dropout_watch.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace handrail {
namespace dropout_watch_test {

// Simulates a device that mixes 256 samples at a time. Its clock drifts by 200 parts in a million. The loop that
// watches it is up to 20 ms late. Every `stops_every_s`, the device loses one period. Returns whether the watch reports
// dropouts within `seconds`.
bool dropped(double seconds, double stops_every_s) {
    constexpr double kPeriod_s = 256.0 / 48000.0;
    std::minstd_rand random(3);
    DropoutWatch watch;
    for (double now_s = 100.0; now_s < 100.0 + seconds; now_s += 0.005 + (random() % 20 == 0 ? 0.02 : 0.0)) {
        const double lost_s = stops_every_s > 0.0 ? std::floor((now_s - 100.0) / stops_every_s) * kPeriod_s : 0.0;
        const double played_s = (now_s - 100.0) * 1.0002 - lost_s;
        if (watch.tick(now_s, std::floor(played_s / kPeriod_s) * kPeriod_s)) return true;
    }
    return false;
}

TEST(DropoutWatch, stays_silent_about_a_device_that_keeps_up_even_if_its_watcher_is_late) {
    EXPECT_FALSE(dropped(600.0, 0.0));
}

TEST(DropoutWatch, reports_three_dropouts_within_a_minute_but_not_a_single_one) {
    EXPECT_TRUE(dropped(60.0, 10.0));
    EXPECT_TRUE(dropped(10.0, 1.5));
    EXPECT_FALSE(dropped(600.0, 60.0));
}

TEST(DropoutWatch, one_long_sleep_of_the_machine_is_one_dropout) {
    DropoutWatch watch;
    for (double t = 0.0; t < 5.0; t += 0.005) EXPECT_FALSE(watch.tick(t, t));
    for (double t = 3600.0; t < 3610.0; t += 0.005) EXPECT_FALSE(watch.tick(t, t - 3595.0));
}

}  // namespace dropout_watch_test
}  // namespace handrail
