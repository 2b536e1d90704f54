// Computes the true position of the proxy in every tick of a world. It uses tests/support/reference_proxy.h, which
// works in long double by brute force and shares no code with any renderer.
#pragma once

#include <vector>

#include "tests/bench/compare/bench_world.h"

namespace handrail::bench {

// Returns one position for each tick. Returns none if the path does not begin in free space or takes more than
// `most_work` comparisons.
std::vector<Vec3> reference_walk(const BenchWorld& world, double most_work);

}  // namespace handrail::bench
