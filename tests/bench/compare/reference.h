// Where the proxy truly goes on every tick of a world. Uses tests/support/reference_proxy: long double and brute force,
// which shares no code with any renderer.
#pragma once

#include <vector>

#include "tests/bench/compare/bench_world.h"

namespace handrail::bench {

// One position for each tick. Empty if the path does not begin in free space or takes more than most_work comparisons.
std::vector<Vec3> reference_walk(const BenchWorld& world, double most_work);

}  // namespace handrail::bench
