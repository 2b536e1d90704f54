#include "haptic/drivers/falcon_kinematics.h"

#include <random>

#include "tests/emulators/falcon_emulator.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/scale.h"

namespace handrail {
namespace falcon_kinematics_test {

using test::FalconEmulator;

// Returns a random place within the sphere in which the device is used.
Vec3 random_grip(std::mt19937& random) {
    std::uniform_real_distribution<double> within(-0.04, 0.04);
    for (;;) {
        const Vec3 p{within(random), within(random), within(random)};
        if (glm::length(p) < 0.04) return p + kFalconMiddleM;
    }
}

int nearest_counts(double angle) {
    return static_cast<int>(std::lround((angle - radians_from_degrees(35.0)) / (14.25 / 110.0 * 2.0 * kPi / 1280.0)));
}

TEST(FalconKinematics, agrees_with_the_published_values_in_front_of_the_centre) {
    const Vec3 grip{0.0, 0.0, 0.12};
    const auto angles = falcon_inverse(grip);
    ASSERT_TRUE(angles);
    for (int leg = 0; leg < 3; ++leg) {
        EXPECT_NEAR(degrees_from_radians((*angles)[leg]), 23.918, 1e-3);
        EXPECT_EQ(falcon_encoder_counts((*angles)[leg]), -304);
    }
    const auto rows = falcon_jacobian(grip, *angles);
    ASSERT_TRUE(rows);
    const std::array<Vec3, 3> expected{Vec3{3.202, -10.699, 13.281}, Vec3{-10.867, 2.577, 13.281},
                                       Vec3{7.665, 8.122, 13.281}};
    for (std::size_t leg = 0; leg < 3; ++leg)
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR((*rows)[leg][axis], expected[leg][axis], 1e-3);
    EXPECT_NEAR(degrees_from_radians(falcon_inverse({0.0, 0.0, 0.15})->x), 47.24, 0.005);
    EXPECT_EQ(falcon_encoder_counts(falcon_inverse({0.0, 0.0, 0.15})->x), 336);
    // A force of 1 N along z needs 251 counts of each motor, at 10,000 counts per Nm.
    const auto torques = falcon_torques(grip, *angles, {0.0, 0.0, 1.0});
    ASSERT_TRUE(torques);
    EXPECT_NEAR(torques->x * 10000.0, 251.0, 0.5);
}

TEST(FalconKinematics, forward_after_inverse_is_within_0_06_mm_from_quantised_encoders) {
    const unsigned seed = 20250;
    std::mt19937 random(seed);
    double worst = 0.0;
    const int points = test::scaled(20000);
    for (int i = 0; i < points; ++i) {
        const Vec3 grip = random_grip(random);
        const auto angles = falcon_inverse(grip);
        ASSERT_TRUE(angles) << "seed " << seed << ", point " << i;
        Vec3 measured{0.0};
        for (int leg = 0; leg < 3; ++leg) measured[leg] = falcon_leg_angle_rad(falcon_encoder_counts((*angles)[leg]));
        // The search starts from a place where the hand might have been a moment ago, from the middle, and from a
        // random place.
        for (const Vec3& start : {grip + Vec3(0.002, -0.001, 0.003), kFalconMiddleM, random_grip(random)}) {
            const auto back = falcon_forward(measured, start);
            ASSERT_TRUE(back) << "seed " << seed << ", point " << i;
            worst = std::max(worst, glm::length(*back - grip));
        }
    }
    EXPECT_LT(worst, 0.06e-3);
    RecordProperty("worst_m", std::to_string(worst));
    std::printf("worst of %d points: %.4f mm\n", points, worst * 1e3);
}

TEST(FalconKinematics, jacobian_equals_numeric_differences) {
    const unsigned seed = 77;
    std::mt19937 random(seed);
    double worst = 0.0;
    for (int i = 0; i < test::scaled(20000); ++i) {
        const Vec3 grip = random_grip(random);
        const auto rows = falcon_jacobian(grip, *falcon_inverse(grip));
        ASSERT_TRUE(rows);
        for (int axis = 0; axis < 3; ++axis) {
            // The numeric derivative uses five points, so that it is exact to fourth order.
            constexpr double h = 2e-5;
            Vec3 step{0.0};
            step[axis] = h;
            const Vec3 numeric = (8.0 * (*falcon_inverse(grip + step) - *falcon_inverse(grip - step)) -
                                  (*falcon_inverse(grip + 2.0 * step) - *falcon_inverse(grip - 2.0 * step))) /
                                 (12.0 * h);
            for (std::size_t leg = 0; leg < 3; ++leg)
                worst = std::max(
                    worst, std::abs((*rows)[leg][axis] - numeric[static_cast<int>(leg)]) / glm::length((*rows)[leg]));
        }
    }
    EXPECT_LT(worst, 1e-6) << "relative to the row's length; seed " << seed;
    std::printf("worst relative difference: %.2e\n", worst);
}

TEST(FalconKinematics, inverse_agrees_with_bisection) {
    const unsigned seed = 5;
    std::mt19937 random(seed);
    for (int i = 0; i < test::scaled(5000); ++i) {
        const Vec3 grip = random_grip(random);
        const Vec3 ours = *falcon_inverse(grip), theirs = FalconEmulator::leg_angles_at(grip);
        for (int leg = 0; leg < 3; ++leg)
            ASSERT_NEAR(ours[leg], theirs[leg], 1e-9) << "seed " << seed << ", point " << i;
        EXPECT_EQ(falcon_encoder_counts(ours.x), nearest_counts(theirs.x));
    }
}

TEST(FalconKinematics, torques_do_the_work_of_the_force) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> newtons(-5.0, 5.0);
    FalconEmulator falcon;
    for (int i = 0; i < test::scaled(2000); ++i) {
        const Vec3 grip = random_grip(random), force{newtons(random), newtons(random), newtons(random)};
        const Vec3 torques = *falcon_torques(grip, *falcon_inverse(grip), force);
        // With this many counts per newton metre, rounding to whole counts does not affect the comparison.
        falcon.counts_per_nm = 1e6;
        const std::array<int, 3> counts{static_cast<int>(-torques.x * 1e6), static_cast<int>(-torques.y * 1e6),
                                        static_cast<int>(-torques.z * 1e6)};
        EXPECT_LT(glm::length(falcon.force_for(counts, grip) - force), 2e-4);
    }
}

TEST(FalconKinematics, returns_nothing_rather_than_a_wrong_answer) {
    const double nan = std::nan("");
    EXPECT_FALSE(falcon_inverse({0.0, 0.0, 0.5}));
    EXPECT_FALSE(falcon_inverse({0.3, 0.0, 0.12}));
    EXPECT_FALSE(falcon_inverse({nan, 0.0, 0.12}));
    EXPECT_FALSE(falcon_forward({nan, 0.4, 0.4}, kFalconMiddleM));
    EXPECT_FALSE(falcon_torques({0.0, 0.3, 0.12}, {0.4, 0.4, 0.4}, {0.0, 0.0, 1.0}));
    // Arbitrary encoder values must give either no position or one that matches the legs.
    std::mt19937 random(8);
    std::uniform_int_distribution<int> counts(-32768, 32767), near(-1500, 1500);
    int places = 0;
    for (int i = 0; i < test::scaled(20000); ++i) {
        auto& range = i % 2 ? counts : near;
        const Vec3 angles{falcon_leg_angle_rad(range(random)), falcon_leg_angle_rad(range(random)),
                          falcon_leg_angle_rad(range(random))};
        const auto grip = falcon_forward(angles, random_grip(random));
        if (!grip) continue;
        ++places;
        const auto back = falcon_inverse(*grip);
        ASSERT_TRUE(back);
        EXPECT_LT(glm::length(*back - angles), 1e-5);
    }
    EXPECT_GT(places, 10);
}

}  // namespace falcon_kinematics_test
}  // namespace handrail
