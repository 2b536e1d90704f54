// Defines a world on which renderers are compared. BenchWorld has a scene, a path of the hand through it, and the
// scene's shapes as plain numbers. Renderers and judges that must not use the scene's own structures use the plain
// numbers. Immutable after construction; any thread may use it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "haptic/render/haptic_scene.h"
#include "tests/support/brute_force.h"
#include "tests/support/names.h"
#include "worlds/base/result.h"

namespace handrail::bench {

struct BenchWorld {
    std::string name;    // for example "T5a crevice 10 degrees, seed 3"
    std::string family;  // for example "T5", "sphere 1e4", "map first_room"
    std::uint32_t seed = 0;
    std::shared_ptr<const HapticScene> scene;
    std::vector<Vec3> goals_m;  // positions of the hand at 1 kHz, world coordinates
    double radius_m = 0.005;
    // The judge, with every obstacle in the scene's order. For a sphere mesh it contains only the triangles near the
    // path; `thing_of` then maps obstacles to the judge's entries.
    test::BruteForce judge;
    // For each obstacle, its index in the judge; -1: left out; empty: the same order as in the scene.
    std::vector<std::int32_t> thing_of;
    bool hard_case = false;  // true for a small world of the families T1 to T16
    bool judged = true;      // true if the judge contains every obstacle of the scene
    // > 0: the scene is a tessellated sphere of this radius around the origin, whose exact answer is known.
    double sphere_radius_m = 0.0;
    // For a simplified mesh: requested and measured distance (haptic/compile/simplify_mesh).
    double simplify_bound_m = 0.0, simplify_measured_m = 0.0;
    double build_s = 0.0;
    double bytes_per_obstacle = 0.0;  // heap memory that building the scene takes, per obstacle

    // Returns the approximate number of comparisons that the judge needs for one place. For one place the judge
    // examines all near obstacles, and for a solid it tries all triples of the solid's planes.
    double judging_work() const;
    const test::BruteForce::Thing* thing(std::uint32_t obstacle) const {
        const std::int64_t at = thing_of.empty() ? static_cast<std::int64_t>(obstacle) : thing_of[obstacle];
        return at < 0 ? nullptr : &judge.things()[static_cast<std::size_t>(at)];
    }
};

// Returns the hard cases. Seed 0 gives those of tests/support/touch_worlds unchanged. Other seeds give the families of
// tests/support/random_families, drawn entirely from the seed. Cases without such a family are rotated and shifted,
// with a proxy of 2 to 6 mm and the hand displaced by up to half a millimetre.
std::vector<BenchWorld> hard_case_worlds(std::uint32_t seed);
// Returns a world in which a hand slides at 0.2 m/s, 2 to 5 mm deep, over a sphere of 0.5 m made of 20 frequency^2
// triangles. If simplify_m > 0, the mesh is first simplified within that distance.
BenchWorld sphere_world(int frequency, int ticks, std::uint32_t seed, double simplify_m = 0.0);
// Returns a world in which a hand slides at 0.2 m/s, 3 mm deep, over the pole of a sphere of 0.5 m. `sectors` triangles
// meet at the pole; the parallels are 3 mm apart.
BenchWorld pole_world(int sectors, int ticks);
// Returns a world in which a hand walks and slides through a map, beginning at the map's first start.
Result<BenchWorld> map_world(const std::filesystem::path& map, int ticks, std::uint32_t seed);

}  // namespace handrail::bench
