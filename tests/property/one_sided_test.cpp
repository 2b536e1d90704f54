// Tests sheets that can be touched only from one side. A closed surface of such sheets is solid from that side and is
// not felt from the other.
#include <iostream>

#include "tests/property/replay.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"

namespace handrail::test {
namespace one_sided_test {

// Returns a cube whose faces point outwards, with `half` as half the length of its edges. The faces are polygons, or
// triangles that meet at random inner points.
TouchWorld cube(double half, TouchSide side, bool triangles, std::mt19937& random) {
    TouchWorld world;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            Vec3 n(0.0), u(0.0), v(0.0);
            n[axis] = sign;
            u[(axis + 1) % 3] = 1.0;
            v[(axis + 2) % 3] = sign;
            const std::vector<Vec3> corners{half * (n - u - v), half * (n + u - v), half * (n + u + v),
                                            half * (n - u + v)};
            if (!triangles) {
                world.polygon(corners, side);
                continue;
            }
            const double s = (random() % 100) / 150.0 - 0.33, t = (random() % 100) / 150.0 - 0.33;
            const Vec3 middle = half * (n + s * u + t * v);
            for (std::size_t i = 0; i < 4; ++i) world.sided_triangle(corners[i], corners[(i + 1) % 4], middle, side);
        }
    return world;
}

std::vector<Vec3> random_path(std::mt19937& random, const Vec3& start, double half, int points, double speed) {
    std::vector<Vec3> way{start};
    for (int i = 0; i < points; ++i)
        way.emplace_back((random() % 2000 / 1e3 - 1.0) * half, (random() % 2000 / 1e3 - 1.0) * half,
                         (random() % 2000 / 1e3 - 1.0) * half);
    return hand_path(way, speed);
}

double outside_m(const Vec3& p, double half) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - half; }

constexpr double kHalf = 0.04, kRadius = 0.005;

TEST(OneSidedSheets, facing_outwards_stop_the_hand_at_faces_edges_and_corners_at_every_speed) {
    const auto seed0 = seed_of_run();
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(scaled(24)); ++k) {
        std::mt19937 random(seed0 + k);
        const double speed = std::array{0.05, 0.5, 5.0, 50.0}[k % 4];
        const bool capped = k % 3 != 0;
        const TouchWorld world = cube(kHalf, TouchSide::Front, k % 2 == 0, random);
        const TouchWorld both = cube(kHalf, TouchSide::Both, false, random);
        const BruteForce judge = both.judge();
        Motion motion = random_turn(random);
        motion.shift_m = {k * 1.1, -3.0, 2.0};
        SCOPED_TRACE(fmt::format("seed {} speed {} capped {}", seed0 + k, speed, capped));
        double deepest = 0.0;
        std::size_t touched = 0;
        const std::vector<Vec3> goals =
            random_path(random, {0, 0, 2 * kHalf}, 0.06, std::max(scaled(speed < 0.1 ? 12 : 60), 4), speed);
        replay(*world.scene(motion), goals, motion, capped ? plain_tuning(kRadius) : uncapped_tuning(kRadius),
               [&](std::size_t i, const Vec3&, const TouchResult& r, const SolverProbe& solver) {
                   touched += r.contacts.count > 0 ? 1 : 0;
                   for (int s = 1; s < solver.path_size(); ++s)
                       for (const double t : {0.25, 0.5, 0.75, 1.0}) {
                           const Vec3 p =
                               motion.back(solver.path_m(s - 1) + (solver.path_m(s) - solver.path_m(s - 1)) * t);
                           ASSERT_GT(outside_m(p, kHalf), 0.0) << i;
                           if (i % 5 == 0)
                               deepest = std::max(deepest, kRadius - static_cast<double>(judge.distance(p)));
                       }
               });
        EXPECT_LE(deepest, 3e-9);
        EXPECT_GT(touched, 0U);
    }
}

TEST(OneSidedSheets, of_a_closed_skin_let_the_hand_leave_and_are_solid_again_from_outside) {
    for (const TouchSide side : {TouchSide::Front, TouchSide::Back}) {
        for (const double speed : {0.05, 0.5, 5.0, 20.0}) {
            std::mt19937 random(5);
            const TouchWorld world = cube(kHalf, side, speed < 1.0, random);
            const auto scene = world.scene();
            // With Front, the hand is free on the path from the inside outwards, and the cube is solid on the way back.
            // With Back, the cube is solid on the way out and free on the way back.
            const double free_start = side == TouchSide::Front ? 0.0 : 0.08,
                         free_end = side == TouchSide::Front ? 0.08 : 0.0;
            TouchState state;
            for (const Vec3& goal : hand_path({{free_start, 0.001, 0.002}, {free_end, 0.001, 0.002}}, speed)) {
                const TouchResult r = touch_tick(state, *scene, plain_tuning(kRadius), goal, 1e-3);
                ASSERT_EQ(r.force_n, Vec3(0.0)) << speed;
                ASSERT_EQ(r.proxy_m, goal);
                ASSERT_EQ(r.radius_m, kRadius);
            }
            const double rest = side == TouchSide::Front ? kHalf + kRadius : kHalf - kRadius;
            TouchResult held;
            for (const Vec3& goal : hand_path({{free_end, 0.001, 0.002}, {0.04, 0.001, 0.002}}, speed))
                held = touch_tick(state, *scene, plain_tuning(kRadius), goal, 1e-3);
            EXPECT_NEAR(held.proxy_m.x, rest, 1e-9) << speed;
            EXPECT_NEAR(glm::length(held.force_n), 1000.0 * kRadius, 1e-5);
        }
    }
}

TEST(OneSidedSheets, facing_inwards_keep_the_hand_inside_a_closed_skin) {
    const auto seed0 = seed_of_run();
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(scaled(12)); ++k) {
        std::mt19937 random(seed0 + k);
        const double speed = std::array{0.05, 0.5, 5.0, 50.0}[k % 4];
        SCOPED_TRACE(fmt::format("seed {} speed {}", seed0 + k, speed));
        const TouchWorld world = cube(kHalf, TouchSide::Back, k % 2 == 0, random);
        const std::vector<Vec3> goals =
            random_path(random, {0, 0, 0}, 0.06, std::max(scaled(speed < 0.1 ? 12 : 60), 4), speed);
        replay(*world.scene(), goals, {}, k % 3 == 0 ? uncapped_tuning(kRadius) : plain_tuning(kRadius),
               [&](std::size_t i, const Vec3&, const TouchResult& r, const ProxySolver&) {
                   ASSERT_LE(outside_m(r.proxy_m, kHalf), -kRadius + 1e-9) << i;
               });
    }
}

TEST(OneSidedSheets, feel_like_two_sided_sheets_on_their_front) {
    std::mt19937 random(6);
    const TouchWorld sided = cube(kHalf, TouchSide::Both, false, random);
    TouchWorld front = cube(kHalf, TouchSide::Front, false, random);
    const std::vector<Vec3> goals = random_path(random, {0, 0, 2 * kHalf}, 0.06, 20, 0.3);
    const Trace a = trace(sided, goals, {}, uncapped_tuning(kRadius)),
                b = trace(front, goals, {}, uncapped_tuning(kRadius));
    EXPECT_LE(largest_difference(a, b), 2e-8);
    EXPECT_FALSE(sided.scene()->one_sided_sheets);
    EXPECT_TRUE(front.scene()->one_sided_sheets);
}

// A sheet on a moving body comes down on a resting hand. Its front pushes the hand, and its back passes through it,
// however the body is turned.
TEST(OneSidedSheets, of_a_moving_body_push_from_the_front_and_pass_from_behind) {
    for (const bool front : {true, false}) {
        HapticSceneBuilder shape;
        shape.add_polygon(std::vector<Vec3>{{-.1, -.1, 0}, {.1, -.1, 0}, {.1, .1, 0}, {-.1, .1, 0}},
                          SurfaceLabel{FeatureId{1}}, TouchSide::Front);
        HapticSceneBuilder builder;
        ASSERT_TRUE(builder.add_body(FeatureId{1}, shape.build(), {}));
        const auto scene = builder.build();
        // The sheet's front faces the hand, or faces away from it.
        Placement at;
        if (!front) at.rotation = rotation_about({1, 0, 0}, kPi);
        TouchState state;
        double strongest = 0.0;
        for (int i = 0; i < 600; ++i) {
            at.position_m = {0.0, 0.0, -0.03 + 1e-4 * i};
            const BodyPose pose{at, true};
            const TouchResult r = touch_tick(state, *scene, plain_tuning(kRadius), {0.01, 0.02, 0.0}, 1e-3, Vec3(0.0),
                                             {std::span(&pose, 1), static_cast<std::uint64_t>(i) + 1});
            strongest = std::max(strongest, glm::length(r.force_n));
            if (front && r.contacts.count > 0) {
                ASSERT_NEAR(r.proxy_m.z, at.position_m.z + kRadius, 1e-7) << i;
                ASSERT_GT(r.force_n.z, 0.0);
            }
        }
        EXPECT_EQ(strongest > 10.0, front) << "30 mm behind the sheet that carried the ball off, or nothing";
        EXPECT_TRUE(front || strongest == 0.0);
    }
}

TEST(OneSidedSheets, let_a_hand_that_is_half_through_from_behind_turn_back) {
    TouchWorld world;
    world.polygon({{-.1, -.1, 0}, {.1, -.1, 0}, {.1, .1, 0}, {-.1, .1, 0}}, TouchSide::Front);
    const auto scene = world.scene();
    for (const double turn_at : {0.001, 0.004, kRadius - 1e-6}) {
        TouchState state;
        for (const Vec3& goal : hand_path({{0, 0, -.03}, {0, 0, turn_at}, {0, 0, -.03}}, 0.1)) {
            const TouchResult r = touch_tick(state, *scene, plain_tuning(kRadius), goal, 1e-3);
            ASSERT_EQ(r.force_n, Vec3(0.0)) << turn_at;
            ASSERT_EQ(r.proxy_m, goal);
        }
    }
    // A hand that starts close behind the sheet feels nothing. If a hand starts close in front of it, its proxy starts
    // with a smaller radius and grows.
    TouchState behind, before;
    EXPECT_EQ(touch_tick(behind, *scene, plain_tuning(kRadius), {0, 0, -.001}, 1e-3).radius_m, kRadius);
    EXPECT_NEAR(touch_tick(before, *scene, plain_tuning(kRadius), {0, 0, .001}, 1e-3).radius_m, .001 + 2e-5, 1e-9);
    EXPECT_GE(touch_tick(before, *scene, plain_tuning(kRadius), {0, 0, -.02}, 1e-3).proxy_m.z, .001);
}

}  // namespace one_sided_test
}  // namespace handrail::test
