// Tests a hand and bodies in one closed loop, in virtual time: how weight, friction and mass feel. The bodies must not
// give the hand any energy.
#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/dynamics/rig.h"

namespace handrail::test {
namespace hand_test {

const HandIntent kNothing{};

TEST(BodyModel, of_four_kilograms_breaks_away_at_its_friction_and_then_slides_with_less) {
    BodyWorldMaker world;
    world.floor();
    BodyNature n = nature(4.0, 0.32);
    n.friction_static = 0.4;
    world.body(box_of(0.2), Vec3(0, 0, 0.2), n);
    HandSetup setup;
    setup.origin_m = Vec3(-0.2 - 0.04 - 0.004, 0, 0.1);
    BodyRig rig(world, {setup});
    LoopSettings settings = light_hand(3.0, 0.0);
    settings.hand.dry_friction_n = 0.0;
    ClosedLoop loop(settings, Vec3(0.0));
    double breaks_n = 0.0;
    for (int i = 0; i < 24000 && breaks_n == 0.0; ++i) {
        loop.tick(
            [&](double now) {
                return HandIntent{Vec3(0.0), Vec3(0.05 * now, 0, 0)};
            },
            [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
        // 0.015 m/s in the world is three quarters of a millimetre of the hand a second. The push grows by 0.05 N a
        // second. When the body reaches this speed, the push is 0.02 N above the force at which the body broke loose.
        if (i > 1500 && rig.engine.speed_m_per_s(0).x > 0.015) breaks_n = -rig.hands[0]->force_n.x;
    }
    EXPECT_NEAR(breaks_n, 0.4 * 4.0 * 9.81 / 20.0, 0.05 * 0.785);
    // A hand that moves at a steady 10 mm/s pushes the body along, so its mean force is the sliding friction.
    BodyWorldMaker same;
    same.floor();
    same.body(box_of(0.2), Vec3(0, 0, 0.2), n);
    BodyRig again(same, {setup});
    ClosedLoop slow(light_hand(3.0, 300.0), Vec3(0.0));
    double mean_n = 0.0;
    for (int i = 0; i < 3000; ++i) {
        slow.tick(
            [&](double now) {
                return HandIntent{Vec3(0.01 * now, 0, 0), Vec3(0.0)};
            },
            [&](const Vec3& hand, double, double) { return again.render(0, hand); });
        if (i >= 2000) mean_n -= again.hands[0]->force_n.x / 1000.0;
    }
    EXPECT_NEAR(mean_n, 0.32 * 4.0 * 9.81 / 20.0, 0.04);
}

TEST(BodyModel, is_felt_in_the_grip_with_its_true_weight) {
    for (const double kg : {0.05, 0.5, 1.0, 2.0, 4.0}) {
        SCOPED_TRACE(kg);
        BodyWorldMaker world;
        world.floor();
        world.body(box_of(0.2), Vec3(0, 0, 0.2), nature(kg));
        HandSetup setup;
        setup.origin_m = Vec3(0, 0, 0.39);
        BodyRig rig(world, {setup});
        rig.hands[0]->want_grip = true;
        ClosedLoop loop(light_hand(3.0), Vec3(0.0));
        double mean_n = 0.0;
        for (int i = 0; i < 4000; ++i) {
            loop.tick(
                [&](double now) {
                    return HandIntent{Vec3(0, 0, 0.02 * std::clamp(now - 0.3, 0.0, 1.0)), Vec3(0.0)};
                },
                [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
            if (i >= 3000) mean_n -= rig.hands[0]->force_n.z / 1000.0;
        }
        EXPECT_EQ(rig.hands[0]->bodies().holds(), 0U);
        EXPECT_GT(rig.engine.middle(0).position_m.z, 0.25);
        EXPECT_NEAR(mean_n, kg * 9.81 / 20.0, 0.02 * kg * 9.81 / 20.0 + 1e-3);
        // When released, the body must fall and come to rest where it was before.
        rig.hands[0]->want_grip = false;
        for (int i = 0; i < 1500; ++i)
            loop.tick(
                [&](double) {
                    return HandIntent{Vec3(0, 0, 0.02), Vec3(0.0)};
                },
                [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
        EXPECT_NEAR(rig.engine.middle(0).position_m.z, 0.2, 3e-3);
    }
}

TEST(BodyModel, is_felt_with_its_true_mass) {
    for (const double kg : {0.05, 1.0, 4.0}) {
        SCOPED_TRACE(kg);
        BodyWorldMaker world;
        world.floor();
        world.body(ball_of(0.2), Vec3(0, 0, 0.2), nature(kg, 0.0));
        HandSetup setup;
        setup.origin_m = Vec3(-0.2 - 0.04 - 0.004, 0, 0.2);
        BodyRig rig(world, {setup});
        LoopSettings settings = light_hand(0.0, 0.0);
        settings.hand.damping_ns_per_m = settings.hand.dry_friction_n = 0.0;
        ClosedLoop loop(settings, Vec3(0.0));
        double n = 0, st = 0, sv = 0, stt = 0, stv = 0;
        for (int i = 0; i < 1000; ++i) {
            const LoopTick t = loop.tick(
                [&](double) {
                    return HandIntent{Vec3(0.0), Vec3(0.3, 0, 0)};
                },
                [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
            if (i < 200) continue;
            const double at = 1e-3 * i, v = t.velocity_m_per_s.x;
            ++n, st += at, sv += v, stt += at * at, stv += at * v;
        }
        const double a = (n * stv - st * sv) / (n * stt - st * st);
        EXPECT_NEAR(0.3 / a - 0.4, kg, 0.05 * kg + 0.002);
    }
}

// Returns the greatest energy in mJ that the bodies give the hand. The hand follows a prescribed path exactly, without
// delay and encoder. The path is a random closed path of four seconds, followed by a second of rest. Nothing is damped.
double worst_energy_mj(bool push, double kg, int seeds) {
    double worst = -1e9;
    for (int seed = 1; seed <= seeds; ++seed) {
        BodyWorldMaker world;
        world.floor();
        BodyNature n = nature(kg, 0.0);
        n.elasticity = 0.9;
        if (push) n.string = BodyNature::String{Vec3(0, 0, 0.2), 20.0};
        else world.dynamics().set_gravity(Vec3(0.0));
        world.body(ball_of(0.2), Vec3(0, 0, push ? 0.2 : 3.0), n);
        HandSetup setup;
        setup.stiffness_n_per_m = setup.grip_n_per_m = 400.0;
        setup.damping_ns_per_m = setup.grip_ns_per_m = 0.0;
        setup.origin_m = push ? Vec3(-0.24, 0, 0.2) : Vec3(-0.21, 0, 3.0);
        BodyRig rig(world, {setup});
        rig.hands[0]->want_grip = !push;
        std::mt19937 random(static_cast<unsigned>(seed));
        double phase[4], size[4];
        for (int k = 0; k < 4; ++k) {
            phase[k] = random() / 4294967296.0 * 2.0 * kPi;
            size[k] = 0.004 / (k + 1) * (0.5 + random() / 4294967296.0);
        }
        const auto path = [&](double t) {
            t = std::min(t, 4.0);
            double x = 0.0;
            for (int k = 0; k < 4; ++k) x += size[k] * (std::sin(kPi * (k + 1) * t + phase[k]) - std::sin(phase[k]));
            return Vec3(x, 0, 0);
        };
        double work = 0.0;
        Vec3 last(0.0), last_n(0.0);
        for (int i = 0; i < 5000; ++i) {
            const Vec3 hand = path(1e-3 * i), force = rig.render(0, hand);
            if (i > 0) work += glm::dot(0.5 * (force + last_n), hand - last);
            last = hand;
            last_n = force;
        }
        worst = std::max(worst, 1e3 * work);
    }
    return worst;
}

TEST(BodyModel, gives_the_hand_no_energy_on_closed_paths_without_any_damping) {
    for (const bool push : {false, true})
        for (const double kg : {0.05, 0.2, 1.0}) {
            const double worst = worst_energy_mj(push, kg, scaled(20));
            EXPECT_LE(worst, 0.05) << (push ? "pushed against a string, " : "in the grip, ") << kg << " kg";
            RecordProperty((push ? "push_" : "grip_") + std::to_string(kg), std::to_string(worst));
        }
}

TEST(BodyModel, does_not_vibrate_in_a_light_hand_with_a_late_engine) {
    for (const double kg : {0.05, 0.2, 1.0, 4.0})
        for (const int late : {1, 4, 16}) {
            SCOPED_TRACE(testing::Message() << kg << " kg, " << late << " ms late");
            BodyWorldMaker world;
            world.floor();
            world.body(ball_of(0.2), Vec3(0, 0, 3.0), nature(kg, 0.0));
            HandSetup setup;
            setup.grip_n_per_m = 1567.0;
            setup.latency_ticks = late;
            setup.origin_m = Vec3(-0.21, 0, 3.0);
            BodyRig rig(world, {setup});
            rig.hands[0]->want_grip = true;
            ClosedLoop loop(light_hand(), Vec3(0.0));
            const double weight_n = kg * 9.81 / 20.0;
            std::vector<double> before, after, place_before, place_after;
            for (int i = 0; i < 4500; ++i) {
                loop.tick(
                    [&](double now) {
                        return HandIntent{Vec3(now > 0.5 && now < 0.6 ? 0.004 : 0.0, 0, 0), Vec3(0, 0, weight_n)};
                    },
                    [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
                (i < 3000 ? before : after).push_back(rig.hands[0]->force_n.x);
                (i < 3000 ? place_before : place_after).push_back(rig.engine.middle(0).position_m.x / 20.0);
            }
            before.erase(before.begin(), before.begin() + 1500);
            place_before.erase(place_before.begin(), place_before.begin() + 1500);
            EXPECT_TRUE(peak_to_peak(place_after) < 0.15e-3 ||
                        peak_to_peak(place_after) < 0.8 * peak_to_peak(place_before))
                << peak_to_peak(place_after);
            EXPECT_TRUE(peak_to_peak(after) < 0.15 + 0.18e-3 * 1567 || peak_to_peak(after) < 0.8 * peak_to_peak(before))
                << peak_to_peak(after);
        }
}

TEST(BodyModel, dropped_on_a_still_hand_never_rises_above_its_starting_height) {
    for (const double kg : {0.05, 1.0}) {
        SCOPED_TRACE(kg);
        BodyWorldMaker world;
        world.floor();
        world.body(box_of(0.2), Vec3(0, 0, 1.70), nature(kg));
        HandSetup setup;
        setup.origin_m = Vec3(0, 0, 1);
        BodyRig rig(world, {setup});
        ClosedLoop loop(light_hand(3.0), Vec3(0.0));
        double rises = 0.0, force = 0.0;
        for (int i = 0; i < 2500; ++i) {
            loop.tick([&](double) { return kNothing; },
                      [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
            force = std::max(force, glm::length(rig.hands[0]->force_n));
            if (i > 450) rises = std::max(rises, rig.engine.middle(0).position_m.z);
        }
        EXPECT_GT(force, 0.02) << "it was felt";
        EXPECT_LT(rises, 1.70);
    }
}

TEST(BodyModel, can_be_moved_by_two_hands_at_once_and_rests_between_them) {
    for (const double kg : {0.05, 0.2, 1.0, 4.0}) {
        SCOPED_TRACE(kg);
        BodyWorldMaker world;
        world.floor();
        world.body(box_of(0.2), Vec3(0, 0, 0.2), nature(kg, 0.0));
        HandSetup left, right;
        left.origin_m = Vec3(-0.24, 0, 0.2);
        right.origin_m = Vec3(0.24, 0, 0.2);
        BodyRig rig(world, {left, right});
        ClosedLoop a(light_hand(), Vec3(-0.001, 0, 0)), b(light_hand(), Vec3(0.001, 0, 0));
        std::vector<double> force, at;
        const double press = 1.0 / 300 + 1.0 / 800;
        for (int i = 0; i < 6000; ++i) {
            a.tick(
                [&](double now) {
                    return HandIntent{Vec3(press + (now > 2 ? 0.005 : 0), 0, 0), Vec3(0.0)};
                },
                [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
            b.tick(
                [&](double now) {
                    return HandIntent{Vec3(-press + (now > 2 ? 0.005 : 0), 0, 0), Vec3(0.0)};
                },
                [&](const Vec3& hand, double, double) { return rig.render(1, hand); });
            if (i < 5000) continue;
            force.push_back(rig.hands[0]->force_n.x);
            at.push_back(rig.engine.middle(0).position_m.x / 20.0);
        }
        EXPECT_LT(peak_to_peak(force), 0.05);
        EXPECT_NEAR(at.back(), 0.005, 0.5e-3);
        EXPECT_NEAR(rig.hands[0]->force_n.x, -1.0, 0.1);
    }
}

TEST(BodyModel, squeezed_between_hand_and_wall_stands_still_and_feels_like_the_wall) {
    for (const double kg : {0.05, 1.0, 400.0}) {
        SCOPED_TRACE(kg);
        BodyWorldMaker world;
        world.floor();
        world.box({Vec3(0.2, -5, 0), Vec3(1.2, 5, 5)}, kWall);
        world.body(box_of(0.2), Vec3(0, 0, 0.2), nature(kg));
        HandSetup setup;
        setup.stiffness_n_per_m = 1567.0;
        setup.origin_m = Vec3(-0.24, 0, 0.2);
        BodyRig rig(world, {setup});
        ClosedLoop loop(light_hand(), Vec3(-0.002, 0, 0));
        std::vector<double> force, at;
        for (int i = 0; i < 4500; ++i) {
            loop.tick(
                [&](double) {
                    return HandIntent{Vec3(2.5 / 300, 0, 0), Vec3(0.0)};
                },
                [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
            if (i < 3500) continue;
            force.push_back(rig.hands[0]->force_n.x);
            at.push_back(rig.engine.middle(0).position_m.x);
        }
        EXPECT_LT(peak_to_peak(force), 0.35);
        EXPECT_LT(std::abs(at.back()), 0.006);  // 0.006 m of the world are a third of a millimetre of the hand
        EXPECT_LT(rig.hands[0]->force_n.x, -1.2);
    }
}

TEST(BodiesInReach, pushed_in_a_row_or_a_stack_never_pass_through_each_other) {
    BodyWorldMaker world;
    world.floor();
    for (int i = 0; i < 3; ++i) world.body(box_of(0.15), Vec3(0.31 * i, 0, 0.15), nature(1.0, 0.3));
    world.body(box_of(0.15), Vec3(0, 0, 0.45), nature(1.0, 0.3));  // the second body stands on the first one
    HandSetup setup;
    setup.origin_m = Vec3(-0.15 - 0.04 - 0.02, 0, 0.12);
    BodyRig rig(world, {setup});
    ClosedLoop loop(light_hand(3.0), Vec3(0.0));
    double most_j = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const LoopTick t = loop.tick(
            [&](double now) {
                return HandIntent{Vec3(0.02 * std::min(now, 2.0), 0, 0), Vec3(0.0)};
            },
            [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
        most_j = std::max(most_j, t.work_j);
    }
    EXPECT_GT(rig.engine.middle(0).position_m.x, 0.5);
    for (std::uint32_t i = 0; i + 1 < 3; ++i)
        EXPECT_GT(rig.engine.middle(i + 1).position_m.x - rig.engine.middle(i).position_m.x, 0.29) << i;
    EXPECT_NEAR(rig.engine.middle(3).position_m.z, 0.45, 0.01);
    EXPECT_NEAR(rig.engine.middle(3).position_m.x, rig.engine.middle(0).position_m.x, 0.1);
    EXPECT_LT(most_j, 5e-5);
}

TEST(BodiesInReach, hold_a_plank_jammed_in_a_corridor_with_no_more_than_the_ceiling) {
    BodyWorldMaker world;
    world.floor();
    world.box({Vec3(-3, 0.25, 0), Vec3(3, 0.5, 1)}, kWall);
    world.box({Vec3(-3, -0.5, 0), Vec3(3, -0.25, 1)}, kWall);
    // The corridor is half a metre wide. The plank is longer, so it jams when it turns.
    const DynamicsPiece plank = make_box_piece({Vec3(-0.3, -0.1, -0.1), Vec3(0.3, 0.1, 0.1)});
    world.body(plank, Vec3(0, 0, 0.1), nature(2.0, 0.6));
    HandSetup setup;
    setup.ceiling_n = 2.5;
    setup.friction = 0.3;
    // The hand pushes away from the plank's middle, so that the plank turns.
    setup.origin_m = Vec3(-0.3 - 0.04 - 0.02, 0.08, 0.1);
    BodyRig rig(world, {setup});
    ClosedLoop loop(light_hand(3.0), Vec3(0.0));
    double most_n = 0.0;
    for (int i = 0; i < 4000; ++i) {
        loop.tick(
            [&](double now) {
                return HandIntent{Vec3(0.02 * now, 0, 0), Vec3(0.0)};
            },
            [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
        most_n = std::max(most_n, glm::length(rig.hands[0]->force_n));
        const Vec3 at = rig.engine.middle(0).position_m;
        ASSERT_LT(std::abs(at.y), 0.2) << i;
        ASSERT_GT(at.z, 0.05) << i;
    }
    EXPECT_LE(most_n, 2.5 + 1e-12);
}

TEST(BodiesInReach, let_a_safe_slip_out_of_the_grip_at_the_ceiling_and_report_it_as_heavy) {
    BodyWorldMaker world;
    world.floor();
    world.body(box_of(0.3), Vec3(0, 0, 0.3), nature(400.0));
    HandSetup setup;
    setup.ceiling_n = 2.5;
    setup.origin_m = Vec3(0, 0, 0.59);
    BodyRig rig(world, {setup});
    rig.hands[0]->want_grip = true;
    ClosedLoop loop(light_hand(3.0), Vec3(0.0));
    int heavy = 0;
    double most_n = 0.0;
    bool slipped = false;
    for (int i = 0; i < 4000; ++i) {
        loop.tick(
            [&](double now) {
                return HandIntent{Vec3(0, 0, 0.04 * now), Vec3(0.0)};
            },
            [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
        heavy += rig.hands[0]->bodies().heavy() == 0U;
        most_n = std::max(most_n, glm::length(rig.hands[0]->force_n));
        if (rig.hands[0]->bodies().holds() == kNoBody && i > 100) {
            slipped = true;
            rig.hands[0]->want_grip = false;
        }
    }
    EXPECT_TRUE(slipped);
    EXPECT_GE(heavy, 1);
    EXPECT_LE(most_n, 2.5 + 1e-12);
    EXPECT_NEAR(rig.engine.middle(0).position_m.z, 0.3, 1e-3);
}

TEST(BodiesInReach, stay_upright_in_the_grip_and_turn_in_quarter_turns) {
    BodyWorldMaker world;
    world.floor();
    const DynamicsPiece plank = make_box_piece({Vec3(-0.4, -0.1, -0.05), Vec3(0.4, 0.1, 0.05)});
    world.body(plank, Vec3(0, 0, 0.05), nature(1.0));
    HandSetup setup;
    setup.origin_m = Vec3(0.3, 0, 0.09);  // the hand grips far from the plank's centre
    BodyRig rig(world, {setup});
    rig.hands[0]->want_grip = true;
    ClosedLoop loop(light_hand(3.0), Vec3(0.0));
    const auto run = [&](int ticks, double lift_m) {
        for (int i = 0; i < ticks; ++i)
            loop.tick(
                [&](double) {
                    return HandIntent{Vec3(0, 0, lift_m), Vec3(0.0)};
                },
                [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
    };
    run(2000, 0.04);
    const Placement lifted = rig.engine.middle(0);
    EXPECT_GT(lifted.position_m.z, 0.4);
    // The plank's weight turns it by less than 20 degrees.
    EXPECT_GT(std::abs(lifted.rotation.w), std::cos(0.5 * 0.35));
    rig.hands[0]->bodies().turn_held(rotation_about({0, 0, 1}, kPi / 2));
    run(1500, 0.04);
    const Rotation turned = rig.engine.middle(0).rotation;
    EXPECT_NEAR(std::abs(turned.z), std::sqrt(0.5), 0.12);
}

TEST(BodiesInReach, give_bit_identical_results_in_two_runs) {
    const auto play = [] {
        BodyWorldMaker world;
        world.floor();
        for (int i = 0; i < 4; ++i)
            world.body(i % 2 ? ball_of(0.15) : box_of(0.15), Vec3(0.4 * i, 0.01 * i, 0.15), nature(0.5 + i, 0.3));
        HandSetup setup;
        setup.origin_m = Vec3(-0.25, 0, 0.14);
        BodyRig rig(world, {setup});
        ClosedLoop loop(light_hand(3.0), Vec3(0.0));
        std::vector<double> felt;
        for (int i = 0; i < 1500; ++i) {
            rig.hands[0]->want_grip = i > 900 && i < 1200;
            loop.tick(
                [&](double now) {
                    return HandIntent{Vec3(0.03 * now, 0.002 * std::sin(5 * now), 0), Vec3(0.0)};
                },
                [&](const Vec3& hand, double, double) { return rig.render(0, hand); });
            for (int k = 0; k < 3; ++k) felt.push_back(rig.hands[0]->force_n[k]);
        }
        for (std::uint32_t b = 0; b < 4; ++b)
            for (int k = 0; k < 3; ++k) felt.push_back(rig.engine.middle(b).position_m[k]);
        return felt;
    };
    EXPECT_EQ(play(), play());
}

// Moves two equal hands along the same path. One of them examines every body on every tick, the other only the moving
// ones.
TEST(BodiesInReach, considering_only_moving_ones_gives_the_same_result_as_considering_all) {
    BodyWorldMaker world;
    world.floor();
    for (int i = 0; i < 24; ++i) world.body(i % 2 ? ball_of(0.1) : box_of(0.1), Vec3(0.3 * i, 0.0, 0.1), nature(1));
    HandSetup setup;
    const auto moves = world.moves();
    const auto felt = world.felt();
    Dynamics engine(moves);
    Hand hand(0, felt, *moves, setup), twin(0, felt, *moves, setup);
    DynamicsFrame frame;
    std::vector<BodyEvent> events;
    engine.step(frame, events);
    std::size_t most = 0, least = 24;
    for (int i = 0; i < 12000; ++i) {
        const double now_s = Dynamics::kStep_s + 1e-3 * i;
        // The hand approaches the first bodies, holds one of them for a while, and leaves.
        const Vec3 goal = Vec3(-0.6 + 0.25e-3 * std::min(i, 6000), 0.02, 0.12 + (i > 7000 ? 1.0 : 0.0)) / setup.scale;
        for (Hand* each : {&hand, &twin}) {
            each->want_grip = i % 3000 > 2500;
            if (i % 50 != 7) each->hear(frame);  // sometimes both hands miss a frame
        }
        twin.bodies().show_all();
        hand.tick(goal, now_s, 1e-3);
        twin.tick(goal, now_s, 1e-3);
        ASSERT_EQ(hand.poses(), twin.poses()) << i;
        ASSERT_EQ(hand.force_n, twin.force_n) << i;
        most = std::max(most, hand.bodies().lively());
        least = std::min(least, hand.bodies().lively());
        hand.send_to(engine);
        for (HandPush push; twin.pushes.pop(push);) {
        }
        if (i == 9000) engine.restart();
        while (engine.time_s() + Dynamics::kStep_s <= now_s + 1e-3) engine.step(frame, events);
        events.clear();
    }
    EXPECT_GT(most, 0U);
    EXPECT_EQ(least, 0U) << "whatever rests costs a tick nothing";
}

TEST(BodiesInReach, stand_still_while_the_engine_is_silent_and_move_again_when_it_answers) {
    BodyWorldMaker world;
    world.floor();
    world.body(box_of(0.2), Vec3(0, 0, 0.2), nature(1.0));
    HandSetup setup;
    setup.origin_m = Vec3(-0.24, 0, 0.2);
    setup.latency_ticks = 400;
    BodyRig rig(world, {setup});
    for (int i = 0; i < 3000; ++i) {
        const Vec3 force = rig.render(0, Vec3(std::min(0.002, 2e-6 * i), 0, 0));
        ASSERT_TRUE(is_finite(force)) << i;
        ASSERT_LT(glm::length(force), 4.0) << i;
    }
    EXPECT_GT(rig.engine.middle(0).position_m.x, -0.01);
}

}  // namespace hand_test
}  // namespace handrail::test
