// Tests that walls with mitred ends become square, so that no corner has a notch.
#include "worlds/plan/plan_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/exports/plans.h"

namespace handrail::test {
namespace squared_wall_test {

TEST(SquaredWall, has_no_mitre) {
    // The upper side of this wall is longer at its right end.
    const auto squared = squared_wall({{0.0, 0.0}, {3.0, 0.0}, {3.4, 0.4}, {0.0, 0.4}});
    ASSERT_TRUE(squared);
    EXPECT_NEAR(glm::distance(squared->outline[1], Vec2(3.4, 0.0)), 0.0, 1e-9);
    EXPECT_FALSE(squared_wall(squared->outline));
    EXPECT_FALSE(squared_wall({{0.0, 0.0}, {3.0, 0.0}, {3.05, 0.4}, {0.0, 0.4}})) << "all but square";
    const auto other = squared_wall({{0.4, 0.0}, {3.0, 0.0}, {3.0, 0.4}, {0.0, 0.4}});
    ASSERT_TRUE(other);
    EXPECT_NEAR(glm::distance(other->outline[0], Vec2(0.0, 0.0)), 0.0, 1e-9);
}

TEST(SquaredWall, leaves_no_notch_in_the_corners_of_a_real_building) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes too long here";
    const NamedStoreys* world = storeys_of("duplex-apartment.ifc");
    if (!world) GTEST_SKIP() << needs_real_world("duplex-apartment.ifc");
    const Storey& storey = world->storeys.at(1);
    Vec2 low(1e9), high(-1e9);
    for (const PlanOutline& wall : storey.walls_m)
        for (const Vec2& p : wall) low = glm::min(low, p), high = glm::max(high, p);
    const auto walled = [&](const Vec2& at) {
        return std::any_of(storey.walls_m.begin(), storey.walls_m.end(),
                           [&](const PlanOutline& wall) { return within(wall, at); });
    };
    for (const Vec2& corner : {Vec2(low.x, high.y), Vec2(high.x, low.y)}) {
        const Vec2 inwards = glm::sign(0.5 * (low + high) - corner);
        EXPECT_TRUE(walled(corner + inwards * Vec2(0.3, 0.1))) << corner.x << " " << corner.y;
        EXPECT_TRUE(walled(corner + inwards * Vec2(0.1, 0.3))) << corner.x << " " << corner.y;
    }
}

}  // namespace squared_wall_test
}  // namespace handrail::test
