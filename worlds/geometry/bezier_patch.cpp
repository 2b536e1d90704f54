#include "worlds/geometry/bezier_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "worlds/base/contract.h"
#include "worlds/geometry/closest_point.h"

namespace handrail {
namespace {

bool is_patch(const PatchGrid& grid) {
    return grid.rows >= 3 && grid.columns >= 3 && grid.rows % 2 == 1 && grid.columns % 2 == 1 &&
           grid.points_m.size() == static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
}

using Curve = std::array<Vec3, 3>;

// Returns the point of the curve at `t`. The result is bit-identical if the curve is reversed and t becomes 1 - t.
Vec3 on_curve(const Curve& c, double t) {
    const double s = 1.0 - t;
    return (c[0] * (s * s) + c[2] * (t * t)) + c[1] * (2.0 * s * t);
}

// Returns the number of parts into which a curve must be split. The number is a power of two, so that t and 1 - t are
// exact and the splits of neighbouring patches coincide.
int splits_for(double bend_m, double chord_m) {
    int splits = 1;
    while (splits < kMostPatchSplits && bend_m / (static_cast<double>(splits) * splits) > chord_m) splits *= 2;
    return splits;
}

// Returns the distance from the chord to the middle of a curve: a quarter of the second difference.
double bend_of(const Curve& c) { return 0.25 * glm::length((c[0] + c[2]) - 2.0 * c[1]); }

struct Splits {
    std::vector<int> across;  // number of splits for each column of 3 by 3 parts
    std::vector<int> up;      // number of splits for each row of 3 by 3 parts
};

// Uses half of the allowed error for the interior of the grid. The other half is left for the outer edges, which may
// have fewer splits than the interior.
Splits splits_of(const PatchGrid& grid, double chord_m) {
    const int rows = grid.rows / 2, columns = grid.columns / 2;
    Splits splits{std::vector<int>(static_cast<std::size_t>(columns), 1),
                  std::vector<int>(static_cast<std::size_t>(rows), 1)};
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            // bend_u and bend_v are an eighth of the greatest second derivatives along u and v, computed from the
            // control net. `twist` is the greatest twist of a cell of the control net, which bounds the mixed
            // derivative.
            double bend_u = 0.0, bend_v = 0.0, twist = 0.0;
            for (int k = 0; k < 3; ++k) {
                bend_u = std::max(bend_u, bend_of({grid.at(2 * r + k, 2 * c), grid.at(2 * r + k, 2 * c + 1),
                                                   grid.at(2 * r + k, 2 * c + 2)}));
                bend_v = std::max(bend_v, bend_of({grid.at(2 * r, 2 * c + k), grid.at(2 * r + 1, 2 * c + k),
                                                   grid.at(2 * r + 2, 2 * c + k)}));
            }
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j)
                    twist = std::max(
                        twist, glm::length(grid.at(2 * r + i, 2 * c + j) - grid.at(2 * r + i, 2 * c + j + 1) -
                                           grid.at(2 * r + i + 1, 2 * c + j) + grid.at(2 * r + i + 1, 2 * c + j + 1)));
            // For linear triangles with sides 1/m and 1/n, the error is at most bend_u / m^2 + bend_v / n^2 + twist /
            // (m n). The last term has no further factor, because f_uv <= 4 twist and the bound contains a quarter of
            // f_uv.
            int& m = splits.across[static_cast<std::size_t>(c)];
            int& n = splits.up[static_cast<std::size_t>(r)];
            m = std::max(m, splits_for(bend_u, chord_m / 6.0));
            n = std::max(n, splits_for(bend_v, chord_m / 6.0));
            while (twist / (static_cast<double>(m) * n) > chord_m / 6.0 &&
                   (m < kMostPatchSplits || n < kMostPatchSplits)) {
                int& finer = (m <= n && m < kMostPatchSplits) || n >= kMostPatchSplits ? m : n;
                finer *= 2;
            }
        }
    return splits;
}

// Returns a point of an outer edge. The edge alone may need fewer splits than the grid. The point is then on the
// straight line between two splits of the edge.
Vec3 on_edge(const Curve& curve, int step, int steps, double chord_m) {
    const int own = std::min(splits_for(bend_of(curve), 0.5 * chord_m), steps);
    const int stride = steps / own, before = step / stride * stride;
    const Vec3 a = on_curve(curve, static_cast<double>(before) / steps);
    if (before == step) return a;
    const Vec3 b = on_curve(curve, static_cast<double>(before + stride) / steps);
    const double t = static_cast<double>(step - before) / stride;
    return a * (1.0 - t) + b * t;
}

}  // namespace

Vec3 point_of_patch(const PatchGrid& grid, int part_row, int part_column, double u, double v) {
    contract_pre(part_row >= 0 && 2 * part_row + 2 < grid.rows && part_column >= 0 &&
                 2 * part_column + 2 < grid.columns);
    contract_pre(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0);
    Curve along;
    for (int k = 0; k < 3; ++k)
        along[static_cast<std::size_t>(k)] =
            on_curve({grid.at(2 * part_row + k, 2 * part_column), grid.at(2 * part_row + k, 2 * part_column + 1),
                      grid.at(2 * part_row + k, 2 * part_column + 2)},
                     u);
    return on_curve(along, v);
}

std::size_t triangles_of_patch(const PatchGrid& grid, double chord_m) {
    contract_pre(is_patch(grid));
    contract_pre(chord_m > 0.0);
    const Splits splits = splits_of(grid, chord_m);
    std::size_t across = 0, up = 0;
    for (const int m : splits.across) across += static_cast<std::size_t>(m);
    for (const int n : splits.up) up += static_cast<std::size_t>(n);
    return 2 * across * up;
}

PatchMesh tessellate(const PatchGrid& grid, double chord_m) {
    contract_pre(is_patch(grid));
    contract_pre(chord_m > 0.0);
    const Splits splits = splits_of(grid, chord_m);
    // Identifies a vertex of the grid by its 3 by 3 part, its step within the part, and the number of steps of the
    // part.
    struct Knot {
        int part, step, steps;
    };
    const auto knots_of = [](const std::vector<int>& counts) {
        std::vector<Knot> knots;
        for (std::size_t part = 0; part < counts.size(); ++part)
            for (int step = 0; step < counts[part]; ++step)
                knots.push_back({static_cast<int>(part), step, counts[part]});
        knots.push_back({static_cast<int>(counts.size()) - 1, counts.back(), counts.back()});
        return knots;
    };
    const std::vector<Knot> us = knots_of(splits.across), vs = knots_of(splits.up);
    PatchMesh out;
    out.columns = us.size();
    for (std::size_t j = 0; j < vs.size(); ++j)
        for (std::size_t i = 0; i < us.size(); ++i) {
            const auto& [column, ustep, usteps] = us[i];
            const auto& [row, vstep, vsteps] = vs[j];
            const int c = 2 * column, r = 2 * row;
            Vec3 p;
            if (j == 0 || j + 1 == vs.size()) {
                const int line = j == 0 ? 0 : grid.rows - 1;
                p = on_edge({grid.at(line, c), grid.at(line, c + 1), grid.at(line, c + 2)}, ustep, usteps, chord_m);
            } else if (i == 0 || i + 1 == us.size()) {
                const int line = i == 0 ? 0 : grid.columns - 1;
                p = on_edge({grid.at(r, line), grid.at(r + 1, line), grid.at(r + 2, line)}, vstep, vsteps, chord_m);
            } else {
                p = point_of_patch(grid, row, column, static_cast<double>(ustep) / usteps,
                                   static_cast<double>(vstep) / vsteps);
            }
            out.mesh.points_m.push_back(p);
        }
    const auto index = [&](std::size_t i, std::size_t j) { return static_cast<std::uint32_t>(j * us.size() + i); };
    for (std::size_t j = 0; j + 1 < vs.size(); ++j)
        for (std::size_t i = 0; i + 1 < us.size(); ++i) {
            const auto& [column, ustep, usteps] = us[i];
            const auto& [row, vstep, vsteps] = vs[j];
            std::array<TriangleShape, 2> shapes;
            int made = 0;
            const std::array<Corners, 2> halves{Corners{index(i, j), index(i + 1, j), index(i + 1, j + 1)},
                                                Corners{index(i, j), index(i + 1, j + 1), index(i, j + 1)}};
            for (const Corners& half : halves) {
                const Vec3 &a = out.mesh.points_m[half[0]], &b = out.mesh.points_m[half[1]],
                           &d = out.mesh.points_m[half[2]];
                const TriangleShape shape = make_triangle(a, b, d);
                if (shape.degenerate) continue;
                shapes[static_cast<std::size_t>(made++)] = shape;
                out.mesh.triangles.push_back(half);
            }
            if (made == 0) continue;
            for (int k = 0; k < 9; ++k) {
                const double u = (ustep + 0.25 * (1 + k % 3)) / usteps, v = (vstep + 0.25 * (1 + k / 3)) / vsteps;
                const Vec3 p = point_of_patch(grid, row, column, u, v);
                double nearest = std::numeric_limits<double>::infinity();
                for (int s = 0; s < made; ++s)
                    nearest = std::min(nearest, closest_point(shapes[static_cast<std::size_t>(s)], p).distance_m);
                out.error_m = std::max(out.error_m, nearest);
            }
        }
    return out;
}

}  // namespace handrail
