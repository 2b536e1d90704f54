// Generates walks that each follow one strategy, with the sway, pauses and wrong turns of people. The program must
// detect the strategy.
#include "app/results/strategy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"

namespace handrail {
namespace strategy_test {

struct Hall {
    double wide_m, deep_m;
    std::vector<Vec3> things;
};
const std::vector<Hall> kHalls = {
    {6.0, 4.0, {{1.0, 3.4, 0}, {4.4, 2.6, 0}, {5.4, 1.0, 0}, {1.2, 1.2, 0}, {3.0, 3.5, 0}}},
    {10.0, 8.0, {{1.0, 7.0, 0}, {5.0, 4.0, 0}, {9.0, 2.0, 0}, {2.0, 2.0, 0}, {8.0, 6.5, 0}, {5.0, 7.3, 0}}},
    {16.0, 10.0, {{2.0, 8.0, 0}, {8.0, 5.0, 0}, {14.0, 2.0, 0}, {3.0, 3.0, 0}, {12.0, 8.0, 0}, {8.0, 9.0, 0}}},
};

// Simulates a person who sways by 5 cm and whose direction is wrong by about 3 degrees on each leg. One leg in five
// ends with a pause, and one in twenty begins with a detour.
class Person {
public:
    Person(const Hall& hall, std::uint64_t seed, const Vec3& at) : hall_(hall), draw_(seed), at_(at) {}

    void trail_walls() { trails_ = true; }
    void go(const Vec3& to, int thing = -1) {
        if (chance(0.05)) {
            const Vec3 middle = 0.5 * (at_ + to);
            leg({std::clamp(middle.x + normal(), 0.3, hall_.wide_m - 0.3),
                 std::clamp(middle.y + normal(), 0.3, hall_.deep_m - 0.3), 0.0});
        }
        leg(to);
        if (thing >= 0) stand(2.0, thing);
        else if (chance(0.2)) stand(1.0 + 3.0 * uniform(), -1);
    }
    std::size_t choose(std::size_t among) { return draw_() % among; }
    const std::vector<WalkSample>& walk() const { return walk_; }

private:
    double uniform() { return std::uniform_real_distribution<double>()(draw_); }
    double normal() { return std::normal_distribution<double>()(draw_); }
    bool chance(double share) { return uniform() < share; }
    void note(int thing) {
        const double wall_m = std::max(0.0, std::min({at_.x, hall_.wide_m - at_.x, at_.y, hall_.deep_m - at_.y}));
        walk_.push_back({t_s_, at_, wall_m, (trails_ && wall_m < 0.6 && chance(0.5)) || wall_m <= 0.25, thing, false});
        t_s_ += 0.1;
    }
    void stand(double seconds, int thing) {
        for (int i = 0; i < std::lround(seconds * 10.0); ++i) note(thing);
    }
    void leg(const Vec3& to) {
        const Vec3 from = at_, way = to - from;
        const double far_m = glm::length(way);
        if (far_m < 0.05) return;
        const double step_m = (0.7 + 0.3 * uniform()) * 0.1;
        const double off = std::tan(3.0 * std::numbers::pi / 180.0 * normal());
        const Vec3 ahead = way / far_m, right(ahead.y, -ahead.x, 0.0);
        for (double gone_m = step_m;; gone_m += step_m) {
            const double part = std::min(1.0, gone_m / far_m);
            sway_m_ = 0.95 * sway_m_ + std::sqrt(1.0 - 0.95 * 0.95) * 0.05 * normal();
            const double aside_m = std::sin(std::numbers::pi * part) * far_m * off * 0.5 + sway_m_;
            at_ = from + way * part + right * aside_m;
            at_ = {std::clamp(at_.x, 0.25, hall_.wide_m - 0.25), std::clamp(at_.y, 0.25, hall_.deep_m - 0.25), 0.0};
            note(-1);
            if (part >= 1.0) return;
        }
    }

    const Hall& hall_;
    std::mt19937_64 draw_;
    Vec3 at_;
    double t_s_ = 0.0, sway_m_ = 0.0;
    bool trails_ = false;
    std::vector<WalkSample> walk_;
};

Vec3 base_of(const Hall& hall) { return {0.5 * hall.wide_m, 0.3, 0.0}; }

std::vector<WalkSample> made_by(Strategy strategy, const Hall& hall, std::uint64_t seed) {
    Person person(hall, seed, strategy == Strategy::Grid ? Vec3(0.5, 0.5, 0.0) : base_of(hall));
    const double w = hall.wide_m, d = hall.deep_m;
    if (strategy == Strategy::Perimeter) {
        person.trail_walls();
        for (int lap = 0; lap < 4; ++lap)
            for (const Vec3& corner :
                 {Vec3(0.3, 0.3, 0), Vec3(0.3, d - 0.3, 0), Vec3(w - 0.3, d - 0.3, 0), Vec3(w - 0.3, 0.3, 0)})
                person.go(corner);
    } else if (strategy == Strategy::Grid) {
        bool up = true;
        for (int lap = 0; lap < 3; ++lap)
            for (double x = 1.0; x <= w - 0.99; x += 1.0, up = !up) {
                person.go({x, up ? d - 0.5 : 0.5, 0.0});
                person.go({std::min(x + 1.0, w - 0.5), up ? d - 0.5 : 0.5, 0.0});
            }
    } else {
        std::size_t last = hall.things.size();
        for (int visit = 0; visit < 24; ++visit) {
            std::size_t next = person.choose(hall.things.size());
            if (next == last) next = (next + 1) % hall.things.size();
            last = next;
            person.go(hall.things[next], static_cast<int>(next));
            if (strategy == Strategy::BackToBase) person.go(base_of(hall));
        }
    }
    return person.walk();
}

TEST(Strategies, of_walks_with_five_centimetres_of_sway_are_classified_correctly_in_nine_of_ten_windows) {
    const int walks = test::scaled(8);
    for (const Strategy strategy :
         {Strategy::Perimeter, Strategy::Grid, Strategy::ObjectToObject, Strategy::BackToBase}) {
        int right = 0, all = 0;
        for (const Hall& hall : kHalls)
            for (int i = 0; i < walks; ++i)
                for (const StrategyWindow& window :
                     strategy_windows(made_by(strategy, hall, static_cast<std::uint64_t>(100 + i)), base_of(hall))) {
                    if (window.kind == Strategy::None) continue;
                    ++all;
                    right += window.kind == strategy ? 1 : 0;
                }
        std::printf("strategy %d: %.1f %% of %d windows right\n", static_cast<int>(strategy), 100.0 * right / all, all);
        EXPECT_GT(all, 20);
        EXPECT_GE(right, 0.9 * all) << static_cast<int>(strategy);
    }
}

TEST(Strategies, are_undefined_for_a_standing_walker_and_have_no_windows_without_data) {
    std::vector<WalkSample> stands;
    for (int i = 0; i < 600; ++i) stands.push_back({i * 0.1, {1.0, 1.0, 0.0}});
    const auto windows = strategy_windows(stands, Vec3(0.0));
    ASSERT_EQ(windows.size(), 8U);
    for (const StrategyWindow& window : windows) EXPECT_EQ(window.kind, Strategy::None);
    EXPECT_TRUE(strategy_windows({}, Vec3(0.0)).empty());
}

TEST(Strategies, name_a_window_by_at_least_half_of_its_path_and_shares_sum_to_one) {
    const auto walk = made_by(Strategy::Perimeter, kHalls[1], 3);
    for (const StrategyWindow& window : strategy_windows(walk, base_of(kHalls[1]))) {
        double sum = 0.0;
        for (const double share : window.share) sum += share;
        EXPECT_NEAR(sum, 1.0, 1e-9);
        EXPECT_LE(window.to_s - window.from_s, 90.0 + 1e-9);
        EXPECT_GE(window.to_s - window.from_s, 20.0 - 1e-9);
        const double share = window.share[static_cast<std::size_t>(window.kind)];
        EXPECT_TRUE(window.kind == Strategy::Mixed || share >= 0.5) << share;
    }
}

TEST(Legs, are_cut_at_bends_and_visits_and_merged_on_straight_stretches) {
    std::vector<WalkSample> walk;
    const auto go = [&walk](const Vec3& from, const Vec3& to, int thing) {
        for (int i = 0; i <= 40; ++i)
            walk.push_back({static_cast<double>(walk.size()) * 0.1, from + (to - from) * (i / 40.0), 5.0, false,
                            i == 40 ? thing : -1, false});
    };
    go({0, 0, 0}, {4, 0, 0}, -1);
    go({4, 0, 0}, {4, 4, 0}, 7);
    go({4, 4, 0}, {4, 8, 0}, -1);
    const std::vector<WalkedLeg> legs = legs_of(walk, {50, 50, 0});
    ASSERT_EQ(legs.size(), 3U);
    EXPECT_NEAR(legs[0].to_m.x, 4.0, 0.01);
    EXPECT_EQ(legs[1].to_thing, 7);
    EXPECT_EQ(legs[2].from_thing, 7);
    double way_m = 0.0;
    for (const WalkedLeg& leg : legs) way_m += leg.way_m;
    EXPECT_NEAR(way_m, 12.0, 1e-9);
}

}  // namespace strategy_test
}  // namespace handrail
