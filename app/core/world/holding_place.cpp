#include "app/core/world/holding_place.h"

#include <algorithm>
#include <vector>

#include "worlds/base/contract.h"

namespace handrail::core {
namespace {

constexpr double kTick_s = 0.05, kLongestFall_s = 30.0;
constexpr int kGrid = 16;                 // number of tried places along each side of the world
constexpr std::size_t kMostThings = 400;  // at most this many things whose tops are tried too
constexpr double kAbove_m = 0.1;

// Returns where a walker comes to rest that falls from this place, as in Walking. Returns no value if the walker falls
// out of the world, or slides without end.
std::optional<Vec3> rest_below(const Aabb& bounds_m, const WalkerWorld& world, const WalkerSize& size,
                               const Vec3& from_m) {
    const double lowest_m = bounds_m.min_m.z - kOutOfWorld_m;
    Walker walker(world, size);
    walker.place(from_m);
    for (double t = 0.0; t < kLongestFall_s && !walker.state().on_ground; t += kTick_s) {
        if (walker.state().feet_m.z < lowest_m) return std::nullopt;
        walker.tick(Vec3(0.0), kTick_s);
    }
    if (!walker.state().on_ground) return std::nullopt;
    return walker.state().feet_m;
}

// Returns places above the ground and the things of the world, at the height of `preferred_m` and at a height above
// everything.
std::vector<Vec3> places_over(const Scene& scene, const Vec3& preferred_m) {
    std::vector<Vec3> places;
    const Aabb& box = scene.bounds_m;
    const double top_m = box.max_m.z + kAbove_m;
    for (int i = 0; i < kGrid * kGrid; ++i) {
        const Vec3 share((i % kGrid + 0.5) / kGrid, (i / kGrid + 0.5) / kGrid, 0.0);
        const Vec3 at = box.min_m + share * box.size_m();
        if (preferred_m.z > box.min_m.z && preferred_m.z < top_m) places.emplace_back(at.x, at.y, preferred_m.z);
        places.emplace_back(at.x, at.y, top_m);
    }
    std::size_t things = 0;
    for (const Feature& feature : scene.features) {
        if (feature.bounds_m.empty()) continue;
        if (++things > kMostThings) break;
        const Vec3 middle = feature.bounds_m.centre_m();
        places.emplace_back(middle.x, middle.y, feature.bounds_m.max_m.z + kAbove_m);
    }
    std::stable_sort(places.begin(), places.end(), [&](const Vec3& a, const Vec3& b) {
        return glm::distance(a, preferred_m) < glm::distance(b, preferred_m);
    });
    return places;
}

}  // namespace

std::optional<Vec3> place_that_holds(const Scene& scene, const WalkerWorld& world, const WalkerSize& size,
                                     std::span<const Vec3> preferred) {
    contract_pre(!scene.bounds_m.empty());
    contract_pre(!preferred.empty());
    for (const Vec3& preferred_m : preferred)
        if (const auto rest = rest_below(scene.bounds_m, world, size, preferred_m)) return rest;
    const WalkerShape shape{size.radius_m, size.height_m};
    for (const Vec3& place_m : places_over(scene, preferred.front())) {
        const Vec3 below_m(place_m.x, place_m.y, scene.bounds_m.min_m.z - 1.0);
        if (world.blocked(place_m, shape) || !world.trace(place_m, below_m, shape).hit) continue;
        if (const auto rest = rest_below(scene.bounds_m, world, size, place_m)) return rest;
    }
    return std::nullopt;
}

}  // namespace handrail::core
