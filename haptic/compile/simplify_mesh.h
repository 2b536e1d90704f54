// A coarser mesh within a stated distance of a given one, by collapsing edges, and the distance measured. Pure
// functions, worker thread; 0.1 to 1 ms per triangle. The half-edge library is known to the source file alone. Source:
// Garland & Heckbert, Surface simplification using quadric error metrics, SIGGRAPH 1997 (order of the collapses);
// Klein, Liebich & Strasser, Mesh reduction with error control, Visualization 1996 (the distance that forbids one).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail {

struct SimplifiedMesh {
    TriangleMesh mesh;
    std::vector<std::uint32_t> surfaces;
    double measured_m = 0.0;  // the greater of both directions; at most the bound
    double spacing_m = 0.0;   // between samples
};

// Borders between surfaces and every point of a triangle that does not fit a half-edge structure (more than two at an
// edge, fans that only touch) stay. Where the measured distance is above the bound after all, it is tried again with a
// smaller one; at worst the mesh comes back as it was.
SimplifiedMesh simplify_mesh(const TriangleMesh& mesh, std::span<const std::uint32_t> surfaces, double bound_m);

// The farthest that a point of a lies from b, taken at a's corners and at samples no farther than spacing_m apart. The
// true value is at most spacing_m / sqrt(3) greater.
double measured_distance(const TriangleMesh& a, const TriangleMesh& b, double spacing_m);

}  // namespace handrail
