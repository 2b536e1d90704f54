// The families of the hard cases with everything about them drawn from a seed: angles, sizes, gaps, offsets, ball, hand
// path. So that nothing is tuned to the listed cases alone.
#pragma once

#include <cstdint>

#include "tests/support/touch_worlds.h"

namespace handrail::test {

inline constexpr std::size_t kRandomFamilies = 12;

// The same seed gives the same case on every machine.
TouchCase random_case(std::size_t family, std::uint32_t seed);

// The seed of this run: HANDRAIL_SEED where it is set, else drawn once per process. Tests print it.
std::uint32_t seed_of_run();

}  // namespace handrail::test
