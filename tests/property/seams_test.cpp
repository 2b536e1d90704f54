// Tests that the proxy never passes where two solids overlap, touch or nearly touch. The hand aims at such seams on
// purpose, in generated worlds and at the inner seams of a real map.
#include <iostream>

#include "haptic/compile/compile_haptic.h"
#include "tests/property/replay.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/touch_worlds.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace seams_test {

Vec3 direction(std::mt19937& random) {
    for (;;) {
        const double x = 2 * unit(random) - 1, y = 2 * unit(random) - 1, z = 2 * unit(random) - 1;
        const double length = std::sqrt(x * x + y * y + z * z);
        if (length > 0.1 && length < 1.0) return Vec3(x, y, z) / length;
    }
}

TEST(Seams, between_boxes_that_overlap_touch_or_have_a_gap_narrower_than_the_proxy_stay_shut) {
    constexpr std::uint32_t kSeed = 77;
    std::mt19937 random(kSeed);
    for (int round = 0; round < scaled(300); ++round) {
        const double radius = round % 2 == 0 ? 0.005 : 1e-5;
        // The solids overlap by up to 5 mm, touch exactly, or leave a gap of up to 99 % of the proxy's diameter.
        const double gap = round % 3 == 0   ? -0.005 * unit(random)
                           : round % 3 == 1 ? 0.0
                                            : 0.99 * 2 * radius * unit(random);
        TouchWorld world;
        const double thick = 0.002 + 0.05 * unit(random);
        world.box({-0.3, -0.3, -thick}, {0, 0.3, 0});
        if (round % 4 < 2) world.box({gap, -0.3, -thick * (0.5 + unit(random))}, {0.3, 0.3, 0});
        else world.brush_box({gap, -0.3, -thick}, {0.3, 0.3, 0});
        Motion motion = random_turn(random);
        motion.shift_m = {3.0 * unit(random), -20.0 * unit(random), 1.0};
        const BruteForce judge = world.judge(motion);
        // The hand moves into the seam at one of 12 angles, to 0.1 m beyond it. Then it sweeps along the seam while
        // pressed deep.
        std::vector<Vec3> way;
        const double tilt = kPi * (round % 12 + 0.5) / 12.0;
        const Vec3 from(0.08 * std::cos(tilt), 0.1 * unit(random) - 0.05, 0.08 * std::sin(tilt) + radius);
        const Vec3 at(gap / 2, 0.1 * unit(random) - 0.05, 0.0);
        way = {from, at + (at - from), at + (at - from) + Vec3(0, 0.1, 0), at + (at - from) - Vec3(0, 0.1, 0)};
        SCOPED_TRACE(fmt::format("seed {} round {} gap {} radius {}", kSeed, round, gap, radius));
        double deepest = 0.0, lowest = 1.0, largest_jump = 0.0;
        Vec3 last_force(0.0), last_goal = way[0];
        replay(*world.scene(motion), hand_path(way, 0.3), motion, plain_tuning(radius),
               [&](std::size_t i, const Vec3& goal, const TouchResult& r, const ProxySolver&) {
                   lowest = std::min(lowest, motion.back(r.proxy_m).z);
                   if (i % 3 == 0) deepest = std::max(deepest, static_cast<double>(radius - judge.distance(r.proxy_m)));
                   largest_jump = std::max(
                       largest_jump, glm::length(r.force_n - last_force) - 1000.0 * glm::length(goal - last_goal));
                   last_force = r.force_n;
                   last_goal = goal;
               });
        EXPECT_LE(deepest, 1e-9);
        EXPECT_GE(lowest, gap > 0.0 ? 0.0 : radius - 1e-9) << "a ball above the seam stays above it";
        if (gap <= 0.0) {
            EXPECT_LE(largest_jump, 1e-5) << "a closed seam is not felt";
        }
    }
}

// The solids of a real map near a place, for the judge.
struct Neighbours {
    BruteForce judge;
    std::size_t count = 0;
};
Neighbours near(const Scene& scene, const Vec3& at, double reach) {
    Neighbours out;
    for (const Solid& solid : scene.solids) {
        if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover) continue;
        if (distance_squared(solid.shape.bounds_m, at) > reach * reach) continue;
        std::vector<Vec3> corners;
        for (const Polygon& face : solid.shape.faces)
            corners.insert(corners.end(), face.points_m.begin(), face.points_m.end());
        out.judge.add_solid(solid.shape.planes, corners);
        ++out.count;
    }
    return out;
}

void no_ray_or_sweep_passes_a_seam_of(const std::filesystem::path& path) {
    ReadOptions options;
    options.guess_materials = false;
    const Result<Scene> scene = read_world(path, options);
    ASSERT_TRUE(scene) << scene.error().sentence();
    const auto haptic = compile_haptic(*scene, MaterialSource::KeysOnly);
    constexpr std::uint32_t kSeed = 4711;
    std::mt19937 random(kSeed);
    std::vector<const Solid*> solids;
    for (const Solid& solid : scene->solids)
        if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) solids.push_back(&solid);
    const int wanted = scaled(1000);
    int seams = 0, touched = 0;
    double deepest = 0.0;
    for (int attempt = 0; seams < wanted && attempt < wanted * 400; ++attempt) {
        // Finds an inner seam within a hand's reach: a point on an edge of one brush that is also on another brush and
        // not inside any.
        const Solid& a = *solids[random() % solids.size()];
        const Polygon& face = a.shape.faces[random() % a.shape.faces.size()];
        const std::size_t corner = random() % face.points_m.size();
        const double along = unit(random);
        const Vec3 seam =
            face.points_m[corner] * along + face.points_m[(corner + 1) % face.points_m.size()] * (1.0 - along);
        bool shared = false;
        haptic->obstacle_bvh.within(seam - haptic->origin_m, 1e-6, [&](std::uint32_t item, double&) {
            // The brush with the edge also has distance 0 from the seam, so a second brush must have distance 0, too.
            const double d = haptic->closest(item, seam - haptic->origin_m).distance_m;
            const bool self = std::abs(d) < 1e-6 &&
                              haptic->closest(item, a.shape.bounds_m.centre_m() - haptic->origin_m).distance_m < 0.0;
            shared = shared || (std::abs(d) < 1e-6 && !self);
        });
        if (!shared) continue;
        const Neighbours around = near(*scene, seam, 0.25);
        Vec3 start(0.0);
        bool reachable = false;
        for (int i = 0; i < 6 && !reachable; ++i) {
            start = seam + direction(random) * (0.02 + 0.06 * unit(random));
            reachable = around.judge.distance(start) > 0.0055L;
        }
        if (!reachable) continue;
        ++seams;
        const Vec3 beyond = seam + (seam - start) * (0.05 / glm::length(seam - start));
        const Vec3 edge = glm::normalize(face.points_m[(corner + 1) % face.points_m.size()] - face.points_m[corner]);
        for (const double radius : {0.005, 1e-5}) {
            const std::vector<Vec3> goals = hand_path({start, beyond, beyond + edge * 0.03, beyond - edge * 0.03}, 0.5);
            bool contact = false;
            replay(*haptic, goals, {}, plain_tuning(radius),
                   [&](std::size_t i, const Vec3&, const TouchResult& r, const SolverProbe& solver) {
                       contact = contact || r.contacts.count > 0;
                       if (i % 12 != 0 && i + 1 != goals.size()) return;
                       for (int k = 0; k < solver.path_size(); ++k)
                           deepest = std::max(
                               deepest, static_cast<double>(r.radius_m - around.judge.distance(solver.path_m(k))));
                   });
            touched += contact;
        }
        ASSERT_LE(deepest, 1e-9) << fmt::format("seed {} seam {} at {} {} {}", kSeed, seams, seam.x, seam.y, seam.z);
    }
    EXPECT_EQ(seams, wanted);
    EXPECT_GT(touched, seams) << "of two rays per seam";
    std::cout << fmt::format("{} seams, {} of {} rays touched, deepest {:.1e} m\n", seams, touched, 2 * seams, deepest);
}

TEST(Seams, of_our_school_let_no_ray_or_sweep_through_at_1000_places) {
    no_ray_or_sweep_passes_a_seam_of(project_root() / "worlds/maps/school.map");
}

TEST(Seams, of_a_real_map_let_no_ray_or_sweep_through_at_1000_places) {
    const auto path = real_world("quake-e1m1.map");
    if (!path) GTEST_SKIP() << needs_real_world("quake-e1m1.map");
    no_ray_or_sweep_passes_a_seam_of(*path);
}

}  // namespace seams_test
}  // namespace handrail::test
