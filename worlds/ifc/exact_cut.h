// Cuts closed solids of any shape with each other. The reader uses this where convex solids do not suffice. It calls
// the mesh booleans of CGAL (corefinement) with exact numbers. Results are rounded to double only once, so they are
// bit-identical whichever compiler built the program. Pure functions, used on the reading thread. Source: Loriot,
// Rouxel-Labbé, Tournois and Yaz, Polygon Mesh Processing, CGAL 5.5.
#pragma once

#include <stop_token>

#include "worlds/ifc/body.h"

namespace handrail::ifc {

enum class ExactCut : std::uint8_t { TakeAway, KeepWithin };

// Limits on the cost of all exact cuts of one file together. The limits count steps and not time, so that one file
// always gives the same building. A step takes about 5 us. The number of triangles limits the memory.
struct ExactLimits {
    std::size_t most_triangles = 20'000;  // greatest number of triangles of one solid
    // Budget of steps. A step is a pair of nearby triangles, or a point where two triangles intersect.
    std::size_t steps_left = 1'000'000;
    std::size_t looks_left = 100'000'000;  // budget for dividing the results into convex solids (see closed_mesh.h)
};

// Subtracts `by` from `body`, or keeps only the part of `body` within `by`, as `cut` says. The sheets of each body must
// together form closed skins. Corners are first moved to a grid of about a micrometre. The result is convex solids, or
// a closed skin of triangles if dividing it would cost too much. Returns nothing if a skin is open or intersects
// itself, or if a limit is reached.
std::optional<Body> cut_exactly(const Body& body, const Body& by, ExactCut cut, ExactLimits& limits,
                                const std::stop_token& stop);

}  // namespace handrail::ifc
