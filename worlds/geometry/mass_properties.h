// How much a solid holds and how it is spread: what a body's inertia follows from. Pure functions, any thread, + - x /
// and square root only; sums are taken about a point of the solid, so it may lie far from zero. Source: Mirtich, Fast
// and accurate computation of polyhedral mass properties, 1996 (here by tetrahedra, exact for flat faces); round solids
// in closed form. Brute-force twin in tests/unit/geometry_touch.
#pragma once

#include <array>

#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"
#include "worlds/geometry/round_shapes.h"

namespace handrail {

// Symmetric: rows of a matrix.
using Spread = std::array<Vec3, 3>;

struct MassProperties {
    double volume_m3 = 0.0;
    Vec3 middle_m{0.0};                                 // of mass, where it is spread evenly
    Spread spread_m5{Vec3(0.0), Vec3(0.0), Vec3(0.0)};  // integral of (p - middle)(p - middle)^T over the volume
};

// Zero volume for what is flat or empty.
MassProperties mass_properties(const ConvexSolid& solid) noexcept;
// Zero volume for std::monostate.
MassProperties mass_properties(const RoundShape& shape) noexcept;
// Both together; they may overlap, and then count twice.
MassProperties together(const MassProperties& a, const MassProperties& b) noexcept;

struct PrincipalAxes {
    Rotation rotation;     // from the principal frame to the frame of the solid
    Vec3 inertia_m5{0.0};  // about each of its axes, for a density of 1
};
// Axes that are principal already stay as they are. Jacobi's method, 1846.
PrincipalAxes principal_axes(const Spread& spread_m5) noexcept;

// The rotation whose columns these three unit vectors, square to each other and right-handed, are.
Rotation rotation_of(const std::array<Vec3, 3>& columns) noexcept;

}  // namespace handrail
