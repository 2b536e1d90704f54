// Makes the last check in every driver, so that a driver never sends its device a force that is not finite or exceeds
// the device's peak. Pure functions; real-time safe.
#pragma once

#include <algorithm>
#include <cmath>

#include "worlds/base/vec.h"

namespace handrail::drivers {

// Returns `force_n` unchanged if its size is at most `peak_n`. Otherwise returns a force of the size `peak_n` in the
// same direction, however large the given force was. Returns zero if the force is not finite.
inline Vec3 held_to(const Vec3& force_n, double peak_n) noexcept {
    if (!is_finite(force_n) || !(peak_n > 0.0)) return Vec3(0.0);
    const double largest = std::max({std::abs(force_n.x), std::abs(force_n.y), std::abs(force_n.z)});
    if (largest == 0.0) return Vec3(0.0);
    const Vec3 direction = force_n / largest;  // scaled so that the squares neither overflow nor underflow
    const double length = std::sqrt(glm::dot(direction, direction));
    return largest <= peak_n / length ? force_n : direction * (peak_n / length);
}

}  // namespace handrail::drivers
