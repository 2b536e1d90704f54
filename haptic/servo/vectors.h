// Defines vector and rotation helpers for the stages of a tick. Pure functions, any thread, no allocation.
#pragma once

#include <cmath>

#include "worlds/base/vec.h"
#include "worlds/geometry/placement.h"

namespace handrail::servo {

inline double length(const Vec3& v) noexcept { return std::sqrt(glm::dot(v, v)); }

// Returns v, shortened to the length `most` if it is longer.
inline Vec3 at_most(const Vec3& v, double most) noexcept {
    const double l = length(v);
    return l > most ? v * (most / l) : v;
}

// Returns the rotation from one orientation to the other, as a vector along its axis. The vector's length is twice the
// sine of half the angle, which for small angles is the angle in radians. Needs unit quaternions.
inline Vec3 turn_between(const Rotation& from, const Rotation& to) noexcept {
    const Rotation d = to * Rotation{from.w, -from.x, -from.y, -from.z};
    const double two = d.w < 0.0 ? -2.0 : 2.0;
    return {two * d.x, two * d.y, two * d.z};
}

}  // namespace handrail::servo
