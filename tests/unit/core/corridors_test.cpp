// Compares the corridors of a labyrinth with the result of an exhaustive search for rectangles, and checks the
// corridors of the bundled labyrinths.
#include <gmock/gmock.h>

#include <random>

#include "app/core/labyrinth/corridors.h"
#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace corridors_test {

// Examines every rectangle of free cells. Removes the largest rectangle, and among equal ones the first by row and
// column, until no cell is left.
std::vector<CellStrip> all_looked_at(std::vector<bool> free, int width, int depth) {
    std::vector<CellStrip> strips;
    const auto all_free = [&](const CellStrip& s) {
        for (int y = s.y0; y <= s.y1; ++y)
            for (int x = s.x0; x <= s.x1; ++x)
                if (!free[static_cast<std::size_t>(y * width + x)]) return false;
        return true;
    };
    for (;;) {
        CellStrip best{0, 0, -1, -1};
        int area = 0;
        for (int y0 = 0; y0 < depth; ++y0)
            for (int x0 = 0; x0 < width; ++x0)
                for (int y1 = y0; y1 < depth; ++y1)
                    for (int x1 = x0; x1 < width; ++x1) {
                        const CellStrip one{x0, y0, x1, y1};
                        if (one.wide() * one.deep() > area && all_free(one)) {
                            area = one.wide() * one.deep();
                            best = one;
                        }
                    }
        if (area == 0) return strips;
        for (int y = best.y0; y <= best.y1; ++y)
            for (int x = best.x0; x <= best.x1; ++x) free[static_cast<std::size_t>(y * width + x)] = false;
        strips.push_back(best);
    }
}

TEST(Corridors, are_the_largest_strips_of_free_cells_in_order_and_cover_them_all) {
    std::mt19937 random(20261124);
    for (int round = 0; round < 60; ++round) {
        const int width = 1 + static_cast<int>(random() % 9), depth = 1 + static_cast<int>(random() % 9);
        std::vector<bool> free(static_cast<std::size_t>(width * depth));
        for (std::size_t i = 0; i < free.size(); ++i) free[i] = random() % 4 != 0;
        const std::vector<CellStrip> strips = largest_strips(free, width, depth),
                                     twin = all_looked_at(free, width, depth);
        ASSERT_EQ(strips.size(), twin.size()) << "round " << round;
        std::vector<int> held(free.size(), 0);
        for (std::size_t i = 0; i < strips.size(); ++i) {
            EXPECT_EQ(strips[i].wide() * strips[i].deep(), twin[i].wide() * twin[i].deep()) << "round " << round;
            for (int y = strips[i].y0; y <= strips[i].y1; ++y)
                for (int x = strips[i].x0; x <= strips[i].x1; ++x) ++held[static_cast<std::size_t>(y * width + x)];
        }
        for (std::size_t i = 0; i < free.size(); ++i) ASSERT_EQ(held[i], free[i] ? 1 : 0) << "round " << round;
    }
    EXPECT_TRUE(largest_strips({}, 0, 0).empty());
    EXPECT_TRUE(largest_strips({false}, 1, 1).empty());
}

TEST(Corridors, of_the_bundled_labyrinths_are_mutually_connected_and_the_ball_starts_in_the_first) {
    for (const char* map : {"labyrinth1.map", "labyrinth2.map", "labyrinth3.map"}) {
        SCOPED_TRACE(map);
        const EnteringWorld world = make_ready(test::our_world(map));
        const Scene& scene = *world.scene;
        const auto ball = std::find_if(scene.placed.begin(), scene.placed.end(),
                                       [&](const PlacedModel& one) { return one.feature == scene.labyrinth.ball; });
        ASSERT_NE(ball, scene.placed.end());
        const Vec3 at_m = ball->at.position_m;
        const auto corridors = corridors_of(scene, at_m, 0.05);
        ASSERT_TRUE(corridors);
        ASSERT_FALSE(corridors->empty());
        const Aabb& first = corridors->front().box_m;
        EXPECT_TRUE(at_m.x >= first.min_m.x && at_m.x <= first.max_m.x && at_m.y >= first.min_m.y &&
                    at_m.y <= first.max_m.y);
        const auto other_way = [](CorridorSide side) {
            return static_cast<CorridorSide>((static_cast<int>(side) + 2) % 4);
        };
        for (std::size_t i = 0; i < corridors->size(); ++i) {
            EXPECT_GE((*corridors)[i].length_m, (*corridors)[i].across_m);
            for (const Corridor::Branch& branch : (*corridors)[i].branches) {
                ASSERT_LT(branch.to, corridors->size());
                const auto& back = (*corridors)[branch.to].branches;
                EXPECT_TRUE(std::any_of(back.begin(), back.end(),
                                        [&](const Corridor::Branch& one) {
                                            return one.to == i && one.towards == other_way(branch.towards);
                                        }))
                    << i << " to " << branch.to;
            }
        }
        // One of the corridors contains the goal and can be reached from the first corridor.
        const Vec3 goal = scene.labyrinth.goals.front().box_m.centre_m();
        EXPECT_TRUE(std::any_of(corridors->begin(), corridors->end(), [&](const Corridor& one) {
            const Vec3 near = glm::clamp(goal, one.box_m.min_m, one.box_m.max_m);
            return std::hypot(near.x - goal.x, near.y - goal.y) < 0.1;
        }));
    }
    // There is no floor on which the ball could roll, so the function fails.
    EXPECT_FALSE(corridors_of(Scene{}, Vec3(0.0), 0.05));
}

}  // namespace corridors_test
}  // namespace handrail
