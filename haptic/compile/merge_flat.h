// Flat patches of a triangle mesh as few convex polygons: what touches like one plane should be one obstacle. Pure
// function, worker thread. About 2 us per triangle. Source of the last step: Hertel & Mehlhorn, Fast triangulation of
// simple polygons, 1983 (inner edges go while what they part stays convex).
#pragma once

#include <span>
#include <vector>

#include "worlds/geometry/triangle_mesh.h"

namespace handrail {

struct FlatPolygon {
    std::vector<Vec3> points_m;            // convex, in one plane, counter-clockwise seen from where its triangles were
    std::vector<std::uint32_t> triangles;  // it replaces, at least two
};

struct FlatMerge {
    std::vector<FlatPolygon> polygons;
    std::vector<std::uint32_t> single;  // triangles that stay as they are, in rising order
    double farthest_m = 0.0;            // that a corner lay from its polygon's plane
};

// Triangles are joined over edges that exactly two of them share, running opposite ways, when they are of one group and
// all corners of the patch lie within bound_m of one plane. So each polygon covers what its triangles covered: seen
// along the plane's normal the same area to a thousandth of the bound (at least 1e-9 m) at its rim, and nowhere farther
// than bound_m from it. What is not manifold, or folds back on itself, stays single. groups: one per triangle.
// keep_curves: a patch that meets another triangle of its group at less than 30 degrees is a facet of a curve, which
// shading rounds, and stays triangles.
FlatMerge merge_flat(const TriangleMesh& mesh, std::span<const std::uint32_t> groups, double bound_m,
                     bool keep_curves = false);

}  // namespace handrail
