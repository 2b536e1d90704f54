// Tests the invariants that must be true on every tick in every world, judged by brute force. Tests name them by
// number:
// - I1 to I3: the proxy and its whole path stay outside everything, and all numbers are finite.
// - I4: each cut contains the proxy and supports its obstacle.
// - I5: the proxy never moves away from the hand.
// - I6: the proxy stops only where no contact would let it move on.
// - I7: the proxy stays where it is if the hand does.
// - I8: in free space the proxy follows exactly and without force.
// - I9: in locally convex free space a step of the hand is not amplified.
// - I10: the proxy moves no farther in a tick than the cap.
// - I11: closed loops give the hand no energy.
// - I12: the proxy sticks inside the friction cone and slides on it (tests/unit/render/touch_test.cpp).
// - I13: the result is the same far from the origin.
// - I14: order and number of repetitions of obstacles make no difference.
// - I15: finer triangles of the same surface make no difference.
// - I16: the work of a tick is bounded.
// - I17: if the solver is stopped early, I1, I2, I3 and I5 are still true.
// - I18: with cuts that are fifty milliseconds old, I2 and I3 are still true.
#include "tests/property/replay.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"

namespace handrail::test {
namespace invariants_test {

// Returns the listed hard cases, then one case of each random family with this run's seed. HANDRAIL_SEED=... repeats a
// run with a failing seed.
std::vector<TouchCase> all_cases() {
    std::vector<TouchCase> cases = hard_cases();
    for (std::size_t family = 0; family < kRandomFamilies; ++family)
        cases.push_back(random_case(family, seed_of_run()));
    return cases;
}

class EveryCase : public testing::TestWithParam<std::size_t> {
protected:
    TouchCase case_ = all_cases()[GetParam()];
    std::uint32_t seed_ = is_random() ? seed_of_run() : static_cast<std::uint32_t>(1000 + GetParam());
    std::mt19937 random_{seed_};

    bool is_random() const { return case_.name.starts_with("random"); }

    // Tolerance for results found by iteration, as for edges of triangles and overlapping sheets. The results for the
    // most deeply pressed random edges agree to 6e-8 m.
    double by_iteration_m() const { return is_random() ? 1e-6 : 1e-8; }

    double most_unsettled() const { return is_random() ? 0.03 : 0.01; }

    // Returns the stride between judged ticks. Judging solids by enumeration is slow, so fewer of their ticks are
    // judged.
    std::size_t stride() const {
        double work = 0.0;
        const BruteForce judge = case_.world.judge();
        for (const BruteForce::Thing& t : judge.things()) {
            const double n = static_cast<double>(t.planes.size());
            work += t.other ? 4.0 : t.solid ? n * n * n * n / 24 + n * n : 8.0;
        }
        return static_cast<std::size_t>(1.0 +
                                        work * static_cast<double>(case_.goals_m.size()) * 8 / (2e7 * kSanitizerScale));
    }
};

// Cases in which free space is locally convex along the path.
class HollowCase : public EveryCase {};
// Cases whose answer is unique and continuous: no soup, no raw slivers, no spike.
class TidyCase : public EveryCase {};

TEST_P(EveryCase, keeps_the_proxy_and_its_whole_path_outside_all_obstacles) {  // invariants I1, I2 and I3
    for (const bool turned : {false, true}) {
        Motion motion = turned ? random_turn(random_) : Motion{};
        if (turned) motion.shift_m = {12.3, -4.5, 6.7};
        SCOPED_TRACE(fmt::format("{}, seed {}, turned {}", case_.name, seed_, turned));
        const BruteForce judge = case_.world.judge(motion);
        const std::size_t every = stride();
        double deepest = 0.0;
        replay(*case_.world.scene(motion), case_.goals_m, motion, plain_tuning(case_.radius_m),
               [&](std::size_t i, const Vec3&, const TouchResult& r, const SolverProbe& solver) {
                   ASSERT_TRUE(is_finite(r.proxy_m) && is_finite(r.force_n)) << i;
                   if (i % every != 0) return;
                   for (int k = 1; k < solver.path_size(); ++k)
                       for (int s = 0; s <= 8; ++s) {
                           const Vec3 p = solver.path_m(k - 1) + (solver.path_m(k) - solver.path_m(k - 1)) * (s / 8.0);
                           deepest = std::max(deepest, static_cast<double>(r.radius_m - judge.distance(p, 0.02L)));
                       }
                   deepest = std::max(deepest, static_cast<double>(r.radius_m - judge.distance(r.proxy_m, 0.02L)));
               });
        EXPECT_LE(deepest, 1e-9);
    }
}

TEST_P(EveryCase, uses_only_cuts_that_contain_the_proxy_and_support_their_obstacle) {  // invariant I4
    const Motion motion = random_turn(random_);
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    const auto scene = case_.world.scene(motion);
    replay(*scene, case_.goals_m, motion, plain_tuning(case_.radius_m),
           [&](std::size_t i, const Vec3&, const TouchResult& r, const SolverProbe& solver) {
               if (i % 37 != 0) return;
               for (int k = 0; k < solver.candidates(); ++k) {
                   const HalfSpace cut = solver.cut(k);
                   ASSERT_NEAR(glm::length(cut.normal), 1.0, 1e-12);
                   ASSERT_GE(glm::dot(cut.normal, solver.local_m()) - cut.offset_m, r.radius_m - 1e-9);
                   const Obstacle& o = scene->obstacles[solver.candidate(k)];
                   if (o.kind == ObstacleKind::Triangle) {
                       const TriangleShape t = scene->triangle(o);
                       for (const Vec3& corner : {t.a_m, t.b_m, t.c_m})
                           ASSERT_LE(glm::dot(cut.normal, corner), cut.offset_m + (t.degenerate ? 2e-7 : 1e-9));
                   } else {
                       // Checks the points of the solid that are nearest to random places.
                       for (int s = 0; s < 4; ++s) {
                           const Vec3 far =
                               solver.local_m() +
                               Vec3(random_() % 200 / 1e3 - .1, random_() % 200 / 1e3 - .1, random_() % 200 / 1e3 - .1);
                           const ClosestPoint q = scene->closest(solver.candidate(k), far);
                           ASSERT_LE(glm::dot(cut.normal, q.distance_m > 0.0 ? q.point_m : far), cut.offset_m + 1e-9);
                       }
                   }
               }
           });
}

TEST_P(EveryCase, never_moves_away_from_the_hand) {  // invariant I5
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    for (const bool capped : {false, true}) {
        Vec3 before = case_.goals_m.front();
        double worst = 0.0;
        replay(*case_.world.scene(), case_.goals_m, {},
               capped ? plain_tuning(case_.radius_m) : uncapped_tuning(case_.radius_m),
               [&](std::size_t, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
                   worst = std::max(worst, glm::length(r.proxy_m - goal) - glm::length(before - goal));
                   before = r.proxy_m;
               });
        EXPECT_LE(worst, 1e-9) << "capped " << capped;
    }
}

TEST_P(EveryCase, stops_only_where_contacts_prevent_further_movement) {  // invariant I6
    const Motion motion = random_turn(random_);
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    const BruteForce judge = case_.world.judge(motion);
    const std::size_t every = stride() * 4 + 3;
    std::size_t off = 0, judged = 0, unfinished = 0;
    double worst_finished = 0.0;
    replay(*case_.world.scene(motion), case_.goals_m, motion, uncapped_tuning(case_.radius_m),
           [&](std::size_t i, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
               if (!r.contacts.converged) ++unfinished;
               if ((r.contacts.converged && i % every != 0) || r.contacts.count == 0) return;
               ++judged;
               const double residual = static_cast<double>(judge.residual(r.proxy_m, goal, r.radius_m));
               if (residual > 1e-5) ++off;
               if (r.contacts.converged) worst_finished = std::max(worst_finished, residual);
           });
    EXPECT_LE(worst_finished, 1e-5) << judged << " ticks judged";
    // In the random cases, edges, spikes and slivers are pressed deeper than in the listed cases.
    EXPECT_LE(off, is_random() && !case_.concave ? 3 + case_.goals_m.size() / 250 : 1 + case_.goals_m.size() / 1000)
        << unfinished << " unfinished";
    RecordProperty("unfinished", static_cast<int>(unfinished));
}

TEST_P(EveryCase, keeps_the_proxy_still_while_the_hand_is_still) {  // invariant I7
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    const auto scene = case_.world.scene();
    TouchState state;
    double worst = 0.0;
    for (const Vec3& goal : case_.goals_m) {
        const TouchResult once = touch_tick(state, *scene, uncapped_tuning(case_.radius_m), goal, 1e-3);
        const TouchResult twice = touch_tick(state, *scene, uncapped_tuning(case_.radius_m), goal, 1e-3);
        if (once.contacts.converged && twice.contacts.converged)
            worst = std::max(worst, glm::length(once.proxy_m - twice.proxy_m));
    }
    EXPECT_LE(worst, case_.tidy ? by_iteration_m() : 2e-5);
}

TEST_P(EveryCase, follows_the_hand_exactly_and_without_force_in_free_space) {  // invariant I8
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    const BruteForce judge = case_.world.judge();
    Vec3 last_goal = case_.goals_m.front();
    bool stood_at_goal = true;
    std::size_t free_ticks = 0;
    replay(*case_.world.scene(), case_.goals_m, {}, plain_tuning(case_.radius_m),
           [&](std::size_t i, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
               if (stood_at_goal && r.radius_m == std::max(case_.radius_m, 1e-5) && i % 5 == 0 &&
                   judge.clear(last_goal, goal, case_.radius_m + 1e-9L, 1)) {
                   ++free_ticks;
                   EXPECT_EQ(r.proxy_m, goal);
                   EXPECT_EQ(r.force_n, Vec3(0.0));
                   EXPECT_EQ(r.contacts.count, 0);
               }
               stood_at_goal = r.proxy_m == goal;
               last_goal = goal;
           });
    EXPECT_GT(free_ticks, 0U);
}

TEST_P(HollowCase, gives_the_hand_no_energy) {  // invariant I9
    const Motion motion = random_turn(random_);
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    Vec3 last_goal = motion(case_.goals_m.front()), last_proxy = last_goal;
    double worst = 0.0;
    replay(*case_.world.scene(motion), case_.goals_m, motion, uncapped_tuning(case_.radius_m),
           [&](std::size_t, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
               worst = std::max(
                   worst, glm::length((r.proxy_m - goal) - (last_proxy - last_goal)) - glm::length(goal - last_goal));
               last_goal = goal;
               last_proxy = r.proxy_m;
           });
    EXPECT_LE(worst, 1e-8);
}

TEST_P(EveryCase, moves_the_proxy_no_further_per_tick_than_the_cap) {  // invariant I10
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    Vec3 last_goal = case_.goals_m.front();
    replay(*case_.world.scene(), case_.goals_m, {}, plain_tuning(case_.radius_m),
           [&](std::size_t, const Vec3& goal, const TouchResult& r, const SolverProbe& solver) {
               double way = 0.0;
               for (int k = 1; k < solver.path_size(); ++k) way += glm::length(solver.path_m(k) - solver.path_m(k - 1));
               EXPECT_LE(way, std::max(0.5e-3, 2.0 * glm::length(goal - last_goal)) + 1e-12);
               EXPECT_LE(glm::length(r.slide_m), way + 1e-12);
               last_goal = goal;
           });
}

TEST_P(EveryCase, feels_the_same_far_from_the_origin) {  // invariant I13
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    const TouchTuning tuning = uncapped_tuning(case_.radius_m);
    const Trace here = trace(case_.world, case_.goals_m, {}, tuning);
    for (const auto& [far, tolerance] : {std::pair{1e3, 1e-10}, {1e6, 1e-8}}) {
        Motion motion;
        motion.shift_m = {far * 0.9, 0.63 * far, 0.27 * far};
        const double worst =
            largest_difference(here, trace(case_.world, case_.goals_m, motion, tuning), most_unsettled());
        // Far from the origin, the world's own coordinates are rounded to 1e-13 m and 1e-10 m, and edges and crevices
        // multiply this error. In the narrowest random grooves the error is up to 50 times that of the listed grooves
        // (4.8e-9 m at 1 km with seed 196324; in none of 250 other seeds).
        if (case_.tidy) {
            EXPECT_LE(worst, tolerance * (!case_.concave ? 1e3 : is_random() ? 100.0 : 4.0)) << far;
        }
        RecordProperty(fmt::format("shift_{:.0e}", far), fmt::format("{:.1e}", worst));
    }
}

TEST_P(EveryCase, is_independent_of_the_order_and_repetition_of_obstacles) {  // invariant I14
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    const TouchTuning tuning = uncapped_tuning(case_.radius_m);
    const Trace once = trace(case_.world, case_.goals_m, {}, tuning);
    const double worst = largest_difference(
        once, trace(case_.world.shuffled_and_doubled(random_), case_.goals_m, {}, tuning), most_unsettled());
    if (case_.tidy) {
        EXPECT_LE(worst, by_iteration_m());
    }
    RecordProperty("worst", fmt::format("{:.1e}", worst));
}

// Checks that no obstacle comes nearer to the proxy's path than the proxy's radius. `tuning_of` returns the tuning of
// each tick. Returns the deepest overlap.
template <class TuningOf>
double deepest_overlap(const TouchCase& c, const Motion& motion, std::size_t every, TuningOf&& tuning_of) {
    const BruteForce judge = c.world.judge(motion);
    const auto scene = c.world.scene(motion);
    TouchState state;
    double deepest = 0.0;
    for (std::size_t i = 0; i < c.goals_m.size(); ++i) {
        const TouchResult r = touch_tick(state, *scene, tuning_of(i), motion(c.goals_m[i]), 1e-3);
        if (i % every != 0) continue;
        const SolverProbe solver(state.solver());
        for (int k = 1; k < solver.path_size(); ++k)
            for (int s = 1; s <= 4; ++s) {
                const Vec3 p = solver.path_m(k - 1) + (solver.path_m(k) - solver.path_m(k - 1)) * (s / 4.0);
                deepest = std::max(deepest, static_cast<double>(r.radius_m - judge.distance(p, 0.02L)));
            }
    }
    return deepest;
}

TEST_P(EveryCase, is_as_safe_if_the_solver_stops_early) {  // invariant I17, with I1, I2, I3 and I5
    for (const int most_rounds : {1, 4}) {
        const Motion motion = random_turn(random_);
        SCOPED_TRACE(fmt::format("{}, seed {}, at most {} rounds", case_.name, seed_, most_rounds));
        TouchTuning tuning = plain_tuning(case_.radius_m);
        tuning.most_rounds = most_rounds;
        EXPECT_LE(deepest_overlap(case_, motion, stride() * 2, [&](std::size_t) { return tuning; }), 1e-9);
        Vec3 before = motion(case_.goals_m.front());
        double away = 0.0;
        replay(*case_.world.scene(motion), case_.goals_m, motion, tuning,
               [&](std::size_t i, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
                   ASSERT_TRUE(is_finite(r.proxy_m) && is_finite(r.force_n)) << i;
                   ASSERT_LE(r.contacts.iterations, most_rounds) << i;
                   away = std::max(away, glm::length(r.proxy_m - goal) - glm::length(before - goal));
                   before = r.proxy_m;
               });
        // A crevice of half a degree multiplies the solver's tolerance of 1e-10 m by 230.
        EXPECT_LE(away, is_random() ? 1e-8 : 1e-9);
    }
}

TEST_P(EveryCase, is_as_safe_with_cuts_that_are_fifty_milliseconds_old) {  // invariant I18, with I2 and I3
    const Motion motion = random_turn(random_);
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    const TouchTuning looking = plain_tuning(case_.radius_m);
    TouchTuning blind = looking;
    blind.most_rounds = 0;
    // The stride is chosen so that the judged ticks include every phase of the fifty ticks between renewals.
    EXPECT_LE(
        deepest_overlap(case_, motion, stride() * 2 + 1, [&](std::size_t i) { return i % 50 == 0 ? looking : blind; }),
        1e-9);
}

// Invariant I16. The tests unit_render and unit_servo_realtime check that a tick allocates no memory and uses no lock
// or clock.
TEST_P(EveryCase, never_works_more_than_its_bound) {
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    replay(*case_.world.scene(), case_.goals_m, {}, plain_tuning(case_.radius_m),
           [&](std::size_t i, const Vec3&, const TouchResult& r, const SolverProbe& solver) {
               ASSERT_LE(r.contacts.iterations, 64) << i;
               ASSERT_LE(solver.candidates(), ProxySolver::kMaxCandidates) << i;
               ASSERT_LE(solver.path_size(), 2 * ProxySolver::kMaxIterations + 4) << i;
           });
}

TEST_P(TidyCase, feels_finer_triangles_as_the_same_surface) {  // invariant I15
    SCOPED_TRACE(fmt::format("{}, seed {}", case_.name, seed_));
    const TouchTuning tuning = uncapped_tuning(case_.radius_m);
    const Trace coarse = trace(case_.world, case_.goals_m, {}, tuning);
    EXPECT_LE(largest_difference(coarse, trace(case_.world.with_triangles_split(random_), case_.goals_m, {}, tuning),
                                 most_unsettled()),
              1e-6);
}

std::vector<std::size_t> cases_that(bool (*chosen)(const TouchCase&)) {
    const std::vector<TouchCase> all = all_cases();
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (chosen(all[i])) indices.push_back(i);
    return indices;
}

std::string name_of(const testing::TestParamInfo<std::size_t>& which) {
    std::string name = all_cases()[which.param].name;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(HardCases, EveryCase, testing::ValuesIn(cases_that([](const TouchCase&) { return true; })),
                         name_of);
INSTANTIATE_TEST_SUITE_P(HardCases, HollowCase,
                         testing::ValuesIn(cases_that([](const TouchCase& c) { return c.concave; })), name_of);
INSTANTIATE_TEST_SUITE_P(HardCases, TidyCase, testing::ValuesIn(cases_that([](const TouchCase& c) { return c.tidy; })),
                         name_of);

}  // namespace invariants_test
}  // namespace handrail::test
