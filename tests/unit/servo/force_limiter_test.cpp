#include "haptic/render/force_limiter.h"

#include <limits>
#include <random>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace force_limiter_test {

constexpr double kTick = 1e-3;
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ForceLimiter ramped_in() {
    ForceLimiter limiter;
    for (int i = 0; i < 1001; ++i) limiter.limit(Vec3(0.0), 2.5, ForceFlow::Run, kTick);
    return limiter;
}

TEST(ForceLimiter, turns_nan_into_zero_force_and_reports_a_fault) {
    for (const double bad : {kNan, kInf, -kInf})
        for (int axis = 0; axis < 3; ++axis) {
            ForceLimiter limiter = ramped_in();
            Vec3 force(0.5, 0.5, 0.5);
            force[axis] = bad;
            EXPECT_EQ(limiter.limit(force, 2.5, ForceFlow::Run, kTick), Vec3(0.0));
            EXPECT_TRUE(limiter.broken());
            // After the fault, the limiter must ramp the force up from zero.
            EXPECT_NEAR(glm::length(limiter.limit(Vec3(1, 0, 0), 2.5, ForceFlow::Run, kTick)), 1e-3, 1e-12);
            EXPECT_FALSE(limiter.broken());
        }
}

TEST(ForceLimiter, passes_a_force_below_the_ceiling_bit_identically) {
    ForceLimiter limiter = ramped_in();
    const Vec3 force(0.1234567890123, -1.1, 0.7);
    EXPECT_EQ(limiter.limit(force, 2.5, ForceFlow::Run, kTick), force);
    EXPECT_EQ(limiter.limit(1e3 * force, kInf, ForceFlow::Run, kTick), 1e3 * force);
}

TEST(ForceLimiter, scales_the_vector_to_the_ceiling_and_keeps_its_direction) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0), exponent(-3.0, 308.0);
    ForceLimiter limiter = ramped_in();
    for (int i = 0; i < 2000; ++i) {
        const Vec3 direction = glm::normalize(Vec3(unit(random), unit(random), unit(random)));
        const Vec3 wanted = direction * std::pow(10.0, exponent(random));
        const Vec3 force = limiter.limit(wanted, 2.5, ForceFlow::Run, kTick);
        ASSERT_LE(glm::length(force), 2.5 * (1 + 1e-12));
        ASSERT_NEAR(glm::dot(glm::normalize(force), direction), 1.0, 1e-12) << i;
    }
    // Tests the largest finite force, with and without a ceiling.
    const Vec3 huge(std::numeric_limits<double>::max());
    EXPECT_NEAR(glm::length(limiter.limit(huge, 2.5, ForceFlow::Run, kTick)), 2.5, 1e-9);
    EXPECT_TRUE(is_finite(limiter.limit(huge, kInf, ForceFlow::Run, kTick)));
}

TEST(ForceLimiter, gives_no_force_under_an_invalid_ceiling) {
    for (const double ceiling : {0.0, -1.0, kNan}) {
        ForceLimiter limiter = ramped_in();
        EXPECT_EQ(limiter.limit(Vec3(1, 2, 3), ceiling, ForceFlow::Run, kTick), Vec3(0.0));
    }
}

TEST(ForceLimiter, ramps_in_over_one_second_and_never_early) {
    ForceLimiter limiter;
    double last = 0.0;
    for (int i = 1; i <= 1000; ++i) {
        const double force = glm::length(limiter.limit(Vec3(0, 2, 0), 2.5, ForceFlow::Run, kTick));
        ASSERT_NEAR(force, 2.0 * i * kTick, 1e-9);
        ASSERT_GE(force, last);
        last = force;
    }
    // With longer ticks, the ramp must last the same number of seconds.
    limiter.restart();
    EXPECT_NEAR(glm::length(limiter.limit(Vec3(0, 2, 0), 2.5, ForceFlow::Run, 0.01)), 0.02, 1e-12);
}

TEST(ForceLimiter, cuts_the_force_on_the_same_tick_and_fades_it_within_75_ms) {
    ForceLimiter limiter = ramped_in();
    EXPECT_EQ(limiter.limit(Vec3(0, 2, 0), 2.5, ForceFlow::Cut, kTick), Vec3(0.0));
    limiter = ramped_in();
    double last = 2.0;
    for (int i = 1; i <= 75; ++i) {
        const double force = glm::length(limiter.limit(Vec3(0, 2, 0), 2.5, ForceFlow::Fade, kTick));
        ASSERT_LT(force, last);
        ASSERT_NEAR(last - force, 2.0 / 75.0, 1e-9);
        last = force;
    }
    EXPECT_NEAR(last, 0.0, 1e-9);
    EXPECT_EQ(limiter.limit(Vec3(0, 2, 0), 2.5, ForceFlow::Fade, kTick), Vec3(0.0));
}

TEST(ForceLimiter, recovers_over_20_ms_after_a_dropout_without_a_new_ramp) {
    ForceLimiter limiter = ramped_in();
    limiter.drop_out();
    EXPECT_EQ(limiter.limit(Vec3(2, 0, 0), 2.5, ForceFlow::Run, kTick), Vec3(0.0));
    for (int i = 1; i <= 20; ++i)
        ASSERT_NEAR(limiter.limit(Vec3(2, 0, 0), 2.5, ForceFlow::Run, kTick).x, 2.0 * i / 20.0, 1e-9);
    EXPECT_NEAR(limiter.limit(Vec3(2, 0, 0), 2.5, ForceFlow::Run, kTick).x, 2.0, 1e-12);
}

TEST(ForceLimiter, resumes_after_a_gap_from_the_held_force_and_never_adds) {
    ForceLimiter limiter = ramped_in();
    EXPECT_EQ(limiter.limit(Vec3(0.5, 0, 0), 2.5, ForceFlow::Run, kTick).x, 0.5);
    limiter.resume_after_gap();
    // The hand pressed deeper during the gap. The renderer now requests 2 N, but the limiter has held 0.5 N.
    EXPECT_NEAR(limiter.limit(Vec3(2, 0, 0), 2.5, ForceFlow::Run, 0.02).x, 0.5, 1e-12);
    double offset = 1.5;
    for (int i = 0; i < 400; ++i) {
        const double force = limiter.limit(Vec3(2, 0, 0), 2.5, ForceFlow::Run, kTick).x;
        ASSERT_LE(force, 2.0);
        ASSERT_LT(2.0 - force, offset);
        offset = 2.0 - force;
        if (i == 79) {
            EXPECT_NEAR(offset, 1.5 * std::exp(-1.0), 0.02);  // the excess has decayed for one time constant of 80 ms
        }
    }
    // If the renderer requests less than the held force, the limiter must pass it unchanged, because holding more would
    // add force.
    limiter = ramped_in();
    limiter.limit(Vec3(2, 0, 0), 2.5, ForceFlow::Run, kTick);
    limiter.resume_after_gap();
    EXPECT_EQ(limiter.limit(Vec3(1, 0, 0), 2.5, ForceFlow::Run, 0.02).x, 1.0);
    // If the requested force has the opposite direction, the limited force must start from zero.
    limiter = ramped_in();
    limiter.limit(Vec3(2, 0, 0), 2.5, ForceFlow::Run, kTick);
    limiter.resume_after_gap();
    EXPECT_EQ(limiter.limit(Vec3(-1, 0, 0), 2.5, ForceFlow::Run, 0.02).x, 0.0);
}

TEST(ForceLimiter, has_no_slew_limit_in_normal_operation) {
    ForceLimiter limiter = ramped_in();
    EXPECT_EQ(limiter.limit(Vec3(0, 0, 2.4), 2.5, ForceFlow::Run, kTick).z, 2.4);
    EXPECT_EQ(limiter.limit(Vec3(0, 0, -2.4), 2.5, ForceFlow::Run, kTick).z, -2.4);
}

}  // namespace force_limiter_test
}  // namespace handrail
