// What renderers are compared on: a scene to touch, a path of the hand through it, and the same shapes once more as
// plain numbers for those renderers and judges that must not see the scene's own structures. Immutable once built; any
// thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic/render/haptic_scene.h"
#include "tests/support/brute_force.h"
#include "worlds/base/result.h"

namespace handrail::bench {

struct BenchWorld {
    std::string name;    // "T5a crevice 10 degrees, seed 3"
    std::string family;  // "T5", "sphere 1e4", "map first_room"
    std::uint32_t seed = 0;
    std::shared_ptr<const HapticScene> scene;
    std::vector<Vec3> goals_m;  // 1 kHz, world
    double radius_m = 0.005;
    // Every obstacle in the scene's order. Of a sphere mesh only those near the path; `thing_of` then tells where they
    // are.
    test::BruteForce judge;
    std::vector<std::int32_t> thing_of;  // by obstacle, -1: left out; empty: the same order
    bool hard_case = false;              // a small world of the families T1 to T16
    bool judged = true;                  // the judge knows everything that the scene holds
    double sphere_radius_m = 0.0;        // a tessellated sphere around zero: the exact answer is known
    double simplify_bound_m = 0.0,
           simplify_measured_m = 0.0;  // of a mesh made coarser: asked for, and found (haptic/compile/simplify_mesh)
    double build_s = 0.0;
    double bytes_per_obstacle = 0.0;  // heap taken by building, all of it

    // About how many comparisons one look of the judge at everything near a place costs: solids are judged by trying
    // every three of their planes.
    double judging_work() const;
    const test::BruteForce::Thing* thing(std::uint32_t obstacle) const {
        const std::int64_t at = thing_of.empty() ? static_cast<std::int64_t>(obstacle) : thing_of[obstacle];
        return at < 0 ? nullptr : &judge.things()[static_cast<std::size_t>(at)];
    }
};

// Seed 0: the hard cases of tests/support/touch_worlds as they stand. Others: the families of
// tests/support/random_families with everything drawn from the seed, and the cases that have none turned, shifted, with
// a ball of 2 to 6 mm; the hand off by up to half a millimetre.
std::vector<BenchWorld> hard_case_worlds(std::uint32_t seed);
// A hand that slides at 0.2 m/s, 2 to 5 mm deep, over a sphere of 0.5 m made of 20 frequency^2 triangles.
// simplify_m > 0: made coarser within that distance first.
BenchWorld sphere_world(int frequency, int ticks, std::uint32_t seed, double simplify_m = 0.0);
// A hand that slides at 0.2 m/s, 3 mm deep, over the pole of a sphere of 0.5 m in which so many triangles meet,
// parallels 3 mm apart.
BenchWorld pole_world(int sectors, int ticks);
// A hand that walks and feels its way through a map, from its first start.
Result<BenchWorld> map_world(const std::filesystem::path& map, int ticks, std::uint32_t seed);

}  // namespace handrail::bench
