#include "haptic/servo/rate_watch.h"

#include <set>

#include "haptic/servo/fault.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/spoken_language.h"

namespace handrail {
namespace rate_watch_test {

// Returns the time in seconds until the watch reports constant periods of `period_s` as too slow; -1 if it reports
// nothing within a second.
double time_to_notice(double period_s, double min_rate_hz) {
    RateWatch watch;
    for (double t = period_s; t < 1.0; t += period_s)
        if (too_slow(watch, period_s, min_rate_hz)) return t;
    return -1.0;
}

TEST(RateWatch, notices_a_rate_below_the_limit_after_20_ms) {
    EXPECT_NEAR(time_to_notice(1.0 / 500, 600.0), 0.020, 1e-9);
    EXPECT_NEAR(time_to_notice(1.0 / 550, 600.0), 0.020, 0.002);
    EXPECT_NEAR(time_to_notice(1.0 / 100, 600.0), 0.020, 1e-9);
    EXPECT_NEAR(time_to_notice(1.0 / 250, 300.0), 0.020, 0.004);
}

TEST(RateWatch, accepts_rates_at_and_above_the_limit) {
    EXPECT_EQ(time_to_notice(1.0 / 600, 600.0), -1.0);
    EXPECT_EQ(time_to_notice(1e-3, 600.0), -1.0);
    EXPECT_EQ(time_to_notice(1.0 / 350, 300.0), -1.0);
    EXPECT_EQ(time_to_notice(0.1, 0.0), -1.0);
}

TEST(RateWatch, restarts_its_count_after_one_good_period) {
    RateWatch watch;
    for (int i = 0; i < 1000; ++i) ASSERT_FALSE(too_slow(watch, i % 9 == 8 ? 1e-3 : 2e-3, 600.0));
}

TEST(RateWatch, reports_two_gaps_but_not_one_as_a_slow_rate) {
    RateWatch watch;
    EXPECT_FALSE(too_slow(watch, 0.024, 600.0));
    RateWatch after_one = watch;
    EXPECT_FALSE(too_slow(after_one, 0.002, 600.0));
    EXPECT_FALSE(too_slow(after_one, 0.001, 600.0));
    EXPECT_TRUE(too_slow(watch, 0.024, 600.0));
    EXPECT_NEAR(watch.elapsed_s, 0.048, 1e-12);
}

TEST(PeriodHistogram, counts_every_period_in_the_matching_bucket) {
    PeriodHistogram histogram;
    for (int i = 0; i < 99; ++i) histogram.add(0.001);
    histogram.add(0.0042);
    EXPECT_EQ(histogram.total(), 100u);
    EXPECT_EQ(histogram.quantile_s(0.5), 0.0011);
    EXPECT_EQ(histogram.quantile_s(0.99), 0.0011);
    EXPECT_EQ(histogram.quantile_s(1.0), 0.005);
    EXPECT_EQ(histogram.worst_s, 0.0042);
    histogram.add(7.0);
    EXPECT_EQ(histogram.counts.back(), 1u);
    EXPECT_EQ(histogram.quantile_s(1.0), 7.0);
    EXPECT_EQ(PeriodHistogram{}.quantile_s(0.5), 0.0);
}

TEST(FaultSentence, every_fault_has_its_own_whole_sentence) {
    std::set<std::string> seen;
    for (const Fault fault : {Fault::BadSample, Fault::Jump, Fault::Unplugged, Fault::DeviceSilent, Fault::LateLoop,
                              Fault::Stalled, Fault::Unhomed, Fault::BadForce, Fault::TooHot, Fault::DriverError,
                              Fault::MayPush, Fault::ForceOff, Fault::FocusLost, Fault::ButtonReleased}) {
        const std::string sentence = fault_sentence(fault);
        EXPECT_TRUE(seen.insert(sentence).second) << sentence;
        ASSERT_GT(sentence.size(), 20u);
        EXPECT_EQ(sentence.back(), '.');
    }
    EXPECT_EQ(fault_sentence(Fault::None), "");
    const test::InLanguage german("de");
    EXPECT_EQ(fault_sentence(Fault::Unplugged), "Das Tastgerät wurde abgezogen. Alles andere läuft weiter.");
}

}  // namespace rate_watch_test
}  // namespace handrail
