// Merges flat patches of a triangle mesh into few convex polygons. A surface that feels like one plane then becomes one
// obstacle. Pure function, background thread. About 2 us per triangle. The last step removes inner edges while the
// polygon that results stays convex, after Hertel & Mehlhorn, Fast triangulation of simple polygons, 1983.
#pragma once

#include <span>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail::compile {

struct FlatPolygon {
    // Corners of a convex polygon in one plane, counter-clockwise seen from the front of its triangles.
    std::vector<Vec3> points_m;
    std::vector<std::uint32_t> triangles;  // the triangles that the polygon replaces, at least two
};

struct FlatMerge {
    std::vector<FlatPolygon> polygons;
    std::vector<std::uint32_t> single;  // triangles that were not merged, in rising order
    double farthest_m = 0.0;            // greatest distance of a corner from its polygon's plane
};

// Joins triangles over edges that exactly two of them share in opposite directions, if both triangles are of one group
// and all corners of the patch are within bound_m of one plane. Each polygon covers the same area as its triangles.
// Seen along the plane's normal, its rim differs from theirs by at most a thousandth of bound_m, or 1e-9 m if that is
// more. No point is farther than bound_m from the plane. Parts that are not manifold, or fold back on themselves, are
// not merged.
// - groups: one number per triangle.
// - keep_curves: a patch that meets another triangle of its group at less than 30 degrees is a facet of a curve, which
//   shading rounds. Its triangles are not merged.
FlatMerge merge_flat(const TriangleMesh& mesh, std::span<const std::uint32_t> groups, double bound_m,
                     bool keep_curves = false);

}  // namespace handrail::compile
