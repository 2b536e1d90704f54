// Cuts between solids of any closed shape, used where convex solids do not suffice: mesh booleans of CGAL
// (corefinement) with exact numbers. Results are rounded to double once, so they are bit-identical whichever compiler
// built the program. Pure functions; one reading thread. Source: Loriot, Rouxel-Labbé, Tournois and Yaz, Polygon Mesh
// Processing, CGAL 5.5.
#pragma once

#include <stop_token>

#include "worlds/ifc/body.h"

namespace handrail::ifc {

enum class ExactCut : std::uint8_t { TakeAway, KeepWithin };

// What all exact cuts of one file may cost together. Steps are counted rather than timed, so that one file always gives
// the same building. A step takes about 5 us. The number of triangles bounds the memory.
struct ExactLimits {
    std::size_t most_triangles = 20'000;   // for one solid
    std::size_t steps_left = 1'000'000;    // pairs of nearby triangles, and points where they meet
    std::size_t looks_left = 100'000'000;  // for dividing the results into convex solids, see closed_mesh.h
};

// The sheets of each body must together be closed skins. Corners are first moved to a grid of about a micrometre. The
// result is convex solids, or a closed skin of triangles if dividing it takes too long. Returns nothing if a skin is
// open or intersects itself, or if the limits are reached.
std::optional<Body> cut_exactly(const Body& body, const Body& by, ExactCut cut, ExactLimits& limits,
                                const std::stop_token& stop);

}  // namespace handrail::ifc
