// Simplifies a mesh by collapsing edges, within a stated distance of the original, and measures the distance. Pure
// functions, background thread; 0.1 to 1 ms per triangle. Only the source file knows the half-edge library. Source:
// Garland & Heckbert, Surface simplification using quadric error metrics, SIGGRAPH 1997 (order of the collapses);
// Klein, Liebich & Strasser, Mesh reduction with error control, Visualization 1996 (the distance at which a collapse is
// refused).
#pragma once

#include <stop_token>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail::compile {

struct SimplifiedMesh {
    TriangleMesh mesh;        // with the points of the given one; some are not used any more
    double measured_m = 0.0;  // the greater of both directions; at most the bound
    double spacing_m = 0.0;   // between samples
};

// fixed: points that stay, one flag for each point; empty: none. Every point of a triangle that does not fit a
// half-edge structure (more than two at an edge, fans that only touch) stays, too. If the measured distance is above
// the bound after all, a smaller one is tried; at worst the mesh comes back as it was. So it does soon after a stop
// request.
SimplifiedMesh simplify_mesh(const TriangleMesh& mesh, const std::vector<bool>& fixed, double bound_m,
                             const std::stop_token& stop = {});

// The farthest that a point of a lies from b, taken at a's corners and at samples no farther than spacing_m apart. The
// true value is at most spacing_m / sqrt(3) greater. After a stop request the value means nothing.
double measured_distance(const TriangleMesh& a, const TriangleMesh& b, double spacing_m,
                         const std::stop_token& stop = {});

}  // namespace handrail::compile
