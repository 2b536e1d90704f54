// Vectors and frames, one convention everywhere: right-handed, x east, y north, z up; metres, seconds, newtons,
// radians. The haptic core, files and settings are double throughout; only drawing and sound sinks convert to float.
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

// A unit vector square to v, the same for the same v; z up where v is zero.
inline Vec3 any_perpendicular(const Vec3& v) noexcept {
    const Vec3 axis = std::abs(v.x) <= std::abs(v.y) && std::abs(v.x) <= std::abs(v.z) ? Vec3(1, 0, 0)
                      : std::abs(v.y) <= std::abs(v.z)                                 ? Vec3(0, 1, 0)
                                                                                       : Vec3(0, 0, 1);
    const Vec3 n = glm::cross(v, axis);
    const double length = glm::length(n);
    return length > 0.0 ? n / length : Vec3(0, 0, 1);
}

// Headings: 0 is north, clockwise, radians inside and degrees only in speech and files.
inline double radians_from_degrees(double degrees) noexcept { return degrees * (kPi / 180.0); }
inline double degrees_from_radians(double radians) noexcept { return radians * (180.0 / kPi); }

// Unit vector that a body with this heading faces, in the horizontal plane.
inline Vec3 forward_of_heading(double heading_rad) noexcept {
    return {std::sin(heading_rad), std::cos(heading_rad), 0.0};
}
// Unit vector to the right of a body with this heading.
inline Vec3 right_of_heading(double heading_rad) noexcept {
    return {std::cos(heading_rad), -std::sin(heading_rad), 0.0};
}

// Which eighth of a turn an angle is nearest to: 0 for none, 2 for a quarter clockwise; 0 to 7 for any angle.
inline std::size_t nearest_eighth(double angle_rad) noexcept {
    return static_cast<std::size_t>((std::lround(angle_rad / (kPi / 4.0)) % 8 + 8) % 8);
}

}  // namespace handrail
