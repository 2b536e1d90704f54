// Prepares the loose triangles of a world file for the hand. prepare_mesh() welds identical points and drops degenerate
// triangles that lie on their neighbours. It merges flat patches into convex polygons and, on request, simplifies dense
// surfaces within a stated error. A report counts these changes. Pure functions, worker thread. They take 2 to 4 us per
// triangle; simplification takes 0.1 to 1 ms per triangle more.
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
    // Points at most this far apart are merged into the first of them. 0: only identical points are merged. Values
    // above a millimetre close the gaps of thin objects.
    double weld_m = 0.0;
    bool tidy = true;   // drop triangles that have no area, or the same corners and surface as another triangle
    bool merge = true;  // merge flat patches of triangles into convex polygons
    // Greatest distance of a corner from its polygon's plane. The default covers the rounding of coordinates written
    // with 5 or 6 digits. Above 1e-4 m, facets of tessellated curves become larger, and the hand feels their edges.
    double flat_m = 1e-5;
    bool keep_curves = true;        // do not merge facets of a curve, which shading rounds
    double simplify_m = 0.0;        // largest distance between a surface and its simplified form; 0: no simplification
    std::size_t simplify_from = 0;  // least number of triangles of a surface that is simplified
};

// The options of `touch`, with which no point moves by more than rounding.
inline constexpr MeshOptions kExactMesh{.weld_m = 0.0,
                                        .tidy = false,
                                        .merge = true,
                                        .flat_m = 1e-9,
                                        .keep_curves = false,
                                        .simplify_m = 0.0,
                                        .simplify_from = 0};

struct MeshReport {
    std::size_t triangles = 0;      // number of triangles before processing
    std::size_t points_welded = 0;  // number of points that were merged into another point
    double farthest_weld_m = 0.0;
    std::size_t without_area = 0;  // triangles dropped because they have no area and their neighbours cover them
    std::size_t repeated = 0;      // triangles dropped because another has the same corners and surface
    std::size_t simplified = 0;    // number of triangles removed by simplification
    double simplify_bound_m = 0.0;
    // Hausdorff distance between the original and the simplified mesh, measured in both directions at samples.
    double simplify_measured_m = 0.0;
    // Distance between the samples of simplify_measured_m. The true Hausdorff distance is at most this much / sqrt(3)
    // greater.
    double simplify_spacing_m = 0.0;
    std::size_t merged = 0;  // number of triangles that were replaced by polygons
    std::size_t polygons = 0;
    double flat_bound_m = 0.0, flat_measured_m = 0.0;

    MeshReport& operator+=(const MeshReport& other);
    // Returns sentences for the honesty report, with the bounds of the changes. Returns an empty vector if nothing was
    // changed.
    std::vector<std::string> sentences() const;
};

// A surface that was simplified to fewer triangles.
struct CoarserSurface {
    std::uint32_t surface = 0;
    std::size_t before = 0, after = 0;
    double measured_m = 0.0;  // Hausdorff distance in both directions, measured at samples
};

struct PreparedMesh {
    TriangleMesh mesh;                    // the triangles that were not merged
    std::vector<std::uint32_t> surfaces;  // surface of each triangle in `mesh`
    std::vector<FlatPolygon> polygons;    // merged patches; the field `triangles` of each is empty
    std::vector<std::uint32_t> polygon_surfaces;
    std::vector<CoarserSurface> coarser;  // the simplified surfaces, in rising order of their numbers
    MeshReport report;
};

// Prepares a mesh.
// - corners_m: three for each triangle.
// - surfaces: one number for each triangle. Only triangles of the same surface are merged, and no border between
//   surfaces moves.
// - stop: after a stop request from another thread, the function returns the mesh soon, with fewer surfaces simplified.
// - begins: called before a surface is simplified, with the surface's number and its count of triangles.
using SurfaceBegins = std::function<void(std::uint32_t surface, std::size_t triangles)>;
PreparedMesh prepare_mesh(std::span<const Vec3> corners_m, std::span<const std::uint32_t> surfaces,
                          const MeshOptions& options, const std::stop_token& stop = {},
                          const SurfaceBegins& begins = {});

// Merges points that are at most `tolerance_m` apart into the first of them. If `tolerance_m` is 0, only identical
// points are merged, where -0 equals 0. Triangles keep their order.
TriangleMesh weld_corners(std::span<const Vec3> corners_m, double tolerance_m, MeshReport& report);

}  // namespace handrail::compile
