// Draws cases of the families of hard cases, with all their parameters drawn from a seed: angles, sizes, gaps, offsets,
// proxy radius and hand path. With these cases, tests check that nothing is tuned to the listed cases alone.
#pragma once

#include <cstdint>

#include "tests/support/names.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {

inline constexpr std::size_t kRandomFamilies = 12;

// Returns a case of a family. The same seed gives the same case on every machine.
TouchCase random_case(std::size_t family, std::uint32_t seed);

// Returns the seed of this run: HANDRAIL_SEED if that variable is set, otherwise a number drawn once per process. Tests
// print the seed.
std::uint32_t seed_of_run();

}  // namespace handrail::test
