// Simplifies a mesh by collapsing edges, within a stated distance of the original, and measures that distance. Pure
// functions, background thread; 0.1 to 1 ms per triangle. Only simplify_mesh.cpp includes OpenMesh. Sources: Garland &
// Heckbert, Surface simplification using quadric error metrics, SIGGRAPH 1997 (order of the collapses); Klein, Liebich
// & Strasser, Mesh reduction with error control, Visualization 1996 (distance at which a collapse is refused).
#pragma once

#include <stop_token>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail::compile {

struct SimplifiedMesh {
    TriangleMesh mesh;        // has the points of the given mesh, some of which no triangle uses
    double measured_m = 0.0;  // Hausdorff distance: the greater of both directions; at most the bound
    double spacing_m = 0.0;   // distance between the samples of the measurement
};

// Simplifies a mesh. `fixed` has one flag for each point that must stay; empty: none. Points of triangles that do not
// fit a half-edge structure stay, too: more than two triangles at an edge, or fans that only touch. If the measured
// distance still exceeds `bound_m`, the function tries again with a smaller bound. If all attempts fail, it returns the
// mesh unchanged. It also returns the mesh unchanged soon after a stop request.
SimplifiedMesh simplify_mesh(const TriangleMesh& mesh, const std::vector<bool>& fixed, double bound_m,
                             const std::stop_token& stop = {});

// Returns the greatest distance of a point of `a` from `b`. It is measured at the corners of `a` and at samples at most
// `spacing_m` apart. The true value is at most spacing_m / sqrt(3) greater. After a stop request the result is
// meaningless.
double measured_distance(const TriangleMesh& a, const TriangleMesh& b, double spacing_m,
                         const std::stop_token& stop = {});

}  // namespace handrail::compile
