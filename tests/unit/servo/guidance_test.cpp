// Tests guidance tick by tick, without a device: the pull along a path, and the lines that cross at a thing.
#include "haptic/servo/guidance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/names.h"
#include "tests/support/random_families.h"

namespace handrail {
namespace guidance_test {

constexpr double kTick_s = 1e-3, kPeak_n = 3.3;
constexpr double kMost_n = 0.8;

GuidancePath pull_to(const Vec3& goal_m, double strength = 1.0) {
    GuidancePath path;
    path.number = 1;
    path.strength = strength;
    path.points_m[0] = goal_m;
    path.count = 1;
    return path;
}

struct Led {
    explicit Led(const GuidancePath& p = {}) : path(p) {}
    Guidance guidance;
    GuidancePath path;
    Vec3 hand_m{0.0};  // position of the hand at scale 1
    Vec3 force_n{0.0};
    bool allowed = true;
    void tick() { force_n = guidance.tick(path, hand_m, 1.0, kPeak_n, allowed, kTick_s); }
    void run(double seconds) {
        for (int i = 0; i < std::lround(seconds / kTick_s); ++i) tick();
    }
    GuidancePhase phase() const { return guidance.state().phase; }
};

TEST(Guidance, ramps_in_from_zero_over_half_a_second) {
    Led led(pull_to({0.1, 0.0, 0.0}));
    led.tick();
    EXPECT_LT(glm::length(led.force_n), 1e-4);
    for (int i = 2; i <= 500; ++i) {
        led.tick();
        ASSERT_LE(glm::length(led.force_n), kMost_n * i * kTick_s / Guidance::kRamp_s + 1e-12) << i;
    }
    led.run(0.1);
    // The spring of 300 N/m pulls a resting hand with the lead of 2.5 mm. Guidance must not treat a resting hand as one
    // that resists.
    EXPECT_NEAR(led.force_n.x, 0.75, 0.02);
    led.run(5.0);
    EXPECT_EQ(led.phase(), GuidancePhase::Acts);
}

TEST(Guidance, is_at_most_08_n_and_a_quarter_of_the_device_and_scales_with_the_requested_strength) {
    for (const double peak_n : {1.0, 2.0, 3.3, 8.0, 40.0})
        for (const double strength : {1.0, 0.6, 0.3, 0.0}) {
            Guidance guidance;
            const GuidancePath path = pull_to({0.1, 0.0, 0.0}, strength);
            guidance.tick(path, Vec3(0.0), 1.0, peak_n, true, kTick_s);
            double most_n = 0.0;
            for (int i = 1; i < 1000; ++i)
                most_n = std::max(most_n, glm::length(guidance.tick(path, Vec3(-1e-5 * std::min(i, 650), 0.0, 0.0), 1.0,
                                                                    peak_n, true, kTick_s)));
            EXPECT_NEAR(most_n, strength * std::min(0.8, 0.25 * peak_n), 0.02 * strength) << peak_n << " " << strength;
            EXPECT_LE(most_n, strength * std::min(0.8, 0.25 * peak_n) + 1e-12);
        }
}

TEST(Guidance, releases_a_hand_that_resists_with_more_than_12_n_for_03_s_and_no_weaker_one) {
    const auto held_at = [](double away_m, double for_s) {
        Led led(pull_to({0.1, 0.0, 0.0}));
        led.run(1.0);
        const Vec3 rested = led.hand_m;
        led.hand_m = rested - Vec3(away_m - Guidance::kLead_m, 0.0, 0.0);
        led.run(for_s);
        return led;
    };
    EXPECT_EQ(held_at(0.0045, 0.299).phase(), GuidancePhase::Acts);
    Led gone = held_at(0.0045, 0.301);
    EXPECT_EQ(gone.phase(), GuidancePhase::LetGo);
    gone.run(0.1);
    EXPECT_EQ(gone.force_n, Vec3(0.0));
    gone.run(5.0);
    EXPECT_EQ(gone.phase(), GuidancePhase::LetGo) << "only another number begins again";
    EXPECT_EQ(held_at(0.0038, 5.0).phase(), GuidancePhase::Acts);
    // Several short resistances must not add up to a long resistance.
    Led led = held_at(0.0045, 0.2);
    led.hand_m.x += 0.002;
    led.run(0.05);
    led.hand_m.x -= 0.002;
    led.run(0.2);
    EXPECT_EQ(led.phase(), GuidancePhase::Acts);
}

TEST(Guidance, never_holds_back_a_hand_that_moves_ahead_on_the_path) {
    Led led(pull_to({0.1, 0.0, 0.0}));
    led.run(1.0);
    for (int i = 0; i < 300; ++i) {
        led.hand_m.x += 0.3e-3;  // the hand moves at 0.3 m/s
        led.tick();
        ASSERT_GE(led.force_n.x, -1e-9);
    }
    led.hand_m.x = 0.099;
    led.run(0.1);
    EXPECT_EQ(led.phase(), GuidancePhase::Arrived);
}

TEST(Guidance, ends_when_force_is_not_permitted_and_follows_one_request_after_the_other) {
    Led led(pull_to({0.1, 0.0, 0.0}));
    led.run(1.0);
    const double before_n = glm::length(led.force_n);
    led.path = pull_to({-0.1, 0.0, 0.0});
    led.path.number = 2;
    double least = 1e9, step = 0.0;
    Vec3 last = led.force_n;
    for (int i = 0; i < 200; ++i) {
        led.tick();
        least = std::min(least, glm::length(led.force_n));
        step = std::max(step, glm::length(led.force_n - last));
        last = led.force_n;
    }
    EXPECT_LT(least, 1e-3) << "the first is gone before the second begins";
    EXPECT_LE(step, before_n * kTick_s / Guidance::kFade_s + 1e-3);
    led.run(1.0);
    EXPECT_LT(led.force_n.x, -0.5);
    led.allowed = false;
    led.run(0.1);
    EXPECT_EQ(led.phase(), GuidancePhase::Ended);
    EXPECT_EQ(led.force_n, Vec3(0.0));
    led.allowed = true;
    led.run(1.0);
    EXPECT_EQ(led.phase(), GuidancePhase::Ended);
}

TEST(Guidance, rejects_invalid_paths) {
    for (const Vec3& bad : {Vec3(NAN, 0, 0), Vec3(INFINITY, 0, 0)}) {
        Led led(pull_to(bad));
        led.run(1.0);
        EXPECT_EQ(led.force_n, Vec3(0.0));
        EXPECT_EQ(led.phase(), GuidancePhase::Off);
    }
    for (const std::uint32_t count : {0U, GuidancePath::kMostPoints + 1}) {
        Led led(pull_to({0.1, 0, 0}));
        led.path.count = count;
        led.run(1.0);
        EXPECT_EQ(led.force_n, Vec3(0.0));
    }
    Led points(pull_to({0.0, 0.0, 0.0}));
    points.path.count = GuidancePath::kMostPoints;  // all points are at one place
    points.run(0.2);
    EXPECT_EQ(points.phase(), GuidancePhase::Arrived);
}

TEST(Guidance, follows_a_path_with_corners) {
    Led led;
    led.path.number = 1;
    for (const Vec3& p : {Vec3(0.02, 0, 0), Vec3(0.02, 0.03, 0), Vec3(0.02, 0.03, 0), Vec3(-0.01, 0.03, 0.02)})
        led.path.points_m[led.path.count++] = p;
    // The simulated hand has no mass and much damping, so it moves exactly in the direction of the force.
    double farthest_m = 0.0;
    int ticks = 0;
    for (; ticks < 10000 && led.phase() != GuidancePhase::Arrived; ++ticks) {
        led.tick();
        led.hand_m += led.force_n * (kTick_s / 6.0);
        double off_m = 1e9;
        Vec3 from(0.0);
        for (std::uint32_t k = 0; k < led.path.count; ++k) {
            const Vec3 leg = led.path.points_m[k] - from;
            const double l2 = std::max(1e-18, glm::dot(leg, leg));
            off_m = std::min(
                off_m,
                glm::length(from + leg * std::clamp(glm::dot(led.hand_m - from, leg) / l2, 0.0, 1.0) - led.hand_m));
            from = led.path.points_m[k];
        }
        farthest_m = std::max(farthest_m, off_m);
    }
    EXPECT_EQ(led.phase(), GuidancePhase::Arrived);
    EXPECT_LT(farthest_m, 0.0025);
    EXPECT_LT(ticks, 4000);  // the path is 91 mm long, so at 40 mm/s it takes a little less than 4,000 ticks
}

TEST(CrossLines, equal_the_slope_of_a_potential_and_never_exceed_their_limits) {
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> place(-0.01, 0.01);
    GuidancePath path;
    path.number = 1;
    path.kind = GuidanceKind::CrossLines;
    path.count = 1;
    Guidance guidance;
    guidance.tick(path, Vec3(0.0), 1.0, kPeak_n, true, kTick_s);
    for (int i = 0; i < 600; ++i) guidance.tick(path, Vec3(0.0), 1.0, kPeak_n, true, kTick_s);
    const auto at = [&](const Vec3& p) { return guidance.tick(path, p, 1.0, kPeak_n, true, kTick_s); };
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p(place(random), place(random), place(random));
        const Vec3 f = at(p);
        EXPECT_LE(glm::length(f), 0.7);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(std::abs(f[axis]), Guidance::kLine_n + 1e-12);
            if (std::abs(p[axis]) > Guidance::kLineHalfWidth_m) EXPECT_EQ(f[axis], 0.0);
            else EXPECT_LE(f[axis] * p[axis], 0.0) << "towards the line";
        }
    }
    // On a closed loop, the lines must give the hand no energy. The test adds up force times distance around a random
    // polygon in fine steps.
    for (int loop = 0; loop < 20; ++loop) {
        std::vector<Vec3> corners;
        for (int i = 0; i < 5; ++i) corners.emplace_back(place(random), place(random), place(random));
        corners.push_back(corners.front());
        double work_j = 0.0;
        Vec3 before = at(corners[0]);
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            for (int k = 1; k <= 400; ++k) {
                const Vec3 now = at(corners[i] + (corners[i + 1] - corners[i]) * (k / 400.0));
                work_j += glm::dot(0.5 * (before + now), (corners[i + 1] - corners[i]) / 400.0);
                before = now;
            }
        EXPECT_NEAR(work_j, 0.0, 1e-7);
    }
}

// Returns a path with a corner, stairs, a doorway next to it and a leg that runs back. So its legs meet, cross and run
// side by side.
GuidancePath grooves() {
    GuidancePath path;
    path.number = 1;
    path.kind = GuidanceKind::Grooves;
    for (const Vec3& p :
         {Vec3(-0.02, 0, 0), Vec3(0.01, 0, 0), Vec3(0.01, 0, 0), Vec3(0.01, 0.015, 0), Vec3(0.01, 0.015, 0),
          Vec3(-0.01, 0.02, 0.012), Vec3(0, -0.005, 0), Vec3(0, 0.005, 0), Vec3(-0.02, 0.004, 0), Vec3(0.01, 0.004, 0)})
        path.points_m[path.count++] = p;
    return path;
}

struct Felt {
    Guidance guidance;
    GuidancePath path = grooves();
    explicit Felt(GuidanceKind kind = GuidanceKind::Grooves) {
        path.kind = kind;
        for (int i = 0; i < 600; ++i) at(Vec3(1.0));
    }
    Vec3 at(const Vec3& p) { return guidance.tick(path, p, 1.0, kPeak_n, true, kTick_s); }
};

// The reference potential. It finds the nearest place of each groove by trying many places along the leg. The test
// derives the slope from neighbouring values.
double potential_by_looking(const GuidancePath& path, const Vec3& p) {
    const double w = Guidance::kGrooveHalfWidth_m;
    double left = 1.0;
    for (std::uint32_t i = 0; i + 1 < path.count; i += 2) {
        double nearest = 1e300;
        for (int k = 0; k <= 4000; ++k) {
            Vec3 place = path.points_m[i] + (path.points_m[i + 1] - path.points_m[i]) * (k / 4000.0);
            if (path.kind == GuidanceKind::Grooves) place.z = std::min(place.z, p.z);
            nearest = std::min(nearest, glm::length(p - place));
        }
        const double rest = std::max(0.0, 1.0 - nearest * nearest / (w * w));
        left *= 1.0 - rest * rest * rest;
    }
    return Guidance::kGroove_n * w / 1.7173003580037202 * left;
}

void expect_the_slope_of_the_potential(GuidanceKind kind) {
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> place(-0.025, 0.025);
    Felt felt(kind);
    int inside = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 p(place(random), place(random), 0.5 * place(random));
        const Vec3 force = felt.at(p);
        inside += force != Vec3(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 step(0.0);
            step[axis] = 2e-5;
            const double slope =
                (potential_by_looking(felt.path, p - step) - potential_by_looking(felt.path, p + step)) / 4e-5;
            EXPECT_NEAR(force[axis], slope, 4e-3) << i << " axis " << axis;
        }
    }
    EXPECT_GT(inside, 40);
}

TEST(Grooves, equal_the_slope_of_a_potential_found_by_exhaustive_search) {
    expect_the_slope_of_the_potential(GuidanceKind::Grooves);
}
TEST(PathLines, equal_the_slope_of_a_potential_found_by_exhaustive_search) {
    expect_the_slope_of_the_potential(GuidanceKind::PathLines);
}

TEST(PathLines, hold_a_hand_from_all_sides_let_it_slide_along_and_never_exceed_their_limit) {
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> place(-0.025, 0.025);
    Felt felt(GuidanceKind::PathLines);
    for (double x = -0.018; x < -0.008; x += 1e-3) {
        EXPECT_LT(glm::length(felt.at({x, 0.0, 0.0})), 1e-12) << "on the way nothing is felt";
        EXPECT_GT(felt.at({x, 0.0, -0.003}).z, 0.2) << "from below as from above";
        EXPECT_LT(felt.at({x, 0.0, 0.003}).z, -0.2);
        EXPECT_EQ(felt.at({x, 0.0, -0.0061}), Vec3(0.0));
    }
    EXPECT_GT(felt.at({-0.023, 0.0, 0.0}).x, 0.2) << "behind its beginning it holds back";
    double most_n = 0.0;
    for (int i = 0; i < 20000; ++i)
        most_n = std::max(most_n, glm::length(felt.at({place(random), place(random), 0.3 * place(random)})));
    EXPECT_LE(most_n, Guidance::kMostForce_n);
    EXPECT_GT(most_n, 0.3);
    for (const double peak_n : {1.0, 3.3, 8.0}) {
        Felt other(GuidanceKind::PathLines);
        for (int i = 0; i < 2000; ++i)
            EXPECT_LE(glm::length(other.guidance.tick(other.path, {place(random), place(random), 0.0}, 1.0, peak_n,
                                                      true, kTick_s)),
                      std::min(Guidance::kMostForce_n, Guidance::kMostShare * peak_n) + 1e-12);
    }
}

TEST(Grooves, hold_a_hand_on_the_route_let_it_slide_along_and_never_exceed_their_limit) {
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> place(-0.025, 0.025);
    Felt felt;
    for (double x = -0.018; x < -0.008; x += 1e-3) {
        EXPECT_LT(glm::length(felt.at({x, 0.0, 0.0})), 1e-12) << "on the way nothing is felt";
        EXPECT_LT(felt.at({x, -0.003, 0.0}).z, 1e-12) << "and no floor is lifted";
        EXPECT_GT(felt.at({x, -0.003, 0.0}).y, 0.25);
        EXPECT_GT(felt.at({x, -0.003, -0.004}).y, 0.25) << "pressed into the floor, it holds as well";
        EXPECT_LT(felt.at({x, 0.0, 0.003}).z, -0.2) << "over it, it is a hollow";
        EXPECT_EQ(felt.at({x, -0.0061, 0.0}), Vec3(0.0));
    }
    double most_n = 0.0, per_m = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p(place(random), place(random), 0.3 * place(random));
        const Vec3 near = p + Vec3(place(random), place(random), place(random)) * 1e-3;
        const Vec3 a = felt.at(p), b = felt.at(near);
        most_n = std::max(most_n, glm::length(a));
        per_m = std::max(per_m, glm::length(a - b) / glm::length(p - near));
    }
    EXPECT_LE(most_n, 0.8);
    EXPECT_GT(most_n, 0.3);
    EXPECT_LE(per_m, 700.0)
        << "newtons a metre: a hand at 0.1 m/s feels changes below 0.07 N a tick, wherever legs meet";
    for (const double peak_n : {1.0, 3.3, 8.0}) {
        Felt other;
        for (int i = 0; i < 2000; ++i)
            EXPECT_LE(glm::length(other.guidance.tick(other.path, {place(random), place(random), 0.0}, 1.0, peak_n,
                                                      true, kTick_s)),
                      std::min(0.8, 0.25 * peak_n) + 1e-12);
    }
}

TEST(Grooves, give_no_energy_on_closed_paths_and_appear_and_vanish_without_a_jump) {
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> place(-0.02, 0.02);
    Felt felt;
    for (int loop = 0; loop < 30; ++loop) {
        std::vector<Vec3> corners;
        for (int i = 0; i < 6; ++i) corners.emplace_back(place(random), place(random), 0.3 * place(random));
        corners.push_back(corners.front());
        double work_j = 0.0;
        Vec3 before = felt.at(corners[0]);
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            for (int k = 1; k <= 600; ++k) {
                const Vec3 now = felt.at(corners[i] + (corners[i + 1] - corners[i]) * (k / 600.0));
                work_j += glm::dot(0.5 * (before + now), (corners[i + 1] - corners[i]) / 600.0);
                before = now;
            }
        EXPECT_NEAR(work_j, 0.0, 2e-7);
    }
    // Guidance starts and ends while the hand rests on the slope of a groove.
    Guidance guidance;
    GuidancePath path = grooves();
    const Vec3 slope(-0.015, -0.003, 0.0);
    Vec3 last(0.0);
    const auto tick = [&](bool allowed) {
        const Vec3 force = guidance.tick(path, slope, 1.0, kPeak_n, allowed, kTick_s);
        EXPECT_LE(glm::length(force - last), 0.35 * kTick_s / Guidance::kFade_s + 1e-12);
        last = force;
    };
    for (int i = 0; i < 700; ++i) tick(true);
    EXPECT_GT(glm::length(last), 0.25);
    path.number = 2;
    path.points_m[0].x -= 0.01;
    for (int i = 0; i < 700; ++i) tick(true);
    EXPECT_GT(glm::length(last), 0.25);
    for (int i = 0; i < 100; ++i) tick(false);
    EXPECT_EQ(last, Vec3(0.0));
}

}  // namespace guidance_test
}  // namespace handrail
