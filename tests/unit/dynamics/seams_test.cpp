// Tests parts of a building that are flush with each other. Bodies that slide or roll over the seams must not catch,
// and real contacts must remain.
#include "haptic/dynamics/seams.h"

#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/dynamics/rig.h"

namespace handrail::test {
namespace seams_test {

// Gives body 0 the speed `speed` and the angular speed `turning` in one step. `inertia` is its moment of inertia.
void throw_it(Dynamics& engine, const Vec3& speed, const Vec3& turning, double inertia) {
    HandPush push = push_of(engine);
    push.force_n = speed * (engine.scene().bodies[0].nature.mass_kg / Dynamics::kStep_s);
    push.moment_nm = turning * (inertia / Dynamics::kStep_s);
    engine.push(0, push);
}

struct Slide {
    double bump_m = 0.0, aside_m = 0.0, speed_left = 1.0;
};

Slide over_tiles(bool ball, unsigned seed, bool cylinder = false) {
    std::mt19937 random(seed);
    const auto unit = [&] { return random() / 4294967296.0; };
    DynamicsSceneBuilder builder;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j) builder.add_fixed_box({Vec3(i, j, -0.5), Vec3(i + 1, j + 1, 0)});
    const double turn = cylinder ? 0.0 : unit() * 0.8;
    const DynamicsPiece piece = cylinder
                                    ? make_piece(RoundShape(CylinderShape{Vec3(0, -0.2, 0), Vec3(0, 1, 0), 0.4, 0.2}))
                                : ball ? ball_of(0.2)
                                       : box_of(0.2);
    EXPECT_EQ(builder.add_body(std::span(&piece, 1), kThing, 0, {Vec3(1.5, 1.5 + unit(), 0.2), {}, 1.0},
                               nature(1.0, ball || cylinder ? 0.4 : 0.0)),
              BodyFault::None);
    Dynamics engine(builder.build());
    run(engine, 60);
    const double speed = 0.5 + 4.0 * unit();
    const Vec3 way(std::cos(turn), std::sin(turn), 0.0);
    const bool rolls = ball || cylinder;
    throw_it(engine, way * speed, rolls ? Vec3(-way.y, way.x, 0) * (speed / 0.2) : Vec3(0.0),
             ball ? 0.4 * 0.04 : 0.5 * 0.04);
    run(engine, 1);
    const Vec3 start = engine.middle(0).position_m;
    const double began = glm::length(engine.speed_m_per_s(0));
    Slide slide;
    for (int i = 0; i < 2400; ++i) {
        run(engine, 1);
        const Vec3 at = engine.middle(0).position_m;
        if (at.x > 11 || at.y > 11) break;
        slide.bump_m = std::max(slide.bump_m, at.z - start.z);
        slide.aside_m = std::max(slide.aside_m, std::abs(glm::cross(way, at - start).z));
    }
    slide.speed_left = glm::length(engine.speed_m_per_s(0)) / began;
    return slide;
}

TEST(Seams, neither_catch_nor_bump_bodies_that_slide_or_roll_over_them) {
    for (const bool ball : {false, true}) {
        Slide worst;
        for (int seed = 1; seed <= scaled(100); ++seed) {
            const Slide s = over_tiles(ball, static_cast<unsigned>(seed));
            worst.bump_m = std::max(worst.bump_m, s.bump_m);
            worst.aside_m = std::max(worst.aside_m, s.aside_m);
            worst.speed_left = std::min(worst.speed_left, s.speed_left);
        }
        EXPECT_LT(worst.bump_m, 1e-4) << (ball ? "ball" : "box");
        EXPECT_LT(worst.aside_m, 5e-3) << (ball ? "ball" : "box");
        EXPECT_GT(worst.speed_left, 0.999) << (ball ? "ball" : "box");
    }
}

TEST(Seams, let_a_cylinder_roll_over_them) {
    for (int seed = 1; seed <= scaled(20); ++seed) {
        const Slide s = over_tiles(false, static_cast<unsigned>(seed), true);
        EXPECT_LT(s.bump_m, 1e-3) << seed;
        EXPECT_GT(s.speed_left, 0.97) << seed;
    }
}

TEST(Seams, handling_does_not_change_a_real_step_a_wall_or_a_hole) {
    {
        DynamicsSceneBuilder builder;
        builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(1, 5, 0)});
        builder.add_fixed_box({Vec3(1, -5, -1), Vec3(5, 5, 0.02)});
        const DynamicsPiece box = box_of(0.2);
        ASSERT_EQ(builder.add_body(std::span(&box, 1), kThing, 0, {Vec3(0, 0, 0.2), {}, 1.0}, nature(1.0, 0.0)),
                  BodyFault::None);
        Dynamics engine(builder.build());
        run(engine, 60);
        throw_it(engine, Vec3(0.5, 0, 0), Vec3(0.0), 0.0);
        run(engine, 960);
        EXPECT_LT(engine.middle(0).position_m.x, 0.801);
        EXPECT_NEAR(engine.middle(0).position_m.z, 0.2, 2e-3);
    }
    {
        DynamicsSceneBuilder builder;
        builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(1, 5, 0)});
        builder.add_fixed_box({Vec3(1, -5, 0), Vec3(2, 5, 1)});
        builder.add_fixed_box({Vec3(1, -5, -1), Vec3(5, 5, 0)});
        const DynamicsPiece ball = ball_of(0.2);
        ASSERT_EQ(builder.add_body(std::span(&ball, 1), kThing, 0, {Vec3(0, 0, 0.2), {}, 1.0}, nature(1.0, 0.4)),
                  BodyFault::None);
        Dynamics engine(builder.build());
        run(engine, 60);
        throw_it(engine, Vec3(2, 0, 0), Vec3(0.0), 0.0);
        double most = 0.0;
        for (int i = 0; i < 960; ++i) {
            run(engine, 1);
            most = std::max(most, engine.middle(0).position_m.x);
        }
        EXPECT_NEAR(most, 0.8, 3e-3);
    }
    {
        DynamicsSceneBuilder builder;
        builder.add_fixed_box({Vec3(-5, -5, -1), Vec3(1, 5, 0)});
        builder.add_fixed_box({Vec3(1.5, -5, -1), Vec3(5, 5, 0)});
        builder.add_fixed_box({Vec3(1, -5, -1), Vec3(1.5, -0.25, 0)});
        builder.add_fixed_box({Vec3(1, 0.25, -1), Vec3(1.5, 5, 0)});
        const DynamicsPiece ball = ball_of(0.2);
        ASSERT_EQ(builder.add_body(std::span(&ball, 1), kThing, 0, {Vec3(0, 0, 0.2), {}, 1.0}, nature(1.0, 0.4)),
                  BodyFault::None);
        Dynamics engine(builder.build());
        run(engine, 60);
        throw_it(engine, Vec3(0.8, 0, 0), Vec3(0.0), 0.0);
        double least = 0.0;
        for (int i = 0; i < 960; ++i) {
            run(engine, 1);
            least = std::min(least, engine.middle(0).position_m.z);
        }
        EXPECT_LT(least, -1.0);
    }
}

// The independent check examines every part of the building. The compiled scene lists only the neighbours of each part.
TEST(Seams, get_the_same_verdict_from_neighbours_as_from_all_parts_in_any_order_and_far_away) {
    std::mt19937 random(5);
    const auto unit = [&] { return random() / 4294967296.0; };
    int turned = 0, none = 0, judged = 0;
    for (int round = 0; round < scaled(40); ++round) {
        const Vec3 zero = round % 2 ? Vec3(0.0) : Vec3(4000.0, -2500.0, 100.0);
        std::vector<Aabb> boxes;
        for (int i = 0; i < 30;
             // The boxes are on a grid, so that many are flush; some overlap, and some have lips of half a millimetre.
             ++i) {
            const Vec3 low(std::floor(unit() * 4) * 0.5, std::floor(unit() * 4) * 0.5, std::floor(unit() * 2) * 0.5);
            const Vec3 size = Vec3(0.5) * Vec3(1 + std::floor(unit() * 2), 1 + std::floor(unit() * 2), 1);
            const double lip = unit() < 0.3 ? 5e-4 : 0.0;
            boxes.push_back({zero + low, zero + low + size + Vec3(0, 0, lip)});
        }
        DynamicsSceneBuilder straight(zero), back(zero);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            straight.add_fixed_box(boxes[i]);
            back.add_fixed_box(boxes[boxes.size() - 1 - i]);
        }
        const auto scene = straight.build(), reversed = back.build();
        for (int query = 0; query < 200; ++query) {
            const auto piece = static_cast<std::uint32_t>(unit() * 30.0);
            const DynamicsPiece& is = scene->building[piece];
            const Polygon& face = is.solid.faces[static_cast<std::size_t>(unit() * 6.0)];
            Vec3 at = face.points_m[0] + (face.points_m[1] - face.points_m[0]) * unit() +
                      (face.points_m[3] - face.points_m[0]) * unit();
            // Every third point is on an edge.
            if (query % 3 == 0) at = face.points_m[0] + (face.points_m[1] - face.points_m[0]) * unit();
            at += Vec3(unit() - 0.5, unit() - 0.5, unit() - 0.5) * 4e-3;
            const Vec3 normal = glm::normalize(Vec3(unit() - 0.5, unit() - 0.5, unit() - 0.5));
            const Vec3 body = at + Vec3(unit() - 0.5, unit() - 0.5, unit()) * 0.3;
            const SeamVerdict verdict = judge_seam(*scene, piece, at, normal, body);
            const SeamVerdict twin = judge_seam(is, at, normal, body, [&](std::uint32_t, const Vec3& p) {
                for (std::uint32_t other = 0; other < scene->building.size(); ++other)
                    if (other != piece && in_grown(scene->building[other], p)) return true;
                return false;
            });
            const SeamVerdict other_order =
                judge_seam(*reversed, static_cast<std::uint32_t>(boxes.size()) - 1 - piece, at, normal, body);
            ASSERT_EQ(verdict.kind, twin.kind);
            ASSERT_EQ(verdict.face, twin.face);
            ASSERT_EQ(verdict.kind, other_order.kind);
            ASSERT_EQ(verdict.face, other_order.face);
            ++judged;
            turned += verdict.kind == SeamVerdict::Kind::Face;
            none += verdict.kind == SeamVerdict::Kind::None;
        }
    }
    EXPECT_GT(turned, judged / 50);
    EXPECT_GT(none, judged / 50);
}

TEST(Seams, have_few_neighbouring_parts_even_in_a_large_building) {
    DynamicsSceneBuilder builder;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) builder.add_fixed_box({Vec3(i, j, -0.5), Vec3(i + 1, j + 1, 0)});
    const auto scene = builder.build();
    std::size_t most = 0;
    for (std::uint32_t piece = 0; piece < 400; ++piece)
        for (std::uint32_t face = 0; face < 6; ++face) most = std::max(most, scene->beside(piece, face).size());
    EXPECT_LE(most, 8U);
}

}  // namespace seams_test
}  // namespace handrail::test
