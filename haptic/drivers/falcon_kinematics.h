// Geometry of the Novint Falcon: three legs, each with one driven thigh, hold a grip that never turns. Pure functions,
// any thread. Falcon axes: x right, y up, z out of the device towards the person; metres from the middle of its base.
// Legs and their angles, encoders and motors are numbered 0 to 2 and stored as Vec3 or array. About 0.5 us each.
// Sources: leg measures after R. E. Stamper, A three degree of freedom parallel manipulator with only translational
// degrees of freedom, thesis, 1997; the equations are solved here from the closure of each leg.
#pragma once

#include <array>
#include <optional>

#include "worlds/base/vec.h"

namespace handrail::drivers {

// The middle of the workspace for the driver: z reaches from about 0.085 to 0.165.
inline constexpr Vec3 kFalconMiddleM{0.0, 0.0, 0.125};

// Convert to the device frame of HapticDevice (x right, y forward, z up, from the middle) and back. The versions with
// `turn_` convert directions.
inline Vec3 falcon_to_device(const Vec3& falcon_m) noexcept {
    return {falcon_m.x, kFalconMiddleM.z - falcon_m.z, falcon_m.y};
}
inline Vec3 turn_device_to_falcon(const Vec3& device) noexcept { return {device.x, device.z, -device.y}; }

// 1280 counts per turn of the motor, geared by 14.25 / 110; count 0 of a homed leg is 35 degrees.
double falcon_leg_angle_rad(int encoder_counts) noexcept;
int falcon_encoder_counts(double leg_angle_rad) noexcept;  // rounded to the nearest count

// Thigh angles that hold the grip at a point; nothing if a leg cannot reach it.
std::optional<Vec3> falcon_inverse(const Vec3& grip_m) noexcept;

// The grip's position for three thigh angles, by Newton steps from `near_m` (the last position), else from the middle.
// Nothing if the legs cannot meet, or only in a way in which the real legs are not built.
std::optional<Vec3> falcon_forward(const Vec3& leg_angles_rad, const Vec3& near_m) noexcept;

// Row i: the derivative of leg angle i by the grip's position, rad/m. `leg_angles_rad` must belong to `grip_m`. Nothing
// at the edge of the workspace.
std::optional<std::array<Vec3, 3>> falcon_jacobian(const Vec3& grip_m, const Vec3& leg_angles_rad) noexcept;

// Torques of the thighs in Nm that give this force on the grip: J^T torque = force, by the principle of virtual work.
std::optional<Vec3> falcon_torques(const Vec3& grip_m, const Vec3& leg_angles_rad, const Vec3& force_n) noexcept;

}  // namespace handrail::drivers
