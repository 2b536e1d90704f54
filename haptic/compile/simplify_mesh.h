// Simplifies a mesh by collapsing edges, within a stated distance of the original, and measures the distance. Pure
// functions, background thread; 0.1 to 1 ms per triangle. Only the source file knows the half-edge library. Source:
// Garland & Heckbert, Surface simplification using quadric error metrics, SIGGRAPH 1997 (order of the collapses);
// Klein, Liebich & Strasser, Mesh reduction with error control, Visualization 1996 (the distance at which a collapse is
// refused).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail {

struct SimplifiedMesh {
    TriangleMesh mesh;
    std::vector<std::uint32_t> surfaces;
    double measured_m = 0.0;  // the greater one of both directions; at most the bound
    double spacing_m = 0.0;   // distance between samples
};

// Borders between surfaces stay. So does every point of a triangle that does not fit a half-edge structure (more than
// two at an edge, fans that only touch). If the measured distance exceeds the bound after all, it tries again with a
// smaller one; at worst the mesh is returned unchanged.
SimplifiedMesh simplify_mesh(const TriangleMesh& mesh, std::span<const std::uint32_t> surfaces, double bound_m);

// The greatest distance from a point of a to b, taken at a's corners and at samples at most spacing_m apart. The true
// value is at most spacing_m / sqrt(3) greater.
double measured_distance(const TriangleMesh& a, const TriangleMesh& b, double spacing_m);

}  // namespace handrail
