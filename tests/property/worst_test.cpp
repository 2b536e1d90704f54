// Tests places where more obstacles are near the proxy than a tick has time for. The work of a tick stays bounded, and
// the proxy never crosses an obstacle that it had no time to examine. Work is counted, not timed.
#include <algorithm>

#include "haptic/servo/body_playback.h"
#include "tests/property/replay.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/worst_cases.h"

namespace handrail::test {
namespace worst_test {

constexpr double kTick_s = 1e-3;

// Returns the distance between a place and the nearest sheet of the scene, in the judge's arithmetic; at most `far_m`.
double sheet_distance(const HapticScene& scene, const Vec3& at_m, double far_m) {
    long double nearest = far_m;
    const Vec3 local = at_m - scene.origin_m;
    scene.obstacle_bvh.within(local, far_m, [&](std::uint32_t item, double&) {
        const Corners& t = scene.mesh.triangles[scene.obstacles[item].shape];
        const auto corner = [&](std::size_t k) { return LVec(scene.mesh.points_m[t[k]]); };
        nearest = std::min(nearest, nearest_on_triangle(corner(0), corner(1), corner(2), LVec(local)).distance);
    });
    return static_cast<double>(nearest);
}

class WorstTicks : public testing::TestWithParam<int> {};

TEST_P(WorstTicks, stay_within_their_work_budget_and_never_pass_through_a_surface) {
    const WorstCase worst = worst_case(GetParam(), scaled(700));
    SCOPED_TRACE(worst.name);
    const HapticScene& scene = *worst.scene;
    TouchState state;
    std::vector<BodyPose> poses;
    for (const HapticBody& body : scene.bodies) poses.push_back({body.start, true});
    int most_work = 0, most_looks = 0;
    long waits = 0, moved = 0;
    double deepest = 0.0;
    for (std::size_t i = 0; i < worst.goals_m.size(); ++i) {
        if (worst.move) worst.move(i, poses);
        const TouchResult r =
            touch_tick(state, scene, worst.tuning, worst.goals_m[i], kTick_s, Vec3(0.0), {poses, i + 1});
        const SolverProbe solver(state.solver());
        ASSERT_TRUE(is_finite(r.force_n) && is_finite(r.proxy_m));
        most_work = std::max(most_work, solver.work());
        most_looks = std::max(most_looks, solver.looks());
        waits += r.contacts.waits;
        moved += glm::length(r.slide_m) > 0.0;
        ASSERT_TRUE(solver.work() <= ProxySolver::kMostWork || r.contacts.waits) << "what is over the budget is said";
        if (r.contacts.ghosted) continue;
        // The proxy is outside all obstacles along its path. The test's steps are shorter than the proxy's radius, so
        // they cannot jump over a sheet.
        for (int k = 0; k < solver.path_size(); ++k) {
            const Vec3 from = solver.path_m(std::max(0, k - 1)), way = solver.path_m(k) - from;
            const int parts = scene.mesh.triangles.empty()
                                  ? 1
                                  : std::clamp(static_cast<int>(std::ceil(2.0 * glm::length(way) / r.radius_m)), 1, 8);
            for (int p = 1; p <= parts && !scene.mesh.triangles.empty() && i % 3 == 0; ++p) {
                const Vec3 at = from + way * (static_cast<double>(p) / parts);
                deepest = std::max(deepest, r.radius_m - sheet_distance(scene, at, r.radius_m));
            }
        }
        for (std::size_t b = 0; b < scene.bodies.size() && i % 3 == 0; ++b) {
            if (!solver.tracks(b)) continue;
            const PlacedFrame frame(solver.body_at(b));
            const HapticScene& shape = *scene.bodies[b].shape;
            const Vec3 own = frame.to_own(r.proxy_m);
            // Every one of these shapes is closed around its origin, and the proxy's centre must stay outside. Meshes
            // are balls of 0.3 m.
            if (shape.mesh.triangles.empty()) {
                const Vec3 over = glm::max(glm::abs(own) - Vec3(kBox_m / 2.0), Vec3(0.0));
                deepest = std::max(deepest, r.radius_m - glm::length(over));
                continue;
            }
            deepest = std::max(deepest, r.radius_m - sheet_distance(shape, own, r.radius_m));
            ASSERT_GT(glm::length(own), 0.29) << "tick " << i << ", body " << b;
        }
    }
    std::cout << worst.name << ": " << most_work << " of work at most, " << most_looks << " looks, " << waits
              << " ticks waited, " << moved << " moved\n";
    EXPECT_LE(most_work, 2 * ProxySolver::kMostWork);
    EXPECT_LE(most_looks, ProxySolver::kMostWork / 50 + 6 * 128);
    EXPECT_LE(deepest, 1e-9);
    // Under a sanitizer the walk is shorter and need not reach these limits.
    if (kSanitizerScale == 1.0) {
        EXPECT_GT(moved, static_cast<long>(worst.goals_m.size()) / 20) << "waiting is not standing still for ever";
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, WorstTicks, testing::Range(0, kWorstCases));

// ---- bodies that are far away ----

// A hall full of bodies, some of which wander, jump, appear and vanish, and a hand that moves fast among them.
TEST(TrackedBodies, give_bit_identical_results_to_tracking_all_bodies) {
    const auto seed = seed_of_run();
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::size_t held = 0;
    const int ticks = scaled(6000);
    for (int round = 0; round < 4; ++round) {
        SCOPED_TRACE(fmt::format("seed {}, round {}", seed, round));
        HapticSceneBuilder box, mesh, builder;
        box.add_box({Vec3(-0.1), Vec3(0.1)});
        mesh.add_triangle({-0.15, -0.1, 0}, {0.15, -0.1, 0.02}, {0, 0.15, 0});
        mesh.add_triangle({-0.15, -0.1, 0}, {0.15, -0.1, 0.02}, {0, 0.0, 0.1});
        const auto box_shape = box.build(), mesh_shape = mesh.build();
        builder.add_box({{-6, -6, -1}, {6, 6, -0.2}});
        std::vector<BodyPose> poses;
        for (int b = 0; b < 300; ++b) {
            const Placement at{Vec3(uniform(-5, 5), uniform(-5, 5), uniform(-0.2, 0.4)),
                               rotation_about({0, 0, 1}, uniform(0, 6)), uniform(0.7, 1.3)};
            const bool present = random() % 8 != 0;
            builder.add_body(FeatureId{static_cast<std::uint32_t>(b)}, random() % 2 ? box_shape : mesh_shape, at,
                             present);
            poses.push_back({at, present});
        }
        const auto scene = builder.build();
        ProxySolver near, all;
        SolverProbe::track_all(all);
        const SolverProbe near_probe(near), all_probe(all);
        BodyFrame frame;
        BodyPlayback playback;
        frame.push(scene->generation, 0.0, poses);
        ProxySolver::Request request;
        Vec3 goal(0.0), way(1e-3, 0.0, 0.0);
        std::size_t most = 0;
        int parted = 0;
        double next_s = 0.0;
        for (int i = 0; i < ticks; ++i) {
            const double now_s = i * kTick_s;
            if (now_s >= next_s) {
                next_s = now_s + uniform(0.012, 0.02) *
                                     (random() % 50 == 0 ? 12.0 : 1.0);  // at times, no body moves for a while
                for (int k = 0; k < 40; ++k) {
                    BodyPose& pose = poses[random() % poses.size()];
                    const std::uint32_t what = random() % 40;
                    if (what == 0) pose.present = !pose.present;
                    else if (what == 1)
                        pose.at.position_m = goal + Vec3(uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-0.2, 0.2));
                    else if (what == 2) pose.at.position_m = Vec3(uniform(-5, 5), uniform(-5, 5), 0.0);
                    else pose.at.position_m += Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-0.2, 0.2)) * 0.03;
                }
                frame.push(scene->generation, now_s, poses);
            }
            if (random() % 300 == 0)
                way = glm::normalize(Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-0.3, 0.3)) - goal * 0.3) *
                      uniform(0.0, 4e-3);
            const Vec3 before = goal;
            goal += way;
            const BodyPoses at = playback.at(frame, *scene, std::max(0.0, now_s - 0.02));
            request.goal_m = goal;
            request.path_cap_m = std::max(5e-4, 2.0 * glm::length(goal - before));
            request.growth_m = 2e-5;
            request.bodies = &at;
            const ProxySolver::Step& a = near.move(*scene, request);
            const ProxySolver::Step& b = all.move(*scene, request);
            if (a.waits || b.waits || near_probe.hurries() || all_probe.hurries()) {
                // Which bodies are tracked affects how much work a tick has time for, and how far the proxy hurries in
                // one tick. The results may therefore differ, so both solvers start again.
                ++parted;
                near.reset();
                all.reset();
                continue;
            }
            ASSERT_EQ(near.world_m(), all.world_m()) << "tick " << i;
            ASSERT_EQ(near.radius_m(), all.radius_m()) << "tick " << i;
            ASSERT_EQ(a.count, b.count) << "tick " << i;
            for (int k = 0; k < a.count; ++k) {
                const auto h = static_cast<std::size_t>(k);
                ASSERT_TRUE(a.holds[h].body == b.holds[h].body && a.holds[h].obstacle == b.holds[h].obstacle &&
                            a.holds[h].normal == b.holds[h].normal);
            }
            most = std::max(most, near_probe.tracked());
            held += static_cast<std::size_t>(a.count > 0 && a.holds[0].body != ProxySolver::kStill);
        }
        EXPECT_EQ(all_probe.tracked(), 300U);
        EXPECT_LT(most, 150U);
        EXPECT_LT(parted, ticks / 20);
    }
    if (kSanitizerScale == 1.0) {
        EXPECT_GT(held, static_cast<std::size_t>(ticks) / 20) << "bodies were met";
    }
}

// A street of 2,000 doors. The hand leans on each closed door, the door opens, and the hand goes through.
TEST(TrackedBodies, let_an_office_open_each_of_two_thousand_doors_to_the_hand) {
    constexpr std::size_t kDoors = 2000, kRow = 50;
    const std::size_t visited_every = static_cast<std::size_t>(1.0 / kSanitizerScale);
    HapticSceneBuilder leaf, builder;
    leaf.add_box({{0.0, -0.02, 0.0}, {0.9, 0.02, 2.0}});  // the hinge of the leaf is at the origin
    const auto shape = leaf.build();
    std::vector<BodyPose> poses;
    for (std::size_t d = 0; d < kDoors; ++d) {
        const Vec3 hinge(1.2 * static_cast<double>(d % kRow), 3.0 * static_cast<double>(d / kRow), 0.0);
        // A wall from this door to the next.
        builder.add_box({hinge + Vec3(0.91, -0.05, 0.0), hinge + Vec3(1.19, 0.05, 2.0)});
        ASSERT_TRUE(builder.add_body(FeatureId{static_cast<std::uint32_t>(d)}, shape, {hinge, {}, 1.0}));
        poses.push_back({{hinge, {}, 1.0}, true});
    }
    const auto scene = builder.build();
    ASSERT_EQ(scene->bodies.size(), kDoors);
    BodyFrame frame;
    BodyPlayback playback;
    TouchState state;
    TouchTuning tuning = plain_tuning(0.005);
    double now_s = 0.0;
    frame.push(scene->generation, now_s, poses);
    Vec3 hand(0.45, -0.3, 1.0);
    std::size_t most = 0;
    int most_work = 0;
    TouchResult last;
    const auto tick = [&](const Vec3& goal) {
        now_s += kTick_s;
        last = touch_tick(state, *scene, tuning, hand = goal, kTick_s, Vec3(0.0),
                          playback.at(frame, *scene, now_s - 0.02));
        most = std::max(most, SolverProbe(state.solver()).tracked());
        most_work = std::max(most_work, SolverProbe(state.solver()).work());
    };
    const auto go = [&](const Vec3& to, double step_m) {
        for (int parts = std::max(1, static_cast<int>(std::ceil(glm::length(to - hand) / step_m))); parts > 0; --parts)
            tick(hand + (to - hand) / static_cast<double>(parts));
    };
    for (std::size_t d = 0; d < kDoors; d += visited_every) {
        const Vec3 hinge = poses[d].at.position_m, before = hinge + Vec3(0.45, -0.3, 1.0);
        if (hinge.y != hand.y + 0.3) go(Vec3(hand.x, before.y, 1.0), 0.02);
        state.reset();  // the hand moves to the next door over the walls
        go(before, 0.02);
        go(hinge + Vec3(0.45, -0.02, 1.0), 0.02);
        ASSERT_EQ(last.contacts.count, 1) << "door " << d;
        ASSERT_NEAR(glm::length(last.force_n), 5.0, 1e-6);
        go(before, 0.02);
        // The leaf swings away from the hand by a right angle.
        for (int part = 1; part <= 6; ++part) {
            poses[d].at.rotation = rotation_about({0, 0, 1}, 0.5 * kPi * part / 6.0);
            frame.push(scene->generation, now_s, poses);
            for (int i = 0; i < 16; ++i) tick(hand);
        }
        for (int i = 0; i < 30; ++i) tick(hand);
        go(hinge + Vec3(0.45, 0.3, 1.0), 0.02);
        ASSERT_EQ(last.contacts.count, 0) << "door " << d;
        ASSERT_EQ(last.proxy_m, hand) << "door " << d;
        go(before, 0.02);
    }
    EXPECT_LT(most, 16U);
    EXPECT_LE(most_work, ProxySolver::kMostWork);
}

TEST(TrackedBodies, cost_nothing_while_they_are_far_away) {
    HapticSceneBuilder crate, builder;
    crate.add_box({Vec3(-0.1), Vec3(0.1)});
    const auto shape = crate.build();
    builder.add_box({{-1, -1, -1}, {1, 1, 0}});
    std::vector<BodyPose> poses;
    for (int b = 0; b < 20; ++b) {
        const Placement at{Vec3(std::cos(0.3 * b), std::sin(0.3 * b), 0.3) * 2.0, {}, 1.0};
        builder.add_body(FeatureId{static_cast<std::uint32_t>(b)}, shape, at);
        poses.push_back({at, true});
    }
    const auto scene = builder.build();
    BodyFrame frame;
    frame.push(scene->generation, 0.0, poses);
    BodyPlayback playback;
    TouchState state;
    const TouchTuning tuning = plain_tuning(0.005);
    for (int i = 0; i < 500; ++i) {
        if (i % 16 == 0) {
            for (BodyPose& pose : poses) pose.at.position_m.z += 1e-3;
            frame.push(scene->generation, 1e-3 * i, poses);
        }
        touch_tick(state, *scene, tuning, {1e-4 * i, 0.0, 0.003}, kTick_s, Vec3(0.0),
                   playback.at(frame, *scene, 1e-3 * i - 0.02));
        ASSERT_LE(SolverProbe(state.solver()).gatherings(), 4U)
            << "no coming and going of theirs makes the ball look around";
        ASSERT_EQ(SolverProbe(state.solver()).tracked(), 0U);
    }
}

}  // namespace worst_test
}  // namespace handrail::test
