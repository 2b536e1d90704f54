// A soup of triangles from a file becomes what a hand should meet: points that are one are made one, what has no area
// and lies on its neighbours goes, flat patches become convex polygons, and on request tessellated curves become
// coarser within a stated error. What was done is counted. Pure functions, worker thread; 2 to 4 us per triangle
// without simplification.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "haptic/compile/merge_flat.h"
#include "worlds/geometry/triangle_mesh.h"

namespace handrail {

struct MeshOptions {
    double weld_m = 0.0;  // points at most this far apart become the first of them; 0: only identical points. Above a
                          // millimetre thin things close up
    bool tidy = true;     // drop triangles that only repeat what their neighbours are
    bool merge = true;    // flat patches to convex polygons
    // How far a corner may lie from its polygon's plane: the noise of coordinates written with 5 or 6 digits. Above
    // 1e-4 m facets of tessellated curves become larger, and their edges are felt.
    double flat_m = 1e-5;
    bool keep_curves = true;  // facets that shading rounds stay triangles
    double simplify_m = 0.0;  // largest distance between the mesh as it was and a coarser one; 0: as fine as it is
};

// What `touch` uses: nothing moves by more than rounding.
inline constexpr MeshOptions kExactMesh{
    .weld_m = 0.0, .tidy = false, .merge = true, .flat_m = 1e-9, .keep_curves = false, .simplify_m = 0.0};

struct MeshReport {
    std::size_t triangles = 0;      // before
    std::size_t points_welded = 0;  // that became another one
    double farthest_weld_m = 0.0;
    std::size_t without_area = 0;  // dropped: their neighbours cover them
    std::size_t repeated = 0;      // dropped: the same corners and surface as another
    std::size_t simplified = 0;    // fewer triangles by simplification
    double simplify_bound_m = 0.0;
    double simplify_measured_m = 0.0;  // Hausdorff distance, both ways, at samples
    double simplify_spacing_m = 0.0;   // of the samples: the true distance is at most this much / sqrt(3) greater
    std::size_t merged = 0;            // triangles that became polygons
    std::size_t polygons = 0;
    double flat_bound_m = 0.0, flat_measured_m = 0.0;

    MeshReport& operator+=(const MeshReport& other);
    // Sentences for the honesty report, with the bounds; none when nothing was done.
    std::vector<std::string> sentences() const;
};

struct PreparedMesh {
    TriangleMesh mesh;                    // the triangles that stay triangles
    std::vector<std::uint32_t> surfaces;  // of them
    std::vector<FlatPolygon> polygons;    // `triangles` is empty here
    std::vector<std::uint32_t> polygon_surfaces;
    MeshReport report;
};

// corners: three for each triangle. surfaces: one number for each; only what has the same is joined, and no border
// between different ones moves.
PreparedMesh prepare_mesh(std::span<const Vec3> corners_m, std::span<const std::uint32_t> surfaces,
                          const MeshOptions& options);

// Points at most tolerance_m apart become one, the first of them (0: identical ones; -0 is 0). Triangles keep their
// order.
TriangleMesh weld_corners(std::span<const Vec3> corners_m, double tolerance_m, MeshReport& report);

}  // namespace handrail
