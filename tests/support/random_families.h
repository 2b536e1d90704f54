// The families of hard cases with all their parameters drawn from a seed: angles, sizes, gaps, offsets, proxy radius
// and hand path. They ensure that nothing is tuned to the listed cases alone.
#pragma once

#include <cstdint>

#include "tests/support/names.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {

inline constexpr std::size_t kRandomFamilies = 12;

// The same seed gives the same case on every machine.
TouchCase random_case(std::size_t family, std::uint32_t seed);

// The seed of this run: HANDRAIL_SEED if it is set, else drawn once per process. Tests print it.
std::uint32_t seed_of_run();

}  // namespace handrail::test
