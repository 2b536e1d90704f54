// Checks that the renderers that the benchmark compares do what their descriptions say, and that the measurements are
// correct.
#include <random>

#include "tests/bench/compare/measure.h"
#include "tests/bench/compare/nearby.h"
#include "tests/bench/compare/reference.h"
#include "tests/bench/compare/swept.h"
#include "tests/support/names.h"
#include "tests/support/touch_worlds.h"

namespace handrail::bench {
namespace contestants_test {

BenchWorld world_of(const test::TouchWorld& world, const std::vector<Vec3>& path_points, double speed_m_per_s,
                    std::uint32_t seed = 0, double radius_m = 0.005) {
    std::mt19937 random(seed);
    const test::Motion motion = seed == 0 ? test::Motion{} : test::random_turn(random);
    BenchWorld out;
    out.name = fmt::format("test, seed {}", seed);
    out.scene = world.scene(motion);
    out.judge = world.judge(motion);
    out.radius_m = radius_m;
    for (const Vec3& goal : test::hand_path(path_points, speed_m_per_s)) out.goals_m.push_back(motion(goal));
    return out;
}

test::TouchWorld three_boxes() {
    test::TouchWorld world;
    world.box({-.05, -.05, -.1}, {.05, .05, 0});
    world.box({.01, -.06, -.05}, {.06, .06, .05});
    world.box({-.06, .02, -.05}, {.06, .06, .05});
    return world;
}
const std::vector<Vec3> kIntoCorner{
    {-.02, 0, .02}, {-.02, 0, -.004}, {.015, .001, -.004}, {.015, .025, -.004}, {-.02, 0, .02}};

TEST(Contestants, that_keep_a_proxy_outside_agree_in_a_corner_of_three_boxes) {
    for (const std::uint32_t seed : {0U, 1U, 2U}) {
        const BenchWorld world = world_of(three_boxes(), kIntoCorner, 0.1, seed);
        const Truth truth = truth_of(world, 1e9);
        ASSERT_EQ(truth.reference_m.size(), world.goals_m.size());
        for (const Contestant& contestant : main_contestants()) {
            const Measured m = measure(world, truth, contestant, 1, 1e7);
            SCOPED_TRACE(
                fmt::format("{}, seed {}: error {} rms, {} at most", m.title, seed, m.error_rms_m, m.error_max_m));
            if (!contestant.has_proxy) continue;
            EXPECT_EQ(m.wrong_holds, 0);
            EXPECT_LE(m.penetration_m, m.renderer == "single_precision" ? 1e-6 : 1e-9);
            EXPECT_LE(m.error_rms_m, m.renderer == "handrail" ? 1e-12 : 2e-4);
        }
    }
}

TEST(Contestants, slide_over_a_plane_of_many_triangles_as_over_a_single_plane) {
    test::TouchWorld world;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k)
            world.quad({i * .01, k * .01, 0}, {i * .01 + .01, k * .01, 0}, {i * .01 + .01, k * .01 + .01, 0},
                       {i * .01, k * .01 + .01, 0});
    const BenchWorld built =
        world_of(world, {{.02, .02, .01}, {.02, .02, -.003}, {.06, .05, -.003}, {.02, .02, .01}}, 0.1);
    Truth exact;
    for (const Vec3& goal : built.goals_m)
        exact.reference_m.emplace_back(goal.x, goal.y, std::max(goal.z, built.radius_m));
    const Measured ours = measure(built, exact, handrail_touch(), 1, 1e7),
                   active = measure(built, exact, active_set(64), 1, 1e7);
    EXPECT_LE(ours.error_max_m, 1e-5) << "one tick on a corner of six triangles may stop a few micrometres short";
    EXPECT_LE(ours.error_p99_m, 1e-12);
    ASSERT_TRUE(ours.given_j);
    EXPECT_NEAR(*ours.given_j, 0.0, 1e-6);
    EXPECT_LE(active.error_max_m, 1e-4) << "the rival must not be stopped by seams either";
    EXPECT_LE(active.error_rms_m, 5e-6);
    const std::vector<Vec3> walked = reference_walk(built, 1e9);
    ASSERT_EQ(walked.size(), exact.reference_m.size());
    for (std::size_t i = 0; i < walked.size(); ++i)
        ASSERT_LE(glm::length(walked[i] - exact.reference_m[i]), 1e-5) << "the reference's own step";
}

TEST(Contestants, a_penalty_method_pops_through_a_thin_wall_and_a_proxy_does_not) {
    for (const std::uint32_t seed : {0U, 5U}) {
        test::TouchWorld wall;
        wall.box({-5e-5, -.1, -.1}, {5e-5, .1, .1});
        const BenchWorld world = world_of(wall, {{-.03, 0, 0}, {.03, .001, .001}, {-.03, 0, 0}}, 0.5, seed);
        const Truth truth = truth_of(world, 1e9);
        EXPECT_GT(measure(world, truth, penalty_sum(), 1, 1e7).wrong_holds, 0);
        for (const Contestant& proxy : {handrail_touch(), sequential_planes(), active_set(64), single_precision()})
            EXPECT_EQ(measure(world, truth, proxy, 1, 1e7).wrong_holds, 0) << proxy.title;
    }
}

TEST(Contestants, overlapping_objects_add_up_their_penalty_stiffness) {
    test::TouchWorld boxes;
    for (int i = 0; i < 3; ++i) boxes.box({-1, -1 - 0.1 * i, -1 - 0.1 * i}, {0, 1, 1});
    const BenchWorld world = world_of(boxes, {{.01, 0, 0}, {.002, 0, 0}}, 0.1);
    for (const Contestant& c : {penalty_sum(), handrail_touch()}) {
        const std::shared_ptr<void> state(c.make(world, c.knob_value), c.drop);
        Vec3 tool(0.0);
        for (const Vec3& goal : world.goals_m) tool = c.tick(state.get(), goal).tool_m;
        EXPECT_NEAR(tool.x - .002, c.has_proxy ? .003 : 3 * .003, 1e-9) << c.title;
    }
}

TEST(Contestants, give_the_same_answers_a_hundred_kilometres_from_the_origin) {
    BenchWorld world = world_of(three_boxes(), kIntoCorner, 0.1);
    test::Motion far;
    far.shift_m = {5e4, -3e4, 8e4};
    world.scene = three_boxes().scene(far);
    world.judge = three_boxes().judge(far);
    for (Vec3& goal : world.goals_m) goal = far(goal);
    const Truth truth = truth_of(world, 1e9);
    EXPECT_LE(measure(world, truth, handrail_touch(), 1, 1e7).error_max_m, 1e-9);
    EXPECT_LE(measure(world, truth, active_set(64), 1, 1e7).error_rms_m, 2e-4);
}

TEST(TimeOfImpact, agrees_with_the_first_contact_found_by_small_steps) {
    std::mt19937 random(3);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        test::TouchWorld world;
        if (i % 2) world.random_triangles(random, 1, .01, .03);
        else world.random_brush(random, Vec3(0.0), .02, 4);
        const auto scene = world.scene();
        const Vec3 from(0.08 * unit() - .04, 0.08 * unit() - .04, 0.07),
            way(0.08 * unit() - .04, 0.08 * unit() - .04, -0.2 * unit());
        constexpr double kRadius = 0.004;
        Vec3 normal;
        const double part = time_of_impact(*scene, 0, from, way, kRadius, normal);
        constexpr int kSteps = 4000;
        double first = kNoHit;
        for (int k = 0; k <= kSteps && first > 1.0; ++k)
            if (scene->closest(0, from + way * (static_cast<double>(k) / kSteps)).distance_m < kRadius)
                first = static_cast<double>(k) / kSteps;
        if (first > 1.0) {
            // The sampled steps may miss a grazing contact. They may do so only if the overlap is within the depth that
            // the proxy can reach between two steps.
            if (part <= 1.0) {
                EXPECT_NEAR(scene->closest(0, from + way * part).distance_m, kRadius, 2e-8) << i;
            }
            continue;
        }
        ++hits;
        EXPECT_LE(part, first + 1e-9) << i;
        EXPECT_GE(part, first - 1.5 / kSteps) << i;
        EXPECT_NEAR(scene->closest(0, from + way * part).distance_m, kRadius, 2e-8) << i;
    }
    EXPECT_GT(hits, 30);
}

TEST(Reference, solution_follows_a_circle_round_an_edge) {
    // The exact solution at the edge of a box: the proxy's centre is on a circle about the edge. The circle's radius is
    // the proxy's, and the centre is on the hand's side.
    test::TouchWorld box;
    box.box({-.05, -.05, -.1}, {.05, .05, 0});
    const BenchWorld world = world_of(box, {{.03, 0, .02}, {.03, 0, .003}, {.052, 0, .003}}, 0.1);
    const std::vector<Vec3> proxies = reference_walk(world, 1e9);
    ASSERT_EQ(proxies.size(), world.goals_m.size());
    for (std::size_t i = 0; i < proxies.size(); ++i) {
        const Vec3 goal = world.goals_m[i];
        Vec3 wanted = goal.z < .005 ? Vec3(goal.x, 0, .005) : goal;
        if (goal.z < .005 && goal.x > .05)
            wanted = Vec3(.05, 0, 0) +
                     (goal - Vec3(.05, 0, 0)) * (.005 / std::max(.005, glm::length(goal - Vec3(.05, 0, 0))));
        if (goal.z < .005 && goal.x > .05 && glm::length(goal - Vec3(.05, 0, 0)) < .005)
            wanted = Vec3(.05, 0, 0) + glm::normalize(goal - Vec3(.05, 0, 0)) * .005;
        EXPECT_LE(glm::length(proxies[i] - wanted), 1e-9) << i;
    }
}

TEST(Nearby, returns_every_obstacle_within_reach_at_any_point) {
    std::mt19937 random(9);
    test::TouchWorld world;
    world.random_triangles(random, 200, .1, .01);
    const auto scene = world.scene();
    Nearby nearby(*scene);
    Vec3 at(0.0);
    for (int i = 0; i < 400; ++i) {
        at += Vec3(static_cast<double>(random() % 2001) - 1000, static_cast<double>(random() % 2001) - 1000,
                   static_cast<double>(random() % 2001) - 1000) *
              1e-5;
        const double reach = 1e-3 * static_cast<double>(random() % 30);
        std::vector<bool> given(scene->obstacles.size(), false);
        nearby.within(at, reach, [&](std::uint32_t obstacle) { given[obstacle] = true; });
        for (std::uint32_t k = 0; k < given.size(); ++k)
            if (scene->closest(k, at).distance_m <= reach) {
                ASSERT_TRUE(given[k]) << i;
            }
    }
}

}  // namespace contestants_test
}  // namespace handrail::bench
