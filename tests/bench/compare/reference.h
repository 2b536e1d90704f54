// Where the ball truly goes: the way of steepest approach to the hand among all places that keep clear of everything, followed in steps of 10 um in long
// double from where it was a tick ago. Every obstacle is looked at, contact planes are met by trying every set of at most three; nothing is shared with any
// renderer. Slow on purpose. It errs where the renderer may be better: in dips narrower than its steps.
#pragma once

#include <vector>

#include "tests/bench/compare/bench_world.h"

namespace handrail::bench {

// By tick. Empty when the path does not begin in free space, or when it takes more than most_work comparisons.
std::vector<Vec3> reference_walk(const BenchWorld& world, double most_work);

}  // namespace handrail::bench
