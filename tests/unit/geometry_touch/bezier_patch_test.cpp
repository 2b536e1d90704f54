// Tests the meshes of curved patches. Dense samples of the curved patch are the reference. Meshes of neighbouring
// patches must meet.
#include "worlds/geometry/bezier_patch.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/geometry/closest_point.h"

namespace handrail::test {
namespace bezier_patch_test {

double number(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

// Returns the control points of a sheet of about a metre with random bends.
PatchGrid random_grid(std::mt19937& random, double bend) {
    PatchGrid grid{3 + 2 * static_cast<int>(random() % 2), 3 + 2 * static_cast<int>(random() % 3), {}};
    for (int r = 0; r < grid.rows; ++r)
        for (int c = 0; c < grid.columns; ++c)
            grid.points_m.emplace_back(0.5 * c + bend * number(random, -0.2, 0.2),
                                       0.5 * r + bend * number(random, -0.2, 0.2), bend * number(random, -1.0, 1.0));
    return grid;
}

double distance_to(const TriangleMesh& mesh, const Vec3& p) {
    double nearest = 1e9;
    for (const Corners& t : mesh.triangles)
        nearest = std::min(
            nearest,
            closest_point(make_triangle(mesh.points_m[t[0]], mesh.points_m[t[1]], mesh.points_m[t[2]]), p).distance_m);
    return nearest;
}

TEST(BezierPatch, keeps_its_triangles_within_the_permitted_error_and_reports_the_error) {
    constexpr std::uint32_t kSeed = 87;
    std::mt19937 random(kSeed);
    for (int round = 0; round < scaled(40); ++round) {
        const PatchGrid grid = random_grid(random, round % 4 == 0 ? 0.01 : 0.5);
        const double chord = round % 2 == 0 ? 1e-2 : 3e-3;
        const PatchMesh made = tessellate(grid, chord);
        EXPECT_EQ(made.mesh.triangles.size(), triangles_of_patch(grid, chord));
        EXPECT_LE(made.error_m, chord);
        double worst = 0.0;
        for (int s = 0; s < 60; ++s) {
            const int row = static_cast<int>(random() % static_cast<unsigned>(grid.rows / 2)),
                      column = static_cast<int>(random() % static_cast<unsigned>(grid.columns / 2));
            worst = std::max(worst, distance_to(made.mesh, point_of_patch(grid, row, column, number(random, 0, 1),
                                                                          number(random, 0, 1))));
        }
        EXPECT_LE(worst, chord) << "seed " << kSeed << " round " << round;
        EXPECT_LE(worst, 1.35 * made.error_m + 1e-12) << "measured at 9 places of each cell";
    }
}

TEST(BezierPatch, flat_patches_become_two_triangles_per_part_and_patches_without_area_none) {
    PatchGrid flat{5, 3, {}};
    for (int r = 0; r < 5; ++r)
        for (int c = 0; c < 3; ++c) flat.points_m.emplace_back(c, r, 0.25 * c);
    EXPECT_EQ(tessellate(flat, 1e-3).mesh.triangles.size(), 4U);
    EXPECT_LE(tessellate(flat, 1e-3).error_m, 1e-15);
    const PatchMesh sheet = tessellate(flat, 1e-3);
    for (const Corners& t : sheet.mesh.triangles)
        EXPECT_GT(
            make_triangle(sheet.mesh.points_m[t[0]], sheet.mesh.points_m[t[1]], sheet.mesh.points_m[t[2]]).normal.z,
            0.0);
    const PatchGrid point{3, 3, std::vector<Vec3>(9, Vec3(1, 2, 3))};
    EXPECT_TRUE(tessellate(point, 1e-3).mesh.triangles.empty());
    // The tip of a cone: one row of control points is a single point.
    PatchGrid cone{3,
                   3,
                   {{0, 0, 1},
                    {0, 0, 1},
                    {0, 0, 1},
                    {0.5, 0, 0.5},
                    {0.5, 0.5, 0.5},
                    {0, 0.5, 0.5},
                    {1, 0, 0},
                    {1, 1, 0},
                    {0, 1, 0}}};
    const PatchMesh made = tessellate(cone, 1e-3);
    EXPECT_LE(made.error_m, 1e-3);
    EXPECT_LT(made.mesh.triangles.size(), triangles_of_patch(cone, 1e-3));
    // The control points bend the patch far beyond the limits. The mesh must use the greatest number of splits and
    // report its true error.
    for (Vec3& p : cone.points_m) p *= 1e4;
    const PatchMesh huge = tessellate(cone, 1e-3);
    EXPECT_LE(huge.mesh.triangles.size(), std::size_t{2 * kMostPatchSplits * kMostPatchSplits});
    EXPECT_GT(huge.error_m, 1e-3);
}

PatchGrid transposed(const PatchGrid& grid) {
    PatchGrid out{grid.columns, grid.rows, {}};
    for (int r = 0; r < out.rows; ++r)
        for (int c = 0; c < out.columns; ++c) out.points_m.push_back(grid.at(c, r));
    return out;
}
PatchGrid mirrored(const PatchGrid& grid) {
    PatchGrid out = grid;
    for (int r = 0; r < grid.rows; ++r)
        for (int c = 0; c < grid.columns; ++c)
            out.points_m[static_cast<std::size_t>(r * grid.columns + c)] = grid.at(r, grid.columns - 1 - c);
    return out;
}

TEST(BezierPatch, neighbours_with_a_common_edge_meet_along_one_line_in_any_orientation) {
    constexpr std::uint32_t kSeed = 88;
    std::mt19937 random(kSeed);
    for (int round = 0; round < scaled(30); ++round) {
        const PatchGrid a = random_grid(random, 0.5);
        // Patch b continues beyond the first row of a with a very different bend, so that tessellate() splits the
        // inside of b differently.
        PatchGrid b{3, a.columns, {}};
        for (int r = 2; r >= 0; --r)
            for (int c = 0; c < a.columns; ++c)
                b.points_m.push_back(r == 0 ? a.at(0, c)
                                            : a.at(0, c) +
                                                  Vec3(number(random, -0.5, 0.5), -0.5 * r, number(random, -3.0, 3.0)));
        if (round % 4 == 1) b = mirrored(b);
        if (round % 4 == 2) b = transposed(b);
        if (round % 4 == 3) b = mirrored(transposed(b));
        const PatchMesh one = tessellate(a, 2e-3), other = tessellate(b, 2e-3);
        const auto line_of = [](const PatchMesh& mesh, std::size_t first, std::size_t step, std::size_t count) {
            std::vector<Vec3> line;
            for (std::size_t k = 0; k < count; ++k) line.push_back(mesh.mesh.points_m[first + k * step]);
            return line;
        };
        const std::size_t width_a = one.columns, width_b = other.columns;
        const std::vector<Vec3> edge_a = line_of(one, 0, 1, width_a);
        const bool turned = round % 4 >= 2;
        // The edge of b towards a is the last row of b. After transposing it is the last column; after transposing and
        // mirroring it is the first column.
        const std::size_t rows_b = other.mesh.points_m.size() / width_b;
        const std::vector<Vec3> edge_b = !turned          ? line_of(other, (rows_b - 1) * width_b, 1, width_b)
                                         : round % 4 == 2 ? line_of(other, width_b - 1, width_b, rows_b)
                                                          : line_of(other, 0, width_b, rows_b);
        for (const auto& [points, line] : {std::pair{&edge_a, &edge_b}, {&edge_b, &edge_a}})
            for (const Vec3& p : *points) {
                double nearest = 1e9;
                for (std::size_t k = 0; k + 1 < line->size(); ++k)
                    nearest = std::min(
                        nearest, closest_point(make_triangle((*line)[k], (*line)[k + 1], (*line)[k]), p).distance_m);
                EXPECT_LE(nearest, 1e-14) << "seed " << kSeed << " round " << round;
            }
    }
}

}  // namespace bezier_patch_test
}  // namespace handrail::test
