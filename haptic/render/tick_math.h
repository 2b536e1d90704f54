// Implements the few mathematical functions that force laws need in a servo tick. They use only + - * / and the
// rounding of std::floor, so that every machine and build gives bit-identical results. Pure, noexcept, a few
// nanoseconds each.
#pragma once

#include <algorithm>
#include <cmath>

#include "haptic/render/tick_assert.h"
#include "worlds/base/vec.h"

namespace handrail::render {

// Returns exp(-u) for u >= 0, within 0.4 % for u <= 1. The result falls for every u. Used where only the trend is
// important, as for shares and recovery.
inline double decay(double u) noexcept {
    tick_assert(!(u < 0.0));
    return 1.0 / (1.0 + u * (1.0 + u * (0.5 + u * (1.0 / 6.0 + u * (1.0 / 24.0)))));
}

// Returns exp(-u) for u >= 0, with a relative error below 1e-8 up to u = 40, and 0 beyond. Used for forces that must be
// the exact slope of an energy.
inline double exp_minus(double u) noexcept {
    tick_assert(!(u < 0.0));
    if (!(u < 40.0)) return 0.0;
    const double t = u * (1.0 / 64.0);
    double series = 1.0;
    for (int k = 11; k >= 1; --k) series = 1.0 + series * t / k;
    double value = 1.0 / series;
    for (int k = 0; k < 6; ++k) value *= value;
    return value;
}

struct SineCosine {
    double sine, cosine;
};
// Returns sine and cosine of an angle given in whole turns, with an error below 1e-11. The nearest whole turn is
// subtracted first, so a large number loses no more precision than its own rounding.
inline SineCosine sine_of_turns(double turns) noexcept {
    const double rest = turns - std::floor(turns + 0.5);  // range -0.5 to 0.5
    const double half = 0.5 * kPi * rest;                 // a quarter of the angle in radians; at most 0.79 in size
    const double x2 = half * half;
    double sine = 1.0, cosine = 1.0;
    for (int k = 8; k >= 1; --k) {
        sine = 1.0 - sine * x2 / ((2 * k) * (2 * k + 1));
        cosine = 1.0 - cosine * x2 / ((2 * k - 1) * (2 * k));
    }
    sine *= half;
    for (int k = 0; k < 2; ++k) {
        const double doubled = 2.0 * sine * cosine;
        cosine = 1.0 - 2.0 * sine * sine;
        sine = doubled;
    }
    return {sine, cosine};
}

// Returns u^2 (3 - 2u), with u limited to 0 to 1: a step without corners.
inline double smooth_step(double u) noexcept {
    u = std::clamp(u, 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}
inline double smooth_step_slope(double u) noexcept {
    u = std::clamp(u, 0.0, 1.0);
    return 6.0 * u * (1.0 - u);
}
// Returns the integral of smooth_step from 0 to u, for any u.
inline double smooth_step_area(double u) noexcept {
    const double inside = std::clamp(u, 0.0, 1.0);
    return inside * inside * inside * (1.0 - 0.5 * inside) + std::max(0.0, u - 1.0);
}

inline double length_of(const Vec3& v) noexcept { return std::sqrt(glm::dot(v, v)); }

// Returns the vector, shortened to the length `longest` if it is longer.
inline Vec3 shortened(const Vec3& v, double longest) noexcept {
    tick_assert(!(longest < 0.0));
    const double length = length_of(v);
    return length > longest ? v * (longest / length) : v;
}

}  // namespace handrail::render
