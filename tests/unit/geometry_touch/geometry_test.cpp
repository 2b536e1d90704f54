// Tests each geometry routine against brute force. The inputs are ordinary, degenerate, far from the origin, and in
// every order.
#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/touch_worlds.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/geometry/half_space_projection.h"

namespace handrail::test {
namespace geometry_test {

constexpr std::uint32_t kSeed = 20240611;

Vec3 random_point(std::mt19937& random, double half) {
    std::uniform_real_distribution<double> u(-half, half);
    const double x = u(random), y = u(random), z = u(random);
    return {x, y, z};
}

double as_double(long double v) { return static_cast<double>(v); }

// Returns a triangle of one kind: ordinary, needle, degenerate, a point, or with a repeated corner.
std::array<Vec3, 3> random_triangle(std::mt19937& random, int kind) {
    const Vec3 a = random_point(random, 0.1), b = random_point(random, 0.1);
    switch (kind % 6) {
        case 0:
            return {a, b, random_point(random, 0.1)};
        case 1:
            return {a, b, a + (b - a) * 0.3 + random_point(random, 1e-6)};  // a needle
        case 2:
            return {a, b, a + (b - a) * 0.7};  // zero area
        case 3:
            return {a, a, b};
        case 4:
            return {a, a, a};
        default:
            return {a, a + random_point(random, 1e-9), b};
    }
}

TEST(ClosestPointOfTriangle, agrees_with_brute_force_in_all_vertex_orders_degenerate_and_far_from_origin) {
    std::mt19937 random(kSeed);
    for (int round = 0; round < scaled(6000); ++round) {
        const std::array<Vec3, 3> t = random_triangle(random, round);
        const Vec3 shift = round % 3 == 0 ? Vec3(0.0) : round % 3 == 1 ? Vec3(1e3, -2e3, 500.0) : Vec3(7e5, 3e5, -9e5);
        const double rounding = round % 3 == 0 ? 1e-12 : round % 3 == 1 ? 2e-12 : 2e-9;
        const Vec3 p = shift + random_point(random, 0.2);
        const std::array<Vec3, 3> s{shift + t[0], shift + t[1], shift + t[2]};
        const double expected = as_double(nearest_on_triangle(LVec(s[0]), LVec(s[1]), LVec(s[2]), LVec(p)).distance);
        for (const auto& [i, j, k] :
             {std::array<std::size_t, 3>{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
            const TriangleShape shape = make_triangle(s[i], s[j], s[k]);
            const ClosestPoint q = closest_point(shape, p);
            const ClosestPoint unprepared = closest_point_of_triangle(s[i], s[j], s[k], p);
            ASSERT_NEAR(unprepared.distance_m, q.distance_m, rounding);
            ASSERT_LE(glm::length(unprepared.normal - q.normal),
                      q.distance_m > 1e-6 ? 1e-6 + 3.0 * rounding / q.distance_m : 2.1);
            Vec3 support{0.0};
            const double apart = support_towards(s[i], s[j], s[k], p, support);
            ASSERT_LE(apart, expected + rounding) << "round " << round;
            const Vec3 middle = (s[0] + s[1] + s[2]) / 3.0;
            double reach = 0.0;
            for (const Vec3& corner : s) {
                if (apart > 0.0) {
                    ASSERT_GE(glm::dot(support, p - corner), apart - rounding) << "round " << round;
                }
                reach = std::max(reach, glm::length(corner - middle));
            }
            if (expected > reach + rounding) {
                ASSERT_GT(apart, 0.0) << "from farther than the triangle reaches there is such a plane, round "
                                      << round;
            }
            SCOPED_TRACE(fmt::format("seed {} round {} degenerate {}", kSeed, round, shape.degenerate));
            ASSERT_NEAR(q.distance_m, expected, rounding + (shape.degenerate ? 1e-7 : 0.0));
            ASSERT_NEAR(glm::length(q.normal), 1.0, 1e-12);
            ASSERT_NEAR(glm::length(p - q.point_m), q.distance_m, rounding);
            for (const Vec3& corner : s)  // the plane at the closest point must have the whole triangle behind it
                ASSERT_LE(glm::dot(q.normal, corner - q.point_m), rounding * 10 + (shape.degenerate ? 2e-7 : 0.0));
        }
    }
}

TEST(ClosestPointOfTriangle, on_the_sheet_itself_gives_a_supporting_normal) {
    std::mt19937 random(kSeed);
    for (int round = 0; round < 600; ++round) {
        const std::array<Vec3, 3> t = random_triangle(random, round);
        const TriangleShape shape = make_triangle(t[0], t[1], t[2]);
        for (const Vec3& p : {t[0], t[1], t[2], (t[0] + t[1]) * 0.5}) {
            const ClosestPoint q = closest_point(shape, p);
            ASSERT_LE(q.distance_m, shape.degenerate ? 1e-7 : 1e-12);
            ASSERT_NEAR(glm::length(q.normal), 1.0, 1e-12);
        }
    }
}

TEST(ClosestPointOfBox, agrees_with_the_same_box_given_as_planes_and_with_brute_force) {
    std::mt19937 random(kSeed);
    for (int round = 0; round < scaled(3000); ++round) {
        const Vec3 low = random_point(random, 0.1);
        const double thin = round % 4 == 0 ? 1e-4 : 0.1;
        const Vec3 size = glm::abs(random_point(random, 1.0)) * Vec3(0.1, 0.1, thin);
        const Aabb box{low, low + size};
        const std::vector<Plane> planes{{{1, 0, 0}, box.max_m.x}, {{-1, 0, 0}, -box.min_m.x},
                                        {{0, 1, 0}, box.max_m.y}, {{0, -1, 0}, -box.min_m.y},
                                        {{0, 0, 1}, box.max_m.z}, {{0, 0, -1}, -box.min_m.z}};
        const Vec3 p = random_point(random, 0.15);
        const double expected = as_double(nearest_on_solid(planes, LVec(p)).distance);
        for (const ClosestPoint& q : {closest_point(box, p), closest_point(std::span(planes), p)}) {
            ASSERT_NEAR(q.distance_m, expected, 1e-12) << "seed " << kSeed << " round " << round;
            ASSERT_NEAR(glm::length(q.normal), 1.0, 1e-12);
            ASSERT_NEAR(glm::dot(p - q.point_m, q.normal), q.distance_m, 1e-12);
        }
    }
}

TEST(ClosestPointOfSolid, agrees_with_brute_force_on_random_brushes_with_permuted_and_doubled_planes) {
    std::mt19937 random(kSeed);
    for (int round = 0; round < scaled(1500); ++round) {
        const Vec3 shift = round % 2 == 0 ? Vec3(0.0) : Vec3(900.0, -300.0, 20.0);
        std::vector<Plane> planes;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                Vec3 n(0.0);
                n[axis] = side;
                planes.push_back({n, 0.05 + glm::dot(n, shift)});
            }
        for (int cut = 0; cut < round % 5; ++cut) {
            const Vec3 n = glm::normalize(random_point(random, 1.0) + Vec3(1e-3));
            planes.push_back({n, 0.02 + 0.04 * (random() % 1000) / 1000.0 + glm::dot(n, shift)});
        }
        const Vec3 p = shift + random_point(random, 0.12);
        const double expected = as_double(nearest_on_solid(planes, LVec(p)).distance);
        if (round % 3 == 0) planes.insert(planes.end(), planes.begin(), planes.end());
        std::shuffle(planes.begin(), planes.end(), random);
        const ClosestPoint q = closest_point(std::span(planes), p);
        SCOPED_TRACE(fmt::format("seed {} round {}", kSeed, round));
        ASSERT_NEAR(q.distance_m, expected, 1e-9);
        ASSERT_NEAR(glm::length(q.normal), 1.0, 1e-12);
        for (const Plane& plane : planes) ASSERT_LE(signed_distance(plane, q.point_m), 1e-9);
    }
}

TEST(ProjectOnHalfSpaces, agrees_with_trying_every_subset_from_cold_and_warm_starts) {
    std::mt19937 random(kSeed);
    int infeasible = 0;
    for (int round = 0; round < scaled(4000); ++round) {
        const std::size_t count = 1 + random() % 12;
        std::vector<HalfSpace> walls;
        std::vector<LHalfSpace> long_walls;
        for (std::size_t i = 0; i < count; ++i) {
            HalfSpace h{glm::normalize(random_point(random, 1.0) + Vec3(1e-3)), (random() % 2000 - 1200.0) * 1e-5};
            if (i > 0 && random() % 8 == 0) h = walls[random() % i];  // repeats an earlier wall
            walls.push_back(h);
            long_walls.push_back({LVec(h.normal), h.offset_m});
        }
        const Vec3 goal = random_point(random, 0.03);
        const auto at = [&](int i) { return walls[static_cast<std::size_t>(i)]; };
        ProjectionBasis basis;
        const bool solved = project_on_half_spaces(goal, static_cast<int>(count), at, basis);
        const std::optional<LVec> expected = project_by_enumeration(long_walls, LVec(goal), 1e-9L);
        SCOPED_TRACE(fmt::format("seed {} round {}", kSeed, round));
        if (!expected) {
            ++infeasible;
            EXPECT_FALSE(solved);
            continue;
        }
        // project_on_half_spaces() may fail only if the cell is thinner than rounding can resolve. Then the enumeration
        // with a negative tolerance has no solution either.
        if (!solved) {
            EXPECT_FALSE(project_by_enumeration(long_walls, LVec(goal), -1e-7L)) << "gave up on a roomy cell";
            continue;
        }
        EXPECT_NEAR(glm::length(basis.point_m - goal), as_double(glm::length(*expected - LVec(goal))), 1e-7);
        Vec3 sum(0.0);
        for (int k = 0; k < basis.count; ++k) {
            EXPECT_GE(basis.multiplier_m[static_cast<std::size_t>(k)], 0.0);
            sum +=
                at(basis.index[static_cast<std::size_t>(k)]).normal * basis.multiplier_m[static_cast<std::size_t>(k)];
        }
        EXPECT_LE(glm::length(sum - (basis.point_m - goal)), 1e-9);
        for (const HalfSpace& h : walls) EXPECT_GE(glm::dot(h.normal, basis.point_m), h.offset_m - 1e-9);
        ProjectionBasis warm = basis;
        ASSERT_TRUE(project_on_half_spaces(goal + random_point(random, 1e-9), static_cast<int>(count), at, warm));
        EXPECT_LE(glm::length(warm.point_m - basis.point_m), 1e-6);
    }
    EXPECT_GT(infeasible, 0) << "the generator should also make empty cells";
}

}  // namespace geometry_test
}  // namespace handrail::test
