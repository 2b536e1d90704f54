// One factor for the length of long random walks, so that instrumented builds finish too.
#pragma once

#include <cstddef>

namespace handrail::test {

#if defined(HANDRAIL_SANITIZED)
inline constexpr double kSanitizerScale = 0.1;
#else
inline constexpr double kSanitizerScale = 1.0;
#endif

// The thread sanitizer is told of each kind of threads once: a test that starts the same as a shorter one skips there.
#if defined(HANDRAIL_SANITIZED_THREAD)
inline constexpr bool kThreadSanitizer = true;
#else
inline constexpr bool kThreadSanitizer = false;
#endif

// `count` under the factor, at least 1.
inline constexpr int scaled(int count) {
    return static_cast<int>(count * kSanitizerScale) > 0 ? static_cast<int>(count * kSanitizerScale) : 1;
}

// Of many that are alike: whether the one of this number is tried. Each is; under a sanitizer every `stride`-th.
inline constexpr bool tried(std::size_t number, std::size_t stride) {
    return kSanitizerScale == 1.0 || number % stride == 0;
}

}  // namespace handrail::test
