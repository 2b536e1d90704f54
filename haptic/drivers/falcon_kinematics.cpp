#include "haptic/drivers/falcon_kinematics.h"

#include <cmath>

namespace handrail::drivers {
namespace {

constexpr double kThighM = 0.060;
constexpr double kRodM = 0.1025;     // length of the rods of the parallelogram
constexpr double kJointsM = 0.0225;  // sum of both joint offsets of the rod
constexpr double kGripOutM = 0.01443, kGripAsideM = -0.025;
constexpr double kShoulderOutM = 0.0400, kShoulderAsideM = -0.02309;
constexpr double kRadPerCount = (0.01425 / 0.110) * 2.0 * kPi / 1280.0;
constexpr double kRadAtZero = 35.0 * kPi / 180.0;
constexpr int kMostSteps = 20;
constexpr double kConvergedM2 = 1e-20;
constexpr double kSameAngleRad = 1e-6;

struct LegPlane {
    double cosine, sine;
};
// The planes of the legs are at 105, -15 and -135 degrees around z.
const std::array<LegPlane, 3> kLegs{LegPlane{std::cos(105.0 * kPi / 180.0), std::sin(105.0 * kPi / 180.0)},
                                    LegPlane{std::cos(-15.0 * kPi / 180.0), std::sin(-15.0 * kPi / 180.0)},
                                    LegPlane{std::cos(-135.0 * kPi / 180.0), std::sin(-135.0 * kPi / 180.0)}};

// Position of the grip relative to one leg's shoulder: u outwards, v sideways, w along z. `reach` is the distance from
// knee to grip in the leg's plane.
struct SeenByLeg {
    double u, v, w;
    double rod_in_plane;
    double reach;
};

std::optional<SeenByLeg> seen_by_leg(const Vec3& p, const LegPlane& leg) noexcept {
    SeenByLeg seen{};
    seen.u = p.x * leg.cosine + p.y * leg.sine - kShoulderOutM + kGripOutM;
    seen.v = -p.x * leg.sine + p.y * leg.cosine - kShoulderAsideM + kGripAsideM;
    seen.w = p.z;
    const double square = kRodM * kRodM - seen.v * seen.v;
    if (!(square > 1e-12)) return std::nullopt;
    seen.rod_in_plane = std::sqrt(square);
    seen.reach = kJointsM + seen.rod_in_plane;
    return seen;
}

// Closure error of a leg, |grip - knee|^2 - reach^2, with its derivatives with respect to the grip's position and the
// leg's angle.
struct Closure {
    double value;
    Vec3 by_place;
    double by_angle;
};

Closure closure(const SeenByLeg& seen, const LegPlane& leg, double angle) noexcept {
    const double knee_u = kThighM * std::cos(angle), knee_w = kThighM * std::sin(angle);
    const double du = seen.u - knee_u, dw = seen.w - knee_w;
    const double by_u = 2.0 * du, by_v = 2.0 * seen.reach * seen.v / seen.rod_in_plane, by_w = 2.0 * dw;
    return {du * du + dw * dw - seen.reach * seen.reach,
            {by_u * leg.cosine - by_v * leg.sine, by_u * leg.sine + by_v * leg.cosine, by_w},
            2.0 * (du * knee_w - dw * knee_u)};
}

std::optional<Vec3> newton(const Vec3& angles, Vec3 p) noexcept {
    for (int step = 0; step < kMostSteps; ++step) {
        std::array<Closure, 3> legs;
        for (int i = 0; i < 3; ++i) {
            const auto seen = seen_by_leg(p, kLegs[static_cast<std::size_t>(i)]);
            if (!seen) return std::nullopt;
            legs[static_cast<std::size_t>(i)] = closure(*seen, kLegs[static_cast<std::size_t>(i)], angles[i]);
        }
        const Vec3 c0 = glm::cross(legs[1].by_place, legs[2].by_place);
        const double volume = glm::dot(legs[0].by_place, c0);
        if (!(std::abs(volume) > 1e-12)) return std::nullopt;
        const Vec3 c1 = glm::cross(legs[2].by_place, legs[0].by_place),
                   c2 = glm::cross(legs[0].by_place, legs[1].by_place);
        const Vec3 by = -(c0 * legs[0].value + c1 * legs[1].value + c2 * legs[2].value) / volume;
        p += by;
        if (!is_finite(p)) return std::nullopt;
        if (glm::dot(by, by) < kConvergedM2) return p;
    }
    return std::nullopt;
}

// Returns true if the legs are folded as on the real device. Newton's method may find the mirrored solution, but
// falcon_inverse() returns only the real one, so the two are compared.
bool is_built_so(const Vec3& p, const Vec3& angles) noexcept {
    const auto back = falcon_inverse(p);
    return back && p.z > 0.0 && std::abs(back->x - angles.x) < kSameAngleRad &&
           std::abs(back->y - angles.y) < kSameAngleRad && std::abs(back->z - angles.z) < kSameAngleRad;
}

}  // namespace

double falcon_leg_angle_rad(int encoder_counts) noexcept { return kRadAtZero + encoder_counts * kRadPerCount; }

int falcon_encoder_counts(double leg_angle_rad) noexcept {
    return static_cast<int>(std::lround((leg_angle_rad - kRadAtZero) / kRadPerCount));
}

std::optional<Vec3> falcon_inverse(const Vec3& grip_m) noexcept {
    Vec3 angles{0.0};
    for (int i = 0; i < 3; ++i) {
        const auto seen = seen_by_leg(grip_m, kLegs[static_cast<std::size_t>(i)]);
        if (!seen) return std::nullopt;
        const double square = seen->u * seen->u + seen->w * seen->w;
        const double cosine =
            (square + kThighM * kThighM - seen->reach * seen->reach) / (2.0 * kThighM * std::sqrt(square));
        if (!(std::abs(cosine) <= 1.0)) return std::nullopt;
        angles[i] = std::atan2(seen->w, seen->u) - std::acos(cosine);
    }
    return angles;
}

std::optional<Vec3> falcon_forward(const Vec3& leg_angles_rad, const Vec3& near_m) noexcept {
    if (is_finite(near_m))
        if (const auto found = newton(leg_angles_rad, near_m); found && is_built_so(*found, leg_angles_rad))
            return found;
    if (const auto found = newton(leg_angles_rad, {0.0, 0.0, 0.12}); found && is_built_so(*found, leg_angles_rad))
        return found;
    return std::nullopt;
}

std::optional<std::array<Vec3, 3>> falcon_jacobian(const Vec3& grip_m, const Vec3& leg_angles_rad) noexcept {
    std::array<Vec3, 3> rows;
    for (int i = 0; i < 3; ++i) {
        const LegPlane& leg = kLegs[static_cast<std::size_t>(i)];
        const auto seen = seen_by_leg(grip_m, leg);
        if (!seen) return std::nullopt;
        const Closure here = closure(*seen, leg, leg_angles_rad[i]);
        if (!(std::abs(here.by_angle) > 1e-9)) return std::nullopt;
        rows[static_cast<std::size_t>(i)] = -here.by_place / here.by_angle;
    }
    return rows;
}

std::optional<Vec3> falcon_torques(const Vec3& grip_m, const Vec3& leg_angles_rad, const Vec3& force_n) noexcept {
    const auto rows = falcon_jacobian(grip_m, leg_angles_rad);
    if (!rows) return std::nullopt;
    const auto& [a, b, c] = *rows;
    const double volume = glm::dot(a, glm::cross(b, c));
    if (!(std::abs(volume) > 1e-9)) return std::nullopt;
    return Vec3{glm::dot(force_n, glm::cross(b, c)), glm::dot(force_n, glm::cross(c, a)),
                glm::dot(force_n, glm::cross(a, b))} /
           volume;
}

}  // namespace handrail::drivers
