#include "haptic/servo/heat_budget.h"

#include <limits>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace heat_budget_test {

double seconds_until_warm(double force_n, double sustained_n, double most_s) {
    HeatBudget heat;
    for (double t = 0.0; t < most_s; t += 1e-3) {
        heat.add(force_n, sustained_n, 1e-3);
        if (heat.too_warm()) return t;
    }
    return most_s;
}

TEST(HeatBudget, is_never_used_up_by_a_force_that_the_motors_can_sustain) {
    EXPECT_EQ(seconds_until_warm(2.64, 2.64, 600.0), 600.0);
    EXPECT_EQ(seconds_until_warm(100.0, std::numeric_limits<double>::infinity(), 60.0), 60.0);
}

// The mean square of the force must reach the limit after -T ln(1 - (sustained / force)^2).
TEST(HeatBudget, lasts_shorter_with_the_square_of_the_force) {
    EXPECT_NEAR(seconds_until_warm(3.3, 2.64, 600.0), -10.0 * std::log(1.0 - 0.64), 0.01);
    EXPECT_NEAR(seconds_until_warm(5.28, 2.64, 600.0), -10.0 * std::log(1.0 - 0.25), 0.01);
}

TEST(HeatBudget, counts_time_rather_than_ticks) {
    HeatBudget fine, coarse;
    for (int i = 0; i < 4000; ++i) fine.add(2.0, 3.0, 1e-3);
    for (int i = 0; i < 400; ++i) coarse.add(2.0, 3.0, 1e-2);
    EXPECT_NEAR(fine.warmth(), coarse.warmth(), 1e-3);
}

TEST(HeatBudget, stays_exceeded_until_half_the_heat_is_gone) {
    HeatBudget heat;
    while (!heat.too_warm()) heat.add(3.3, 2.64, 1e-3);
    double rested_s = 0.0;
    for (; heat.too_warm(); rested_s += 1e-3) heat.add(0.0, 2.64, 1e-3);
    EXPECT_NEAR(rested_s, 10.0 * std::log(2.0), 0.01);
    heat.add(2.0, 2.64, 1e-3);
    EXPECT_FALSE(heat.too_warm());
}

}  // namespace heat_budget_test
}  // namespace handrail
