// Tests measures against numbers worked out by hand, and against the simplest way to compute them.
#include "app/results/measures.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace handrail {
namespace measures_test {

constexpr double kDegree = std::numbers::pi / 180.0;

// Returns a walk at 1 m/s along straight lines, with ten positions a second.
std::vector<WalkedPoint> walk_along(const std::vector<Vec3>& corners) {
    std::vector<WalkedPoint> walk{{0.0, corners.front()}};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Vec3 from = corners[i - 1], to = corners[i];
        const int steps = std::max(1, static_cast<int>(std::lround(glm::length(to - from) * 10.0)));
        for (int s = 1; s <= steps; ++s)
            walk.push_back({walk.back().t_s + 0.1, from + (to - from) * (static_cast<double>(s) / steps)});
    }
    return walk;
}

TEST(WalkedLength, counts_places_a_quarter_of_a_metre_apart_without_leaps_and_swaying) {
    EXPECT_NEAR(walked_length_m(walk_along({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}})), 7.0, 0.3);
    std::vector<WalkedPoint> sways;
    for (int i = 0; i < 100; ++i) sways.push_back({i * 0.1, {i % 2 == 0 ? 0.0 : 0.2, 0.0, 0.0}});
    EXPECT_EQ(walked_length_m(sways), 0.0);
    const std::vector<WalkedPoint> leaps = {{0, {0, 0, 0}}, {1, {1, 0, 0}}, {2, {50, 0, 0}, true}, {3, {51, 0, 0}}};
    EXPECT_DOUBLE_EQ(walked_length_m(leaps), 2.0);
    EXPECT_EQ(walked_length_m({}), 0.0);
}

TEST(PathRatio, does_not_exist_for_a_short_path_or_an_unreached_goal) {
    EXPECT_DOUBLE_EQ(*path_ratio(15.0, 10.0, true), 1.5);
    EXPECT_FALSE(path_ratio(15.0, 0.9, true));
    EXPECT_FALSE(path_ratio(15.0, 10.0, false));
}

TEST(Hesitations, are_pauses_of_over_two_seconds_without_a_known_reason) {
    std::vector<WalkedPoint> walk = walk_along({{0, 0, 0}, {2, 0, 0}});
    const auto stand = [&walk](double seconds) {
        for (const double until_s = walk.back().t_s + seconds; walk.back().t_s < until_s - 0.05;)
            walk.push_back({walk.back().t_s + 0.1, walk.back().place_m + Vec3(0.001, 0.0, 0.0)});
    };
    stand(3.0);
    for (int i = 0; i < 20; ++i) walk.push_back({walk.back().t_s + 0.1, walk.back().place_m + Vec3(0.1, 0, 0)});
    stand(1.5);
    for (int i = 0; i < 20; ++i) walk.push_back({walk.back().t_s + 0.1, walk.back().place_m + Vec3(0.1, 0, 0)});
    const double third_s = walk.back().t_s;
    stand(5.0);
    const Hesitations all = hesitations(walk);
    EXPECT_EQ(all.count, 2);
    EXPECT_NEAR(all.sum_s, 8.0, 0.5);
    const Span reading{third_s + 1.0, third_s + 2.0};
    const Hesitations without = hesitations(walk, std::span(&reading, 1));
    EXPECT_EQ(without.count, 2);
    EXPECT_NEAR(without.sum_s, 7.0, 0.5);
    const Span long_answer{third_s, third_s + 3.5};
    EXPECT_EQ(hesitations(walk, std::span(&long_answer, 1)).count, 1);
}

TEST(FreeTime, is_time_that_no_busy_interval_covers) {
    const std::vector<Span> busy{{6.0, 8.0}, {-1.0, 1.0}, {2.0, 4.0}, {3.0, 3.5}, {9.5, 20.0}};
    EXPECT_DOUBLE_EQ(free_s({0.0, 10.0}, busy), 1.0 + 2.0 + 1.5);
    EXPECT_DOUBLE_EQ(free_s({0.0, 10.0}, {}), 10.0);
    EXPECT_DOUBLE_EQ(free_s({2.5, 3.0}, busy), 0.0);
}

TEST(ContactEpisodes, join_touches_of_one_thing_that_are_within_two_seconds) {
    const std::vector<Touch> touches = {{0.0, 1}, {1.9, 1}, {3.8, 1}, {4.0, 2}, {6.0, 1}, {6.1, 2}, {8.5, 2}};
    EXPECT_EQ(contact_episodes(touches), 5);
    EXPECT_EQ(contact_episodes({}), 0);
}

TEST(Pointing, uses_circular_statistics_and_reports_a_bias_only_for_consistent_errors) {
    EXPECT_NEAR(pointing_error_rad(350 * kDegree, 10 * kDegree), -20 * kDegree, 1e-12);
    EXPECT_NEAR(pointing_error_rad(10 * kDegree, 350 * kDegree), 20 * kDegree, 1e-12);
    EXPECT_NEAR(pointing_error_rad(180 * kDegree, 0.0), 180 * kDegree, 1e-12);
    EXPECT_NEAR(pointing_error_rad(-180 * kDegree, 0.0), 180 * kDegree, 1e-12);
    // The angles are on both sides of 180 degrees. The circular mean of 170, 180 and -170 degrees is 180, whereas the
    // plain mean is 60.
    const std::vector<double> seam = {170 * kDegree, 180 * kDegree, -170 * kDegree};
    const auto across = pointing(seam);
    EXPECT_NEAR(std::abs(across->signed_rad), 180 * kDegree, 1e-9);
    EXPECT_NEAR(across->absolute_rad, (170 + 180 + 170) / 3.0 * kDegree, 1e-12);
    EXPECT_NEAR(across->agreement, (1.0 + 2.0 * std::cos(10 * kDegree)) / 3.0, 1e-12);
    EXPECT_TRUE(across->biased);
    const std::vector<double> two = {20 * kDegree, 20 * kDegree};
    EXPECT_FALSE(pointing(two)->biased);
    const std::vector<double> scattered = {0.0, 120 * kDegree, -120 * kDegree};
    EXPECT_NEAR(pointing(scattered)->agreement, 0.0, 1e-12);
    EXPECT_FALSE(pointing(scattered)->biased);
    EXPECT_FALSE(pointing({}));
}

TEST(DistanceRatio, is_the_geometric_mean) {
    const std::vector<Judged> answers = {{20.0, 10.0}, {5.0, 10.0}};
    EXPECT_NEAR(*distance_ratio(answers), 1.0, 1e-12);
    const std::vector<Judged> long_ones = {{20.0, 10.0}, {8.0, 1.0}};
    EXPECT_NEAR(*distance_ratio(long_ones), 4.0, 1e-12);
    const std::vector<Judged> none = {{0.0, 10.0}};
    EXPECT_FALSE(distance_ratio(none));
    EXPECT_FALSE(distance_ratio({}));
}

TEST(OrderTau, is_one_for_the_right_order_and_falls_with_the_swaps_that_would_correct_it) {
    EXPECT_DOUBLE_EQ(*order_tau(std::vector<std::size_t>{0, 1, 2, 3}), 1.0);
    EXPECT_DOUBLE_EQ(*order_tau(std::vector<std::size_t>{3, 2, 1, 0}), -1.0);
    EXPECT_DOUBLE_EQ(*order_tau(std::vector<std::size_t>{0, 2, 1, 3}), 1.0 - 2.0 / 6.0);
    EXPECT_FALSE(order_tau(std::vector<std::size_t>{0}));
    // Each swap of two neighbours corrects one of n(n-1)/2 pairs. The test counts the swaps that sorting needs.
    std::mt19937 draw(5);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::size_t> order(2 + draw() % 7);
        std::iota(order.begin(), order.end(), 0U);
        std::shuffle(order.begin(), order.end(), draw);
        std::vector<std::size_t> sorted = order;
        int swaps = 0;
        for (bool again = true; again;) {
            again = false;
            for (std::size_t i = 0; i + 1 < sorted.size(); ++i)
                if (sorted[i] > sorted[i + 1]) std::swap(sorted[i], sorted[i + 1]), ++swaps, again = true;
        }
        const double pairs = 0.5 * static_cast<double>(order.size() * (order.size() - 1));
        EXPECT_NEAR(*order_tau(order), 1.0 - 2.0 * swaps / pairs, 1e-12);
    }
}

const std::vector<Vec3> kRoute = {{0, 0, 0}, {0, 10, 0}, {8, 10, 0}, {8, 20, 0}};

TEST(TurnsMet, of_a_walk_along_the_route_are_all_counted_as_taken) {
    const TurnsMet met = turns_met(kRoute, walk_along(kRoute));
    EXPECT_EQ(met.turns, 2);
    EXPECT_EQ(met.missed, 0);
    EXPECT_EQ(met.early, 0);
    // The first walk cuts corners by half a metre, which must not count as missed turns. The second comparison uses a
    // route without turns.
    EXPECT_EQ(
        turns_met(kRoute, walk_along({{0, 0, 0}, {0.2, 9.5, 0}, {0.5, 10, 0}, {7.5, 10, 0}, {8, 10.5, 0}, {8, 20, 0}}))
            .missed,
        0);
    EXPECT_EQ(turns_met(std::vector<Vec3>{{0, 0, 0}, {0, 5, 0}, {1, 9, 0}}, walk_along(kRoute)).turns, 0);
}

TEST(TurnsMet, count_as_missed_when_passed_and_as_early_when_taken_too_soon) {
    const TurnsMet past = turns_met(kRoute, walk_along({{0, 0, 0}, {0, 13, 0}, {0, 10, 0}, {8, 10, 0}, {8, 20, 0}}));
    EXPECT_EQ(past.missed, 1);
    EXPECT_EQ(past.early, 0);
    const TurnsMet second = turns_met(kRoute, walk_along({{0, 0, 0}, {0, 10, 0}, {11, 10, 0}, {8, 10, 0}, {8, 20, 0}}));
    EXPECT_EQ(second.missed, 1);
    const TurnsMet early = turns_met(
        kRoute, walk_along({{0, 0, 0}, {0, 7, 0}, {1.5, 7, 0}, {0, 7, 0}, {0, 10, 0}, {8, 10, 0}, {8, 20, 0}}));
    EXPECT_EQ(early.early, 1);
    EXPECT_EQ(early.missed, 0);
    // A turn to the wrong side must not count as an early turn.
    const TurnsMet wrong = turns_met(
        kRoute, walk_along({{0, 0, 0}, {0, 7, 0}, {-1.5, 7, 0}, {0, 7, 0}, {0, 10, 0}, {8, 10, 0}, {8, 20, 0}}));
    EXPECT_EQ(wrong.early, 0);
}

}  // namespace measures_test
}  // namespace handrail
