// A soup of triangles from a file becomes what a hand should meet: points that are one are made one, what has no area
// and lies on its neighbours goes, flat patches become convex polygons, and on request dense surfaces become coarser
// within a stated error. What was done is counted. Pure functions, worker thread; 2 to 4 us per triangle without
// simplification, which costs 0.1 to 1 ms per triangle.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "haptic/compile/merge_flat.h"
#include "worlds/geometry/triangle_mesh.h"

namespace handrail::compile {

struct MeshOptions {
    // Points at most this far apart are merged into the first of them; 0: only identical points. Above a millimetre,
    // thin objects close up.
    double weld_m = 0.0;
    bool tidy = true;   // drop triangles that only repeat their neighbours
    bool merge = true;  // merge flat patches into convex polygons
    // How far a corner may be from its polygon's plane. The default covers the noise of coordinates written with 5 or 6
    // digits. Above 1e-4 m, facets of tessellated curves become larger, and their edges are felt.
    double flat_m = 1e-5;
    bool keep_curves = true;  // facets that shading rounds stay triangles
    double simplify_m = 0.0;  // largest distance between a surface as it was and a coarser one; 0: as fine as it is
    std::size_t simplify_from = 0;  // triangles; surfaces with fewer stay as fine as they are
};

// What `touch` uses: nothing moves by more than rounding.
inline constexpr MeshOptions kExactMesh{.weld_m = 0.0,
                                        .tidy = false,
                                        .merge = true,
                                        .flat_m = 1e-9,
                                        .keep_curves = false,
                                        .simplify_m = 0.0,
                                        .simplify_from = 0};

struct MeshReport {
    std::size_t triangles = 0;      // number before processing
    std::size_t points_welded = 0;  // points merged into another one
    double farthest_weld_m = 0.0;
    std::size_t without_area = 0;  // dropped, because their neighbours cover them
    std::size_t repeated = 0;      // dropped, because another has the same corners and surface
    std::size_t simplified = 0;    // number of triangles removed by simplification
    double simplify_bound_m = 0.0;
    double simplify_measured_m = 0.0;  // Hausdorff distance in both directions, measured at samples
    // Distance between samples: the true Hausdorff distance is at most this much / sqrt(3) greater.
    double simplify_spacing_m = 0.0;
    std::size_t merged = 0;  // triangles replaced by polygons
    std::size_t polygons = 0;
    double flat_bound_m = 0.0, flat_measured_m = 0.0;

    MeshReport& operator+=(const MeshReport& other);
    // Sentences for the honesty report, with the bounds; none if nothing was done.
    std::vector<std::string> sentences() const;
};

// A surface with fewer triangles than it had.
struct CoarserSurface {
    std::uint32_t surface = 0;
    std::size_t before = 0, after = 0;
    double measured_m = 0.0;  // Hausdorff distance, both ways, at samples
};

struct PreparedMesh {
    TriangleMesh mesh;                    // the triangles that remain
    std::vector<std::uint32_t> surfaces;  // for each of these triangles
    std::vector<FlatPolygon> polygons;    // `triangles` is empty in these
    std::vector<std::uint32_t> polygon_surfaces;
    std::vector<CoarserSurface> coarser;  // in rising order of the surfaces
    MeshReport report;
};

// corners: three for each triangle. surfaces: one number for each; only what has the same is joined, and no border
// between different ones moves. stop: soon after a request from another thread the mesh comes back less simplified.
// begins: called before a surface is simplified, with its number and its triangles.
using SurfaceBegins = std::function<void(std::uint32_t surface, std::size_t triangles)>;
PreparedMesh prepare_mesh(std::span<const Vec3> corners_m, std::span<const std::uint32_t> surfaces,
                          const MeshOptions& options, const std::stop_token& stop = {},
                          const SurfaceBegins& begins = {});

// Merges points that are at most tolerance_m apart into the first of them (0: only identical ones; -0 counts as 0).
// Triangles keep their order.
TriangleMesh weld_corners(std::span<const Vec3> corners_m, double tolerance_m, MeshReport& report);

}  // namespace handrail::compile
