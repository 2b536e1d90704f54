#include "worlds/geometry/mass_properties.h"

#include <cmath>

#include "worlds/base/overloaded.h"

namespace handrail {
namespace {

Spread outer(const Vec3& v) noexcept { return {v * v.x, v * v.y, v * v.z}; }

void add(Spread& to, const Spread& what, double times) noexcept {
    for (std::size_t i = 0; i < 3; ++i) to[i] += what[i] * times;
}

// Returns the mass properties of a solid of revolution from its spread along the axis and perpendicular to it.
MassProperties of_axis(double volume_m3, const Vec3& middle_m, const Vec3& axis, double along_m5,
                       double across_m5) noexcept {
    MassProperties out{volume_m3, middle_m, {Vec3(across_m5, 0, 0), Vec3(0, across_m5, 0), Vec3(0, 0, across_m5)}};
    add(out.spread_m5, outer(axis), along_m5 - across_m5);
    return out;
}

}  // namespace

MassProperties mass_properties(const ConvexSolid& solid) noexcept {
    if (solid.faces.empty() || solid.bounds_m.empty()) return {};
    const Vec3 zero = solid.bounds_m.centre_m();
    double six_volume = 0.0;
    Vec3 first(0.0);
    Spread second{Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    for (const Polygon& face : solid.faces)
        for (std::size_t i = 2; i < face.points_m.size(); ++i) {
            const Vec3 a = face.points_m[0] - zero, b = face.points_m[i - 1] - zero, c = face.points_m[i] - zero;
            // Six times the volume of the tetrahedron whose fourth corner is the origin.
            const double six = glm::dot(a, glm::cross(b, c));
            const Vec3 sum = a + b + c;
            six_volume += six;
            first += sum * (six / 24.0);
            for (const Vec3& v : {a, b, c, sum}) add(second, outer(v), six / 120.0);
        }
    const Vec3 size = solid.bounds_m.size_m();
    if (!(six_volume > 1e-12 * size.x * size.y * size.z)) return {};
    MassProperties out{six_volume / 6.0, zero + first * (6.0 / six_volume), second};
    add(out.spread_m5, outer(out.middle_m - zero), -out.volume_m3);
    return out;
}

MassProperties mass_properties(const RoundShape& shape) noexcept {
    return std::visit(Overloaded{[](std::monostate) { return MassProperties{}; },
                                 [](const SphereShape& s) {
                                     const double r2 = s.radius_m * s.radius_m, v = 4.0 / 3.0 * kPi * r2 * s.radius_m;
                                     return of_axis(v, s.centre_m, Vec3(0, 0, 1), v * r2 / 5.0, v * r2 / 5.0);
                                 },
                                 [](const CapsuleShape& s) {
                                     const double r2 = s.radius_m * s.radius_m, rod = kPi * r2 * s.length_m,
                                                  cap = 2.0 / 3.0 * kPi * r2 * s.radius_m;
                                     // The centre of mass of a round end is `out` away from the flat side of that end
                                     // and `far` away from the middle of the capsule.
                                     const double out = 0.375 * s.radius_m, far = 0.5 * s.length_m + out;
                                     const double along = rod * s.length_m * s.length_m / 12.0 +
                                                          2.0 * cap * (r2 / 5.0 - out * out + far * far);
                                     return of_axis(rod + 2.0 * cap, s.start_m + s.axis * (0.5 * s.length_m), s.axis,
                                                    along, rod * r2 / 4.0 + 2.0 * cap * r2 / 5.0);
                                 },
                                 [](const CylinderShape& s) {
                                     const double r2 = s.radius_m * s.radius_m, v = kPi * r2 * s.height_m;
                                     return of_axis(v, s.bottom_m + s.axis * (0.5 * s.height_m), s.axis,
                                                    v * s.height_m * s.height_m / 12.0, v * r2 / 4.0);
                                 },
                                 [](const ConeShape& s) {
                                     const double r2 = s.radius_m * s.radius_m, v = kPi * r2 * s.height_m / 3.0;
                                     return of_axis(v, s.base_m + s.axis * (0.25 * s.height_m), s.axis,
                                                    v * 3.0 * s.height_m * s.height_m / 80.0, v * 3.0 * r2 / 20.0);
                                 }},
                      shape);
}

MassProperties together(const MassProperties& a, const MassProperties& b) noexcept {
    MassProperties out;
    out.volume_m3 = a.volume_m3 + b.volume_m3;
    if (!(out.volume_m3 > 0.0)) return {};
    out.middle_m = a.middle_m + (b.middle_m - a.middle_m) * (b.volume_m3 / out.volume_m3);
    for (const MassProperties* part : {&a, &b}) {
        add(out.spread_m5, part->spread_m5, 1.0);
        add(out.spread_m5, outer(part->middle_m - out.middle_m), part->volume_m3);
    }
    return out;
}

Rotation rotation_of(const std::array<Vec3, 3>& m) noexcept {
    // Divides by the largest component of the quaternion (Shepperd, 1978).
    const double w = m[0].x + m[1].y + m[2].z, x = m[0].x - m[1].y - m[2].z, y = m[1].y - m[0].x - m[2].z,
                 z = m[2].z - m[0].x - m[1].y;
    if (w >= x && w >= y && w >= z) return normalized({1.0 + w, m[1].z - m[2].y, m[2].x - m[0].z, m[0].y - m[1].x});
    if (x >= y && x >= z) return normalized({m[1].z - m[2].y, 1.0 + x, m[0].y + m[1].x, m[2].x + m[0].z});
    if (y >= z) return normalized({m[2].x - m[0].z, m[0].y + m[1].x, 1.0 + y, m[1].z + m[2].y});
    return normalized({m[0].y - m[1].x, m[2].x + m[0].z, m[1].z + m[2].y, 1.0 + z});
}

PrincipalAxes principal_axes(const Spread& spread_m5) noexcept {
    double a[3][3];
    std::array<Vec3, 3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) a[i][k] = spread_m5[static_cast<std::size_t>(i)][k];
    const double small = 1e-13 * (a[0][0] + a[1][1] + a[2][2]);
    for (int round = 0; round < 32; ++round) {
        int p = 0, q = 1;
        if (std::abs(a[0][2]) > std::abs(a[p][q])) q = 2;
        if (std::abs(a[1][2]) > std::abs(a[p][q])) p = 1, q = 2;
        if (!(std::abs(a[p][q]) > small)) break;
        const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
        const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0)),
                     c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (int k = 0; k < 3; ++k) {
            const double kp = a[k][p], kq = a[k][q];
            a[k][p] = c * kp - s * kq;
            a[k][q] = s * kp + c * kq;
        }
        for (int k = 0; k < 3; ++k) {
            const double pk = a[p][k], qk = a[q][k];
            a[p][k] = c * pk - s * qk;
            a[q][k] = s * pk + c * qk;
        }
        Vec3 &ap = axes[static_cast<std::size_t>(p)], &aq = axes[static_cast<std::size_t>(q)];
        const Vec3 was = ap;
        ap = was * c - aq * s;
        aq = was * s + aq * c;
    }
    return {rotation_of(axes), Vec3(a[1][1] + a[2][2], a[0][0] + a[2][2], a[0][0] + a[1][1])};
}

}  // namespace handrail
