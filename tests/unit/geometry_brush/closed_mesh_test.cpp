// Tests how convex solids fill closed meshes. A point-by-point test is the reference.
#include "worlds/geometry/closed_mesh.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "tests/support/block_mesh.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/geometry/mass_properties.h"

namespace handrail {
namespace closed_mesh_test {

using test::Block;
using test::BlockMesh;

std::vector<std::uint32_t> all_of(const BlockMesh& mesh) {
    std::vector<std::uint32_t> which(mesh.triangles.size());
    std::iota(which.begin(), which.end(), 0U);
    return which;
}

Aabb box_of(const BlockMesh& mesh) {
    Aabb box;
    for (const Vec3& p : mesh.points_m) box.include(p);
    return box;
}

std::optional<std::vector<ConvexSolid>> filled(const BlockMesh& mesh, const FillLimits& limits = {}) {
    return solids_within(mesh.points_m, mesh.triangles, all_of(mesh), limits);
}

// Returns how many of the solids contain `at_m`; empty if the place is so near a face that the answer is ambiguous.
std::optional<int> held(const std::vector<ConvexSolid>& solids, const Vec3& at_m) {
    int in = 0;
    for (const ConvexSolid& solid : solids) {
        if (contains(solid, at_m, 1e-4) != contains(solid, at_m, -1e-4)) return std::nullopt;
        in += contains(solid, at_m) ? 1 : 0;
    }
    return in;
}

TEST(SolidsWithin, contain_exactly_once_each_point_that_a_ray_cast_calls_inside) {
    int several = 0;
    for (int seed = 0; seed < test::scaled(60); ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        std::set<Block> blocks{{0, 0, 0}};
        while (blocks.size() < 4U + static_cast<unsigned>(seed) % 20) {
            auto from = blocks.begin();
            std::advance(from, static_cast<std::ptrdiff_t>(random() % blocks.size()));
            Block next = *from;
            next[random() % 3] += random() % 2 ? 1 : -1;
            blocks.insert(next);
        }
        // Depending on the seed, the blocks stay as generated, turn about the vertical axis, or are also sheared.
        const double turn = seed % 3 == 0 ? 0.0 : 6.0 * unit(random), slant = seed % 3 == 2 ? unit(random) : 0.0;
        const BlockMesh mesh = test::block_mesh(blocks, [&](const Vec3& p) {
            const Vec3 q(p.x + slant * p.z, p.y - 0.5 * slant * p.x, p.z + 0.25 * slant * p.y);
            return 0.3 *
                   Vec3(q.x * std::cos(turn) - q.y * std::sin(turn), q.x * std::sin(turn) + q.y * std::cos(turn), q.z);
        });
        const auto solids = filled(mesh);
        ASSERT_TRUE(solids.has_value());
        several += solids->size() > 1 ? 1 : 0;
        EXPECT_LE(solids->size(), blocks.size() + 8);
        const Aabb box = box_of(mesh);
        int queries = 0;
        for (int i = 0; i < 400; ++i) {
            const Vec3 at = box.min_m + box.size_m() * Vec3(unit(random), unit(random), unit(random));
            const std::optional<int> in = held(*solids, at);
            if (!in || mesh.distance_m(at) < 1e-4) continue;
            ++queries;
            ASSERT_EQ(*in, mesh.holds(at) ? 1 : 0) << at.x << " " << at.y << " " << at.z;
            ASSERT_EQ(times_around(mesh.points_m, mesh.triangles, all_of(mesh), at), mesh.holds(at) ? 1 : 0);
        }
        EXPECT_GT(queries, 200);
    }
    EXPECT_GT(several, test::scaled(60) / 2);
}

// Returns a torus with the proportions of a swimming ring, made of slanting faces.
BlockMesh ring(int around, int sides) {
    BlockMesh mesh;
    for (int i = 0; i < around; ++i)
        for (int k = 0; k < sides; ++k) {
            const double a = 2.0 * kPi * i / around, b = 2.0 * kPi * k / sides, r = 1.0 + 0.3 * std::cos(b);
            mesh.points_m.emplace_back(r * std::cos(a), r * std::sin(a), 0.3 * std::sin(b));
        }
    const auto at = [&](int i, int k) { return static_cast<std::uint32_t>((i % around) * sides + k % sides); };
    for (int i = 0; i < around; ++i)
        for (int k = 0; k < sides; ++k) {
            mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return mesh;
}

TEST(SolidsWithin, fill_a_ring_without_its_hole) {
    const BlockMesh mesh = ring(16, 10);
    const std::vector<MeshShell> shells = shells_of(mesh.points_m, mesh.triangles);
    ASSERT_EQ(shells.size(), 1U);
    EXPECT_TRUE(shells[0].closed);
    const auto solids = filled(mesh);
    ASSERT_TRUE(solids.has_value());
    double volume_m3 = 0.0;
    for (const ConvexSolid& solid : *solids) volume_m3 += mass_properties(solid).volume_m3;
    EXPECT_NEAR(volume_m3, shells[0].volume_m3, 1e-4);
    EXPECT_EQ(held(*solids, {0, 0, 0.01}), 0);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-1.4, 1.4);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 at(unit(random), unit(random), 0.25 * unit(random));
        if (const std::optional<int> in = held(*solids, at)) {
            ASSERT_EQ(*in, mesh.holds(at) ? 1 : 0);
        }
    }
}

TEST(SolidsWithin, cut_round_shapes_into_parts_with_few_sides) {
    BlockMesh ball;  // the loop makes a sphere with 24 by 24 faces
    constexpr int kSides = 24;
    for (int i = 0; i <= kSides; ++i)
        for (int k = 0; k < kSides; ++k) {
            const double up = kPi * i / kSides, turn = 2.0 * kPi * k / kSides;
            ball.points_m.emplace_back(std::sin(up) * std::cos(turn), std::sin(up) * std::sin(turn), -std::cos(up));
        }
    const auto at = [](int i, int k) { return static_cast<std::uint32_t>(i * kSides + k % kSides); };
    for (int i = 0; i < kSides; ++i)
        for (int k = 0; k < kSides; ++k) {
            if (i < kSides - 1) ball.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
            if (i > 0) ball.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
        }
    for (int k = 0; k < kSides; ++k)  // each pole is a single point
        ball.points_m[at(0, k)] = {0, 0, -1}, ball.points_m[at(kSides, k)] = {0, 0, 1};
    const FillLimits limits;
    const auto solids = filled(ball, limits);
    const auto shells = shells_of(ball.points_m, ball.triangles);
    ASSERT_EQ(shells.size(), 1U);
    ASSERT_TRUE(shells[0].closed);
    ASSERT_GT(shells[0].volume_m3, 4.0);
    ASSERT_TRUE(solids.has_value());
    EXPECT_GT(solids->size(), 1U);
    for (const ConvexSolid& solid : *solids) EXPECT_LE(solid.planes.size(), limits.most_faces);
    EXPECT_EQ(held(*solids, {0.1, 0.2, 0.31}).value_or(1), 1);
    EXPECT_EQ(held(*solids, {0.9, 0.9, 0.0}), 0);
}

TEST(SolidsWithin, are_refused_at_the_limits_and_for_self_intersecting_skins) {
    const auto place = [](const Vec3& p) { return 0.3 * p; };
    const BlockMesh table = test::block_mesh(test::table_blocks(), place);
    EXPECT_TRUE(filled(table).has_value());
    FillLimits few;
    few.most_solids = 2;
    EXPECT_FALSE(filled(table, few).has_value());
    few = {};
    few.most_planes = 8;
    EXPECT_FALSE(filled(table, few).has_value());
    few = {};
    few.most_triangles = 11;
    EXPECT_FALSE(filled(table, few).has_value());
    few = {};
    std::size_t looks = 1'000'000, little = 500;
    few.looks_left = &looks;
    EXPECT_TRUE(filled(table, few).has_value());
    EXPECT_LT(looks, 1'000'000U) << "counted";
    EXPECT_GT(looks, 500'000U);
    few.looks_left = &little;
    EXPECT_FALSE(filled(table, few).has_value());
    EXPECT_EQ(little, 0U);
    // In `through`, one leg of the table reaches up through the table top.
    BlockMesh through = table;
    for (Vec3& p : through.points_m)
        if (p.z < 0.01 && p.x < 0.31 && p.y < 0.31) p += Vec3(0.5, 0.5, 2.0);
    EXPECT_FALSE(filled(through).has_value());
    BlockMesh inside_out = table;
    for (auto& triangle : inside_out.triangles) std::swap(triangle[1], triangle[2]);
    EXPECT_FALSE(filled(inside_out).has_value());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(solids_within(table.points_m, table.triangles, all_of(table), {}, stop.get_token()).has_value());
}

TEST(ShellsOf, a_mesh_are_its_pieces_with_closedness_and_visible_side) {
    BlockMesh mesh = test::block_mesh(test::hollow_blocks(3), [](const Vec3& p) { return p; });
    const auto more = static_cast<std::uint32_t>(mesh.points_m.size());
    mesh.points_m.insert(mesh.points_m.end(), {{9, 0, 0}, {10, 0, 0}, {9, 1, 0}});
    mesh.triangles.push_back({more, more + 1, more + 2});
    std::vector<MeshShell> shells = shells_of(mesh.points_m, mesh.triangles);
    ASSERT_EQ(shells.size(), 3U);
    std::sort(shells.begin(), shells.end(),
              [](const MeshShell& a, const MeshShell& b) { return a.volume_m3 < b.volume_m3; });
    EXPECT_NEAR(shells[0].volume_m3, -1.0, 1e-9) << "the hollow";
    EXPECT_FALSE(shells[1].closed) << "the loose triangle";
    EXPECT_NEAR(shells[2].volume_m3, 27.0, 1e-9);
    EXPECT_TRUE(shells[0].closed && shells[2].closed);
    // Without its loose triangle, the chest must give 26 blocks, and none in its hollow middle.
    mesh.triangles.pop_back();
    const auto solids = filled(mesh);
    ASSERT_TRUE(solids.has_value());
    double volume_m3 = 0.0;
    for (const ConvexSolid& solid : *solids) volume_m3 += mass_properties(solid).volume_m3;
    EXPECT_NEAR(volume_m3, 26.0, 1e-4);
    EXPECT_EQ(held(*solids, {1.5, 1.45, 1.55}), 0);
}

// Each edge alone joins its two triangles, whichever corners it has.
TEST(ShellsOf, an_open_sheet_are_one_piece_across_each_of_its_edges) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (std::uint32_t first = 0; first < 4; ++first) {
        const auto corner = [&](std::uint32_t k) { return (first + k) % 4; };
        const std::vector<MeshCorners> triangles{{corner(0), corner(1), corner(2)}, {corner(0), corner(2), corner(3)}};
        const std::vector<MeshShell> shells = shells_of(points, triangles);
        ASSERT_EQ(shells.size(), 1U) << first;
        EXPECT_EQ(shells[0].triangles.size(), 2U);
        EXPECT_FALSE(shells[0].closed);
    }
    const std::vector<MeshCorners> folded{{0, 1, 2}, {1, 0, 3}};
    EXPECT_EQ(shells_of(points, folded).size(), 1U) << "at the edge with the lowest corners";
}

}  // namespace closed_mesh_test
}  // namespace handrail
