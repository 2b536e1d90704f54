// Tests which place of a route is nearest to the walker. A search of a thousand places on each leg is the reference.
#include "worlds/navigation/route_place.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "tests/support/names.h"
#include "tests/support/random_families.h"

namespace handrail {
namespace route_place_test {

RoutePlace by_looking_everywhere(const std::vector<Vec3>& points_m, const Vec3& from_m) {
    RoutePlace nearest{points_m[0], std::numeric_limits<double>::infinity(), 0.0, 0};
    double before_m = 0.0;
    for (std::size_t leg = 0; leg + 1 < points_m.size(); ++leg) {
        const Vec3 way = points_m[leg + 1] - points_m[leg];
        for (int i = 0; i <= 1000; ++i) {
            const Vec3 place = points_m[leg] + way * (i / 1000.0);
            if (const double far = glm::length(place - from_m); far < nearest.distance_m)
                nearest = {place, far, before_m + glm::length(way) * i / 1000.0, leg};
        }
        before_m += glm::length(way);
    }
    return nearest;
}

TEST(NearestOnPath, agrees_with_an_exhaustive_search_on_random_paths) {
    const std::uint32_t seed = test::seed_of_run();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-5.0, 5.0);
    for (int run = 0; run < 500; ++run) {
        std::vector<Vec3> points;
        for (int i = 0, count = 2 + run % 12; i < count; ++i) {
            points.emplace_back(place(random), place(random), place(random));
            if (i % 5 == 4) points.push_back(points.back());  // adds a leg of zero length
        }
        const Vec3 from(place(random), place(random), place(random));
        const RoutePlace found = nearest_on_path(points, from), twin = by_looking_everywhere(points, from);
        const double cell_m = 20.0 / 1000.0;
        ASSERT_LE(found.distance_m, twin.distance_m + 1e-12) << "seed " << seed << ", run " << run;
        ASSERT_GE(found.distance_m, twin.distance_m - cell_m) << "seed " << seed << ", run " << run;
        ASSERT_NEAR(glm::length(from - found.place_m), found.distance_m, 1e-12);
        ASSERT_LT(glm::length(place_along(points, found.along_m) - found.place_m), 1e-9)
            << "so far along lies that place: seed " << seed << ", run " << run;
    }
}

TEST(NearestOnPath, prefers_the_first_of_equally_near_places_and_accepts_a_path_of_one_point) {
    const std::vector<Vec3> there_and_back{{0, 0, 0}, {4, 0, 0}, {0, 0, 0}};
    EXPECT_EQ(nearest_on_path(there_and_back, {1, 1, 0}).along_m, 1.0);
    EXPECT_EQ(nearest_on_path(there_and_back, {1, 1, 0}).leg, 0U);
    const std::vector<Vec3> one{{2, 0, 0}};
    EXPECT_EQ(nearest_on_path(one, {2, 3, 0}).distance_m, 3.0);
    EXPECT_EQ(place_along(one, 5.0), Vec3(2, 0, 0));
    EXPECT_EQ(place_along(there_and_back, -1.0), Vec3(0, 0, 0));
    EXPECT_EQ(place_along(there_and_back, 5.0), Vec3(3, 0, 0));
    EXPECT_EQ(place_along(there_and_back, 99.0), Vec3(0, 0, 0));
}

TEST(NearOnPath, keeps_its_place_on_a_path_that_passes_close_to_itself) {
    const std::vector<Vec3> way{{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {0, 1, 0}};
    EXPECT_NEAR(near_on_path(way, {2, 0.5, 0}, 2.0).along_m, 2.0, 1e-12);
    EXPECT_NEAR(near_on_path(way, {2, 0.5, 0}, 18.0).along_m, 19.0, 1e-12);
    EXPECT_NEAR(near_on_path(way, {2, 0, 3}, 2.0).distance_m, 1.5, 1e-12) << "height counts half for who walks";
    EXPECT_NEAR(near_on_path(way, {2, 0, 3}, 2.0, 1.0).distance_m, 3.0, 1e-12) << "and whole for a hand";
    EXPECT_NEAR(near_on_path(std::vector<Vec3>{{1, 1, 1}}, {1, 1, 3}, 0.0).distance_m, 1.0, 1e-12);
}

// A wall separates the two long legs. The leg behind the wall is nearer, but the walker cannot see it. So
// near_on_path() must not choose a place on that leg.
TEST(NearOnPath, takes_no_short_cut_through_an_opaque_wall) {
    const std::vector<Vec3> way{{0, 0, 0}, {10, 0, 0}, {10, 2, 0}, {0, 2, 0}};
    const Vec3 at(4, 0.9, 0);
    const auto before_wall = [&](const Vec3& place) { return place.y < 1.0; };
    EXPECT_NEAR(near_on_path(way, at, 18.0).along_m, 18.0, 1e-12);
    EXPECT_NEAR(near_on_path(way, at, 18.0, 1.0, before_wall).along_m, 4.0, 1e-12);
    // If the walker sees nothing, the walker's place on the route must stay the same, and the distance must be measured
    // from there.
    const RoutePlace stays = near_on_path(way, at, 5.0, 1.0, [](const Vec3&) { return false; });
    EXPECT_NEAR(stays.along_m, 5.0, 1e-12);
    EXPECT_EQ(stays.leg, 0U);
    EXPECT_NEAR(stays.distance_m, glm::length(Vec3(5, 0, 0) - at), 1e-12);
    EXPECT_NEAR(near_on_path(way, at, 11.0, 1.0, [](const Vec3&) { return false; }).place_m.y, 1.0, 1e-12)
        << "on the short leg between";
    // If only a much farther place is visible, near_on_path() must not choose it, because something thin merely hides
    // the nearest place.
    const auto far_end = [&](const Vec3& place) { return place.x > 9.0; };
    EXPECT_NEAR(near_on_path(way, at, 5.0, 1.0, far_end).along_m, 5.0, 1e-12);
}

}  // namespace route_place_test
}  // namespace handrail
