// Merges flat patches of a triangle mesh into few convex polygons: what touches like one plane should be one obstacle.
// Pure function, background thread. About 2 us per triangle. Source of the last step: Hertel & Mehlhorn, Fast
// triangulation of simple polygons, 1983 (inner edges are removed while both sides together stay convex).
#pragma once

#include <span>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail::compile {

struct FlatPolygon {
    std::vector<Vec3> points_m;  // convex, in one plane, counter-clockwise seen from the front of its triangles
    std::vector<std::uint32_t> triangles;  // the triangles that it replaces, at least two
};

struct FlatMerge {
    std::vector<FlatPolygon> polygons;
    std::vector<std::uint32_t> single;  // triangles that stay as they are, in rising order
    double farthest_m = 0.0;            // greatest distance of a corner from its polygon's plane
};

// Joins triangles over edges that exactly two of them share in opposite directions, if both are of one group and all
// corners of the patch are within bound_m of one plane. Each polygon then covers what its triangles covered. Seen along
// the plane's normal, the area is the same to a thousandth of the bound (at least 1e-9 m) at its rim, and no point is
// farther than bound_m from it. Parts that are not manifold, or fold back on themselves, stay single.
// - groups: one per triangle.
// - keep_curves: a patch that meets another triangle of its group at less than 30 degrees is a facet of a curve,
//   which shading rounds; it stays triangles.
FlatMerge merge_flat(const TriangleMesh& mesh, std::span<const std::uint32_t> groups, double bound_m,
                     bool keep_curves = false);

}  // namespace handrail::compile
