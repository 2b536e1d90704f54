// Defines a factor for the length of long random walks, so that instrumented builds also finish in time.
#pragma once

#include <cstddef>

#include "tests/support/names.h"

namespace handrail::test {

#if defined(HANDRAIL_SANITIZED)
inline constexpr double kSanitizerScale = 0.1;
#else
inline constexpr double kSanitizerScale = 1.0;
#endif

// True in the build with the thread sanitizer, which needs to see each combination of threads only once. A test that
// starts the same threads as a shorter test is therefore skipped in that build.
#if defined(HANDRAIL_SANITIZED_THREAD)
inline constexpr bool kThreadSanitizer = true;
#else
inline constexpr bool kThreadSanitizer = false;
#endif

// Returns `count` times the factor, at least 1.
inline constexpr int scaled(int count) {
    return static_cast<int>(count * kSanitizerScale) > 0 ? static_cast<int>(count * kSanitizerScale) : 1;
}

// Returns whether to try the case with this number among many similar ones. Normally all are tried, but under a
// sanitizer only every `stride`-th.
inline constexpr bool tried(std::size_t number, std::size_t stride) {
    return kSanitizerScale == 1.0 || number % stride == 0;
}

}  // namespace handrail::test
