// Defines the position, rotation and scale of an object with its own frame: world = position + scale * (rotation
// applied to own). Plain values and pure functions; any thread may use them. They use only + - x / and square root, so
// that every build gives bit-identical results.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/base/vec.h"

namespace handrail {

// A unit quaternion w + xi + yj + zk. Source: Hamilton 1843; conversion to a matrix as in Shoemake, Animating rotation
// with quaternion curves, 1985.
struct Rotation {
    double w = 1.0, x = 0.0, y = 0.0, z = 0.0;

    bool operator==(const Rotation&) const = default;
};

// Returns the nearest unit quaternion, or the identity if q is zero or not finite.
inline Rotation normalized(const Rotation& q) noexcept {
    const double length2 = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (!(length2 > 0.0) || !std::isfinite(length2)) return {};
    const double k = 1.0 / std::sqrt(length2);
    return {q.w * k, q.x * k, q.y * k, q.z * k};
}

// Composes two rotations: the product first applies `b`, then `a`, so (a * b)(v) == a(b(v)).
inline Rotation operator*(const Rotation& a, const Rotation& b) noexcept {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

// Returns the right-handed rotation about a unit axis. Use it off the real-time path only, because it calls the C
// library's sine.
inline Rotation rotation_about(const Vec3& axis, double angle_rad) noexcept {
    const double s = std::sin(0.5 * angle_rad);
    return {std::cos(0.5 * angle_rad), axis.x * s, axis.y * s, axis.z * s};
}

struct Placement {
    Vec3 position_m{0.0};
    Rotation rotation{};
    double scale = 1.0;  // scale, above 0; the same along every axis

    bool operator==(const Placement& other) const noexcept {
        return position_m == other.position_m && rotation == other.rotation && scale == other.scale;
    }
};

// A placement prepared for transforming many points, with the columns of the rotation matrix.
struct PlacedFrame {
    Vec3 position_m{0.0};
    std::array<Vec3, 3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    double scale = 1.0;

    PlacedFrame() = default;
    explicit PlacedFrame(const Placement& p) noexcept : position_m(p.position_m), scale(p.scale) {
        const Rotation& q = p.rotation;
        axes[0] = {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)};
        axes[1] = {2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x)};
        axes[2] = {2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)};
    }

    Vec3 turned(const Vec3& own) const noexcept { return axes[0] * own.x + axes[1] * own.y + axes[2] * own.z; }
    Vec3 turned_back(const Vec3& world) const noexcept {
        return {glm::dot(axes[0], world), glm::dot(axes[1], world), glm::dot(axes[2], world)};
    }
    Vec3 to_world(const Vec3& own_m) const noexcept { return position_m + turned(own_m) * scale; }
    Vec3 to_own(const Vec3& world_m) const noexcept { return turned_back(world_m - position_m) / scale; }
};

// Interpolates between two placements; `part` runs from 0 to 1. The position is interpolated linearly and the rotation
// along the shorter arc (normalised linear interpolation). Below 30 degrees, the speed of the rotation varies by less
// than 1 %.
inline Placement between(const Placement& from, const Placement& to, double part) noexcept {
    const Rotation &a = from.rotation, &b = to.rotation;
    const double sign = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z < 0.0 ? -1.0 : 1.0;
    const auto mix = [&](double p, double q) { return p + (sign * q - p) * part; };
    Placement result;
    result.position_m = from.position_m + (to.position_m - from.position_m) * part;
    result.rotation = normalized({mix(a.w, b.w), mix(a.x, b.x), mix(a.y, b.y), mix(a.z, b.z)});
    result.scale = from.scale + (to.scale - from.scale) * part;
    return result;
}

// Returns an upper bound of the distance that a point travels between two placements. The point is at most reach_m, in
// metres of the object's own frame, from the frame's origin.
inline double farthest_travel_m(const Placement& from, const Placement& to, double reach_m) noexcept {
    const Rotation &a = from.rotation, &b = to.rotation;
    const double sign = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z < 0.0 ? -1.0 : 1.0;
    const double dw = a.w - sign * b.w, dx = a.x - sign * b.x, dy = a.y - sign * b.y, dz = a.z - sign * b.z;
    // Two unit quaternions whose rotations differ by an angle are 2 sin(angle / 4) apart. So the angle is at most pi
    // times that distance.
    const double turn = std::sqrt(dw * dw + dx * dx + dy * dy + dz * dz) * kPi;
    const double scale = std::max(from.scale, to.scale);
    return glm::length(to.position_m - from.position_m) + (turn * scale + std::abs(to.scale - from.scale)) * reach_m;
}

}  // namespace handrail
