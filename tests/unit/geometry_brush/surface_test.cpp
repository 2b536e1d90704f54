#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/geometry/exposed_surface.h"

namespace handrail {
namespace surface_test {

constexpr CutTolerance kTolerance{1e-6, 1e-5};

ConvexSolid solid(const std::vector<Plane>& planes) {
    BuiltSolid built = solid_from_planes(planes, {0, 0, 0}, 1000.0);
    EXPECT_EQ(built.fault, SolidFault::None);
    return built.solid;
}

ConvexSolid box(const Vec3& low, const Vec3& high) {
    return solid({{{1, 0, 0}, high.x},
                  {{-1, 0, 0}, -low.x},
                  {{0, 1, 0}, high.y},
                  {{0, -1, 0}, -low.y},
                  {{0, 0, 1}, high.z},
                  {{0, 0, -1}, -low.z}});
}

std::vector<ExposedPiece> exposed(const std::vector<ConvexSolid>& shapes) {
    std::vector<SurfaceSolid> solids;
    std::vector<Aabb> boxes;
    for (const ConvexSolid& shape : shapes) {
        solids.push_back({&shape});
        boxes.push_back(shape.bounds_m);
    }
    return exposed_surface(solids, BoxIndex(boxes), kTolerance);
}

double total_area(const std::vector<ExposedPiece>& pieces) {
    double sum = 0.0;
    for (const ExposedPiece& piece : pieces) sum += area_m2(piece.polygon);
    return sum;
}

// Returns how deep `p` is inside the polygon, in the polygon's plane; negative if it is outside.
double depth_in(const Polygon& polygon, const Vec3& normal, const Vec3& p) {
    double depth = 1e9;
    const std::size_t n = polygon.points_m.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 edge = polygon.points_m[(i + 1) % n] - polygon.points_m[i];
        depth = std::min(depth, glm::dot(glm::cross(normal, glm::normalize(edge)), p - polygon.points_m[i]));
    }
    return depth;
}

Vec3 random_point_in(const Polygon& polygon, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Vec3 sum{0.0};
    double weights = 0.0;
    for (const Vec3& p : polygon.points_m) {
        const double w = -std::log(unit(random) + 1e-12);
        sum += w * p;
        weights += w;
    }
    return sum / weights;
}

TEST(ExposedSurface, drops_both_sides_of_a_contact_and_one_of_two_equal_faces) {
    // Two unit cubes next to each other have 12 faces. The two faces in contact must be hidden.
    const auto side_by_side = exposed({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
    EXPECT_EQ(side_by_side.size(), 10U);
    EXPECT_DOUBLE_EQ(total_area(side_by_side), 10.0);
    // Two copies of the same cube must count as one.
    EXPECT_DOUBLE_EQ(total_area(exposed({box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1})})), 6.0);
    // A cube stands on a plate. The plate's top loses the area under the cube, and the cube loses its bottom.
    EXPECT_DOUBLE_EQ(total_area(exposed({box({0, 0, 0}, {4, 4, 1}), box({1, 1, 1}, {2, 2, 2})})),
                     16.0 + 15.0 + 16.0 + 5.0);
    // A cube that is wholly inside another one has no exposed surface.
    EXPECT_DOUBLE_EQ(total_area(exposed({box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 2})})), 96.0);
    // Cubes that touch at a point or along an edge cover nothing.
    EXPECT_DOUBLE_EQ(
        total_area(exposed({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2}), box({1, 1, 0}, {2, 2, 1})})), 16.0);
}

TEST(ExposedSurface, keeps_the_wall_behind_doors_and_liquids) {
    const ConvexSolid wall = box({0, 0, 0}, {1, 1, 1}), other = box({1, 0, 0}, {2, 1, 1});
    const std::vector<Aabb> boxes{wall.bounds_m, other.bounds_m};
    const std::vector<SurfaceSolid> door{{&wall, 0}, {&other, 1}};
    EXPECT_DOUBLE_EQ(total_area(exposed_surface(door, BoxIndex(boxes), kTolerance)), 12.0);
    const std::vector<SurfaceSolid> water{{&wall}, {&other, 0, false}};
    EXPECT_DOUBLE_EQ(total_area(exposed_surface(water, BoxIndex(boxes), kTolerance)), 11.0);
}

// Compares with brute force on boxes on a coarse grid, where dozens of faces coincide. If the space directly in front
// of a point of a face is free of all solids, exactly one piece must contain the point. Otherwise no piece may contain
// it.
TEST(ExposedSurface, agrees_with_brute_force_on_boxes_with_coinciding_faces) {
    const int rounds = test::scaled(60);
    for (int seed = 0; seed < rounds; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        std::uniform_int_distribution<int> place(0, 5), extent(1, 4);
        std::vector<ConvexSolid> shapes;
        for (int i = 0; i < 12; ++i) {
            const Vec3 low{place(random), place(random), place(random)};
            shapes.push_back(box(low, low + Vec3{extent(random), extent(random), extent(random)}));
        }
        const std::vector<ExposedPiece> pieces = exposed(shapes);
        double expected_area = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0})
                for (int i = 0; i < 10; ++i)
                    for (int j = 0; j < 10; ++j)
                        for (int k = 0; k < 10; ++k) {
                            Vec3 normal{0.0}, p{0.0};
                            normal[axis] = sign;
                            p[axis] = i;
                            p[(axis + 1) % 3] = j + 0.5;
                            p[(axis + 2) % 3] = k + 0.5;
                            const auto in_any = [&](const Vec3& q) {
                                return std::any_of(shapes.begin(), shapes.end(),
                                                   [&](const ConvexSolid& shape) { return contains(shape, q); });
                            };
                            const int expected = in_any(p - 0.1 * normal) && !in_any(p + 0.1 * normal) ? 1 : 0;
                            expected_area += expected;
                            int found = 0;
                            for (const ExposedPiece& piece : pieces) {
                                const Plane& plane = shapes[piece.solid].planes[piece.face];
                                if (glm::dot(plane.normal, normal) > 0.5 &&
                                    std::abs(signed_distance(plane, p)) < 1e-9 &&
                                    depth_in(piece.polygon, normal, p) > 0.0)
                                    ++found;
                            }
                            ASSERT_EQ(found, expected)
                                << p.x << ' ' << p.y << ' ' << p.z << " axis " << axis << " sign " << sign;
                        }
        EXPECT_NEAR(total_area(pieces), expected_area, 1e-9);
        std::vector<ConvexSolid> shuffled = shapes;
        std::shuffle(shuffled.begin(), shuffled.end(), random);
        EXPECT_NEAR(total_area(exposed(shuffled)), expected_area, 1e-9) << "the order of solids changed the surface";
    }
}

TEST(ExposedSurface, agrees_with_brute_force_on_tilted_solids) {
    const int rounds = test::scaled(60);
    for (int seed = 0; seed < rounds; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> place(-2.0, 2.0);
        std::vector<ConvexSolid> shapes;
        for (int i = 0; i < 8; ++i) {
            const Vec3 middle{place(random), place(random), place(random)};
            std::vector<Plane> planes;
            for (int axis = 0; axis < 3; ++axis)
                for (const double sign : {1.0, -1.0}) {
                    Vec3 n{0.2 * normal(random), 0.2 * normal(random), 0.2 * normal(random)};
                    n[axis] += sign;
                    n = glm::normalize(n);
                    planes.push_back({n, glm::dot(n, middle) + 1.0});
                }
            shapes.push_back(solid(planes));
        }
        const std::vector<ExposedPiece> pieces = exposed(shapes);
        for (std::uint32_t s = 0; s < shapes.size(); ++s)
            for (std::uint32_t f = 0; f < shapes[s].faces.size(); ++f)
                for (int sample = 0; sample < 40; ++sample) {
                    const Vec3 p = random_point_in(shapes[s].faces[f], random);
                    bool covered = false, unsure = false;
                    for (std::uint32_t other = 0; other < shapes.size(); ++other) {
                        if (other == s) continue;
                        covered = covered || contains(shapes[other], p);
                        unsure = unsure || contains(shapes[other], p, 1e-4) != contains(shapes[other], p, -1e-4);
                    }
                    if (unsure) continue;
                    int found = 0;
                    bool on_edge = false;
                    for (const ExposedPiece& piece : pieces) {
                        if (piece.solid != s || piece.face != f) continue;
                        const double depth = depth_in(piece.polygon, shapes[s].planes[f].normal, p);
                        on_edge = on_edge || std::abs(depth) < 1e-4;
                        if (depth > 0.0) ++found;
                    }
                    if (!on_edge) {
                        ASSERT_EQ(found, covered ? 0 : 1) << "solid " << s << " face " << f;
                    }
                }
    }
}

Polygon square(double x0, double y0, double x1, double y1) {
    return {{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}};
}

std::vector<std::uint32_t> joined(const std::vector<Polygon>& polygons, const std::vector<std::uint64_t>& looks = {}) {
    std::vector<FlatPiece> pieces;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        FlatPiece piece;
        piece.polygon = &polygons[i];
        piece.plane = {{0, 0, 1}, polygons[i].points_m.front().z};
        piece.look = looks.empty() ? 0 : looks[i];
        piece.face = i;
        pieces.push_back(piece);
    }
    return joined_surfaces(pieces, 1e-4);
}

// Hundreds of objects stand on a floor. Every place of the floor must be either under an object or in exactly one piece
// of the remaining floor.
TEST(ExposedSurface, cuts_a_floor_around_everything_that_stands_on_it) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-10.0, 9.0), size(0.1, 0.9), anywhere(-10.0, 10.0);
    std::vector<ConvexSolid> shapes{box({-10, -10, -1}, {10, 10, 0})};
    for (int i = 0; i < 400; ++i) {
        // Some of the boxes overlap, and some reach into the floor.
        const Vec3 low(place(random), place(random), i % 5 ? 0.0 : -0.5);
        shapes.push_back(
            i % 7 ? box(low, low + Vec3(size(random), size(random), 1.0))
                  : solid({{glm::normalize(Vec3(1, 1, 0)), glm::dot(glm::normalize(Vec3(1, 1, 0)), low) + 0.5},
                           {glm::normalize(Vec3(-1, 1, 0)), glm::dot(glm::normalize(Vec3(-1, 1, 0)), low) + 0.3},
                           {{0, -1, 0}, -low.y + 0.2},
                           {{0, 0, 1}, 1.0},
                           {{0, 0, -1}, -low.z}}));
    }
    std::vector<ExposedPiece> top;
    for (const ExposedPiece& piece : exposed(shapes))
        if (piece.solid == 0 && shapes[0].planes[piece.face].normal.z > 0.5) top.push_back(piece);
    ASSERT_GT(top.size(), 100U);
    double area = 0.0;
    for (const ExposedPiece& piece : top) area += area_m2(piece.polygon);
    int free = 0;
    const int points = test::scaled(20000);
    for (int i = 0; i < points; ++i) {
        const Vec3 p(anywhere(random), anywhere(random), 0.0);
        bool near_border = false, covered = false;
        for (std::size_t k = 1; k < shapes.size(); ++k) {
            double out = -1e9;
            for (const Plane& plane : shapes[k].planes)
                if (std::abs(plane.normal.z) < 0.5) out = std::max(out, signed_distance(plane, p));
            near_border = near_border || std::abs(out) < 1e-4;
            covered = covered || out < 0.0;
        }
        if (!covered) ++free;
        if (near_border) continue;
        int in = 0;
        bool at_edge = false;
        for (const ExposedPiece& piece : top) {
            const double depth = depth_in(piece.polygon, {0, 0, 1}, p);
            at_edge = at_edge || std::abs(depth) < 1e-4;
            in += depth > 0.0 ? 1 : 0;
        }
        if (!at_edge) {
            ASSERT_EQ(in, covered ? 0 : 1) << p.x << ' ' << p.y;
        }
    }
    EXPECT_NEAR(area, 400.0 * free / points, 400.0 * 4.0 / std::sqrt(points));
}

// Each solid is repeated thousands of times, or less often if time is short. The exposed surface must be that of a
// single copy of each solid, and must belong to the first copy.
TEST(ExposedSurface, shows_thousands_of_coincident_solids_once) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> place(0, 5), extent(1, 4);
    std::vector<ConvexSolid> once;
    for (int i = 0; i < 6; ++i) {
        const Vec3 low{place(random), place(random), place(random)};
        once.push_back(box(low, low + Vec3{extent(random), extent(random), extent(random)}));
    }
    std::vector<ConvexSolid> often = once;
    for (int i = 0; i < test::scaled(12'000); ++i) often.push_back(once[static_cast<std::size_t>(i) % once.size()]);
    const std::vector<ExposedPiece> of_one = exposed(once), of_all = exposed(often);
    ASSERT_EQ(of_all.size(), of_one.size());
    for (std::size_t i = 0; i < of_one.size(); ++i) {
        EXPECT_EQ(of_all[i].solid, of_one[i].solid);
        EXPECT_EQ(of_all[i].face, of_one[i].face);
        EXPECT_EQ(of_all[i].polygon.points_m, of_one[i].polygon.points_m);
    }
}

// The boxes are less than 2 mm apart from each other, and none is identical to another. The exposed surface must still
// be that of their union.
TEST(ExposedSurface, shows_only_the_outside_of_a_heap) {
    std::mt19937 random(12);
    std::uniform_int_distribution<int> tenths_of_mm(0, 20);
    const auto shift = [&] { return 1e-4 * tenths_of_mm(random); };
    std::vector<ConvexSolid> heap;
    const int many = test::scaled(1'500);
    for (int i = 0; i < many; ++i) {
        const Vec3 low{shift(), shift(), shift()};
        heap.push_back(box(low, low + Vec3(1.0)));
    }
    EXPECT_NEAR(total_area(exposed(heap)), 6.0 * 1.002 * 1.002, 0.01);
}

// Returns the exposed area of the tops of solids, seen from above. The solids are all in about the same place.
double top_area(const std::vector<ConvexSolid>& shapes, const CutTolerance& tolerance,
                const std::vector<int>& ranks = {}) {
    std::vector<Aabb> boxes;
    std::vector<SurfaceSolid> solids;
    for (const ConvexSolid& shape : shapes) {
        boxes.push_back(shape.bounds_m);
        solids.push_back({&shape});
        if (!ranks.empty()) solids.back().rank = ranks[solids.size() - 1];
    }
    double area = 0.0;
    for (const ExposedPiece& piece : exposed_surface(solids, BoxIndex(boxes), tolerance))
        if (shapes[piece.solid].planes[piece.face].normal.z > 0.5) area += area_m2(piece.polygon);
    return area;
}

TEST(ExposedSurface, keeps_only_one_of_several_almost_coincident_faces_in_any_arrangement) {
    constexpr CutTolerance kCoarse{1e-3, 1e-3};
    // Each box equals the next within the tolerance, but the third exceeds the first by more than the tolerance.
    EXPECT_NEAR(
        top_area({box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1 + 7e-7, 1, 1}), box({0, 0, 0}, {1 + 1.4e-6, 1, 1})},
                 kCoarse),
        1.0, 1e-5);
    // The second box exceeds the first by more than the tolerance. The size of the third is in between.
    EXPECT_NEAR(
        top_area({box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1.0012}), box({0, 0, 0}, {1, 1, 1.0006})}, kCoarse),
        1.0, 1e-2);
    EXPECT_NEAR(top_area({box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1.0012}), box({0, 0, 0}, {1, 1, 1.0006})},
                         kCoarse, {1, 0, 1}),
                1.0, 1e-2);
    // Many random boxes. In some runs they differ by less than 1 um, in others by several tolerances.
    for (int seed = 0; seed < test::scaled(40); ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        std::uniform_real_distribution<double> apart(0.0, seed % 2 ? 1e-6 : 1e-5);
        std::vector<ConvexSolid> heap;
        std::vector<int> ranks;
        for (int i = 0; i < (seed == 0 ? 1'500 : 30); ++i) {
            const Vec3 low{apart(random), apart(random), apart(random)};
            heap.push_back(box(low, low + Vec3(1.0 + apart(random), 1.0 + apart(random), 1.0 + apart(random))));
            ranks.push_back(static_cast<int>(random() % 2));
        }
        EXPECT_NEAR(top_area(heap, kTolerance), 1.0, 1e-3);
        EXPECT_NEAR(top_area(heap, kTolerance, ranks), 1.0, 1e-3);
    }
}

TEST(JoinedSurfaces, are_joined_along_edges_and_t_junctions_but_not_at_corners) {
    using testing::ElementsAre;
    EXPECT_THAT(joined({square(0, 0, 1, 1), square(1, 0, 2, 1)}), ElementsAre(0, 0));
    EXPECT_THAT(joined({square(0, 0, 1, 3), square(1, 1, 2, 2)}), ElementsAre(0, 0));
    EXPECT_THAT(joined({square(0, 0, 1, 1), square(1, 1, 2, 2)}), ElementsAre(0, 1));
    EXPECT_THAT(joined({square(0, 0, 1, 1), square(1.001, 0, 2, 1)}), ElementsAre(0, 1));
    EXPECT_THAT(joined({square(0, 0, 1, 1), square(2, 0, 3, 1), square(1, 0, 2, 1)}), ElementsAre(0, 0, 0));
    EXPECT_THAT(joined({square(0, 0, 1, 1), square(1, 0, 2, 1)}, {1, 2}), ElementsAre(0, 1));
    Polygon higher = square(1, 0, 2, 1);
    for (Vec3& p : higher.points_m) p.z = 0.01;
    EXPECT_THAT(joined({square(0, 0, 1, 1), higher}), ElementsAre(0, 1));
}

TEST(BoxIndex, finds_the_same_boxes_as_brute_force_in_rising_order) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.0, 10.0), extent(0.0, 2.0);
    const auto random_box = [&] {
        const Vec3 low{place(random), place(random), place(random)};
        return Aabb{low, low + Vec3{extent(random), extent(random), extent(random)}};
    };
    std::vector<Aabb> boxes;
    for (int i = 0; i < 300; ++i) boxes.push_back(random_box());
    boxes.emplace_back();  // a query must never find an empty box
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> found, expected;
    for (int i = 0; i < 300; ++i) {
        const Aabb query = random_box();
        index.find(query, found);
        expected.clear();
        for (std::uint32_t b = 0; b < boxes.size(); ++b)
            if (overlap(query, boxes[b])) expected.push_back(b);
        EXPECT_EQ(found, expected);
    }
    index.find(Aabb{}, found);
    EXPECT_TRUE(found.empty());
}

}  // namespace surface_test
}  // namespace handrail
