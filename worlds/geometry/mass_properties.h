// Computes the volume of a solid and the distribution of that volume, from which a body's inertia follows. Pure
// functions; any thread may call them. They use only + - x / and square root. Sums are computed about a point of the
// solid, so the solid may be far from the origin. Source: Mirtich, Fast and accurate computation of polyhedral mass
// properties, 1996 (here by tetrahedra, exact for flat faces). Round solids use closed formulas. There is a brute-force
// counterpart in tests/unit/geometry_touch.
#pragma once

#include <array>

#include "worlds/geometry/convex.h"
#include "worlds/geometry/placement.h"
#include "worlds/geometry/round_shapes.h"

namespace handrail {

// A symmetric matrix, stored by rows.
using Spread = std::array<Vec3, 3>;

struct MassProperties {
    double volume_m3 = 0.0;
    Vec3 middle_m{0.0};                                 // centre of mass at uniform density
    Spread spread_m5{Vec3(0.0), Vec3(0.0), Vec3(0.0)};  // integral of (p - middle_m)(p - middle_m)^T over the volume
};

// Returns zero volume for a degenerate or empty solid.
MassProperties mass_properties(const ConvexSolid& solid) noexcept;
// Returns zero volume for std::monostate.
MassProperties mass_properties(const RoundShape& shape) noexcept;
// Returns the mass properties of both solids together. If the solids overlap, the overlap counts twice.
MassProperties together(const MassProperties& a, const MassProperties& b) noexcept;

struct PrincipalAxes {
    Rotation rotation;     // rotation from the principal frame to the frame of the solid
    Vec3 inertia_m5{0.0};  // moment of inertia about each axis of the principal frame, for a density of 1
};
// Finds the principal axes by Jacobi's method (1846). Axes of the solid's frame that are principal already are kept.
PrincipalAxes principal_axes(const Spread& spread_m5) noexcept;

// Returns the rotation whose matrix has these columns. They must be unit vectors, perpendicular to each other and
// right-handed.
Rotation rotation_of(const std::array<Vec3, 3>& columns) noexcept;

}  // namespace handrail
