// Tests that bodies which move, turn, grow, appear and vanish while a hand touches them feel as they should. The
// brute-force judge checks each body in the body's own frame.
#include <algorithm>

#include "tests/property/replay.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"

namespace handrail::test {
namespace bodies_test {

constexpr double kTick_s = 1e-3;

// A scene with bodies, the current poses of the bodies, and a hand. tick() runs one tick.
struct Rig {
    std::shared_ptr<const HapticScene> scene;
    std::vector<BodyPose> poses;
    std::uint64_t number = 0;
    TouchState state;
    TouchTuning tuning = plain_tuning(0.005);
    TouchResult last;

    explicit Rig(std::shared_ptr<const HapticScene> s) : scene(std::move(s)) {
        for (const HapticBody& body : scene->bodies) poses.push_back({body.start, body.present});
    }
    const TouchResult& tick(const Vec3& goal, bool something_moved = true) {
        if (something_moved) ++number;
        return last = touch_tick(state, *scene, tuning, goal, kTick_s, Vec3(0.0), {poses, number});
    }
    // Returns the distance between the proxy's surface and the shape in `judge`, in the pose of body `body`.
    double gap(const BruteForce& judge, std::size_t body) const {
        const PlacedFrame frame(poses[body].at);
        return static_cast<double>(judge.distance(frame.to_own(last.proxy_m), 10.0L)) * frame.scale - last.radius_m;
    }
};

std::shared_ptr<const HapticScene> box_shape(const Vec3& half) {
    HapticSceneBuilder builder;
    builder.add_box({-half, half}, SurfaceLabel{FeatureId{3}, 0, false});
    return builder.build();
}

TouchWorld box_world(const Vec3& half, bool of_triangles) {
    TouchWorld world;
    if (of_triangles) world.box_of_triangles(-half, half);
    else world.box(-half, half, FeatureId{3});
    return world;
}

Rotation random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return normalized({normal(random), normal(random), normal(random), normal(random)});
}

// Case T18: each of the six faces of a box moves against a still hand, as a box and as a mesh, in any orientation and
// at several speeds. Nothing enters the proxy. Contact begins in the tick in which the box arrives. The proxy then
// moves exactly with the face, and the force is perpendicular to the face.
TEST(Bodies, a_box_that_moves_against_a_still_hand_is_felt_on_every_face) {
    const auto seed = seed_of_run();
    std::mt19937 random(seed);
    for (const bool mesh : {false, true})
        for (const double speed : {0.05, 0.3, 0.5, 2.0})
            for (int face = 0; face < 6; ++face)
                for (const bool turned : {false, true}) {
                    SCOPED_TRACE(
                        fmt::format("seed {}, mesh {}, {} m/s, face {}, turned {}", seed, mesh, speed, face, turned));
                    const Vec3 half(0.25);
                    const TouchWorld world = box_world(half, mesh);
                    const BruteForce judge = world.judge();
                    Vec3 out(0.0);
                    out[face / 2] = face % 2 == 1 ? 1.0 : -1.0;
                    Placement at;
                    at.rotation = turned ? random_rotation(random) : Rotation{};
                    at.scale = turned ? 1.3 : 1.0;
                    // Normal of the face, which points towards the hand.
                    const Vec3 normal = PlacedFrame(at).turned(out);
                    const Vec3 hand(1.0, -2.0, 0.5);
                    const double start = 0.02;  // distance between the face and the proxy's surface at the start
                    at.position_m = hand - normal * (0.25 * at.scale + 0.005 + start);
                    HapticSceneBuilder builder;
                    builder.add_body(FeatureId{3}, world.scene(), at);
                    Rig rig(builder.build());
                    const Vec3 begin = at.position_m;
                    bool met = false;
                    double last_force = 0.0;
                    for (int i = 0; i < static_cast<int>(0.028 / (speed * kTick_s)); ++i) {
                        const double way = speed * kTick_s * i;
                        rig.poses[0].at.position_m = begin + normal * way;
                        rig.tick(hand);
                        ASSERT_GE(rig.gap(judge, 0), -1e-9) << way;
                        const double depth = way - start;
                        if (depth > 1e-7) {
                            ASSERT_EQ(rig.last.contacts.count, 1) << way;
                            met = true;
                            const double force = glm::length(rig.last.force_n);
                            ASSERT_NEAR(force, 1000.0 * depth, 1e-3);
                            ASSERT_GT(glm::dot(rig.last.force_n, normal), (1.0 - 1e-9) * force);
                            ASSERT_LE(force - last_force, 1000.0 * speed * kTick_s + 1e-3);
                            last_force = force;
                            ASSERT_EQ(rig.last.contacts.contacts[0].feature, mesh ? kNoFeature : FeatureId{3});
                        }
                    }
                    EXPECT_TRUE(met);
                }
}

// Case T18: a plate that turns about its middle once a second sweeps a held proxy along and never passes through it.
TEST(Bodies, a_turning_plate_never_passes_through_the_proxy) {
    for (const double half_thickness : {0.01, 1e-4, 0.0}) {
        TouchWorld world;
        if (half_thickness > 0.0) world.box({-0.3, -half_thickness, -0.3}, {0.3, half_thickness, 0.3});
        else world.quad({-0.3, 0, -0.3}, {0.3, 0, -0.3}, {0.3, 0, 0.3}, {-0.3, 0, 0.3});
        const BruteForce judge = world.judge();
        HapticSceneBuilder builder;
        builder.add_body(FeatureId{3}, world.scene(), {});
        Rig rig(builder.build());
        const Vec3 hand(0.15, -0.03, 0.0);
        int wrong_side = 0;
        double worst = 0.0;
        for (int i = 0; i < 120; ++i) {
            rig.poses[0].at.rotation = rotation_about({0, 0, 1}, -2.0 * kPi * i * kTick_s);
            rig.tick(hand);
            worst = std::min(worst, rig.gap(judge, 0));
            wrong_side += PlacedFrame(rig.poses[0].at).to_own(rig.last.proxy_m).y > 0.0;
        }
        EXPECT_EQ(wrong_side, 0) << half_thickness;
        EXPECT_GE(worst, -1e-9);
        EXPECT_GT(glm::length(rig.last.proxy_m - hand), 0.05);
    }
}

// Case T19: two walls close on the proxy until the gap is a fifth of a millimetre, and open again. The proxy shrinks to
// half the gap, stays exactly in the middle, and never moves faster than the walls.
TEST(Bodies, two_closing_walls_leave_the_proxy_in_the_middle) {
    for (const bool one_still : {false, true}) {
        HapticSceneBuilder builder;
        const auto slab = box_shape({0.05, 0.2, 0.2});
        if (one_still) builder.add_box({{-0.115, -0.2, -0.2}, {-0.015, 0.2, 0.2}});
        else builder.add_body(FeatureId{1}, slab, {Vec3(-0.065, 0, 0), {}, 1.0});
        builder.add_body(FeatureId{2}, slab, {Vec3(0.065, 0, 0), {}, 1.0});
        Rig rig(builder.build());
        Vec3 before(0.0);
        double left = -0.015, right = 0.015;
        const double step = 1e-4;
        for (int i = 0; i < 700; ++i) {
            const bool closing = i < 350;
            const double gap = right - left;
            if (closing && gap > 2.05e-4) right -= step, left += one_still ? 0.0 : step;
            if (!closing && gap < 0.03) right += step, left -= one_still ? 0.0 : step;
            rig.poses.back().at.position_m.x = right + 0.05;
            if (!one_still) rig.poses.front().at.position_m.x = left - 0.05;
            rig.tick({0, 0, 0});
            const double now = right - left;
            ASSERT_LE(rig.last.radius_m, 0.5 * now + 1e-9) << i;
            if (closing && now < 0.01) {
                ASSERT_NEAR(rig.last.radius_m, 0.5 * now, 2e-8) << i;
                ASSERT_NEAR(rig.last.proxy_m.x, 0.5 * (left + right), 2e-8) << i;
            }
            ASSERT_LE(glm::length(rig.last.proxy_m - before), step + 1e-8) << i;
            before = rig.last.proxy_m;
        }
        EXPECT_NEAR(rig.last.radius_m, 0.005, 1e-4);  // the proxy has grown again, at 20 mm/s
        EXPECT_EQ(rig.last.contacts.count, 0);
    }
}

// Case T20: a floor that appears 3 mm above the proxy's lowest point pushes the proxy up gently. A body that appears
// around the hand is not felt until the hand has left it.
TEST(Bodies, a_thing_that_appears_over_the_hand_pushes_gently) {
    HapticSceneBuilder builder;
    builder.add_body(FeatureId{1}, box_shape({1, 1, 1}), {Vec3(0, 0, -0.998), {}, 1.0}, false);
    Rig rig(builder.build());
    for (int i = 0; i < 10; ++i) EXPECT_EQ(rig.tick({0, 0, 0.004}).contacts.count, 0);
    rig.poses[0].present = true;  // the floor's top is at 2 mm, 3 mm above the proxy's lowest point
    double before = 0.0;
    for (int i = 0; i < 400; ++i) {
        rig.tick({0, 0, 0.004}, i == 0);
        const double force = glm::length(rig.last.force_n);
        ASSERT_LE(std::abs(force - before), 0.0201) << i;
        before = force;
    }
    EXPECT_NEAR(rig.last.proxy_m.z, 0.007, 1e-9);
    EXPECT_NEAR(before, 3.0, 1e-6);
    rig.poses[0].present = false;
    for (int i = 0; i < 10; ++i) rig.tick({0, 0, 0.004}, i == 0);
    EXPECT_EQ(rig.last.force_n, Vec3(0.0));
}

TEST(Bodies, a_hand_that_starts_inside_feels_nothing_until_it_is_out) {
    HapticSceneBuilder builder;
    builder.add_body(FeatureId{1}, box_shape({0.1, 0.1, 0.1}), {});
    builder.add_box({{0.05, -0.1, -0.1}, {0.3, 0.1, 0.1}}, SurfaceLabel{FeatureId{2}, 0, false});
    Rig rig(builder.build());
    EXPECT_EQ(rig.tick({0.07, 0, 0}).force_n, Vec3(0.0));  // the hand is inside both boxes
    EXPECT_TRUE(rig.last.contacts.ghosted);
    for (double z = 0.0; z < 0.1; z += 2e-4) {
        rig.tick({0.07, 0, z});
        EXPECT_EQ(rig.last.force_n, Vec3(0.0));
    }
    for (double z = 0.1; z < 0.12; z += 2e-4) rig.tick({0.07, 0, z});
    EXPECT_FALSE(rig.last.contacts.ghosted);
    for (double z = 0.12; z > 0.1; z -= 2e-4) rig.tick({0.07, 0, z});
    EXPECT_EQ(rig.last.contacts.count, 1);
    EXPECT_NEAR(rig.last.proxy_m.z, 0.105, 1e-9);
}

// A body appears or vanishes under the hand at random, a thousand times. When the body appears, the force changes by at
// most 0.02 N in a tick. When it vanishes, the force is zero after 10 ms.
TEST(Bodies, a_thousand_appearing_and_vanishing_things_never_knock) {
    const auto seed = seed_of_run();
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int round = 0; round < scaled(1000); ++round) {
        SCOPED_TRACE(fmt::format("seed {}, round {}", seed, round));
        TouchWorld world;
        const int kind = static_cast<int>(random() % 3);
        if (kind == 0)
            world.box(Vec3(-uniform(0.01, 0.2), -uniform(0.01, 0.2), -uniform(0.01, 0.2)),
                      Vec3(uniform(0.01, 0.2), uniform(0.01, 0.2), uniform(0.01, 0.2)));
        if (kind == 1) world.random_brush(random, Vec3(0.0), 0.1, 4);
        if (kind == 2) world.box_of_triangles(Vec3(-0.1), Vec3(0.1));
        HapticSceneBuilder builder;
        const Placement at{Vec3(uniform(-0.11, 0.11), uniform(-0.11, 0.11), uniform(-0.11, 0.11)),
                           random_rotation(random), uniform(0.5, 2.0)};
        builder.add_body(FeatureId{1}, world.scene(), at, false);
        Rig rig(builder.build());
        Vec3 hand(0.0);
        rig.tick(hand);
        rig.poses[0].present = true;
        Vec3 before(0.0);
        for (int i = 0; i < 300; ++i) {
            rig.tick(hand, i == 0);
            ASSERT_LE(glm::length(rig.last.force_n - before), 0.0201) << i;
            before = rig.last.force_n;
        }
        // The hand presses deeper from its present place, then the body vanishes.
        Vec3 way(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        for (int i = 0; i < 60; ++i) rig.tick(hand += way * 1e-4, false);
        rig.poses[0].present = false;
        for (int i = 0; i < 10; ++i) rig.tick(hand, i == 0);
        ASSERT_EQ(rig.last.force_n, Vec3(0.0));
        ASSERT_EQ(rig.last.contacts.count, 0);
    }
}

// Does the same as the test above with scenes that contain or lack a static object, as when the person adds an object
// to a world or removes it.
TEST(Bodies, adding_and_removing_static_things_under_the_hand_is_gentle) {
    HapticSceneBuilder with;
    with.add_box({{-1, -1, -1}, {1, 1, 0.002}}, SurfaceLabel{FeatureId{5}, 0, false});
    HapticSceneBuilder without;
    without.add_box({{2, 2, 2}, {3, 3, 3}});
    const auto empty = without.build();
    const auto full = with.build(empty->world);
    EXPECT_EQ(full->world, empty->world);
    EXPECT_NE(full->generation, empty->generation);
    TouchState state;
    const TouchTuning tuning = plain_tuning(0.005);
    TouchResult r;
    for (int i = 0; i < 5; ++i) r = touch_tick(state, *empty, tuning, {0, 0, 0.004}, kTick_s);
    double before = 0.0;
    for (int i = 0; i < 300; ++i) {
        r = touch_tick(state, *full, tuning, {0, 0, 0.004}, kTick_s);
        ASSERT_LE(std::abs(r.force_n.z - before), 0.0201);
        before = r.force_n.z;
    }
    EXPECT_NEAR(before, 3.0, 1e-6);
    for (int i = 0; i < 10; ++i) r = touch_tick(state, *empty, tuning, {0, 0, 0.004}, kTick_s);
    EXPECT_EQ(r.force_n, Vec3(0.0));
}

// Friction carries a resting proxy along with a moving floor; without friction the proxy stays behind. The force that
// pulls the proxy back never leaves the friction cone.
TEST(Bodies, friction_carries_the_proxy_on_a_moving_floor) {
    for (const double mu : {0.0, 0.4}) {
        HapticSceneBuilder builder;
        builder.add_body(FeatureId{1}, box_shape({1, 1, 0.5}), {Vec3(0, 0, -0.5), {}, 1.0});
        Rig rig(builder.build());
        rig.tuning.default_friction_static = rig.tuning.default_friction_kinetic = mu;
        for (double z = 0.01; z > 0.002; z -= 1e-4) rig.tick({0, 0, z}, false);
        double drawn = 0.0;
        for (int i = 0; i < 500; ++i) {
            rig.poses[0].at.position_m.x += 2e-5;
            rig.tick({0, 0, 0.002});
            const Vec3 f = rig.last.force_n;
            ASSERT_LE(std::abs(f.x), mu * f.z * (1.0 + 1e-6) + 1e-9);
            drawn = std::max(drawn, f.x);
        }
        // The hand is 3 mm deep at 1 kN/m. The floor draws the proxy along until friction can hold it no longer.
        EXPECT_NEAR(drawn, mu * 3.0, 0.02);
    }
}

// With random shapes, placements, motions and hands, the proxy never enters a body. The result does not depend on the
// world's position.
TEST(Bodies, moving_random_heaps_let_nothing_in) {
    const auto seed0 = seed_of_run();
    int touched = 0;
    const int rounds = std::max(6, static_cast<int>(scaled(12)));
    for (int k = 0; k < rounds; ++k) {
        const std::uint32_t seed = seed0 + static_cast<std::uint32_t>(k);
        SCOPED_TRACE(fmt::format("seed {}", seed));
        std::mt19937 random(seed);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        HapticSceneBuilder builder;
        std::vector<BruteForce> judges;
        std::vector<Vec3> speeds;
        std::vector<Rotation> spins;
        const int bodies = 1 + static_cast<int>(random() % 4);
        for (int b = 0; b < bodies; ++b) {
            TouchWorld world;
            if (random() % 2) world.random_brush(random, Vec3(0.0), 0.03, 3);
            else world.random_triangles(random, 12, 0.03, 0.015);
            judges.push_back(world.judge());
            builder.add_body(FeatureId{static_cast<std::uint32_t>(b)}, world.scene(),
                             {Vec3(uniform(-0.2, 0.2), uniform(-0.2, 0.2), uniform(-0.2, 0.2)), random_rotation(random),
                              uniform(0.7, 1.5)});
            spins.push_back(
                rotation_about(glm::normalize(Vec3(uniform(-1, 1), uniform(-1, 1), 1.5)), uniform(0, 2e-3)));
        }
        Rig rig(builder.build());
        for (const BodyPose& pose : rig.poses) speeds.push_back(-pose.at.position_m * uniform(0.2, 1.0) * kTick_s);
        const double offset = k % 3 == 2 ? 1e5 : 0.0;
        Vec3 hand(offset, 0, 0);
        if (offset > 0.0) {
            HapticSceneBuilder far;
            std::vector<BodyPose> moved = rig.poses;
            for (std::size_t b = 0; b < moved.size(); ++b) {
                moved[b].at.position_m.x += offset;
                far.add_body(rig.scene->bodies[b].feature, rig.scene->bodies[b].shape, moved[b].at);
            }
            rig.scene = far.build();
            rig.poses = moved;
        }
        bool met = false;
        double worst = 0.0;
        for (int i = 0; i < 1500; ++i) {
            for (std::size_t b = 0; b < rig.poses.size(); ++b) {
                rig.poses[b].at.position_m += speeds[b];
                rig.poses[b].at.rotation = normalized(spins[b] * rig.poses[b].at.rotation);
            }
            hand += Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)) * 2e-4;
            rig.tick(hand);
            ASSERT_TRUE(is_finite(rig.last.proxy_m) && is_finite(rig.last.force_n));
            met = met || rig.last.contacts.count > 0;
            if (!rig.last.contacts.ghosted)
                for (std::size_t b = 0; b < judges.size(); ++b) worst = std::min(worst, rig.gap(judges[b], b));
        }
        EXPECT_GE(worst, offset > 0.0 ? -1e-7 : -1e-9);
        touched += met;
    }
    EXPECT_GT(3 * touched, rounds) << "seed " << seed0;
}

// A still body feels the same as its shape in a still scene. Only the direction of the force is rotated with the body's
// placement.
TEST(Bodies, a_placed_body_feels_like_its_rotated_shape) {
    const TouchCase c = hard_cases()[3];
    std::mt19937 random(77);
    HapticSceneBuilder builder;
    const Placement at{Vec3(3, -2, 1), random_rotation(random), 1.0};
    const PlacedFrame frame(at);
    builder.add_body(FeatureId{1}, c.world.scene(), at);
    Rig rig(builder.build());
    TouchState plain;
    const auto scene = c.world.scene();
    double worst = 0.0;
    for (const Vec3& goal : c.goals_m) {
        const TouchResult expected = touch_tick(plain, *scene, rig.tuning, goal, kTick_s);
        rig.tick(frame.to_world(goal), false);
        worst = std::max(worst, glm::length(rig.last.force_n - frame.turned(expected.force_n)));
    }
    EXPECT_LE(worst, 1e-5);
}

}  // namespace bodies_test
}  // namespace handrail::test
