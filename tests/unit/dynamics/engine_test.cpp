// Tests the engine of movable bodies alone. Bodies fall, slide, roll, stack and fall asleep, and every run must be
// bit-identical.
#include <bit>
#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/dynamics/rig.h"

namespace handrail::test {
namespace engine_test {

// Returns a scene with twenty boxes, balls and cylinders above a floor of tiles with a wall.
std::shared_ptr<const DynamicsScene> heap(unsigned seed, const Vec3& at = Vec3(0.0)) {
    std::mt19937 random(seed);
    const auto unit = [&] { return random() / 4294967296.0; };
    DynamicsSceneBuilder builder(at);
    for (int x = -3; x < 3; ++x)
        for (int y = -3; y < 3; ++y) builder.add_fixed_box({at + Vec3(x, y, -0.5), at + Vec3(x + 1, y + 1, 0)}, kFloor);
    builder.add_fixed_box({at + Vec3(1, -3, 0), at + Vec3(1.2, 3, 1)}, kWall);
    for (std::uint32_t i = 0; i < 20; ++i) {
        const double r = 0.06 + 0.1 * unit();
        const DynamicsPiece piece =
            i % 3 == 0   ? ball_of(r)
            : i % 3 == 1 ? box_of(r)
                         : make_piece(RoundShape(CylinderShape{Vec3(0, 0, -r), Vec3(0, 0, 1), 2 * r, 0.7 * r}));
        BodyNature n = nature(0.1 + 4.0 * unit());
        n.elasticity = 0.3;
        n.rolling = 0.05;
        EXPECT_EQ(builder.add_body(std::span(&piece, 1), FeatureId{10 + i}, i,
                                   {at + Vec3(unit() * 2 - 1, unit() * 2 - 1, 0.3 + 0.1 * i), {}, 1.0}, n),
                  BodyFault::None);
    }
    return builder.build();
}

std::uint64_t bits_of(const Dynamics& engine) {
    std::uint64_t sum = 1469598103934665603ULL;
    const auto mix = [&](double v) { sum = (sum ^ std::bit_cast<std::uint64_t>(v)) * 1099511628211ULL; };
    for (std::uint32_t i = 0; i < engine.scene().bodies.size(); ++i) {
        const Placement at = engine.middle(i);
        for (int k = 0; k < 3; ++k) mix(at.position_m[k]);
        for (const double q : {at.rotation.w, at.rotation.x, at.rotation.y, at.rotation.z}) mix(q);
    }
    return sum;
}

// Applies the same pushes on the same steps in every run. Returns a hash of the results.
std::uint64_t play(Dynamics& engine, std::uint32_t game, int steps) {
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    for (int i = 0; i < steps; ++i) {
        HandPush push;
        push.time_s = engine.time_s();
        push.dt_s = Dynamics::kStep_s;
        push.body = static_cast<std::uint32_t>(i / 40) % 20;
        push.game = game;
        push.force_n = Vec3(20.0 * std::cos(0.1 * i), 5.0, 8.0);
        engine.push(0, push);
        engine.place_hand(0, {engine.middle(push.body).position_m, 0.02, 0.0});
        engine.step(frame, events);
    }
    return bits_of(engine);
}

TEST(Dynamics, gives_bit_identical_results_in_two_runs_and_after_a_restart) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(seed);
        const int steps = scaled(600);
        Dynamics a(heap(seed));
        const std::uint64_t first = play(a, 1, steps);
        // This allocation makes the second engine run with a different state of the memory heap.
        auto clutter = std::make_unique<std::vector<std::vector<int>>>(137, std::vector<int>(91));
        Dynamics b(heap(seed));
        EXPECT_EQ(play(b, 1, steps), first);
        clutter.reset();
        const std::uint64_t start = bits_of(Dynamics(heap(seed)));
        b.restart();
        EXPECT_EQ(bits_of(b), start);
        EXPECT_EQ(play(b, 2, steps), first);
    }
}

TEST(Dynamics, is_the_same_far_away_if_the_scene_states_its_origin) {
    Dynamics near(heap(4)), far(heap(4, Vec3(5000.0, -3000.0, 200.0)));
    run(near, scaled(480));
    run(far, scaled(480));
    // At 5 km, the coordinates of the scene are rounded to 1e-12 m, and collisions between the bodies amplify the
    // difference. So the test only checks that the bodies settle above the floor at plausible speeds.
    for (std::uint32_t i = 0; i < 20; ++i) {
        EXPECT_GT(far.middle(i).position_m.z - 200.0, 0.03) << i;
        EXPECT_LT(glm::length(far.speed_m_per_s(i)), 8.0) << i;
    }
    // A single body must come to rest at the same height.
    for (const Vec3& at : {Vec3(0.0), Vec3(5000.0, -3000.0, 200.0)}) {
        DynamicsSceneBuilder builder(at);
        builder.add_fixed_box({at + Vec3(-5, -5, -1), at + Vec3(5, 5, 0)});
        const DynamicsPiece ball = ball_of(0.1);
        ASSERT_EQ(builder.add_body(std::span(&ball, 1), kThing, 0, {at + Vec3(0, 0, 1), {}, 1.0}, nature(1)),
                  BodyFault::None);
        Dynamics engine(builder.build());
        run(engine, 480);
        EXPECT_NEAR(engine.middle(0).position_m.z - at.z, 0.1, 2e-4);
    }
}

TEST(Dynamics, makes_bodies_fall_slide_and_roll_as_the_formulas_say) {
    // A ball falls freely for a quarter of a second.
    {
        DynamicsSceneBuilder builder;
        builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(5, 5, 0)});
        const DynamicsPiece box = box_of(0.2);
        ASSERT_EQ(builder.add_body(std::span(&box, 1), kThing, 0, {Vec3(0, 0, 5), {}, 1.0}, nature(1)),
                  BodyFault::None);
        Dynamics engine(builder.build());
        run(engine, 60);
        EXPECT_NEAR(engine.speed_m_per_s(0).z, -9.81 * 0.25, 1e-9);
    }
    // A ball rolls down a slope of ten degrees. After a second its speed is 5/7 g sin(10 degrees).
    {
        const double slope = kPi / 18.0;
        DynamicsSceneBuilder builder;
        builder.set_gravity(Vec3(9.81 * std::sin(slope), 0.0, -9.81 * std::cos(slope)));
        builder.add_fixed_box({Vec3(-50, -5, -1), Vec3(50, 5, 0)});
        const DynamicsPiece ball = ball_of(0.2);
        ASSERT_EQ(builder.add_body(std::span(&ball, 1), kThing, 0, {Vec3(0, 0, 0.2), {}, 1.0}, nature(1)),
                  BodyFault::None);
        Dynamics engine(builder.build());
        run(engine, 240);
        EXPECT_NEAR(engine.speed_m_per_s(0).x, 5.0 / 7.0 * 9.81 * std::sin(slope), 0.005);
    }
    // A sliding crate must stop after the distance v^2 / (2 mu g).
    {
        DynamicsSceneBuilder builder;
        builder.add_fixed_box({Vec3(-50, -5, -1), Vec3(50, 5, 0)});
        const DynamicsPiece box = box_of(0.2);
        ASSERT_EQ(builder.add_body(std::span(&box, 1), kThing, 0, {Vec3(0, 0, 0.2), {}, 1.0}, nature(4)),
                  BodyFault::None);
        Dynamics engine(builder.build());
        run(engine, 10);
        HandPush push = push_of(engine);
        // This force accelerates the crate to 2 m/s in one step.
        push.force_n = Vec3(4.0 * 2.0 / Dynamics::kStep_s, 0, 0);
        engine.push(0, push);
        run(engine, 480);
        EXPECT_NEAR(engine.middle(0).position_m.x, 2.0 * 2.0 / (2.0 * 0.4 * 9.81), 0.02);
        EXPECT_LT(glm::length(engine.speed_m_per_s(0)), 1e-3);
    }
}

TEST(Dynamics, lets_a_stack_of_five_bodies_stand_and_sleep) {
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(5, 5, 0)});
    const DynamicsPiece box = box_of(0.15);
    for (std::uint32_t i = 0; i < 5; ++i)
        ASSERT_EQ(
            builder.add_body(std::span(&box, 1), FeatureId{5 + i}, i, {Vec3(0, 0, 0.15 + 0.3 * i), {}, 1.0}, nature(2)),
            BodyFault::None);
    Dynamics engine(builder.build());
    run(engine, 1200);
    for (std::uint32_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(engine.middle(i).position_m.z, 0.15 + 0.3 * i, 2e-3);
        EXPECT_LT(std::abs(engine.middle(i).position_m.x), 2e-3);
        EXPECT_FALSE(engine.awake(i)) << i;
    }
    // An approaching hand must wake the body in front of it.
    engine.place_hand(0, {Vec3(0.17, 0, 1.35), 0.02, 0.0});
    run(engine, 1);
    EXPECT_TRUE(engine.awake(4));
}

TEST(Dynamics, lets_no_body_through_walls_floors_and_sheets_at_any_speed) {
    std::mt19937 random(11);
    const auto unit = [&] { return random() / 4294967296.0; };
    // The calls are separate statements, because compilers evaluate arguments in different orders.
    const auto three = [&] {
        const double x = unit(), y = unit();
        return Vec3(x, y, unit());
    };
    for (int run_number = 0; run_number < scaled(600); ++run_number) {
        SCOPED_TRACE(run_number);
        DynamicsSceneBuilder builder;
        builder.add_fixed_box({Vec3(-2, -2, -0.1), Vec3(2, 2, 0)});
        for (int side = 0; side < 4; ++side) {  // the walls are 5 cm thick, except for one, which is a sheet
            const double s = side % 2 ? 1.0 : -1.0;
            if (side == 3) {
                builder.add_sheet({-2, 2, 0}, {2, 2, 0}, {2, 2, 4});
                builder.add_sheet({-2, 2, 0}, {2, 2, 4}, {-2, 2, 4});
            } else if (side < 2) {
                builder.add_fixed_box({Vec3(std::min(s * 2, s * 2.05), -2, 0), Vec3(std::max(s * 2, s * 2.05), 2, 4)});
            } else {
                builder.add_fixed_box({Vec3(-2, -2.05, 0), Vec3(2, -2, 4)});
            }
        }
        builder.add_fixed_box({Vec3(-2.1, -2.1, 4), Vec3(2.1, 2.1, 4.1)});
        const double r = 0.04 + 0.1 * unit();
        const DynamicsPiece piece = run_number % 2 ? ball_of(r) : box_of(r);
        BodyNature n = nature(0.05 + unit());
        n.elasticity = 0.6;
        ASSERT_EQ(builder.add_body(std::span(&piece, 1), kThing, 0, {Vec3(0, 0, 1), {}, 1.0}, n), BodyFault::None);
        Dynamics engine(builder.build());
        for (int hit = 0; hit < 6; ++hit) {
            HandPush push = push_of(engine);
            const Vec3 way = glm::normalize(three() - 0.5);
            push.force_n = way * (n.mass_kg * 20.0 / Dynamics::kStep_s);
            push.moment_nm = three() * 0.2;
            engine.push(0, push);
            run(engine, 40);
            const Vec3 at = engine.middle(0).position_m;
            EXPECT_LT(std::max(std::abs(at.x), std::abs(at.y)), 2.0) << at.x << " " << at.y << " " << at.z;
            EXPECT_GT(at.z, 0.0);
            EXPECT_LT(at.z, 4.0);
        }
    }
}

TEST(Dynamics, puts_back_bodies_that_fall_out_of_the_world_and_reports_it) {
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-1, -1, -1), Vec3(1, 1, 0)});
    const DynamicsPiece ball = ball_of(0.1);
    ASSERT_EQ(builder.add_body(std::span(&ball, 1), kThing, 0, {Vec3(1.5, 0, 1), {}, 1.0}, nature(1)), BodyFault::None);
    Dynamics engine(builder.build());
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    int falls = 0, back = 0;
    for (int i = 0; i < 480; ++i) {
        engine.step(frame, events);
        for (const BodyEvent& event : events) {
            falls += event.kind == BodyEvent::Kind::Falls;
            if (event.kind != BodyEvent::Kind::PutBack) continue;
            ++back;
            EXPECT_EQ(engine.middle(0).position_m, Vec3(1.5, 0, 1));
        }
        events.clear();
    }
    EXPECT_EQ(back, 1);
    EXPECT_GE(falls, 1);
}

TEST(Dynamics, limits_the_number_of_moving_bodies_and_forgets_none) {
    constexpr std::uint32_t kBalls = 128;
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-20, -20, -1), Vec3(20, 20, 0)});
    const DynamicsPiece ball = ball_of(0.1);
    for (std::uint32_t i = 0; i < kBalls; ++i)
        ASSERT_EQ(
            builder.add_body(std::span(&ball, 1), FeatureId{5 + i}, i, {Vec3(i % 16, i / 16, 1), {}, 1.0}, nature(1)),
            BodyFault::None);
    Dynamics engine(builder.build());
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    std::uint32_t most = 0;
    for (int i = 0; i < 2400; ++i) {
        engine.step(frame, events);
        most = std::max(most, frame.awake);
    }
    EXPECT_EQ(most, Dynamics::kMostAwake);
    EXPECT_EQ(frame.waiting, 0U);
    for (std::uint32_t i = 0; i < kBalls; ++i) EXPECT_NEAR(engine.middle(i).position_m.z, 0.1, 2e-3) << i;
}

// Returns `count` boxes of 0.4 m in rows, which fall from `z_m`. Their centres are `apart_m` apart.
std::shared_ptr<const DynamicsScene> many_boxes(std::uint32_t count, double apart_m, double z_m,
                                                const BodyNature& nature) {
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-40, -40, -1), Vec3(40, 40, 0)});
    const DynamicsPiece box = box_of(0.2);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Placement at{Vec3(apart_m * (i % 16) - 20.0, apart_m * (i / 16) - 35.0, z_m), {}, 1.0};
        EXPECT_EQ(builder.add_body(std::span(&box, 1), FeatureId{5 + i}, i, at, nature), BodyFault::None);
    }
    return builder.build();
}

// The boxes are so close together that each moving box keeps its neighbours awake.
TEST(Dynamics, puts_every_resting_body_to_sleep_even_after_waiting) {
    for (const double z_m : {0.2, 0.3, 1.2})
        for (const bool elastic : {false, true}) {
            Dynamics engine(many_boxes(128, 0.5, z_m, elastic ? BodyNature{} : nature(4)));
            DynamicsFrame frame;
            std::vector<BodyEvent> events;
            for (int i = 0; i < 4800; ++i) engine.step(frame, events);
            EXPECT_EQ(frame.awake, 0U) << z_m << ' ' << elastic;
            EXPECT_EQ(frame.waiting, 0U) << z_m << ' ' << elastic;
        }
}

// The engine computes at most a hundred moving bodies at a time, so the others wait. All 2,048 bodies that fit into a
// scene also come to rest, in 44 s of simulated time. That computation takes 44 s, too, so this test uses fewer bodies.
TEST(Dynamics, brings_600_bodies_to_rest_in_place) {
    constexpr std::uint32_t kBodies = 600;
    Dynamics engine(many_boxes(kBodies, 0.5, 0.2, nature(4)));
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    int steps = 0;
    for (; steps < 12'000 && (steps == 0 || frame.awake + frame.waiting > 0); ++steps) engine.step(frame, events);
    EXPECT_EQ(frame.awake, 0U);
    EXPECT_EQ(frame.waiting, 0U);
    for (std::uint32_t b = 0; b < kBodies; ++b) EXPECT_NEAR(engine.middle(b).position_m.z, 0.2, 5e-4) << b;
}

TEST(Dynamics, has_room_for_2048_bodies_and_reports_which_ones_moved) {
    constexpr auto kMost = static_cast<std::uint32_t>(DynamicsScene::kMostBodies);
    ASSERT_GE(kMost, 2048U);
    Dynamics engine(many_boxes(kMost, 0.5, 0.2, nature(4)));
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    engine.step(frame, events);
    ASSERT_EQ(frame.things.size(), kMost);
    EXPECT_EQ(frame.waiting, kMost - Dynamics::kMostAwake);
    for (int i = 0; i < 60; ++i) {
        const std::vector<Placement> before = frame.things;
        engine.step(frame, events);
        std::vector<std::uint32_t> moved;
        for (std::uint32_t b = 0; b < kMost; ++b)
            if (!(frame.things[b] == before[b])) moved.push_back(b);
        ASSERT_EQ(frame.moved, moved) << i;
        EXPECT_LE(frame.awake, Dynamics::kMostAwake);
    }

    DynamicsSceneBuilder full;
    const DynamicsPiece ball = ball_of(0.1);
    for (std::uint32_t i = 0; i < kMost; ++i) full.add_body(std::span(&ball, 1), FeatureId{5 + i}, i, {}, nature(1));
    EXPECT_EQ(full.add_body(std::span(&ball, 1), kThing, 0, {}, nature(1)), BodyFault::TooMany);
}

TEST(Dynamics, moves_a_waiting_body_at_once_when_it_is_pushed) {
    Dynamics engine(many_boxes(128, 1.0, 0.2, nature(4)));
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    engine.step(frame, events);
    ASSERT_EQ(frame.waiting, 28U);
    const Vec3 begin = engine.middle(127).position_m;
    for (int i = 0; i < 120; ++i) {
        HandPush push = push_of(engine);
        push.body = 127;
        push.force_n = Vec3(40, 0, 0);
        engine.push(0, push);
        engine.step(frame, events);
    }
    EXPECT_GT(engine.middle(127).position_m.x, begin.x + 0.2);
    EXPECT_EQ(frame.awake, Dynamics::kMostAwake);
}

TEST(Dynamics, carries_a_body_on_a_lift_and_stops_a_door_at_a_jammed_body) {
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(5, 5, 0)}, kFloor);
    builder.add_fixed_box({Vec3(1.0, -1, 0), Vec3(1.5, 1, 2)}, kWall);
    const DynamicsPiece platform = make_box_piece({Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 0.1)});
    const DynamicsPiece leaf = make_box_piece({Vec3(-0.05, -0.5, 0), Vec3(0.05, 0.5, 2)});
    const std::uint32_t lift =
        builder.add_driven(std::span(&platform, 1), FeatureId{3}, kNoBody, {Vec3(-2, 0, 0), {}, 1.0});
    const std::uint32_t door =
        builder.add_driven(std::span(&leaf, 1), FeatureId{4}, kNoBody, {Vec3(0.2, 0, 0), {}, 1.0});
    const DynamicsPiece crate = box_of(0.15);
    ASSERT_EQ(builder.add_body(std::span(&crate, 1), kThing, 0, {Vec3(-2, 0, 0.25), {}, 1.0}, nature(4)),
              BodyFault::None);
    ASSERT_EQ(builder.add_body(std::span(&crate, 1), FeatureId{6}, 1, {Vec3(0.6, 0, 0.15), {}, 1.0}, nature(4)),
              BodyFault::None);
    Dynamics engine(builder.build());
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    bool blocked = false;
    // The lift rises two metres in two seconds, while the door tries to close to x = 0.95.
    for (int i = 0; i < 720; ++i) {
        const double part = std::min(1.0, i / 480.0);
        engine.drive(lift, {Vec3(-2, 0, 2.0 * part), {}, 1.0});
        engine.drive(door, {Vec3(0.2 + 0.75 * part, 0, 0), {}, 1.0});
        engine.step(frame, events);
        blocked = blocked || frame.blocked == door;
        EXPECT_LT(engine.middle(1).position_m.x, 0.87) << i;  // the crate never reaches the wall, which begins at x = 1
    }
    EXPECT_NEAR(engine.middle(0).position_m.z, 2.25, 5e-3);
    EXPECT_NEAR(engine.middle(0).position_m.x, -2.0, 5e-3);
    EXPECT_TRUE(blocked);
    EXPECT_TRUE(engine.blocked(door));
    EXPECT_NEAR(engine.middle(1).position_m.x, 0.85, 0.01);
    // The door must open again as soon as it is driven back.
    for (int i = 0; i < 120; ++i) {
        engine.drive(door, {Vec3(0.2, 0, 0), {}, 1.0});
        engine.step(frame, events);
    }
    EXPECT_EQ(frame.blocked, kNoBody);
}

TEST(Dynamics, keeps_bodies_out_of_the_walker) {
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(5, 5, 0)});
    const DynamicsPiece ball = ball_of(0.1);
    ASSERT_EQ(builder.add_body(std::span(&ball, 1), kThing, 0, {Vec3(-1, 0, 0.1), {}, 1.0}, nature(1)),
              BodyFault::None);
    Dynamics engine(builder.build());
    engine.walker(Vec3(0.0), 0.25, 1.7);
    HandPush push = push_of(engine);
    push.force_n = Vec3(2.0 / Dynamics::kStep_s, 0, 0);
    engine.push(0, push);
    for (int i = 0; i < 480; ++i) {
        run(engine, 1);
        // The bottom of the walker's capsule is round: a ball of 0.1 m touches it when the ball's centre is 0.316 m
        // from the axis.
        EXPECT_GT(glm::length(Vec2(engine.middle(0).position_m)), 0.31) << i;
    }
    // If the walker walks on, the walker must push the ball along and not walk over it.
    for (int i = 0; i < 240; ++i) {
        engine.walker(Vec3(-0.005 * i, 0, 0), 0.25, 1.7);
        run(engine, 1);
        EXPECT_GT(glm::length(Vec2(engine.middle(0).position_m - Vec3(-0.005 * i, 0, 0))), 0.31) << i;
    }
}

TEST(Dynamics, drives_a_body_by_keys_with_no_more_than_the_given_force) {
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(5, 5, 0)});
    const DynamicsPiece crate = box_of(0.15);
    ASSERT_EQ(builder.add_body(std::span(&crate, 1), kThing, 0, {Vec3(0, 0, 0.15), {}, 1.0}, nature(4)),
              BodyFault::None);
    ASSERT_EQ(builder.add_body(std::span(&crate, 1), FeatureId{6}, 1, {Vec3(2, 0, 0.15), {}, 1.0}, nature(12)),
              BodyFault::None);
    Dynamics engine(builder.build());
    const Rotation quarter = rotation_about({0, 0, 1}, kPi / 2);
    engine.lead(0, Vec3(0.5, 0.5, 0.65), 50.0, quarter);
    run(engine, 480);
    EXPECT_LT(glm::length(engine.middle(0).position_m - Vec3(0.5, 0.5, 0.65)), 0.01);
    EXPECT_NEAR(std::abs(engine.middle(0).rotation.z), std::sqrt(0.5), 0.01);
    engine.lead(1, Vec3(2, 0, 0.65), 50.0);  // the crate of 12 kg weighs 118 N, which is more than the 50 N of the hand
    run(engine, 480);
    EXPECT_NEAR(engine.middle(1).position_m.z, 0.15, 5e-3);
    EXPECT_LT(engine.middle(0).position_m.z, 0.2);  // the first crate fell after it was released
}

TEST(Dynamics, reports_what_an_impact_hit_and_how_hard) {
    DynamicsSceneBuilder builder;
    builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(5, 5, 0)}, kFloor);
    const DynamicsPiece crate = box_of(0.15);
    ASSERT_EQ(builder.add_body(std::span(&crate, 1), kThing, 0, {Vec3(0, 0, 0.65), {}, 1.0}, nature(4)),
              BodyFault::None);
    Dynamics engine(builder.build());
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    for (int i = 0; i < 720; ++i) engine.step(frame, events);
    ASSERT_FALSE(events.empty());
    const auto hit =
        std::find_if(events.begin(), events.end(), [](const BodyEvent& e) { return e.kind == BodyEvent::Kind::Hit; });
    ASSERT_NE(hit, events.end());
    EXPECT_EQ(hit->other, kFloor);
    EXPECT_NEAR(hit->impulse_ns, 4.0 * std::sqrt(2.0 * 9.81 * 0.5), 0.8);
    EXPECT_EQ(events.back().kind, BodyEvent::Kind::Rests);
}

TEST(Dynamics, refuses_bodies_without_volume_or_with_invalid_numbers) {
    DynamicsSceneBuilder builder;
    const DynamicsPiece ball = ball_of(0.1), point = ball_of(0.0);
    const auto add = [&](const DynamicsPiece& piece, BodyNature n, const Vec3& at = Vec3(0.0)) {
        return builder.add_body(std::span(&piece, 1), kThing, 0, {at, {}, 1.0}, n);
    };
    EXPECT_EQ(add(point, nature(1)), BodyFault::NoVolume);
    EXPECT_EQ(builder.add_body({}, kThing, 0, {}, nature(1)), BodyFault::NoVolume);
    EXPECT_EQ(add(ball, nature(0)), BodyFault::BadMass);
    EXPECT_EQ(add(ball, nature(std::nan(""))), BodyFault::BadMass);
    EXPECT_EQ(add(ball, nature(1e5)), BodyFault::BadMass);
    EXPECT_EQ(add(ball, nature(1, -1)), BodyFault::BadNature);
    EXPECT_EQ(add(ball, nature(1), Vec3(std::nan(""), 0, 0)), BodyFault::BadPlace);
    EXPECT_EQ(add(ball, nature(1)), BodyFault::None);
    Dynamics engine(builder.build());  // the scene has no building, so the body falls and is put back
    HandPush bad;
    bad.body = 7;
    bad.dt_s = 1e-3;
    engine.push(0, bad);
    bad.body = 0;
    bad.game = 1;
    bad.force_n = Vec3(std::nan(""), 0, 0);
    engine.push(0, bad);
    run(engine, 720);
    EXPECT_TRUE(is_finite(engine.middle(0).position_m));
}

}  // namespace engine_test
}  // namespace handrail::test
