// Where the ball truly goes on every tick of a world: tests/support/reference_proxy, long double and brute force, which
// shares nothing with any renderer.
#pragma once

#include <vector>

#include "tests/bench/compare/bench_world.h"

namespace handrail::bench {

// By tick. Empty when the path does not begin in free space, or when it takes more than most_work comparisons.
std::vector<Vec3> reference_walk(const BenchWorld& world, double most_work);

}  // namespace handrail::bench
