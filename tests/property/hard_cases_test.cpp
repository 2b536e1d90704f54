// Tests the hard cases against their expected numbers. The calculation of each number is next to it.
#include "tests/property/replay.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/reference_proxy.h"

namespace handrail::test {
namespace hard_cases_test {

TouchCase case_named(const std::string& prefix, double radius_m = 0.005) {
    for (const TouchCase& c : hard_cases(radius_m))
        if (c.name.starts_with(prefix + " ")) return c;
    ADD_FAILURE() << "no case " << prefix;
    return {};
}

// Runs every tick of a case and passes the tick to `check` in the world's own frame. The world is unchanged, or rotated
// and shifted with three seeds.
template <class Check>
void everywhere(const TouchCase& c, const TouchTuning& tuning, Check&& check) {
    for (const std::uint32_t seed : {0U, 21U, 22U, 23U}) {
        std::mt19937 random(seed);
        Motion motion = seed == 0 ? Motion{} : random_turn(random);
        if (seed != 0) motion.shift_m = {seed * 1.7, seed * -3.1, seed * 0.4};
        SCOPED_TRACE(fmt::format("{}, seed {}", c.name, seed));
        replay(*c.world.scene(motion), c.goals_m, motion, tuning,
               [&](std::size_t i, const Vec3&, const TouchResult& r, const ProxySolver&) {
                   check(i, c.goals_m[i], motion.back(r.proxy_m), r);
               });
    }
}

// Returns the proxy's positions while the hand stays at `goal`, which is a way-point of the case, in the world's own
// frame.
std::vector<Vec3> proxies_at(const TouchCase& c, const TouchTuning& tuning, const Vec3& goal) {
    std::vector<Vec3> found;
    everywhere(c, tuning, [&](std::size_t, const Vec3& g, const Vec3& proxy, const TouchResult&) {
        if (glm::length(g - goal) < 1e-12) found.push_back(proxy);
    });
    EXPECT_FALSE(found.empty());
    return found;
}

TEST(HardCase, T1_T8_T10_planes_that_are_cut_doubled_or_littered_feel_like_one_plane) {
    for (const char* name : {"T1", "T8", "T10"}) {
        const TouchCase c = case_named(name);
        everywhere(c, plain_tuning(c.radius_m),
                   [&](std::size_t i, const Vec3& g, const Vec3& proxy, const TouchResult& r) {
                       const bool wall = std::string(name) == "T8" && g.x > 0.02 - c.radius_m;
                       if (g.z < c.radius_m) {
                           ASSERT_NEAR(proxy.z, c.radius_m, 1e-9) << i;
                       }
                       if (!wall) {
                           ASSERT_NEAR(proxy.x, g.x, 1e-8);
                           ASSERT_NEAR(proxy.y, g.y, 1e-8);
                           // The solver takes one round for each of the three triangles at a T-junction, and one that
                           // finds the result complete. Duplicate and degenerate triangles add rounds.
                           if (std::string(name) == "T1") {
                               ASSERT_LE(r.contacts.iterations, 4);
                           }
                       } else {
                           ASSERT_NEAR(proxy.x, 0.02 - c.radius_m, 1e-8);
                       }
                   });
    }
}

TEST(HardCase, T2_the_proxy_sinks_into_a_crack_by_its_sagitta_and_no_deeper) {
    for (const double radius : {0.005, 0.003}) {
        for (const auto& [name, w] : {std::pair{"T2a", 1e-5}, {"T2b", 1e-4}, {"T2c", 5e-4}, {"T2d", 1e-3}}) {
            const TouchCase c = case_named(name, radius);
            Vec3 last(0.0), last_goal(0.0);
            double lowest = 1.0;
            everywhere(c, plain_tuning(radius),
                       [&](std::size_t i, const Vec3& g, const Vec3& proxy, const TouchResult&) {
                           lowest = std::min(lowest, proxy.z);
                           if (i > 0) {
                               ASSERT_LE(glm::length((proxy - g) - (last - last_goal)), 1.6e-3);
                           }
                           last = proxy;
                           last_goal = g;
                       });
            EXPECT_GE(lowest, std::sqrt(radius * radius - w * w / 4) - 1e-9) << name;
        }
    }
    const TouchCase point = case_named("T2a", 1e-5);
    everywhere(point, plain_tuning(1e-5),
               [&](std::size_t, const Vec3&, const Vec3& proxy, const TouchResult&) { ASSERT_GE(proxy.z, 0.0); });
}

TEST(HardCase, T3_T4_corners_of_overlapping_boxes_are_sharp_in_every_representation) {
    for (const Vec3& proxy : proxies_at(case_named("T3"), plain_tuning(0.005), {.025, .001, -.008})) {
        EXPECT_NEAR(proxy.x, 0.005, 1e-9);
        EXPECT_NEAR(proxy.y, 0.001, 1e-9);
        EXPECT_NEAR(proxy.z, 0.005, 1e-9);
    }
    for (const char* name : {"T4a", "T4b", "T4c"})
        for (const Vec3& proxy : proxies_at(case_named(name), plain_tuning(0.005), {.025, .03, -.008}))
            EXPECT_LE(glm::length(proxy - Vec3(.005, .015, .005)), 1e-9) << name;
    const TouchCase triangles = case_named("T4a"), boxes = case_named("T4b"), brushes = case_named("T4c");
    const Trace expected = trace(boxes.world, boxes.goals_m, {}, plain_tuning(0.005));
    EXPECT_LE(largest_difference(expected, trace(triangles.world, boxes.goals_m, {}, plain_tuning(0.005))), 1e-9);
    EXPECT_LE(largest_difference(expected, trace(brushes.world, boxes.goals_m, {}, plain_tuning(0.005))), 1e-9);
}

TEST(HardCase, T5_the_proxy_rests_in_a_crevice_where_both_sides_support_it) {
    for (const auto& [name, degrees] : {std::pair{"T5a", 10.0}, {"T5b", 2.0}, {"T5c", 0.5}}) {
        const TouchCase c = case_named(name);
        const double half = radians_from_degrees(degrees) / 2, rest = c.radius_m / std::sin(half);
        for (const Vec3& goal : {Vec3(-.004, .01, rest + .02 - .06), Vec3(.0005, 0, rest + .02 - .06)})
            for (const Vec3& proxy : proxies_at(c, plain_tuning(c.radius_m), goal)) {
                EXPECT_NEAR(proxy.z, rest, 1e-8) << name;
                EXPECT_NEAR(proxy.x, 0.0, 1e-8);
                EXPECT_NEAR(proxy.y, goal.y, 1e-8);
            }
        // The walls of the groove do not amplify a hand's encoder steps of 0.06 mm.
        std::vector<Vec3> coarse = c.goals_m;
        for (Vec3& g : coarse) g = glm::round(g / 6e-5) * 6e-5;
        Vec3 last_proxy = coarse[0], last_goal = coarse[0];
        replay(*c.world.scene(), coarse, {}, uncapped_tuning(c.radius_m),
               [&](std::size_t, const Vec3& g, const TouchResult& r, const ProxySolver&) {
                   ASSERT_LE(glm::length(r.proxy_m - last_proxy), glm::length(g - last_goal) + 1e-8);
                   last_proxy = r.proxy_m;
                   last_goal = g;
               });
    }
}

TEST(HardCase, T6_T7_slipping_off_an_edge_or_spike_never_jumps_more_than_the_cap) {
    for (const char* name : {"T6", "T7"}) {
        for (TouchCase& c : hard_cases()) {
            if (!c.name.starts_with(name)) continue;
            Vec3 last(0.0), last_goal(0.0);
            everywhere(
                c, plain_tuning(c.radius_m), [&](std::size_t i, const Vec3& g, const Vec3& proxy, const TouchResult&) {
                    if (i > 0) {
                        ASSERT_LE(glm::length(proxy - last), std::max(0.5e-3, 2 * glm::length(g - last_goal)) + 1e-9);
                    }
                    last = proxy;
                    last_goal = g;
                });
        }
    }
}

TEST(HardCase, T9_raw_sliver_triangles_lag_by_a_third_of_a_millimetre_at_most) {
    for (const char* name : {"T9a", "T9b", "T9c"}) {
        const TouchCase c = case_named(name);
        everywhere(c, plain_tuning(c.radius_m), [&](std::size_t, const Vec3& g, const Vec3& proxy, const TouchResult&) {
            ASSERT_GE(proxy.z, c.radius_m - 1e-9);
            if (g.z < c.radius_m) {
                ASSERT_LE(glm::length(proxy - Vec3(g.x, g.y, c.radius_m)), 3e-4);
            }
        });
    }
}

TEST(HardCase, T11_T12_a_thin_wall_and_a_sheet_stop_the_proxy_at_5_metres_per_second_from_either_side) {
    for (const char* name : {"T11a", "T11b", "T12"}) {
        TouchCase c = case_named(name);
        const double rest = std::string(name) == "T12" ? 0.005 : 0.00505;
        for (const double side : {1.0, -1.0}) {
            if (side < 0.0)
                for (Vec3& g : c.goals_m) g.x = -g.x;
            everywhere(c, plain_tuning(c.radius_m),
                       [&](std::size_t, const Vec3& g, const Vec3& proxy, const TouchResult&) {
                           ASSERT_LE(proxy.x * side, -rest + 1e-9);
                           if (g.x * side > -rest) {
                               ASSERT_NEAR(proxy.x * side, -rest, 1e-9);
                           }
                       });
        }
    }
}

// Returns the greatest distance, over all ticks, between the proxy and a reference that follows the same goals
// continuously.
double error_against_reference(const TouchCase& c, const Motion& motion, const TouchTuning& tuning) {
    const BruteForce judge = c.world.judge(motion);
    ReferenceProxy reference(judge, motion(c.goals_m.front()), c.radius_m);
    double worst = 0.0;
    replay(*c.world.scene(motion), c.goals_m, motion, tuning,
           [&](std::size_t, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
               worst = std::max(worst, glm::length(r.proxy_m - reference.follow(goal)));
           });
    return worst;
}

TEST(HardCase, T13_stalls_of_the_hand_lead_the_proxy_where_a_steady_hand_would) {
    for (const char* name : {"T13a", "T13b"}) {
        const TouchCase c = case_named(name);
        for (const std::uint32_t seed : {0U, 31U, 32U}) {
            std::mt19937 random(seed);
            const Motion motion = seed == 0 ? Motion{} : random_turn(random);
            EXPECT_LE(error_against_reference(c, motion, uncapped_tuning(c.radius_m)), 1e-8)
                << name << " seed " << seed;
            // The solver has its speed cap, so only ticks that the cap did not cut short are compared. The reference
            // starts each tick from the proxy's last place.
            const BruteForce judge = c.world.judge(motion);
            ReferenceProxy reference(judge, motion(c.goals_m.front()), c.radius_m);
            std::size_t compared = 0;
            replay(*c.world.scene(motion), c.goals_m, motion, plain_tuning(c.radius_m),
                   [&](std::size_t i, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
                       if (!r.contacts.capped) {
                           ++compared;
                           ASSERT_LE(glm::length(r.proxy_m - reference.follow(goal)), 1e-8)
                               << name << " seed " << seed << " tick " << i;
                       }
                       reference.place(r.proxy_m);
                   });
            EXPECT_GT(compared * 10, c.goals_m.size() * 9) << name;
        }
    }
}

TEST(HardCase, every_tidy_case_follows_a_continuous_path_to_a_hundredth_of_a_micrometre) {
    for (const TouchCase& c : hard_cases()) {
        // In a crack of 0.1 mm, the reference stays in a dip of 0.25 micrometres, but the proxy leaves it.
        if (!c.tidy || c.name.starts_with("T2b")) continue;
        std::mt19937 random(7);
        EXPECT_LE(error_against_reference(c, random_turn(random), uncapped_tuning(c.radius_m)), 1e-8) << c.name;
    }
}

TEST(HardCase, T6_an_edge_is_felt_to_a_hundredth_of_a_millimetre_with_64_solver_rounds) {
    for (const TouchCase& c : hard_cases()) {
        if (!c.name.starts_with("T6")) continue;
        EXPECT_LE(error_against_reference(c, {}, uncapped_tuning(c.radius_m)), 1e-5) << c.name;
    }
}

TEST(HardCase, T7_a_spike_is_felt_to_a_hundredth_of_a_millimetre_on_999_of_1000_ticks) {
    for (const double degrees : {30.0, 15.0, 50.0}) {
        TouchCase c = case_named("T7");
        if (degrees != 30.0) {  // the groove of T7, also with sharper and blunter angles
            c.world = TouchWorld();
            const double q = .1 * std::tan(radians_from_degrees(degrees / 2));
            const Vec3 v[4] = {{-q, -q, -.1}, {q, -q, -.1}, {q, q, -.1}, {-q, q, -.1}};
            for (int i = 0; i < 4; ++i) c.world.triangle({0, 0, 0}, v[i], v[(i + 1) % 4]);
        }
        const BruteForce judge = c.world.judge();
        std::size_t off = 0, unfinished = 0;
        replay(*c.world.scene(), c.goals_m, {}, uncapped_tuning(c.radius_m),
               [&](std::size_t, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
                   if (r.contacts.count > 0 && judge.residual(r.proxy_m, goal, r.radius_m) > 1e-5) ++off;
                   if (!r.contacts.converged) ++unfinished;
               });
        EXPECT_LE(off, c.goals_m.size() / 1000)
            << degrees << " degrees, " << unfinished << " unfinished of " << c.goals_m.size();
    }
}

// Invariant I9 at a convex edge. If the goal is at depth d below the rounded surface, a step of the goal moves the
// proxy by r / (r - d) times that step, and no more.
TEST(HardCase, I9_at_an_edge_the_energy_gain_is_that_of_a_rolling_ball) {
    std::mt19937 random(9);
    for (const bool solid : {true, false}) {
        TouchWorld world;
        if (solid) world.box({-.05, -.05, -.1}, {.05, .05, 0});
        else world.box_of_triangles({-.05, -.05, -.1}, {.05, .05, 0});
        for (const double depth : {0.0005, 0.001, 0.002, 0.003, 0.004, 0.0045}) {
            const Motion motion = random_turn(random);
            constexpr double kRadius = 0.005, kTurn = 0.02;
            // Tolerance, because the solver finds the edge between two triangles by iteration.
            constexpr double kSettled = 1e-6;
            // The path leads around the edge x = 0.05, z = 0 at a constant distance, from above the edge to its side.
            std::vector<Vec3> goals;
            for (double z = 0.02; z > kRadius - depth; z -= 1e-4) goals.emplace_back(.05, .003, z);
            const std::size_t round_from = goals.size() + 1;
            for (double turn = 0.0; turn <= kPi / 2; turn += kTurn)
                goals.emplace_back(.05 + (kRadius - depth) * std::sin(turn), .003, (kRadius - depth) * std::cos(turn));
            const double gain = kRadius / (kRadius - depth);
            Vec3 last_proxy(0.0), last_goal(0.0);
            replay(*world.scene(motion), goals, motion, uncapped_tuning(kRadius),
                   [&](std::size_t i, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
                       if (i > round_from) {
                           const double expected = gain * glm::length(goal - last_goal);
                           ASSERT_NEAR(glm::length(r.proxy_m - last_proxy), expected,
                                       1e-3 * expected + (solid ? 0.0 : kSettled))
                               << "depth " << depth << " solid " << solid;
                       }
                       last_proxy = r.proxy_m;
                       last_goal = goal;
                   });
        }
    }
}

// Tests the second half of invariant I6, with triangle soups of many sizes.
TEST(HardCase, T16_I6_in_triangle_soups_the_proxy_is_where_it_should_be_on_999_of_1000_ticks) {
    const std::uint32_t seed0 = seed_of_run();
    std::size_t ticks = 0, unsettled = 0, off = 0;
    double worst_settled = 0.0;
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(scaled(24)); ++k) {
        std::mt19937 random(seed0 + k);
        const int count = std::array{30, 120, 400}[k % 3];
        const double radius = std::array{0.005, 0.002, 1e-5}[(k / 3) % 3];
        TouchWorld world;
        world.random_triangles(random, count, .03, .015);
        std::vector<Vec3> way{{0, 0, .07}};
        const auto unit = [&random] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
        for (int i = 0; i < 30; ++i) {
            const double x = unit(), y = unit(), z = unit();
            way.emplace_back(0.1 * x, 0.1 * y, 0.1 * z);
        }
        const BruteForce judge = world.judge();
        replay(*world.scene(), hand_path(way, 0.5), {}, uncapped_tuning(radius),
               [&](std::size_t i, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
                   ++ticks;
                   if (r.contacts.count == 0 || (r.contacts.converged && i % 41 != 0)) return;
                   const double residual = static_cast<double>(judge.residual(r.proxy_m, goal, r.radius_m));
                   if (r.contacts.converged) worst_settled = std::max(worst_settled, residual);
                   else ++unsettled, off += residual > 1e-5;
               });
    }
    RecordProperty("seed", static_cast<int>(seed0));
    RecordProperty("unsettled_of_ticks",
                   fmt::format("{} of {}, {} of them off by more than 0.01 mm", unsettled, ticks, off));
    EXPECT_LE(worst_settled, 1e-5) << "seed " << seed0;
    // A single pocket between triangles can hold the proxy wrongly for some ten ticks in a row. In the short runs under
    // sanitizers, a few such pockets are permitted.
    const std::size_t pockets = kSanitizerScale < 1.0 ? 40 : 0;
    EXPECT_LE(off * 1000, ticks + 1000 * pockets) << "seed " << seed0;
    // Measured over many seeds: 0.08 to 0.14 % of the ticks do not settle to 1e-8 m within 64 rounds.
    EXPECT_LE(unsettled * 1000, 3 * ticks + 1000 * pockets) << "seed " << seed0;
}

TEST(HardCase, T16_random_triangle_soups_and_heaps_let_nothing_in_for_any_seed) {
    const std::uint32_t seed0 = seed_of_run();
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(scaled(8)); ++k) {
        const std::uint32_t seed = seed0 + k;
        std::mt19937 random(seed);
        TouchCase c;
        if (k % 2 == 0) c.world.random_triangles(random, 120, .03, .015);
        else
            for (int i = 0; i < 20; ++i)
                c.world.random_brush(
                    random, {(random() % 800) / 1e4 - .04, (random() % 800) / 1e4 - .04, (random() % 800) / 1e4 - .04},
                    .005 + (random() % 150) / 1e4, 3);
        c.radius_m = k % 4 < 2 ? 0.005 : 1e-5;
        std::vector<Vec3> way{{0, 0, .09}};
        for (int i = 0; i < 12; ++i)
            way.push_back(
                {(random() % 1000) / 1e4 - .05, (random() % 1000) / 1e4 - .05, (random() % 1000) / 1e4 - .05});
        const BruteForce judge = c.world.judge();
        Vec3 before = way[0];
        replay(*c.world.scene(), hand_path(way, 0.5), {}, plain_tuning(c.radius_m),
               [&](std::size_t i, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
                   if (i % 7 == 0) {
                       ASSERT_GE(judge.distance(r.proxy_m), r.radius_m - 1e-9L) << "seed " << seed << " tick " << i;
                   }
                   ASSERT_LE(glm::length(r.proxy_m - goal), glm::length(before - goal) + 1e-9)
                       << "seed " << seed << " tick " << i;
                   ASSERT_LE(r.contacts.iterations, 64);
                   before = r.proxy_m;
               });
    }
}

// Invariant I11: the work given to the hand over a closed loop, at 1 kN/m.
TEST(HardCase, closed_loops_give_the_hand_no_energy) {
    for (const TouchCase& c : hard_cases()) {
        for (const double mu : {0.0, 0.4}) {
            TouchTuning tuning = plain_tuning(c.radius_m);
            tuning.default_friction_static = tuning.default_friction_kinetic = mu;
            double energy = 0.0, longest = 0.0;
            int events = 1;
            bool touched = false;
            Vec3 last_goal(0.0), last_force(0.0);
            replay(*c.world.scene(), c.goals_m, {}, tuning,
                   [&](std::size_t i, const Vec3& g, const TouchResult& r, const ProxySolver&) {
                       if (i > 0) {
                           energy += glm::dot((r.force_n + last_force) * 0.5, g - last_goal);
                           longest = std::max(longest, glm::length(g - last_goal));
                       }
                       if ((r.contacts.count > 0) != touched) ++events;
                       touched = r.contacts.count > 0;
                       last_goal = g;
                       last_force = r.force_n;
                   });
            // The limit is the error of the trapezoidal rule itself, which occurs in the step in which a contact begins
            // or ends.
            EXPECT_LE(energy, events * 1000.0 * longest * longest / 8 + 1e-6) << c.name << " mu " << mu;
        }
    }
}

}  // namespace hard_cases_test
}  // namespace handrail::test
