// Curved patches of Quake 3 maps (patchDef2, patchDef3) as flat triangles: a grid of control points, each 3 by 3 of
// them a biquadratic Bezier surface. Pure functions, any thread, double precision; 1 us per triangle. Source of the
// surfaces: Bezier 1962; of the error bound: Filip, Magedson & Markot, Surface algorithms using bounds on derivatives,
// CAGD 1986.
#pragma once

#include <span>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/geometry/triangle_mesh.h"

namespace handrail {

// Row by row; both counts odd and at least 3.
struct PatchGrid {
    int rows = 0, columns = 0;
    std::vector<Vec3> points_m;  // rows * columns

    const Vec3& at(int row, int column) const { return points_m[static_cast<std::size_t>(row * columns + column)]; }
};

struct PatchMesh {
    TriangleMesh mesh;        // vertices row by row
    std::size_t columns = 0;  // of vertices
    // Measured: the farthest that the curved surface lies from the triangle under it, at 9 places of each.
    double error_m = 0.0;
};

inline constexpr int kMostPatchSplits = 256;  // along one side of one 3 by 3 part

// How many triangles tessellate() would make; for keeping within a budget.
std::size_t triangles_of_patch(const PatchGrid& grid, double chord_m);

// Triangles no farther than chord_m from the curved surface, as far as kMostPatchSplits allows. Where two patches have
// an edge in common, given by the same control points in either direction, their triangles meet along one and the same
// line: what lies on an edge depends on that edge's points alone. Counter-clockwise where columns run to the right and
// rows upwards. Triangles of no area are left out.
PatchMesh tessellate(const PatchGrid& grid, double chord_m);

// The surface itself, for checks: part (row, column) of 3 by 3 points, u along columns and v along rows from 0 to 1.
Vec3 point_of_patch(const PatchGrid& grid, int part_row, int part_column, double u, double v);

}  // namespace handrail
