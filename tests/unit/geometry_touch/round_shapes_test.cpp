// Compares spheres, capsules, cylinders and cones with a different implementation in long double. Also checks that at
// the closest point, the whole shape is behind the tangent plane.
#include "worlds/geometry/round_shapes.h"

#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace round_shapes_test {

double number(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
Vec3 point(std::mt19937& random, double half) {
    const double x = number(random, -half, half), y = number(random, -half, half), z = number(random, -half, half);
    return {x, y, z};
}

enum class Kind { Sphere, Capsule, Cylinder, Cone };

struct Shape {
    Kind kind = Kind::Sphere;
    Vec3 from_m{0.0}, axis{0.0, 0.0, 1.0};
    double height_m = 0.0, radius_m = 0.0;

    ClosestPoint closest(const Vec3& p) const {
        switch (kind) {
            case Kind::Sphere:
                return closest_point(SphereShape{from_m, radius_m}, p);
            case Kind::Capsule:
                return closest_point(CapsuleShape{from_m, axis, height_m, radius_m}, p);
            case Kind::Cylinder:
                return closest_point(CylinderShape{from_m, axis, height_m, radius_m}, p);
            default:
                return closest_point(make_cone(from_m, axis, height_m, radius_m), p);
        }
    }
    Nearest twin(const Vec3& p) const {
        // The coordinates are relative to `from_m`, so that a short axis keeps its direction far from the origin.
        const LVec a(0.0L), b = LVec(axis) * static_cast<long double>(height_m), at = LVec(p) - LVec(from_m);
        const auto radius = static_cast<long double>(radius_m);
        switch (kind) {
            case Kind::Sphere:
                return nearest_on_capsule(a, a, radius, at);
            case Kind::Capsule:
                return nearest_on_capsule(a, b, radius, at);
            case Kind::Cylinder:
                return nearest_on_cylinder(a, b, radius, at);
            default:
                return nearest_on_cone(a, b, radius, at);
        }
    }
    // Returns how far the shape extends along the unit direction `n`, measured from `from_m`.
    double reach(const Vec3& n) const {
        const double up = glm::dot(n, axis), across = glm::length(glm::cross(n, axis));
        switch (kind) {
            case Kind::Sphere:
                return radius_m;
            case Kind::Capsule:
                return std::max(0.0, height_m * up) + radius_m;
            case Kind::Cylinder:
                return std::max(0.0, height_m * up) + radius_m * across;
            default:
                return std::max(height_m * up, radius_m * across);
        }
    }
};

// Returns a shape of about 0.1 m. `form` selects ordinary and degenerate forms in turn: no radius, no height, neither,
// needles, discs.
Shape random_shape(Kind kind, int form, const Vec3& shift, std::mt19937& random) {
    Shape shape{kind, shift + point(random, 0.05), random_turn(random).turn[0], number(random, 0.01, 0.2),
                number(random, 0.01, 0.1)};
    if (form % 8 == 1 || form % 8 == 3) shape.radius_m = 0.0;
    if (form % 8 == 2 || form % 8 == 3) shape.height_m = 0.0;
    if (form % 8 == 4) shape.radius_m = 1e-7;
    if (form % 8 == 5) shape.height_m = 1e-7;
    // The reference implementation computes no direction for a shape without height, so the axis is set to +z.
    if (shape.height_m == 0.0) shape.axis = Vec3(0, 0, 1);
    return shape;
}

class RoundShape : public testing::TestWithParam<Kind> {
protected:
    std::uint32_t seed_ = 20261121U + static_cast<std::uint32_t>(GetParam());
    std::mt19937 random_{seed_};
};

TEST_P(RoundShape, agrees_with_brute_force_and_gives_a_supporting_plane_even_degenerate_or_far_away) {
    double worst = 0.0;
    for (int round = 0; round < scaled(20000); ++round) {
        const Vec3 shift = round % 3 == 0 ? Vec3(0.0) : round % 3 == 1 ? Vec3(1e3, -2e3, 500.0) : Vec3(7e5, 3e5, -9e5);
        const double rounding = round % 3 == 0 ? 1e-15 : round % 3 == 1 ? 2e-12 : 2e-9;
        const Shape shape = random_shape(GetParam(), round / 3, shift, random_);
        const Vec3 p = shift + point(random_, round % 5 == 1 ? 0.05 : 0.3);
        const ClosestPoint q = shape.closest(p);
        const Nearest twin = shape.twin(p);
        SCOPED_TRACE(fmt::format("seed {} round {}", seed_, round));
        ASSERT_NEAR(q.distance_m, static_cast<double>(twin.distance), rounding);
        ASSERT_NEAR(glm::length(q.normal), 1.0, 1e-15);
        ASSERT_NEAR(glm::dot(q.normal, p - q.point_m), q.distance_m, rounding);
        // No part of the shape may extend further along the normal than the closest point. The closest point must
        // belong to the shape.
        ASSERT_NEAR(glm::dot(q.normal, q.point_m - shape.from_m), shape.reach(q.normal), rounding);
        ASSERT_LE(std::abs(static_cast<double>(shape.twin(q.point_m).distance)), rounding);
        if (round % 3 == 0)
            worst =
                std::max(worst, std::abs(static_cast<double>(static_cast<long double>(q.distance_m) - twin.distance)));
    }
    std::cout << fmt::format("largest difference near the origin {:.1e} m\n", worst);
}

TEST_P(RoundShape, gives_a_repeatable_supporting_plane_on_and_very_near_the_axis) {
    for (int round = 0; round < scaled(3000); ++round) {
        const Shape shape = random_shape(GetParam(), round, Vec3(0.0), random_);
        const double size = shape.height_m + shape.radius_m;
        for (const double t : {-0.5, 0.0, 0.25, 0.5, 1.0, 1.5})
            for (const double aside : {0.0, 1e-15, 1e-13, 1e-11, 1e-9}) {
                const Vec3 p = shape.from_m + shape.axis * (t * size) + any_perpendicular(shape.axis) * aside;
                const ClosestPoint q = shape.closest(p);
                SCOPED_TRACE(fmt::format("seed {} round {} t {} aside {}", seed_, round, t, aside));
                ASSERT_NEAR(glm::length(q.normal), 1.0, 1e-15);
                ASSERT_NEAR(glm::dot(q.normal, q.point_m - shape.from_m), shape.reach(q.normal), 1e-15);
                ASSERT_NEAR(q.distance_m, static_cast<double>(shape.twin(p).distance), 2e-12);
                ASSERT_EQ(q.normal, shape.closest(p).normal);
            }
    }
}

TEST_P(RoundShape, lies_within_its_bounds_and_touches_them) {
    for (int round = 0; round < scaled(500); ++round) {
        const Shape shape = random_shape(GetParam(), round, Vec3(0.0), random_);
        const Aabb box = shape.kind == Kind::Sphere ? bounds_of(SphereShape{shape.from_m, shape.radius_m})
                         : shape.kind == Kind::Capsule
                             ? bounds_of(CapsuleShape{shape.from_m, shape.axis, shape.height_m, shape.radius_m})
                         : shape.kind == Kind::Cylinder
                             ? bounds_of(CylinderShape{shape.from_m, shape.axis, shape.height_m, shape.radius_m})
                             : bounds_of(make_cone(shape.from_m, shape.axis, shape.height_m, shape.radius_m));
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 n(0.0);
            n[axis] = 1.0;
            ASSERT_NEAR(box.max_m[axis], shape.from_m[axis] + shape.reach(n), 1e-15)
                << "seed " << seed_ << " round " << round;
            ASSERT_NEAR(box.min_m[axis], shape.from_m[axis] - shape.reach(-n), 1e-15);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, RoundShape, testing::Values(Kind::Sphere, Kind::Capsule, Kind::Cylinder, Kind::Cone));

TEST(FaceTowards, names_the_side_and_the_ends) {
    const CylinderShape cylinder{{0, 0, 0}, {0, 0, 1}, 2.0, 1.0};
    EXPECT_EQ(face_towards(cylinder, {1, 0, 0}), 0);
    EXPECT_EQ(face_towards(cylinder, {0, 0, -1}), 1);
    EXPECT_EQ(face_towards(cylinder, {0.1, 0, 0.99}), 2);
    const ConeShape cone = make_cone({0, 0, 0}, {0, 0, 1}, 2.0, 1.0);
    EXPECT_EQ(face_towards(cone, {cone.slant_out, 0, cone.slant_up}), 0);
    EXPECT_EQ(face_towards(cone, {0, 0, 1}), 0) << "the apex belongs to the side";
    EXPECT_EQ(face_towards(cone, {0.1, 0, -0.99}), 1);
}

// Returns a convex polygon: points of an ellipse in order. Some points are repeated or lie on an edge. Other forms are
// needles, degenerate polygons and single points.
std::vector<Vec3> random_polygon(int form, const Vec3& shift, std::mt19937& random) {
    const glm::dmat3 turn = random_turn(random).turn;
    const int count = 3 + static_cast<int>(random() % 7);
    double wide = 0.1, high = number(random, 0.01, 0.1);
    if (form % 6 == 1) high = 0.0;
    if (form % 6 == 2) high = wide = 0.0;
    if (form % 6 == 3) high = 1e-6;
    if (form % 6 == 4) high = 3e-8;
    std::vector<Vec3> corners;
    for (int i = 0; i < count; ++i) {
        const double at = 2 * kPi * (i + 0.3) / count;
        corners.push_back(shift + turn * Vec3(wide * std::cos(at), high * std::sin(at), 0.0));
    }
    if (form % 5 == 0) corners.push_back(corners.back());
    if (form % 5 == 1) corners.push_back(0.5 * (corners.back() + corners.front()));
    return corners;
}

TEST(ClosestPointOfPolygon, agrees_with_brute_force_from_every_first_corner_degenerate_and_far_from_origin) {
    constexpr std::uint32_t kSeed = 7;
    std::mt19937 random(kSeed);
    for (int round = 0; round < scaled(5000); ++round) {
        const Vec3 shift = round % 3 == 0 ? Vec3(0.0) : round % 3 == 1 ? Vec3(1e3, -2e3, 500.0) : Vec3(7e5, 3e5, -9e5);
        std::vector<Vec3> corners = random_polygon(round, shift, random);
        // Far from the origin, rounding moves the corners out of their plane, which adds to the error.
        const double rounding = round % 3 == 0 ? 1e-15 : round % 3 == 1 ? 3e-12 : 3e-9;
        const Vec3 p = shift + point(random, 0.2);
        const Nearest twin = nearest_on_polygon(std::vector<LVec>(corners.begin(), corners.end()), LVec(p));
        for (std::size_t turned = 0; turned < 2 * corners.size(); ++turned) {
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
            if (turned == corners.size()) std::reverse(corners.begin(), corners.end());
            std::vector<PolygonCorner> prepared;
            const Vec3 normal = make_polygon(corners, prepared);
            const PolygonShape polygon{normal, prepared};
            const ClosestPoint q = closest_point(polygon, p);
            const double slack = polygon.degenerate() ? 1e-7 : round % 6 == 3 ? 1e4 * rounding : 10 * rounding;
            SCOPED_TRACE(fmt::format("seed {} round {} degenerate {}", kSeed, round, polygon.degenerate()));
            ASSERT_NEAR(q.distance_m, static_cast<double>(twin.distance), slack);
            ASSERT_NEAR(glm::length(q.normal), 1.0, 1e-15);
            ASSERT_NEAR(glm::dot(q.normal, p - q.point_m), q.distance_m, slack);
            for (const Vec3& corner : corners) ASSERT_LE(glm::dot(q.normal, corner - q.point_m), 2 * slack);
        }
    }
}

TEST(ClosestPointOfPolygon, equals_the_triangle_answer_for_three_corners_bit_for_bit) {
    std::mt19937 random(8);
    for (int round = 0; round < scaled(3000); ++round) {
        const std::array<Vec3, 3> t{point(random, 0.1), point(random, 0.1), point(random, 0.1)};
        const TriangleShape triangle = make_triangle(t[0], t[1], t[2]);
        const std::array<Vec3, 3> in_order{triangle.a_m, triangle.b_m, triangle.c_m};
        std::vector<PolygonCorner> prepared;
        const PolygonShape polygon{make_polygon(in_order, prepared), prepared};
        const Vec3 p = point(random, 0.2);
        const ClosestPoint a = closest_point(triangle, p), b = closest_point(polygon, p);
        EXPECT_EQ(a.point_m, b.point_m);
        EXPECT_EQ(a.normal, b.normal);
        EXPECT_EQ(a.distance_m, b.distance_m);
    }
}

TEST(ClosestPointOfPolygon, on_the_sheet_itself_gives_a_supporting_normal) {
    std::mt19937 random(9);
    for (int round = 0; round < 600; ++round) {
        const std::vector<Vec3> corners = random_polygon(round, Vec3(0.0), random);
        std::vector<PolygonCorner> prepared;
        const PolygonShape polygon{make_polygon(corners, prepared), prepared};
        for (const Vec3& p :
             {corners[0], 0.5 * (corners[0] + corners[1]), (corners[0] + corners[1] + corners[2]) / 3.0}) {
            const ClosestPoint q = closest_point(polygon, p);
            ASSERT_LE(q.distance_m, polygon.degenerate() ? 1e-7 : 1e-12);
            ASSERT_NEAR(glm::length(q.normal), 1.0, 1e-15);
        }
    }
}

}  // namespace round_shapes_test
}  // namespace handrail::test
