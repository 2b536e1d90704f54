#include "tests/bench/compare/bench_world.h"

#include <malloc.h>

#include <algorithm>
#include <random>

#include "haptic/compile/compile_haptic.h"
#include "haptic/compile/simplify_mesh.h"
#include "tests/bench/walk.h"
#include "tests/support/names.h"
#include "tests/support/random_families.h"
#include "tests/support/reference_proxy.h"
#include "tests/support/sphere_mesh.h"
#include "tests/support/touch_worlds.h"
#include "worlds/base/clock.h"
#include "worlds/readers/reader.h"

namespace handrail::bench {
namespace {

using test::unit;

std::size_t heap_bytes() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

// Builds the scene and records how much time and memory the build takes.
template <class Build>
void build_scene(BenchWorld& world, Build&& build) {
    const SteadyClock clock;
    const std::size_t before = heap_bytes();
    const double begun_s = clock.now_s();
    world.scene = build();
    world.build_s = clock.now_s() - begun_s;
    const std::size_t after = heap_bytes();
    world.bytes_per_obstacle = after > before
                                   ? static_cast<double>(after - before) /
                                         static_cast<double>(std::max<std::size_t>(1, world.scene->obstacles.size()))
                                   : 0.0;
}

}  // namespace

double BenchWorld::judging_work() const {
    double work = 0.0;
    for (const test::BruteForce::Thing& t : judge.things()) work += test::judging_work(t);
    // In a large scene, a cheap comparison excludes most obstacles because they are far away.
    const double many = static_cast<double>(judge.things().size());
    return many > 100.0 ? many + work * 20.0 / many : work;
}

std::vector<BenchWorld> hard_case_worlds(std::uint32_t seed) {
    // Family names, indexed by the number of a random family: strips, crack, corner, groove, edge, spike, litter,
    // slivers, thin, rough hand, soup, heap.
    constexpr const char* kFamilyOfRandom[test::kRandomFamilies] = {"T1", "T2", "T3",  "T5",  "T6",  "T7",
                                                                    "T8", "T9", "T11", "T14", "T16", "T16"};
    std::mt19937 random(seed);
    std::vector<BenchWorld> worlds;
    const auto add = [&](const test::TouchCase& c, const std::string& family) {
        test::Motion motion;
        Vec3 off(0.0);
        if (seed != 0) {
            motion = test::random_turn(random);
            motion.shift_m = Vec3(unit(random), unit(random), unit(random)) * 20.0 - Vec3(10.0);
            off = (Vec3(unit(random), unit(random), unit(random)) - Vec3(0.5)) * 1e-3;
        }
        BenchWorld world;
        world.name = seed == 0 ? c.name : fmt::format("{}, seed {}", c.name, seed);
        world.family = family;
        world.hard_case = true;
        world.seed = seed;
        build_scene(world, [&] { return c.world.scene(motion); });
        world.judge = c.world.judge(motion);
        world.radius_m = c.radius_m;
        for (const Vec3& goal : c.goals_m)
            world.goals_m.push_back(motion(goal + off * std::min(1.0, c.radius_m / 0.005)));
        worlds.push_back(std::move(world));
    };
    for (const test::TouchCase& c : test::hard_cases(seed == 0 ? 0.005 : 0.002 + 0.004 * unit(random))) {
        const std::string family = c.name.substr(0, c.name.find_first_of(" abcde", 1));
        const bool drawn =
            std::find(std::begin(kFamilyOfRandom), std::end(kFamilyOfRandom), family) != std::end(kFamilyOfRandom);
        if (seed == 0 || !drawn) add(c, family);
    }
    if (seed != 0)
        for (std::size_t i = 0; i < test::kRandomFamilies; ++i) add(test::random_case(i, seed), kFamilyOfRandom[i]);
    return worlds;
}

BenchWorld sphere_world(int frequency, int ticks, std::uint32_t seed, double simplify_m) {
    constexpr double kSphere_m = 0.5, kSpeed_m_per_s = 0.2, kNear_m = 0.02;
    std::mt19937 random(seed);
    const test::Motion motion = seed == 0 ? test::Motion{} : test::random_turn(random);
    BenchWorld world;
    TriangleMesh mesh = test::sphere_mesh(frequency, kSphere_m);
    for (Vec3& p : mesh.points_m) p = motion(p);
    world.family = fmt::format("sphere of {} triangles", mesh.triangles.size());
    if (simplify_m > 0.0) {
        SimplifiedMesh simplified = simplify_mesh(mesh, {}, simplify_m);
        mesh = std::move(simplified.mesh);
        world.family = fmt::format("simplified {}, within {:g} mm", world.family, simplify_m * 1e3);
        world.simplify_bound_m = simplify_m;
        world.simplify_measured_m = simplified.measured_m;
    }
    world.name = seed == 0 ? world.family : fmt::format("{}, seed {}", world.family, seed);
    world.seed = seed;
    world.sphere_radius_m = kSphere_m;
    build_scene(world, [&] {
        HapticSceneBuilder builder;
        builder.add_mesh(mesh);
        return builder.build();
    });
    // The seed changes only the orientation of the mesh. The hand starts at the same place in the world.
    world.goals_m = test::sphere_slide(kSphere_m, world.radius_m, kSpeed_m_per_s, ticks);
    // Marks the cells of a coarse grid along the path. A triangle with a corner in a marked cell is near enough to
    // affect the result.
    std::vector<std::uint64_t> marked;
    const auto cell = [](const Vec3& p) {
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis)
            key = key * 2097152 +
                  static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p[axis] / kNear_m)) + 1048576);
        return key;
    };
    for (std::size_t i = 0; i < world.goals_m.size(); i += 20)
        for (int n = 0; n < 27; ++n)
            marked.push_back(cell(world.goals_m[i] + Vec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1) * kNear_m));
    std::sort(marked.begin(), marked.end());
    marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
    const auto near = [&](const Vec3& p) { return std::binary_search(marked.begin(), marked.end(), cell(p)); };
    const bool all = mesh.triangles.size() < 30000;
    if (!all) world.thing_of.assign(mesh.triangles.size(), -1);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        const Vec3 pa = mesh.points_m[a], pb = mesh.points_m[b], pc = mesh.points_m[c];
        if (!all && !near(pa) && !near(pb) && !near(pc)) continue;
        if (!all) world.thing_of[i] = static_cast<std::int32_t>(world.judge.things().size());
        world.judge.add_triangle(pa, pb, pc);
    }
    return world;
}

BenchWorld pole_world(int sectors, int ticks) {
    constexpr double kSphere_m = 0.5, kSpeed_m_per_s = 0.2, kRing_m = 3e-3;
    constexpr int kRings = 16;  // rings of triangles; enough for a proxy that moves 20 mm to either side
    BenchWorld world;
    world.family = world.name = fmt::format("pole of a sphere, {} triangles", sectors);
    world.sphere_radius_m = kSphere_m;
    const TriangleMesh mesh = test::pole_mesh(sectors, kRings, kRing_m, kSphere_m);
    build_scene(world, [&] {
        HapticSceneBuilder builder;
        builder.add_mesh(mesh);
        return builder.build();
    });
    world.goals_m = test::pole_slide(kSphere_m, world.radius_m, kSpeed_m_per_s, ticks);
    for (const auto& [a, b, c] : mesh.triangles)
        world.judge.add_triangle(mesh.points_m[a], mesh.points_m[b], mesh.points_m[c]);
    return world;
}

Result<BenchWorld> map_world(const std::filesystem::path& map, int ticks, std::uint32_t seed) {
    ReadOptions options;
    options.guess_materials = false;
    Result<Scene> scene = read_world(map, options);
    if (!scene) return tl::unexpected(scene.error());
    BenchWorld world;
    world.family = "map " + map.stem().string();
    world.name = seed == 0 ? world.family : fmt::format("{}, seed {}", world.family, seed);
    world.seed = seed;
    build_scene(world, [&] { return compile_haptic(*scene, MaterialSource::KeysOnly); });
    for (const Solid& solid : scene->solids) {
        if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover) continue;
        std::vector<Vec3> corners;
        for (const Polygon& face : solid.shape.faces)
            corners.insert(corners.end(), face.points_m.begin(), face.points_m.end());
        world.judge.add_solid(solid.shape.planes, corners);
    }
    for (const MeshTriangle& t : scene->triangles) world.judge.add_triangle(t.a_m, t.b_m, t.c_m);
    world.judged = world.judge.things().size() == world.scene->obstacles.size();
    TouchTuning tuning;
    const Vec3 feet =
        scene->starts.empty() ? scene->bounds_m.centre_m() : scene->starts[seed % scene->starts.size()].feet_m;
    world.goals_m = test::record_walk(*world.scene, tuning, feet + Vec3(0, 0, 1.0), ticks, 1996 + seed);
    return world;
}

}  // namespace handrail::bench
