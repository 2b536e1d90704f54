#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/geometry/clip.h"

namespace handrail {
namespace solid_test {

std::vector<Plane> box_planes(const Vec3& low, const Vec3& high) {
    return {{{1, 0, 0}, high.x},  {{-1, 0, 0}, -low.x}, {{0, 1, 0}, high.y},
            {{0, -1, 0}, -low.y}, {{0, 0, 1}, high.z},  {{0, 0, -1}, -low.z}};
}

Vec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    for (;;) {
        const Vec3 v{normal(random), normal(random), normal(random)};
        if (glm::length(v) > 1e-3) return glm::normalize(v);
    }
}

// An independent brute-force computation: a corner is a point where three planes meet and which is behind all other
// planes.
std::vector<Vec3> corners_by_triples(const std::vector<Plane>& planes) {
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i < planes.size(); ++i)
        for (std::size_t j = i + 1; j < planes.size(); ++j)
            for (std::size_t k = j + 1; k < planes.size(); ++k) {
                const Vec3 jk = glm::cross(planes[j].normal, planes[k].normal);
                const double det = glm::dot(planes[i].normal, jk);
                if (std::abs(det) < 1e-9) continue;
                const Vec3 p =
                    (planes[i].offset_m * jk + planes[j].offset_m * glm::cross(planes[k].normal, planes[i].normal) +
                     planes[k].offset_m * glm::cross(planes[i].normal, planes[j].normal)) /
                    det;
                if (std::all_of(planes.begin(), planes.end(),
                                [&](const Plane& plane) { return signed_distance(plane, p) < 1e-7; }))
                    corners.push_back(p);
            }
    return corners;
}

bool holds_near(const std::vector<Vec3>& points, const Vec3& wanted, double tolerance) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec3& p) { return glm::length(p - wanted) < tolerance; });
}

TEST(SolidFromPlanes, gives_a_box_its_exact_corners) {
    const BuiltSolid built = solid_from_planes(box_planes({0.1, 0.2, 0.3}, {1.7, 2.9, 3.3}), {0, 0, 0}, 100.0);
    ASSERT_EQ(built.fault, SolidFault::None);
    EXPECT_EQ(built.solid.bounds_m.min_m, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(built.solid.bounds_m.max_m, Vec3(1.7, 2.9, 3.3));
    ASSERT_EQ(built.solid.faces.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(built.solid.faces[i].points_m.size(), 4U);
        EXPECT_GT(glm::dot(area_vector_m2(built.solid.faces[i].points_m), built.solid.planes[i].normal), 0.0)
            << "counter-clockwise from outside";
        for (const Vec3& p : built.solid.faces[i].points_m)
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_TRUE(p[axis] == built.solid.bounds_m.min_m[axis] || p[axis] == built.solid.bounds_m.max_m[axis]);
    }
}

TEST(SolidFromPlanes, agrees_with_brute_force_on_random_solids_in_any_order_of_planes) {
    const int rounds = test::scaled(300);
    for (int seed = 0; seed < rounds; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        const Vec3 middle = 50.0 * random_direction(random);
        std::vector<Plane> planes = box_planes(middle - Vec3{2.0}, middle + Vec3{2.0});
        std::uniform_real_distribution<double> distance(0.3, 2.5);
        for (int i = 0; i < 2 + seed % 12; ++i) {
            const Vec3 n = random_direction(random);
            planes.push_back({n, glm::dot(n, middle) + distance(random)});
        }
        std::shuffle(planes.begin(), planes.end(), random);
        const BuiltSolid built = solid_from_planes(planes, middle, 200.0);
        ASSERT_EQ(built.fault, SolidFault::None);
        std::vector<Vec3> corners;
        for (const Polygon& face : built.solid.faces)
            corners.insert(corners.end(), face.points_m.begin(), face.points_m.end());
        const std::vector<Vec3> wanted = corners_by_triples(planes);
        for (const Vec3& p : wanted) EXPECT_TRUE(holds_near(corners, p, 1e-4));
        for (const Vec3& p : corners) EXPECT_TRUE(holds_near(wanted, p, 1e-4));
        // The area vectors of all faces of a closed surface must add up to zero.
        Vec3 sum{0.0};
        for (const Polygon& face : built.solid.faces) sum += area_vector_m2(face.points_m);
        EXPECT_LT(glm::length(sum), 1e-4);
    }
}

TEST(SolidFromPlanes, distinguishes_open_empty_and_inside_out) {
    std::vector<Plane> planes = box_planes({0, 0, 0}, {1, 1, 1});
    planes.pop_back();
    EXPECT_EQ(solid_from_planes(planes, {0, 0, 0}, 100.0).fault, SolidFault::Open);
    planes = box_planes({0, 0, 0}, {1, 1, 1});
    planes.push_back({{1, 0, 0}, -5.0});  // a plane that cuts everything away
    EXPECT_EQ(solid_from_planes(planes, {0, 0, 0}, 100.0).fault, SolidFault::Empty);
    EXPECT_EQ(solid_from_planes({}, {0, 0, 0}, 100.0).fault, SolidFault::Empty);
    std::vector<Plane> turned = box_planes({0, 0, 0}, {1, 1, 1});
    for (Plane& plane : turned) plane = {-plane.normal, -plane.offset_m};
    const BuiltSolid built = solid_from_planes(turned, {0, 0, 0}, 100.0);
    EXPECT_EQ(built.fault, SolidFault::None);
    EXPECT_TRUE(built.was_inside_out);
    EXPECT_EQ(built.solid.bounds_m.max_m, Vec3(1, 1, 1));
}

TEST(SolidFromPlanes, drops_repeated_planes_and_planes_that_touch_nothing) {
    std::vector<Plane> planes = box_planes({0, 0, 0}, {1, 1, 1});
    planes.push_back(planes[2]);
    planes.push_back({{0, 0, 1}, 7.0});
    const BuiltSolid built = solid_from_planes(planes, {0, 0, 0}, 100.0);
    EXPECT_EQ(built.solid.faces.size(), 6U);
    EXPECT_EQ(built.planes_without_face, 2);
    EXPECT_THAT(built.plane_index, testing::ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(PlaneFromClockwise, points_outward_and_refuses_collinear_points) {
    Plane plane;
    ASSERT_TRUE(plane_from_clockwise({0, 0, 5}, {0, 1, 5}, {1, 0, 5}, plane));
    EXPECT_EQ(plane.normal, Vec3(0, 0, 1));
    EXPECT_EQ(plane.offset_m, 5.0);
    EXPECT_FALSE(plane_from_clockwise({0, 0, 0}, {1, 1, 1}, {3, 3, 3}, plane));
    EXPECT_FALSE(plane_from_clockwise({1, 2, 3}, {1, 2, 3}, {3, 3, 3}, plane));
}

TEST(Split, preserves_the_total_area_of_both_sides) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> offset(-1.2, 1.2);
    const std::vector<Vec3> square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    std::vector<Vec3> back, front;
    for (int i = 0; i < 1000; ++i) {
        const Plane plane{random_direction(random), offset(random)};
        split(square, plane, 1e-9, back, front);
        EXPECT_NEAR(area_m2(back) + area_m2(front), 4.0, 1e-7);
        for (const Vec3& p : back) EXPECT_LE(signed_distance(plane, p), 1e-8);
        for (const Vec3& p : front) EXPECT_GE(signed_distance(plane, p), -1e-8);
    }
}

}  // namespace solid_test
}  // namespace handrail
