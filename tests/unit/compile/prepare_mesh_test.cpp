// Tests meshes that are prepared for touch. Joined triangles must cover the same area as before. If a triangle is
// dropped, others must cover its area. A simplified mesh must be as near to the original as stated. The meshes are
// random triangulations of planes, boxes, prisms and terrain, rotated, moved and shuffled.
#include "haptic/compile/prepare_mesh.h"

#include <array>
#include <random>
#include <set>

#include "haptic/compile/simplify_mesh.h"
#include "haptic/render/haptic_scene.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/sphere_mesh.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace prepare_mesh_test {

constexpr std::uint32_t kSeed = 20241109;

double between(std::mt19937& random, double low, double high) { return low + (high - low) * unit(random); }

using Soup = std::vector<Vec3>;  // three corners per triangle

void triangle(Soup& soup, const Vec3& a, const Vec3& b, const Vec3& c) { soup.insert(soup.end(), {a, b, c}); }

// Adds a sheet of n by m cells with random inner points. Each cell is cut along a random diagonal, and `holes` cells
// are missing. `height` is a function that gives the height.
template <class Height>
void grid(Soup& soup, std::mt19937& random, int n, int m, int holes, const Height& height) {
    std::vector<Vec3> points;
    for (int y = 0; y <= m; ++y)
        for (int x = 0; x <= n; ++x) {
            const double dx = x == 0 || x == n ? 0.0 : between(random, -0.3, 0.3),
                         dy = y == 0 || y == m ? 0.0 : between(random, -0.3, 0.3);
            const Vec2 p{(x + dx) * 0.1, (y + dy) * 0.1};
            points.emplace_back(p.x, p.y, height(p));
        }
    std::vector<bool> hole(static_cast<std::size_t>(n * m), false);
    for (int i = 0; i < holes; ++i) hole[random() % hole.size()] = true;
    for (int y = 0; y < m; ++y)
        for (int x = 0; x < n; ++x) {
            if (hole[static_cast<std::size_t>(y * n + x)]) continue;
            const auto at = [&](int i, int k) { return points[static_cast<std::size_t>((y + k) * (n + 1) + x + i)]; };
            if (random() % 2 == 0) {
                triangle(soup, at(0, 0), at(1, 0), at(1, 1));
                triangle(soup, at(0, 0), at(1, 1), at(0, 1));
            } else {
                triangle(soup, at(0, 0), at(1, 0), at(0, 1));
                triangle(soup, at(1, 0), at(1, 1), at(0, 1));
            }
        }
}

void prism(Soup& soup, int sides, double height) {
    std::vector<Vec3> low, high;
    for (int i = 0; i < sides; ++i) {
        low.emplace_back(0.2 * std::cos(2 * kPi * i / sides), 0.2 * std::sin(2 * kPi * i / sides), 0.0);
        high.push_back(low.back() + Vec3(0, 0, height));
    }
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t k = (i + 1) % low.size();
        triangle(soup, low[i], low[k], high[k]);
        triangle(soup, low[i], high[k], high[i]);
        if (i == 0 || k == 0) continue;
        triangle(soup, high[0], high[i], high[k]);
        triangle(soup, low[0], low[k], low[i]);
    }
}

void box(Soup& soup, const Vec3& low, const Vec3& high) {
    const auto v = [&](int i) { return Vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z); };
    for (const auto& f :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        triangle(soup, v(f[0]), v(f[1]), v(f[2]));
        triangle(soup, v(f[0]), v(f[2]), v(f[3]));
    }
}

// Moves all triangles by `motion`. Returns them in random order, each beginning with a random corner.
Soup stirred(const Soup& soup, std::mt19937& random, const Motion& motion) {
    std::vector<std::size_t> order(soup.size() / 3);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    Soup out;
    for (const std::size_t t : order) {
        const std::size_t first = random() % 3;
        for (std::size_t k = 0; k < 3; ++k) out.push_back(motion(soup[3 * t + (first + k) % 3]));
    }
    return out;
}

PreparedMesh prepared(const Soup& soup, const MeshOptions& options = {}) {
    return prepare_mesh(soup, std::vector<std::uint32_t>(soup.size() / 3, 7), options);
}

// Returns the sheets that the touch solver receives, without a hierarchy. Polygons become fans of triangles.
Soup sheets_of(const PreparedMesh& prepared_mesh) {
    Soup sheets;
    for (const Corners& t : prepared_mesh.mesh.triangles)
        for (const std::uint32_t corner : t) sheets.push_back(prepared_mesh.mesh.points_m[corner]);
    for (const FlatPolygon& polygon : prepared_mesh.polygons)
        for (std::size_t i = 1; i + 1 < polygon.points_m.size(); ++i)
            triangle(sheets, polygon.points_m[0], polygon.points_m[i], polygon.points_m[i + 1]);
    return sheets;
}

double distance_to(const Soup& soup, const Vec3& p) {
    long double nearest = 1e30L;
    for (std::size_t i = 0; i < soup.size(); i += 3)
        nearest = std::min(nearest,
                           nearest_on_triangle(LVec(soup[i]), LVec(soup[i + 1]), LVec(soup[i + 2]), LVec(p)).distance);
    return static_cast<double>(nearest);
}

// Returns the greatest distance in metres between a random point on `from` and the mesh `to`.
double farthest(const Soup& from, const Soup& to, std::mt19937& random, int samples) {
    double most = 0.0;
    for (int i = 0; i < samples; ++i) {
        const std::size_t t = 3 * (random() % (from.size() / 3));
        double u = unit(random), v = unit(random);
        if (i % 5 == 0) u = 0.0;  // a point on an edge
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        most = std::max(most, distance_to(to, from[t] * (1.0 - u - v) + from[t + 1] * u + from[t + 2] * v));
    }
    return most;
}

double area_of(const Soup& soup) {
    double area = 0.0;
    for (std::size_t i = 0; i < soup.size(); i += 3)
        area += 0.5 * glm::length(glm::cross(soup[i + 1] - soup[i], soup[i + 2] - soup[i]));
    return area;
}

void expect_convex(const FlatPolygon& polygon, double rounding) {
    const std::size_t n = polygon.points_m.size();
    ASSERT_GE(n, 3U);
    Vec3 normal(0.0);
    for (std::size_t i = 1; i + 1 < n; ++i)
        normal += glm::cross(polygon.points_m[i] - polygon.points_m[0], polygon.points_m[i + 1] - polygon.points_m[0]);
    normal = glm::normalize(normal);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 a = polygon.points_m[i], b = polygon.points_m[(i + 1) % n];
        for (const Vec3& p : polygon.points_m) {
            ASSERT_GE(glm::dot(glm::cross(b - a, p - a), normal), -rounding * glm::length(b - a)) << "not convex";
            ASSERT_LE(std::abs(glm::dot(p - a, normal)), 1e-9 + rounding) << "not flat";
        }
    }
}

struct Family {
    const char* name;
    Soup soup;
    double bound_m;
    std::size_t most_pieces;  // greatest number of pieces; a piece is a polygon or a triangle
};

std::vector<Family> families(std::mt19937& random) {
    std::vector<Family> all;
    const auto flat = [](const Vec2&) { return 0.0; };
    const auto add = [&](const char* name, double bound_m, std::size_t most) -> Soup& {
        all.push_back({name, {}, bound_m, most});
        return all.back().soup;
    };
    grid(add("plane of 288 random triangles", 1e-9, 1), random, 12, 12, 0, flat);
    grid(add("plane with holes", 1e-9, 120), random, 12, 12, 6, flat);
    grid(add("long strip", 1e-9, 1), random, 60, 1, 0, flat);
    box(add("box", 1e-9, 6), {-0.1, -0.2, 0}, {0.3, 0.1, 0.2});
    prism(add("prism of 9 sides", 1e-9, 11), 9, 0.3);
    prism(add("prism of 60 sides", 1e-9, 62), 60, 0.3);
    grid(add("terrain", 1e-9, 288), random, 12, 12, 0,
         [](const Vec2& p) { return 0.05 * std::sin(7 * p.x) * std::cos(5 * p.y); });
    grid(add("terrain within 2 mm", 2e-3, 250), random, 12, 12, 0,
         [](const Vec2& p) { return 0.05 * std::sin(7 * p.x) * std::cos(5 * p.y); });
    grid(add("noisy plane within 0.1 mm", 1e-4, 1), random, 12, 12, 0,
         [&](const Vec2&) { return between(random, -2e-5, 2e-5); });
    Soup& steps = add("steps", 1e-9, 12);
    for (int i = 0; i < 5; ++i) {
        const double x = 0.3 * i, z = 0.17 * i;
        triangle(steps, {x, 0, z}, {x + 0.3, 0, z}, {x + 0.3, 1, z});
        triangle(steps, {x, 0, z}, {x + 0.3, 1, z}, {x, 1, z});
        triangle(steps, {x + 0.3, 0, z}, {x + 0.3, 0, z + 0.17}, {x + 0.3, 1, z + 0.17});
        triangle(steps, {x + 0.3, 0, z}, {x + 0.3, 1, z + 0.17}, {x + 0.3, 1, z});
    }
    return all;
}

TEST(PrepareMesh, merges_flat_patches_into_convex_polygons_that_cover_exactly_the_same_area) {
    std::mt19937 random(kSeed);
    for (const double far : {0.0, 1e3, 5e5})
        for (const Family& family : families(random)) {
            Motion motion = random_turn(random);
            motion.shift_m = Vec3(far, -0.7 * far, 0.3 * far);
            SCOPED_TRACE(fmt::format("{}, {} m away, seed {}", family.name, far, kSeed));
            const Soup soup = stirred(family.soup, random, motion);
            MeshOptions options;
            options.keep_curves = false;
            options.flat_m = std::max(family.bound_m, 4e-16 * far * 4.0);
            const PreparedMesh mesh = prepared(soup, options);
            const double rounding = 3e-9 + 1e-15 * far;
            for (const FlatPolygon& polygon : mesh.polygons) expect_convex(polygon, 1e-11 + 1e-14 * far);
            const Soup sheets = sheets_of(mesh);
            EXPECT_LE(mesh.polygons.size() + mesh.mesh.triangles.size(), family.most_pieces);
            EXPECT_EQ(mesh.report.merged + mesh.mesh.triangles.size(), soup.size() / 3);
            EXPECT_LE(mesh.report.flat_measured_m, options.flat_m);
            const int samples = scaled(300);
            EXPECT_LE(farthest(soup, sheets, random, samples), mesh.report.flat_measured_m + rounding);
            EXPECT_LE(farthest(sheets, soup, random, samples), mesh.report.flat_measured_m + rounding);
            if (family.bound_m <= 1e-9) {
                EXPECT_NEAR(area_of(sheets), area_of(soup), 1e-8 + 1e-10 * far);
            }
        }
}

TEST(PrepareMesh, keeps_the_facets_of_curves_for_shading_when_exploring) {
    Soup soup;
    prism(soup, 60, 0.3);
    const PreparedMesh mesh = prepared(soup);
    EXPECT_EQ(mesh.mesh.triangles.size(), 120U);
    EXPECT_EQ(mesh.polygons.size(), 2U);
}

TEST(PrepareMesh, merges_only_triangles_of_one_surface) {
    std::mt19937 random(kSeed);
    Soup soup;
    grid(soup, random, 10, 2, 0, [](const Vec2&) { return 0.0; });
    std::vector<std::uint32_t> surfaces;
    // The first of two rows of triangles has surface 1, the second surface 2.
    for (std::size_t t = 0; t < soup.size() / 3; ++t) surfaces.push_back(t < 20 ? 1 : 2);
    const PreparedMesh mesh = prepare_mesh(soup, surfaces, {});
    EXPECT_TRUE(mesh.mesh.triangles.empty() || mesh.surfaces.size() == mesh.mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
        Soup fan;
        for (std::size_t k = 1; k + 1 < mesh.polygons[i].points_m.size(); ++k)
            triangle(fan, mesh.polygons[i].points_m[0], mesh.polygons[i].points_m[k], mesh.polygons[i].points_m[k + 1]);
        const Soup same(soup.begin() + (mesh.polygon_surfaces[i] == 1 ? 0 : 60),
                        mesh.polygon_surfaces[i] == 1 ? soup.begin() + 60 : soup.end());
        EXPECT_LE(farthest(fan, same, random, 50), 1e-9);
    }
}

TEST(PrepareMesh, welds_the_same_points_as_an_all_pairs_comparison) {
    std::mt19937 random(kSeed);
    for (const double tolerance : {0.0, 1e-4, 3e-3})
        for (int round = 0; round < 20; ++round) {
            Soup soup;
            for (int i = 0; i < 60; ++i) {
                Vec3 p(static_cast<double>(random() % 4), static_cast<double>(random() % 3), i % 2 == 0 ? 0.0 : -0.0);
                if (round % 2 == 0)
                    p += Vec3(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)) * 2e-3;
                soup.push_back(p);
            }
            MeshReport report;
            const TriangleMesh mesh = weld_corners(soup, tolerance, report);
            // The reference: merges each corner with the nearest kept point within the tolerance, or else keeps the
            // corner.
            std::vector<Vec3> kept;
            for (std::size_t i = 0; i < soup.size(); ++i) {
                std::size_t nearest = kept.size();
                double least = tolerance;
                for (std::size_t k = 0; k < kept.size(); ++k)
                    if (const double d = glm::length(kept[k] - soup[i]);
                        d < least || (d == least && nearest == kept.size())) {
                        least = d;
                        nearest = k;
                    }
                if (nearest == kept.size()) kept.push_back(soup[i]);
                // A corner that occurred before must get the same kept point again, even if a nearer point was kept
                // later.
                const Vec3 got = mesh.points_m[mesh.triangles[i / 3][i % 3]];
                ASSERT_LE(glm::length(got - soup[i]), tolerance) << "seed " << kSeed << " round " << round;
                ASSERT_LE(glm::length(got - kept[nearest]), 2.0 * tolerance);
            }
            ASSERT_EQ(mesh.points_m.size(), kept.size());
            EXPECT_EQ(report.points_welded > 0, tolerance > 0.0 && report.farthest_weld_m > 0.0);
        }
}

TEST(PrepareMesh, drops_zero_area_triangles_only_if_neighbours_cover_them) {
    Soup soup;
    triangle(soup, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    triangle(soup, {0, 0, 0}, {0.4, 0, 0}, {1, 0, 0});  // degenerate, lies on the edge of the first triangle
    triangle(soup, {1, 0, 0}, {1, 0, 0}, {1, 0, 0});    // degenerate, a single point at a corner of the first triangle
    triangle(soup, {2, 0, 0}, {2, 0, 0}, {2, 0, 0});    // degenerate, an isolated point
    triangle(soup, {0, 0, 0}, {0, 0, 0.5}, {0, 0, 1});  // degenerate, an isolated edge
    triangle(soup, {0, 1, 0}, {0, 0, 0}, {1, 0, 0});    // the first triangle again
    const PreparedMesh tidied = prepared(soup, {.merge = false});
    EXPECT_EQ(tidied.report.without_area, 2U);
    EXPECT_EQ(tidied.report.repeated, 1U);
    EXPECT_EQ(tidied.mesh.triangles.size(), 3U);
    const PreparedMesh all = prepared(soup, kExactMesh);
    EXPECT_EQ(all.mesh.triangles.size() + all.report.merged, 6U) << "touch keeps every face of a file";
    EXPECT_EQ(tidied.report.sentences().size(), 2U);
    EXPECT_TRUE(all.report.sentences().empty());
}

// Three sheets that meet at one edge, two that share only a corner, the same face twice, and the same face reversed.
// The preparation may lose none of them.
Soup untidy() {
    Soup soup;
    triangle(soup, {0, 0, 0}, {1, 0, 0}, {0.5, 1, 0});
    triangle(soup, {0, 0, 0}, {1, 0, 0}, {0.5, -1, 0.3});
    triangle(soup, {1, 0, 0}, {0, 0, 0}, {0.5, 0, 1});
    triangle(soup, {0.5, 1, 0}, {1, 2, 0}, {0, 2, 0.2});
    triangle(soup, {0, 0, 0}, {1, 0, 0}, {0.5, 1, 0});
    triangle(soup, {0.5, 0, 1}, {0, 0, 0}, {1, 0, 0});
    triangle(soup, {0, 0, 0}, {0.5, 0, 1}, {1, 0, 0});
    return soup;
}

TEST(PrepareMesh, loses_no_triangle_of_non_manifold_soups) {
    std::mt19937 random(kSeed);
    for (const double simplify : {0.0, 1e-3}) {
        const Soup soup = untidy();
        MeshOptions options;
        options.tidy = false;
        options.simplify_m = simplify;
        const PreparedMesh mesh = prepared(soup, options);
        EXPECT_EQ(mesh.mesh.triangles.size() + mesh.report.merged + mesh.report.simplified, soup.size() / 3);
        EXPECT_LE(farthest(soup, sheets_of(mesh), random, 300), simplify + 1e-9);
    }
}

TEST(PrepareMesh, makes_curves_coarser_within_the_error_bound_and_reports_the_deviation) {
    std::mt19937 random(kSeed);
    for (const double bound : {1e-2, 5e-3}) {
        Soup soup;
        const TriangleMesh sphere = sphere_mesh(10, 0.5);
        for (const Corners& t : sphere.triangles)
            for (const std::uint32_t corner : t) soup.push_back(sphere.points_m[corner]);
        MeshOptions options;
        options.simplify_m = bound;
        const PreparedMesh mesh = prepared(soup, options);
        EXPECT_GT(mesh.report.simplified, soup.size() / 3 / 3) << "a third of 2,000 triangles should go at " << bound;
        EXPECT_GT(mesh.report.simplify_measured_m, 0.0);
        EXPECT_LE(mesh.report.simplify_measured_m, bound);
        const double allowed = mesh.report.simplify_measured_m + mesh.report.simplify_spacing_m / std::sqrt(3.0) +
                               mesh.report.flat_measured_m;
        const Soup sheets = sheets_of(mesh);
        EXPECT_LE(farthest(soup, sheets, random, 200), allowed);
        EXPECT_LE(farthest(sheets, soup, random, 200), allowed);
    }
}

// A half sphere. A band along its rim is a second surface with fewer triangles.
struct TwoSurfaces {
    Soup soup;
    std::vector<std::uint32_t> surfaces;
    std::size_t dense = 0, few = 0;
};
TwoSurfaces dense_beside_few() {
    TwoSurfaces two;
    const TriangleMesh sphere = sphere_mesh(10, 0.5);
    const auto add = [&](const Corners& t, std::uint32_t surface) {
        for (const std::uint32_t corner : t) two.soup.push_back(sphere.points_m[corner]);
        two.surfaces.push_back(surface);
        ++(surface == 2 ? two.dense : two.few);
    };
    for (const Corners& t : sphere.triangles) {
        const Vec3 middle = (sphere.points_m[t[0]] + sphere.points_m[t[1]] + sphere.points_m[t[2]]) / 3.0;
        if (middle.z > 0.1) add(t, 2);
        else if (middle.z > 0.0) add(t, 5);
    }
    return two;
}

TEST(PrepareMesh, makes_dense_surfaces_alone_coarser_and_leaves_their_borders_where_they_are) {
    const TwoSurfaces two = dense_beside_few();
    ASSERT_GT(two.dense, two.few);
    MeshOptions options;
    options.merge = false;
    options.simplify_m = 1e-2;
    options.simplify_from = two.few + 1;
    std::vector<std::pair<std::uint32_t, std::size_t>> begun;
    const PreparedMesh mesh =
        prepare_mesh(two.soup, two.surfaces, options, {},
                     [&](std::uint32_t surface, std::size_t n) { begun.emplace_back(surface, n); });
    EXPECT_EQ(begun, (std::vector<std::pair<std::uint32_t, std::size_t>>{{2, two.dense}}));
    ASSERT_EQ(mesh.coarser.size(), 1U);
    const CoarserSurface& coarser = mesh.coarser[0];
    EXPECT_EQ(coarser.surface, 2U);
    EXPECT_EQ(coarser.before, two.dense);
    EXPECT_LT(coarser.after, two.dense / 2);
    EXPECT_EQ(mesh.report.simplified, coarser.before - coarser.after);
    EXPECT_GT(coarser.measured_m, 0.0);
    EXPECT_LE(coarser.measured_m, options.simplify_m);
    EXPECT_EQ(mesh.report.simplify_measured_m, coarser.measured_m);
    ASSERT_EQ(mesh.mesh.triangles.size(), two.few + coarser.after);
    // The triangles of the smaller surface must be unchanged. Each of their corners that the dense surface touched must
    // still be a corner of both surfaces.
    const auto corners_of = [](const std::vector<Vec3>& points, const auto& in) {
        std::set<std::array<double, 3>> corners;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (in(i)) corners.insert({points[i].x, points[i].y, points[i].z});
        return corners;
    };
    const Soup felt = sheets_of(mesh);
    const auto of = [&](std::uint32_t surface) {
        return std::pair(corners_of(two.soup, [&](std::size_t i) { return two.surfaces[i / 3] == surface; }),
                         corners_of(felt, [&](std::size_t i) { return mesh.surfaces[i / 3] == surface; }));
    };
    const auto [few, few_felt] = of(5);
    const auto [dense, dense_felt] = of(2);
    EXPECT_EQ(few, few_felt);
    std::size_t shared = 0;
    for (const auto& corner : few)
        if (dense.contains(corner)) {
            ++shared;
            EXPECT_TRUE(dense_felt.contains(corner));
        }
    EXPECT_GT(shared, 20U);
}

TEST(PrepareMesh, keeps_every_triangle_of_surfaces_with_fewer_than_requested) {
    const TwoSurfaces two = dense_beside_few();
    MeshOptions options;
    options.simplify_m = 5e-3;
    options.simplify_from = two.dense + 1;
    const PreparedMesh same = prepare_mesh(two.soup, two.surfaces, options),
                       fine = prepare_mesh(two.soup, two.surfaces, {});
    EXPECT_TRUE(same.coarser.empty());
    EXPECT_EQ(same.report.simplified, 0U);
    EXPECT_EQ(same.mesh.points_m, fine.mesh.points_m);
    EXPECT_EQ(same.mesh.triangles, fine.mesh.triangles);
    EXPECT_EQ(same.surfaces, fine.surfaces);
}

TEST(PrepareMesh, leaves_a_surface_as_it_is_when_it_is_stopped_meanwhile) {
    const TwoSurfaces two = dense_beside_few();
    MeshOptions options;
    options.merge = false;
    options.simplify_m = 5e-3;
    std::stop_source stop;
    const PreparedMesh mesh = prepare_mesh(two.soup, two.surfaces, options, stop.get_token(),
                                           [&](std::uint32_t, std::size_t) { stop.request_stop(); });
    EXPECT_EQ(mesh.mesh.triangles.size(), two.dense + two.few);
    EXPECT_TRUE(mesh.coarser.empty());
}

TEST(MeasuredDistance, finds_the_farthest_point_of_simple_shapes) {
    TriangleMesh low{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, high = low, tilted = low;
    for (Vec3& p : high.points_m) p.z = 0.25;
    tilted.points_m[2].z = 0.5;
    EXPECT_NEAR(measured_distance(low, high, 0.1), 0.25, 1e-12);
    EXPECT_NEAR(measured_distance(tilted, low, 0.1), 0.5, 1e-12);
    EXPECT_NEAR(measured_distance(low, low, 0.05), 0.0, 1e-15);
}

std::shared_ptr<const HapticScene> scene_of(const PreparedMesh& mesh) {
    HapticSceneBuilder builder;
    builder.add_mesh(mesh.mesh);
    for (const FlatPolygon& polygon : mesh.polygons) builder.add_polygon(polygon.points_m);
    return builder.build();
}

TEST(PrepareMesh, keeps_touch_within_a_micrometre_of_the_original_mesh) {
    std::mt19937 random(kSeed);
    for (const Family& family : families(random)) {
        if (family.bound_m > 1e-9) continue;
        SCOPED_TRACE(fmt::format("{}, seed {}", family.name, kSeed));
        const Soup soup = stirred(family.soup, random, {});
        const auto raw = scene_of(prepared(soup, {.tidy = false, .merge = false})),
                   merged = scene_of(prepared(soup, kExactMesh));
        TouchState raw_state, merged_state;
        TouchTuning tuning;
        long compared = 0, touching = 0;
        // The hand comes down at a random place of the surface and moves along it, pressed in by 2 mm.
        for (int press = 0; press < scaled(12); ++press) {
            const std::size_t t = 3 * (random() % (soup.size() / 3));
            const Vec3 normal = glm::normalize(glm::cross(soup[t + 1] - soup[t], soup[t + 2] - soup[t]));
            const Vec3 at = (soup[t] + soup[t + 1] + soup[t + 2]) / 3.0,
                       along = glm::cross(normal, glm::normalize(Vec3(0.3, 0.5, 0.81))) * 0.05;
            raw_state.reset();
            merged_state.reset();
            bool same = true;
            for (const Vec3& goal :
                 hand_path({at + normal * 0.02, at + normal * 0.003, at + normal * 0.003 + along}, 0.2)) {
                const TouchResult a = touch_tick(raw_state, *raw, tuning, goal, 1e-3),
                                  b = touch_tick(merged_state, *merged, tuning, goal, 1e-3);
                same = same && a.contacts.converged &&
                       // After the speed cap stopped one of the proxies, the two may be at different places.
                       !a.contacts.capped;
                if (!same) break;
                ++compared;
                touching += b.contacts.count > 0;
                ASSERT_LE(glm::length(a.proxy_m - b.proxy_m), 1e-6);
            }
        }
        EXPECT_GT(touching, compared / 2);
        EXPECT_GT(compared, scaled(12) * 100);
    }
}

// Slivers with aspect ratios of 1e3 to 1e7 in a plane, as in the hard case of that name. Joining them gives the plane.
TEST(PrepareMesh, makes_a_plane_of_sliver_triangles_feel_like_a_plane) {
    constexpr double b = 0.1, r = 0.005;
    for (const double aspect : {1e3, 1e5, 1e7})
        for (const bool exact : {true, false}) {
            SCOPED_TRACE(fmt::format("aspect {}, exact {}", aspect, exact));
            Soup soup;
            const auto quad = [&](double y0, double y1) {
                triangle(soup, {-b, y0, 0}, {b, y0, 0}, {b, y1, 0});
                triangle(soup, {-b, y0, 0}, {b, y1, 0}, {-b, y1, 0});
            };
            const double h = 0.2 / aspect;
            double y = -12 * h;
            quad(-b, y);
            for (int i = 0; i < 24; ++i, y += h) quad(y, y + h);
            quad(y, b);
            const PreparedMesh mesh = prepared(soup, exact ? kExactMesh : MeshOptions{});
            const auto scene = scene_of(mesh);
            EXPECT_EQ(scene->obstacles.size(), 1U);
            TouchState state;
            TouchTuning tuning;
            tuning.radius_m = r;
            int pressed = 0, most = 0;
            for (const Vec3& goal : hand_path({{-.04, -.02, .02},
                                               {-.04, -.02, -.01},
                                               {.04, .02, -.01},
                                               {.0, -.002, -.01},
                                               {.0, .002, -.01},
                                               {-.04, -.02, .02}},
                                              0.1)) {
                const TouchResult result = touch_tick(state, *scene, tuning, goal, 1e-3);
                most = std::max<int>(most, result.contacts.iterations);
                if (goal.z > r - 1e-9) continue;
                ++pressed;
                ASSERT_NEAR(result.proxy_m.z, r, 1e-9);
                ASSERT_NEAR(result.force_n.z, 800.0 * (r - goal.z), 1e-6);
            }
            EXPECT_GT(pressed, 1000);
            EXPECT_LE(most, 3);
        }
}

// The furrows are lower than the bound, but their sides rise at 70 degrees. A hand must still feel them.
TEST(SimplifyMesh, keeps_the_sides_of_steep_furrows_lower_than_its_bound) {
    constexpr std::uint32_t kFurrows = 24;
    constexpr double kHigh_m = 1e-3;
    const double wide_m = kHigh_m / std::tan(70.0 * kPi / 180.0);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= kFurrows; ++i)
        for (std::uint32_t k = 0; k <= kFurrows; ++k)
            mesh.points_m.emplace_back(i * wide_m, 2.0 * k * wide_m, i % 2 == 0 ? 0.0 : kHigh_m);
    for (std::uint32_t i = 0; i < kFurrows; ++i)
        for (std::uint32_t k = 0; k < kFurrows; ++k) {
            const std::uint32_t a = i * (kFurrows + 1) + k, c = a + kFurrows + 1;
            mesh.triangles.push_back({a, c, c + 1});
            mesh.triangles.push_back({a, c + 1, a + 1});
        }
    const SimplifiedMesh made = simplify_mesh(mesh, {}, 1.5 * kHigh_m);
    EXPECT_LT(made.mesh.triangles.size(), mesh.triangles.size() / 4) << "along the furrows it has been simplified";
    std::uint32_t steep = 0;
    for (const Corners& t : made.mesh.triangles) {
        const Vec3& a = made.mesh.points_m[t[0]];
        const Vec3 across = glm::cross(made.mesh.points_m[t[1]] - a, made.mesh.points_m[t[2]] - a);
        steep += std::abs(across.z) < 0.5 * glm::length(across);
    }
    EXPECT_GE(steep, 2 * kFurrows) << "of " << made.mesh.triangles.size();
}

}  // namespace prepare_mesh_test
}  // namespace handrail::test
