// Tests that the walker climbs stairs of each form wherever the routes say that it can.
#include "app/core/world/walker.h"
#include "tests/support/names.h"
#include "tests/support/stair_house.h"
#include "worlds/navigation/navigation.h"

namespace handrail {
namespace walked_stairs_test {

// Walks from point to point of a route, like a person who knows the stairs. Returns the remaining distance to the end
// of the route in metres.
double left_m(Walker& walker, const std::vector<Vec3>& points_m) {
    constexpr double kSpeed_m_per_s = 0.7, kTick_s = 1.0 / 60.0, kThere_m = 0.03, kPatience_s = 3.0;
    for (const Vec3& point_m : points_m) {
        double nearest_m = 1e9;
        for (double idle_s = 0.0; idle_s < kPatience_s; idle_s += kTick_s) {
            const Vec3 off = point_m - walker.state().feet_m;
            const double far_m = std::hypot(off.x, off.y);
            if (far_m < kThere_m) break;
            if (far_m < nearest_m - 0.01) idle_s = 0.0, nearest_m = far_m;
            const double speed = std::min(kSpeed_m_per_s, far_m / kTick_s);
            walker.tick(Vec3(off.x, off.y, 0.0) * (speed / far_m), kTick_s);
        }
    }
    return glm::length(points_m.back() - walker.state().feet_m);
}

TEST(WalkedStairs, of_each_form_lead_up_and_down) {
    for (const test::StairForm form : test::kStairForms) {
        const test::StairHouse house(form);
        const auto scene = house.share();
        const WalkerSize size = walker_size(*scene, 0.25);
        const auto ways =
            Navigation::make(*scene, walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m));
        ASSERT_TRUE(ways.has_value());
        const WalkerWorld world(scene);
        Walker walker(world, size);
        walker.place(house.hall_m());
        for (const bool up : {true, false}) {
            const Vec3 &from_m = up ? house.hall_m() : house.gallery_m(),
                       &to_m = up ? house.gallery_m() : house.hall_m();
            const Route route = (*ways)->plan(from_m, to_m);
            ASSERT_TRUE(route.reaches) << test::form_name(form);
            EXPECT_LT(left_m(walker, route.points_m), 0.1)
                << test::form_name(form) << (up ? " up, at " : " down, at ") << walker.state().feet_m.x << ' '
                << walker.state().feet_m.y << ' ' << walker.state().feet_m.z;
            walker.place(to_m);
        }
    }
}

// A step that does not belong to the stairs keeps its height, even if it is next to them.
TEST(WalkedStairs, lower_no_step_that_does_not_belong_to_them) {
    test::SceneBuilder b;
    b.box({-5, -5, -0.2}, {5, 5, 0}, "floor");
    b.box({-5, 1, 0}, {5, 2, 0.35}, "block");
    const auto scene = b.share();
    const WalkerWorld world(scene);
    Walker walker(world, walker_size(*scene, 0.25));
    walker.place({0, 0, 0});
    for (int i = 0; i < 180; ++i) walker.tick({0, 1, 0}, 1.0 / 60.0);
    EXPECT_NEAR(walker.state().feet_m.z, 0.0, 1e-3);
    EXPECT_NEAR(walker.state().feet_m.y, 0.75, 1e-3);
}

}  // namespace walked_stairs_test
}  // namespace handrail
