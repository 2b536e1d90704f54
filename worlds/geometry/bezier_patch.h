// Turns the curved patches of Quake 3 maps (patchDef2, patchDef3) into flat triangles. A patch is a grid of control
// points; each 3 by 3 of them form a biquadratic Bezier surface. Pure functions in double precision; any thread may
// call them. Cost: 1 us per triangle. Sources: Bezier 1962 for the surfaces; Filip, Magedson & Markot, Surface
// algorithms using bounds on derivatives, CAGD 1986, for the error bound.
#pragma once

#include <span>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/geometry/triangle_mesh.h"

namespace handrail {

// The control points of a patch, row by row. The numbers of rows and columns are odd and at least 3.
struct PatchGrid {
    int rows = 0, columns = 0;
    std::vector<Vec3> points_m;  // rows * columns points, row by row

    const Vec3& at(int row, int column) const { return points_m[static_cast<std::size_t>(row * columns + column)]; }
};

struct PatchMesh {
    TriangleMesh mesh;        // its vertices are stored row by row
    std::size_t columns = 0;  // number of vertices in a row
    // Greatest measured distance between the curved surface and the triangle that approximates it there. It is measured
    // at 9 points of each triangle.
    double error_m = 0.0;
};

inline constexpr int kMostPatchSplits = 256;  // greatest number of splits along one side of a 3 by 3 part

// Returns how many triangles tessellate() would make. Use it to stay within a budget.
std::size_t triangles_of_patch(const PatchGrid& grid, double chord_m);

// Makes triangles that are at most chord_m away from the curved surface, unless that needs more than kMostPatchSplits.
// The points on an edge depend on that edge's control points alone. So if two patches share an edge with the same
// control points, in either direction, their triangles meet along the same line. Triangles run counter-clockwise if
// columns run to the right and rows upwards. Triangles without area are left out.
PatchMesh tessellate(const PatchGrid& grid, double chord_m);

// Returns a point of the curved surface itself, for checks. `part_row` and `part_column` select the part of 3 by 3
// control points. u runs along columns and v along rows, from 0 to 1.
Vec3 point_of_patch(const PatchGrid& grid, int part_row, int part_column, double u, double v);

}  // namespace handrail
