// Tests rooms to which nothing leads. They must be rooms that the program reports as out of reach. The tops of walls,
// roofs and things must not be rooms.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/reach.h"
#include "worlds/navigation/rooms.h"

namespace handrail {
namespace closed_rooms_test {

constexpr double kCell_m = 3.0, kWall_m = 0.2, kHigh_m = 2.6;

// Rooms of 3 by 3 m in rows. Some of them have doorways between them. The base is in the first room.
struct Rows {
    int wide = 1, deep = 1;
    std::vector<std::array<int, 2>> doorways;  // pairs of neighbouring rooms that a doorway joins
    bool ceiling = true;
    Vec3 at_m{0.0};

    Vec3 middle_m(int cell) const {
        return at_m + Vec3((cell % wide + 0.5) * kCell_m, (cell / wide + 0.5) * kCell_m, 0.0);
    }
    test::SceneBuilder build() const {
        test::SceneBuilder b;
        const auto box = [&](const Vec3& from, const Vec3& to, FeatureKind kind) {
            b.box(at_m + from, at_m + to, kind == FeatureKind::Wall ? "wall" : "floor", SolidRole::Solid, {}, kind);
        };
        const double east = wide * kCell_m, north = deep * kCell_m;
        box({0, 0, -0.2}, {east, north, 0}, FeatureKind::Floor);
        if (ceiling) box({0, 0, kHigh_m}, {east, north, kHigh_m + 0.2}, FeatureKind::Floor);
        box({-kWall_m, -kWall_m, 0}, {east + kWall_m, 0, kHigh_m}, FeatureKind::Wall);
        box({-kWall_m, north, 0}, {east + kWall_m, north + kWall_m, kHigh_m}, FeatureKind::Wall);
        box({-kWall_m, 0, 0}, {0, north, kHigh_m}, FeatureKind::Wall);
        box({east, 0, 0}, {east + kWall_m, north, kHigh_m}, FeatureKind::Wall);
        for (int cell = 0; cell < wide * deep; ++cell)
            for (const int step : {1, wide}) {
                const int next = cell + step;
                if (next >= wide * deep || (step == 1 && next % wide == 0) || (step == wide && wide == 1 && deep == 1))
                    continue;
                const Vec3 corner((cell % wide) * kCell_m, (cell / wide) * kCell_m, 0.0);
                const bool open = joins(cell, next);
                // The wall extends over the length of a room. A doorway is 1 m wide and in the middle of the wall.
                for (const auto& [from, to] : open ? std::vector{std::pair(0.0, 1.0), std::pair(2.0, kCell_m)}
                                                   : std::vector{std::pair(0.0, kCell_m)}) {
                    const bool to_the_east = step == 1 && wide > 1;
                    const Vec3 a = to_the_east ? corner + Vec3(kCell_m - 0.1, from, 0)
                                               : corner + Vec3(from, kCell_m - 0.1, 0),
                               c = to_the_east ? corner + Vec3(kCell_m + 0.1, to, kHigh_m)
                                               : corner + Vec3(to, kCell_m + 0.1, kHigh_m);
                    box(a, c, FeatureKind::Wall);
                }
            }
        b.start(middle_m(0), 0.0);
        b.scene().starts.back().base = true;
        return b;
    }
    bool joins(int a, int b) const {
        return std::find(doorways.begin(), doorways.end(), std::array{a, b}) != doorways.end();
    }
};

std::vector<std::string> out_of_reach(const Scene& scene) {
    const Result<WalkSpace> space = make_walk_space(scene, walker_measures(scene, 0.25, 1.8, 0.25));
    EXPECT_TRUE(space.has_value());
    return unreachable_rooms(scene, *space, make_rooms(scene, *space));
}

TEST(ClosedRooms, are_counted_with_or_without_a_name_or_a_ceiling) {
    for (const Vec3& at : {Vec3(0.0), Vec3(-3'000'000.0, 5'000'000.0, 120.0)})
        for (const bool ceiling : {true, false}) {
            const Rows rows{2, 1, {}, ceiling, at};
            EXPECT_EQ(out_of_reach(*rows.build().share()).size(), 1U) << ceiling;
            test::SceneBuilder named = rows.build();
            named.scene().room_names = {{rows.middle_m(1), "Den"}};
            EXPECT_EQ(out_of_reach(*named.share()), std::vector<std::string>{"Den"});
            EXPECT_TRUE(out_of_reach(*Rows{2, 1, {{0, 1}}, ceiling, at}.build().share()).empty());
        }
}

TEST(ClosedRooms, do_not_include_roofs_tops_of_things_or_shafts) {
    test::SceneBuilder b = Rows{1, 1, {}, true, Vec3(0.0)}.build();
    // A roof with a parapet, a high cupboard with free space above it, and a shaft of a square metre.
    for (const auto& [from, to] :
         {std::pair(Vec3(-0.2, -0.2, 2.8), Vec3(3.2, 0, 3.8)), std::pair(Vec3(-0.2, 3, 2.8), Vec3(3.2, 3.2, 3.8)),
          std::pair(Vec3(-0.2, 0, 2.8), Vec3(0, 3, 3.8)), std::pair(Vec3(3, 0, 2.8), Vec3(3.2, 3, 3.8))})
        b.box(from, to, "parapet", SolidRole::Solid, {}, FeatureKind::Wall);
    b.box({0, 2, 0}, {3, 3, 0.6}, "Platform", SolidRole::Solid, {}, FeatureKind::Floor);
    for (const auto& [from, to] :
         {std::pair(Vec3(5, 0, -0.2), Vec3(6.4, 1.4, 0)), std::pair(Vec3(5, 0, 2.6), Vec3(6.4, 1.4, 2.8))})
        b.box(from, to, "shaft", SolidRole::Solid, {}, FeatureKind::Floor);
    for (const auto& [from, to] :
         {std::pair(Vec3(5, -0.2, 0), Vec3(6.4, 0, 2.8)), std::pair(Vec3(5, 1.4, 0), Vec3(6.4, 1.6, 2.8)),
          std::pair(Vec3(4.8, -0.2, 0), Vec3(5, 1.6, 2.8)), std::pair(Vec3(6.4, -0.2, 0), Vec3(6.6, 1.6, 2.8))})
        b.box(from, to, "shaft", SolidRole::Solid, {}, FeatureKind::Wall);
    EXPECT_TRUE(out_of_reach(*b.share()).empty());
}

// A walker must be able to stand in every room. It must reach exactly the rooms that doorways connect to the first
// room.
TEST(ClosedRooms, match_the_doorways_of_random_rows_of_rooms) {
    std::mt19937_64 random(test::seed_of_run());
    const auto chance = [&](double part) { return std::uniform_real_distribution(0.0, 1.0)(random) < part; };
    int closed = 0;
    for (int run = 0; run < 12; ++run) {
        Rows rows{std::uniform_int_distribution(2, 4)(random),
                  std::uniform_int_distribution(1, 3)(random),
                  {},
                  chance(0.5),
                  Vec3(0.0)};
        std::vector<int> group(static_cast<std::size_t>(rows.wide * rows.deep));
        std::iota(group.begin(), group.end(), 0);
        for (int cell = 0; cell < rows.wide * rows.deep; ++cell)
            for (const int step : {1, rows.wide}) {
                const int next = cell + step;
                if (next >= rows.wide * rows.deep || (step == 1 && next % rows.wide == 0) || !chance(0.4)) continue;
                rows.doorways.push_back({cell, next});
                const int from = group[static_cast<std::size_t>(next)], to = group[static_cast<std::size_t>(cell)];
                std::replace(group.begin(), group.end(), from, to);
            }
        const auto scene = rows.build().share();
        const Result<WalkSpace> space = make_walk_space(*scene, walker_measures(*scene, 0.25, 1.8, 0.25));
        ASSERT_TRUE(space.has_value());
        const auto span_in = [&](int cell) { return space->nearest(rows.middle_m(cell), 0.5, 0.3, 0.3); };
        ASSERT_NE(span_in(0), kNothing);
        const std::vector<bool> reached = spans_reached(*space, span_in(0));
        for (int cell = 0; cell < rows.wide * rows.deep; ++cell) {
            const std::uint32_t span = span_in(cell);
            ASSERT_NE(span, kNothing) << "run " << run << ", room " << cell;
            const bool joined = group[static_cast<std::size_t>(cell)] == group[0];
            EXPECT_EQ(reached[span], joined) << "run " << run << ", room " << cell;
            closed += joined ? 0 : 1;
        }
    }
    EXPECT_GT(closed, 10) << "the test tries what it is for";
}

}  // namespace closed_rooms_test
}  // namespace handrail
