// Tests volume, centre and second moments of solids, at any place and rotation. A count of many points is the
// reference.
#include "worlds/geometry/mass_properties.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "tests/support/names.h"
#include "worlds/geometry/clip.h"

namespace handrail {
namespace mass_properties_test {

// Computes the properties by counting the midpoints of a fine grid that are inside.
template <class Inside>
MassProperties counted(const Aabb& box, Inside&& inside) {
    constexpr int kSteps = 70;
    const Vec3 step = box.size_m() / static_cast<double>(kSteps);
    double count = 0.0;
    Vec3 first(0.0);
    Spread second{Vec3(0.0), Vec3(0.0), Vec3(0.0)};
    for (int x = 0; x < kSteps; ++x)
        for (int y = 0; y < kSteps; ++y)
            for (int z = 0; z < kSteps; ++z) {
                const Vec3 p = (Vec3(x, y, z) + 0.5) * step;
                if (!inside(box.min_m + p)) continue;
                count += 1.0;
                first += p;
                for (int k = 0; k < 3; ++k) second[static_cast<std::size_t>(k)] += p * p[k];
            }
    const double cell = step.x * step.y * step.z;
    MassProperties out;
    out.volume_m3 = count * cell;
    const Vec3 middle = first / count;
    out.middle_m = box.min_m + middle;
    for (int k = 0; k < 3; ++k)
        out.spread_m5[static_cast<std::size_t>(k)] =
            (second[static_cast<std::size_t>(k)] - middle * (middle[k] * count)) * cell;
    return out;
}

void expect_near(const MassProperties& a, const MassProperties& b, double size_m, double part) {
    EXPECT_NEAR(a.volume_m3, b.volume_m3, part * b.volume_m3);
    EXPECT_LT(glm::length(a.middle_m - b.middle_m), part * size_m);
    const double trace = b.spread_m5[0].x + b.spread_m5[1].y + b.spread_m5[2].z;
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_LT(glm::length(a.spread_m5[k] - b.spread_m5[k]), 2.0 * part * trace) << k;
}

TEST(MassProperties, of_flat_solids_agree_with_counted_points_even_far_from_the_origin) {
    std::mt19937 random(3);
    const auto unit = [&] { return random() / 4294967296.0 - 0.5; };
    int looked_at = 0;
    for (int round = 0; round < 24; ++round) {
        const Vec3 at = round % 2 ? Vec3(0.0) : Vec3(3000.0, -200.0, 50.0);
        std::vector<Plane> planes;
        for (int i = 0; i < 12; ++i) {
            const Vec3 n = glm::normalize(Vec3(unit(), unit(), unit()));
            planes.push_back({n, glm::dot(n, at) + 0.4 + 0.3 * unit()});
        }
        const BuiltSolid built = solid_from_planes(planes, at, 100.0);
        const Vec3 size = built.solid.bounds_m.size_m();
        if (built.fault != SolidFault::None || std::max({size.x, size.y, size.z}) > 3.0)
            continue;  // the solid is invalid, or so long that the count of points would be too coarse
        ++looked_at;
        const MassProperties exact = mass_properties(built.solid);
        expect_near(exact, counted(built.solid.bounds_m, [&](const Vec3& p) { return contains(built.solid, p); }), 1.0,
                    0.01);
        // In the frame of the principal axes, the second moments must be diagonal.
        const PrincipalAxes axes = principal_axes(exact.spread_m5);
        const PlacedFrame frame(Placement{Vec3(0.0), axes.rotation, 1.0});
        const auto times = [&](const Vec3& v) {
            return Vec3(glm::dot(exact.spread_m5[0], v), glm::dot(exact.spread_m5[1], v),
                        glm::dot(exact.spread_m5[2], v));
        };
        const double trace = exact.spread_m5[0].x + exact.spread_m5[1].y + exact.spread_m5[2].z;
        for (int i = 0; i < 3; ++i) {
            const Vec3& a = frame.axes[static_cast<std::size_t>(i)];
            EXPECT_NEAR(trace - glm::dot(a, times(a)), axes.inertia_m5[i], 1e-12 * trace);
            EXPECT_NEAR(glm::dot(a, times(frame.axes[static_cast<std::size_t>((i + 1) % 3)])), 0.0, 1e-11 * trace);
        }
    }
    EXPECT_GE(looked_at, 6);
}

TEST(MassProperties, of_round_solids_agree_with_counted_points) {
    const Vec3 axis = glm::normalize(Vec3(1, 2, 3)), at(1, -2, 0.5);
    for (const RoundShape& shape :
         {RoundShape(SphereShape{at, 0.3}), RoundShape(CapsuleShape{at, axis, 0.4, 0.2}),
          RoundShape(CylinderShape{at, axis, 0.5, 0.2}), RoundShape(make_cone(at, axis, 0.6, 0.3))}) {
        const auto [box, inside] = std::visit(
            [&](const auto& s) -> std::pair<Aabb, std::function<bool(const Vec3&)>> {
                if constexpr (std::is_same_v<std::decay_t<decltype(s)>, std::monostate>) return {};
                else return {bounds_of(s), [s](const Vec3& p) { return closest_point(s, p).distance_m <= 0.0; }};
            },
            shape);
        expect_near(mass_properties(shape), counted(box, inside), 0.5, 0.015);
    }
    EXPECT_EQ(mass_properties(RoundShape{}).volume_m3, 0.0);
    EXPECT_EQ(mass_properties(RoundShape(SphereShape{})).volume_m3, 0.0);
    EXPECT_EQ(mass_properties(ConvexSolid{}).volume_m3, 0.0);
}

TEST(MassProperties, of_two_parts_equal_those_of_the_whole) {
    const auto box = [](const Vec3& low, const Vec3& high) {
        std::vector<Plane> planes;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                Vec3 n(0.0);
                n[axis] = side;
                planes.push_back({n, side < 0 ? -low[axis] : high[axis]});
            }
        return mass_properties(solid_from_planes(planes, 0.5 * (low + high), 100.0).solid);
    };
    const MassProperties whole = box(Vec3(0.0), Vec3(3, 1, 1)),
                         parts = together(box(Vec3(0.0), Vec3(1, 1, 1)), box(Vec3(1, 0, 0), Vec3(3, 1, 1)));
    expect_near(parts, whole, 1.0, 1e-12);
    EXPECT_EQ(principal_axes(whole.spread_m5).rotation, Rotation{}) << "axes that are principal stay";
    EXPECT_EQ(together({}, {}).volume_m3, 0.0);
}

}  // namespace mass_properties_test
}  // namespace handrail
