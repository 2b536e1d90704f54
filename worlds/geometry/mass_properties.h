// The volume of a solid and how it is distributed, from which a body's inertia follows. Pure functions, any thread;
// they use only + - x / and square root. Sums are taken about a point of the solid, so the solid may be far from zero.
// Source: Mirtich, Fast and accurate computation of polyhedral mass properties, 1996 (here by tetrahedra, exact for
// flat faces); round solids in closed form. Brute-force counterpart in tests/unit/geometry_touch.
#pragma once

#include <array>

#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"
#include "worlds/geometry/round_shapes.h"

namespace handrail {

// A symmetric matrix by rows.
using Spread = std::array<Vec3, 3>;

struct MassProperties {
    double volume_m3 = 0.0;
    Vec3 middle_m{0.0};                                 // centre of mass at uniform density
    Spread spread_m5{Vec3(0.0), Vec3(0.0), Vec3(0.0)};  // integral of (p - middle)(p - middle)^T over the volume
};

// The volume is zero for flat or empty solids.
MassProperties mass_properties(const ConvexSolid& solid) noexcept;
// The volume is zero for std::monostate.
MassProperties mass_properties(const RoundShape& shape) noexcept;
// The sum of both. If they overlap, the overlap counts twice.
MassProperties together(const MassProperties& a, const MassProperties& b) noexcept;

struct PrincipalAxes {
    Rotation rotation;     // from the principal frame to the frame of the solid
    Vec3 inertia_m5{0.0};  // about each of its axes, for a density of 1
};
// Axes that are principal already are kept. Jacobi's method, 1846.
PrincipalAxes principal_axes(const Spread& spread_m5) noexcept;

// The rotation with these three columns: unit vectors, perpendicular to each other and right-handed.
Rotation rotation_of(const std::array<Vec3, 3>& columns) noexcept;

}  // namespace handrail
