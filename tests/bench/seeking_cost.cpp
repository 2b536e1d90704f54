// Measures the cost of the functions that guide along a route in the bundled house. They plan a route on request and
// find the person's place on the route in each frame. Run it by hand: build/release/bin/seeking_cost.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "app/core/wayfinding/hand_path.h"
#include "app/core/wayfinding/sought_route.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "worlds/navigation/route_place.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

constexpr std::size_t kMostPoints = 64;
constexpr double kHand_m = 1.0;

// Destinations from the front door: a thing near by, one across a room, and one on the other storey.
constexpr const char* kThings[] = {"Coat stand", "Dining table", "Piano"};

struct House {
    House()
        : scene(std::make_shared<const Scene>(*read_world(test::project_root() / "worlds/maps/house.map"))),
          world(scene),
          navigation(*Navigation::make(*scene, walker_measures(*scene, 0.25, 1.7, 0.2))),
          feet_m(scene->starts.front().feet_m) {}
    FeatureId thing(const char* name) const {
        const auto& all = scene->features;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Feature& feature) { return feature.name == name; });
        return FeatureId{static_cast<std::uint32_t>(found - all.begin())};
    }
    Route walk(FeatureId id) const { return walk_to_thing(*navigation, world, feet_m, scene->find(id)->bounds_m, id); }
    std::vector<Vec3> by_hand(FeatureId id) const {
        return path_of_hand(walk(id), feet_m + Vec3(0.0, 0.0, kHand_m), kHand_m, world, scene->find(id)->bounds_m, id,
                            kMostPoints);
    }
    std::shared_ptr<const Scene> scene;
    WalkerWorld world;
    std::shared_ptr<Navigation> navigation;
    Vec3 feet_m;
};

const House& house() {
    static const House the_house;
    return the_house;
}

void plan_walk(benchmark::State& state) {
    const char* name = kThings[state.range(0)];
    state.SetLabel(name);
    const FeatureId id = house().thing(name);
    for (auto _ : state) benchmark::DoNotOptimize(house().walk(id));
}
BENCHMARK(plan_walk)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

void plan_for_a_hand(benchmark::State& state) {
    const char* name = kThings[state.range(0)];
    state.SetLabel(name);
    const FeatureId id = house().thing(name);
    for (auto _ : state) benchmark::DoNotOptimize(house().by_hand(id));
}
BENCHMARK(plan_for_a_hand)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

// Finds the place of a person who walks along the route, half a metre to its side, with the route in sight or not.
void look_where_on_it(benchmark::State& state) {
    const char* name = kThings[state.range(0)];
    state.SetLabel(name);
    const FeatureId id = house().thing(name);
    const std::vector<Vec3> points = house().by_hand(id);
    SoughtRoute way;
    way.plan(points, {}, 0.0, points.front(), 0.0);
    double along_m = 0.0;
    const double length_m = way.left_m();
    for (auto _ : state) {
        along_m = along_m + 0.01 < length_m ? along_m + 0.01 : 0.0;
        const Vec3 at = place_along(points, along_m) + Vec3(0.3, 0.4, 0.0);
        way.follow(at, 1.0, [&](const Vec3& place) { return free_line(house().world, at, place, id); });
        benchmark::DoNotOptimize(way.announced_m());
    }
}
BENCHMARK(look_where_on_it)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace handrail

BENCHMARK_MAIN();
