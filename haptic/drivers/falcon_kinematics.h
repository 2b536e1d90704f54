// Computes the geometry of the Novint Falcon, in which three legs with one driven thigh each carry a grip that never
// turns. Pure functions, any thread. Falcon axes: x right, y up, z out of the device towards the person; metres from
// the middle of its base. Legs and their angles, encoders and motors are numbered 0 to 2 and stored as Vec3 or array.
// Each function takes about 0.5 us. Sources: leg measures after R. E. Stamper, A three degree of freedom parallel
// manipulator with only translational degrees of freedom, thesis, 1997; the equations here are derived from the closure
// of each leg.
#pragma once

#include <array>
#include <optional>

#include "worlds/base/vec.h"

namespace handrail::drivers {

// Position that the driver uses as the middle of the workspace. The grip's z ranges from about 0.085 to 0.165.
inline constexpr Vec3 kFalconMiddleM{0.0, 0.0, 0.125};

// Convert positions to the device frame of HapticDevice (x right, y forward, z up, from the middle) and back. The
// versions with `turn_` convert directions.
inline Vec3 falcon_to_device(const Vec3& falcon_m) noexcept {
    return {falcon_m.x, kFalconMiddleM.z - falcon_m.z, falcon_m.y};
}
inline Vec3 turn_device_to_falcon(const Vec3& device) noexcept { return {device.x, device.z, -device.y}; }

// The encoder has 1280 counts per turn of the motor, and the gear ratio is 14.25 / 110. A homed leg with count 0 is at
// 35 degrees.
double falcon_leg_angle_rad(int encoder_counts) noexcept;
int falcon_encoder_counts(double leg_angle_rad) noexcept;  // rounds to the nearest count

// Returns the thigh angles for a position of the grip, or nothing if a leg cannot reach it.
std::optional<Vec3> falcon_inverse(const Vec3& grip_m) noexcept;

// Returns the grip's position for three thigh angles. Newton's method starts at `near_m` (the last position), then, if
// that fails, at the middle. Returns nothing if the legs cannot meet, or can meet only with a leg folded the wrong way.
std::optional<Vec3> falcon_forward(const Vec3& leg_angles_rad, const Vec3& near_m) noexcept;

// Returns the derivatives of the leg angles: row i is that of angle i with respect to the grip's position, in rad/m.
// `leg_angles_rad` must belong to `grip_m`. Returns nothing at the edge of the workspace.
std::optional<std::array<Vec3, 3>> falcon_jacobian(const Vec3& grip_m, const Vec3& leg_angles_rad) noexcept;

// Returns the torques of the thighs in Nm that give this force at the grip: J^T torque = force, by the principle of
// virtual work.
std::optional<Vec3> falcon_torques(const Vec3& grip_m, const Vec3& leg_angles_rad, const Vec3& force_n) noexcept;

}  // namespace handrail::drivers
