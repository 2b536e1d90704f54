// Defines vectors, angles and frames. All code uses one convention: right-handed, x east, y north, z up; metres,
// seconds, newtons, radians. The haptic core, files and settings use double. Only drawing and audio outputs convert to
// float.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace handrail {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

inline constexpr double kPi = 3.14159265358979323846;

inline bool is_finite(const Vec3& v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Returns a unit vector perpendicular to v. The same v always gives the same result. Returns z up if v is zero.
inline Vec3 any_perpendicular(const Vec3& v) noexcept {
    const Vec3 axis = std::abs(v.x) <= std::abs(v.y) && std::abs(v.x) <= std::abs(v.z) ? Vec3(1, 0, 0)
                      : std::abs(v.y) <= std::abs(v.z)                                 ? Vec3(0, 1, 0)
                                                                                       : Vec3(0, 0, 1);
    const Vec3 n = glm::cross(v, axis);
    const double length = glm::length(n);
    return length > 0.0 ? n / length : Vec3(0, 0, 1);
}

// Headings run clockwise from north, which is 0. The code uses radians; only speech and files use degrees.
inline double radians_from_degrees(double degrees) noexcept { return degrees * (kPi / 180.0); }
inline double degrees_from_radians(double radians) noexcept { return radians * (180.0 / kPi); }

// Returns the horizontal unit vector in the direction that a person with this heading faces.
inline Vec3 forward_of_heading(double heading_rad) noexcept {
    return {std::sin(heading_rad), std::cos(heading_rad), 0.0};
}
// Returns the horizontal unit vector to the right of a person with this heading.
inline Vec3 right_of_heading(double heading_rad) noexcept {
    return {std::cos(heading_rad), -std::sin(heading_rad), 0.0};
}

// Rounds any angle to eighths of a turn and returns 0 to 7: 0 for no turn, 2 for a quarter turn clockwise.
inline std::size_t nearest_eighth(double angle_rad) noexcept {
    return static_cast<std::size_t>((std::lround(angle_rad / (kPi / 4.0)) % 8 + 8) % 8);
}

}  // namespace handrail
