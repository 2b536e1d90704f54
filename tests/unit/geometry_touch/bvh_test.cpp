// Tests the box hierarchy. A scan of all boxes is the reference. The boxes are scattered, all in one place, empty, far
// away, or moved at random.
#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/sphere_mesh.h"
#include "worlds/geometry/bvh.h"

namespace handrail::test {
namespace bvh_test {

constexpr std::uint32_t kSeed = 20240712;

double between(std::mt19937& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}
Vec3 in_cube(std::mt19937& random, double half) {
    const double x = between(random, -half, half), y = between(random, -half, half), z = between(random, -half, half);
    return {x, y, z};
}

// Returns boxes of one kind: scattered, thin, points in one place, a row, or nested. Some boxes are empty.
std::vector<Aabb> random_boxes(std::mt19937& random, int count, const Vec3& shift) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < count; ++i) {
        const int kind = i % 6;
        const Vec3 p = shift + (kind == 0 ? Vec3(0.0) : kind == 1 ? Vec3(i * 0.01, 0, 0) : in_cube(random, 5.0));
        const double size = kind == 2 ? 0.0 : kind == 3 ? between(random, 0.0, 8.0) : 0.5;
        boxes.push_back({p, p + glm::abs(in_cube(random, size)) * (kind == 4 ? Vec3(1, 1e-9, 1) : Vec3(1.0))});
        if (i % 50 == 7) boxes.back() = Aabb{};
    }
    return boxes;
}

std::vector<std::uint32_t> scan(const std::vector<Aabb>& boxes, const Vec3& p, double reach) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty() && distance_squared(boxes[i], p) <= reach * reach) found.push_back(i);
    return found;
}

double nearest_of(const std::vector<Aabb>& boxes, const Vec3& p) {
    double nearest2 = std::numeric_limits<double>::infinity();
    for (const Aabb& box : boxes)
        if (!box.empty()) nearest2 = std::min(nearest2, distance_squared(box, p));
    return std::sqrt(nearest2);
}

// Compares every query with a full scan. Visits to boxes beyond the reach only cost time, so the test limits their
// number and nothing else.
void expect_right(const Bvh& bvh, const std::vector<Aabb>& boxes, std::mt19937& random, const Vec3& around,
                  const std::string& what) {
    constexpr int kPlenty = 1 << 20;
    Bvh::Queue queue(kPlenty), small(64);
    for (int query = 0; query < 50; ++query) {
        SCOPED_TRACE(fmt::format("{}, query {}, seed {}", what, query, kSeed));
        const Vec3 p = around + in_cube(random, query % 10 == 0 ? 300.0 : 6.0);
        const double reach = query % 10 == 0 ? 300.0 : 0.02 * query;
        const std::vector<std::uint32_t> expected = scan(boxes, p, reach);
        const auto inside = [&](std::uint32_t item) { return distance_squared(boxes[item], p) <= reach * reach; };
        std::vector<std::uint32_t> found, in_order;
        std::size_t visits = 0;
        bvh.within(p, reach, [&](std::uint32_t item, double&) {
            ++visits;
            if (inside(item)) found.push_back(item);
        });
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected);
        const double slack = 1e-5 * (reach + glm::length(p - around) + 10.0);
        ASSERT_LE(visits, scan(boxes, p, reach + slack).size());

        int looks = kPlenty;
        const double known = bvh.nearest_first(p, reach, looks, queue, [&](std::uint32_t item, double&) {
            if (inside(item)) in_order.push_back(item);
        });
        EXPECT_EQ(known, reach);
        std::sort(in_order.begin(), in_order.end());
        ASSERT_EQ(in_order, expected);

        // Finds the nearest box by lowering the reach. The second query may return a lower bound that is smaller by a
        // factor of 0.7.
        const double nearest = nearest_of(boxes, p);
        double best = 1e9, loose = 1e9;
        bvh.within(p, 1e9, [&](std::uint32_t item, double& lower) {
            best = std::min(best, std::sqrt(distance_squared(boxes[item], p)));
            lower = best;
        });
        looks = kPlenty;
        const double bound = bvh.nearest_first(p, 1e9, looks, queue, [&](std::uint32_t item, double& lower) {
            loose = std::min(loose, std::sqrt(distance_squared(boxes[item], p)));
            lower = std::min(lower, 0.7 * loose);
        });
        if (!scan(boxes, p, 1e9).empty()) {
            EXPECT_DOUBLE_EQ(best, nearest);
            EXPECT_LE(bound, nearest);
            EXPECT_GE(bound, 0.7 * nearest * (1.0 - 1e-12));
        }

        // If a query may examine only a few boxes, it must examine no more than that number. It must have visited every
        // box that is nearer than its answer.
        std::vector<bool> visited(boxes.size(), false);
        looks = 1 + query;
        int used = 0;
        const double known_with_few = bvh.nearest_first(p, reach, looks, small, [&](std::uint32_t item, double&) {
            visited[item] = true;
            ++used;
        });
        EXPECT_GE(looks, 0);
        EXPECT_LE(used, 1 + query);
        EXPECT_LE(known_with_few, reach);
        for (const std::uint32_t item : expected)
            if (std::sqrt(distance_squared(boxes[item], p)) < known_with_few) {
                ASSERT_TRUE(visited[item]);
            }
    }
}

TEST(Bvh, answers_like_a_full_scan_for_many_things_in_one_place_and_far_from_the_origin) {
    std::mt19937 random(kSeed);
    for (const Vec3 shift : {Vec3(0.0), Vec3(1e3, -2e3, 500.0), Vec3(1e6, 1e6, -1e6)})
        for (const int count : {0, 1, 2, 3, 4, 5, 6, 16, 17, 18, 33, 400, scaled(3000)}) {
            const std::vector<Aabb> boxes = random_boxes(random, count, shift);
            expect_right(Bvh(boxes), boxes, random, shift, fmt::format("{} boxes at {}", count, shift.x));
        }
}

TEST(Bvh, stays_within_its_budget_of_looks_when_everything_is_equally_near) {
    // In the middle of a round room, no order of the 20,480 triangles saves time, because all are equally far away.
    // After a hundred examined boxes, the query must stop and still return a lower bound for the distance.
    const TriangleMesh mesh = sphere_mesh(32, 0.006);
    std::vector<Aabb> boxes;
    for (const Corners& t : mesh.triangles) {
        Aabb box;
        for (const std::uint32_t corner : t) box.include(mesh.points_m[corner]);
        boxes.push_back(box);
    }
    const Bvh bvh(boxes);
    Bvh::Queue queue(100);
    int looks = 100, visits = 0;
    const double known = bvh.nearest_first(Vec3(1e-7), 0.025, looks, queue, [&](std::uint32_t, double&) { ++visits; });
    EXPECT_EQ(looks, 0);
    EXPECT_LT(visits, 100);
    EXPECT_GT(known, 0.004);
    EXPECT_LT(known, 0.006);
}

TEST(Bvh, takes_at_most_48_bytes_per_item) {
    std::mt19937 random(kSeed);
    for (const int count : {1000, 20000}) {
        const std::vector<Aabb> boxes = random_boxes(random, count, Vec3(0.0));
        EXPECT_LE(Bvh(boxes).bytes(), static_cast<std::size_t>(48 * count));
    }
}

}  // namespace bvh_test
}  // namespace handrail::test
