// Tests the box hierarchy for lines and boxes. A scan of all boxes is the reference.
#include <random>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "worlds/geometry/box_index.h"

namespace handrail::test {
namespace box_index_test {

constexpr std::uint32_t kSeed = 20261123;

double between(std::mt19937& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}
Vec3 in_cube(std::mt19937& random, double half) {
    const double x = between(random, -half, half), y = between(random, -half, half), z = between(random, -half, half);
    return {x, y, z};
}

std::vector<Aabb> random_boxes(std::mt19937& random, int count, const Vec3& shift) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < count; ++i) {
        const Vec3 p = shift + (i % 5 == 0 ? Vec3(0.0) : in_cube(random, 5.0));
        boxes.push_back({p, p + (i % 7 == 0 ? Vec3(0.0) : glm::abs(in_cube(random, i % 11 == 0 ? 6.0 : 0.5)))});
        if (i % 50 == 7) boxes.back() = Aabb{};
    }
    return boxes;
}

// Returns the fraction of the path at which the line enters the box, grown by `low` and `high`. The fraction is above 1
// if the line never enters that box.
double enters(const Aabb& box, const Vec3& from, const Vec3& to, const Vec3& low, const Vec3& high) {
    double in = 0.0, out = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = box.min_m[axis] - low[axis] - from[axis], b = box.max_m[axis] + high[axis] - from[axis],
                     way = to[axis] - from[axis];
        if (way == 0.0) {
            if (a > 0.0 || b < 0.0) return 2.0;
            continue;
        }
        in = std::max(in, std::min(a / way, b / way));
        out = std::min(out, std::max(a / way, b / way));
    }
    return in <= out ? in : 2.0;
}

TEST(BoxIndex, finds_the_same_boxes_and_lines_as_a_full_scan) {
    std::mt19937 random(kSeed);
    for (const Vec3 shift : {Vec3(0.0), Vec3(1e6, -1e6, 3.0)})
        for (const int count : {0, 1, 4, 5, 200}) {
            const std::vector<Aabb> boxes = random_boxes(random, count, shift);
            const BoxIndex tree(boxes);
            for (int query = 0; query < 200; ++query) {
                SCOPED_TRACE(fmt::format("{} boxes, query {}, seed {}", count, query, kSeed));
                const Vec3 from = shift + in_cube(random, 7.0);
                Vec3 to = shift + in_cube(random, 7.0);
                if (query % 4 == 0) to[query % 3] = from[query % 3];
                Aabb requested;
                requested.include(from);
                requested.include(to);
                std::vector<bool> met(boxes.size(), false), seen(boxes.size(), false);
                tree.meeting(requested, [&](std::uint32_t i) { met[i] = true; });
                const Vec3 low(0.1, 0.2, 0.3), high(0.3, 0.2, 0.1);
                tree.along(from, to, low, high, [&](std::uint32_t i, double&) { seen[i] = true; });
                double nearest = 2.0, reported = 2.0;
                for (std::uint32_t i = 0; i < boxes.size(); ++i) {
                    if (boxes[i].empty()) {
                        EXPECT_FALSE(met[i] || seen[i]);
                        continue;
                    }
                    if (BoxIndex::meets(boxes[i], requested)) {
                        EXPECT_TRUE(met[i]) << i;
                    }
                    const double in = enters(boxes[i], from, to, low, high);
                    if (in <= 1.0) {
                        EXPECT_TRUE(seen[i]) << i;
                    }
                    nearest = std::min(nearest, in);
                }
                // If the first box on the path ends the query, the index must find the nearest box and examine no box
                // behind it.
                std::size_t looks = 0;
                tree.along(from, to, low, high, [&](std::uint32_t i, double& reach) {
                    ++looks;
                    if (const double in = enters(boxes[i], from, to, low, high); in <= 1.0)
                        reach = reported = std::min(reported, in);
                });
                EXPECT_EQ(reported, nearest);
                EXPECT_LE(looks, static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true)));
            }
        }
}

}  // namespace box_index_test
}  // namespace handrail::test
