// Tests one scene with every kind of obstacle: the nearest point, the surface there, and the number of contacts. The
// scene is near the world's origin or far from it.
#include "haptic/render/haptic_scene.h"

#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "tests/support/names.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace haptic_scene_test {

SurfaceLabel label(std::uint32_t feature) { return {FeatureId{feature}, 0, false}; }

// Returns one obstacle of every kind, ten metres apart along x. Each is 2 m wide and 2 m high and stands on z = 0.
std::shared_ptr<const HapticScene> one_of_each(const Vec3& at) {
    HapticSceneBuilder builder;
    const auto x = [&](int i) { return at + Vec3(10.0 * i, 0.0, 0.0); };
    builder.add_triangle(x(0) + Vec3(-1, 0, 0), x(0) + Vec3(1, 0, 0), x(0) + Vec3(0, 0, 2), label(10));
    const std::array<Vec3, 4> square{x(1) + Vec3(-1, 0, 0), x(1) + Vec3(1, 0, 0), x(1) + Vec3(1, 0, 2),
                                     x(1) + Vec3(-1, 0, 2)};
    const std::array<SurfaceLabel, 2> sides{label(20), label(21)};
    builder.add_polygon(square, sides);
    builder.add_box({x(2) - Vec3(1, 1, 0), x(2) + Vec3(1, 1, 2)}, label(30));
    const Vec3 up(0, 0, 1), slope = glm::normalize(Vec3(1, 0, 1));
    std::vector<Plane> planes{{up, 2}, {-up, 0}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {slope, 1.0}};
    for (Plane& plane : planes) plane.offset_m += glm::dot(plane.normal, x(3));
    builder.add_solid(planes, {x(3) - Vec3(1, 1, 0), x(3) + Vec3(1.5, 1, 2)}, label(40));
    builder.add_sphere({x(4) + up, 1.0}, label(50));
    builder.add_capsule({x(5) + 0.5 * up, up, 1.0, 0.5}, label(60));
    const std::array<SurfaceLabel, 3> cylinder{label(70), label(71), label(72)};
    builder.add_cylinder({x(6), up, 2.0, 1.0}, cylinder);
    const std::array<SurfaceLabel, 2> cone{label(80), label(81)};
    builder.add_cone(make_cone(x(7), up, 2.0, 1.0), cone);
    CustomObstacle custom;
    custom.closest = [](const Vec3& p, const void* data) noexcept {
        return closest_point(*static_cast<const SphereShape*>(data), p);
    };
    custom.data = std::make_shared<const SphereShape>(SphereShape{up, 1.0});
    custom.position_m = x(8);
    custom.bounds_m = {{-1, -1, 0}, {1, 1, 2}};
    EXPECT_TRUE(builder.add_custom(custom, label(90)));
    return builder.build();
}

TEST(HapticScene, gives_place_and_surface_of_every_kind_of_obstacle_near_and_far) {
    for (const Vec3& at : {Vec3(0.0), Vec3(4e5, -7e5, 3e4)}) {
        const auto scene = one_of_each(at);
        ASSERT_EQ(scene->obstacles.size(), kObstacleKinds);
        for (const std::size_t count : scene->obstacle_counts()) EXPECT_EQ(count, 1U);
        const auto look = [&](std::uint32_t obstacle, const Vec3& from) {
            const ClosestPoint q = scene->closest(obstacle, at + Vec3(10.0 * obstacle, 0, 0) + from - scene->origin_m);
            return std::pair{q.distance_m, scene->surface(obstacle, q.normal).feature.value};
        };
        struct Row {
            std::uint32_t obstacle;
            Vec3 from;
            double distance;
            std::uint32_t feature;
        };
        const double rounding = at == Vec3(0.0) ? 1e-12 : 1e-9;
        // For each sloping side, the query point is 1 m away from that side, along the side's normal.
        const Vec3 slope = glm::normalize(Vec3(1, 0, 1)), slant = glm::normalize(Vec3(2, 0, 1));
        for (const Row& row : {Row{0, {0, -3, 1}, 3, 10},
                               {0, {0, 3, 1}, 3, 10},
                               {1, {0.9, -3, 1}, 3, 20},
                               {1, {0.9, 3, 1}, 3, 21},
                               {2, {4, 0, 1}, 3, 30},
                               {3, Vec3(0.3, 0, std::sqrt(2.0) - 0.3) + slope, 1, 40},
                               {4, {0, 0, 5}, 3, 50},
                               {4, {3, 4, 1}, 4, 50},
                               {5, {3, 4, 1.2}, 4.5, 60},
                               {6, {3, 4, 1}, 4, 70},
                               {6, {0, 0, -2}, 2, 71},
                               {6, {0.3, 0, 5}, 3, 72},
                               {7, Vec3(0.5, 0, 1) + slant, 1, 80},
                               {7, {0, 0, 5}, 3, 80},
                               {7, {0.3, 0, -2}, 2, 81},
                               {8, {3, 4, 1}, 4, 90}}) {
            const auto [distance, feature] = look(row.obstacle, row.from);
            EXPECT_NEAR(distance, row.distance, rounding) << row.obstacle;
            EXPECT_EQ(feature, row.feature) << row.obstacle;
        }
        for (std::uint32_t i = 0; i < kObstacleKinds; ++i) EXPECT_EQ(scene->solid(i), i >= 2) << i;
    }
}

TEST(HapticScene, stops_the_proxy_at_every_kind_of_obstacle_with_the_label_of_the_face) {
    for (const Vec3& at : {Vec3(0.0), Vec3(4e5, -7e5, 3e4)}) {
        const auto scene = one_of_each(at);
        for (const auto& [x, feature] :
             {std::pair{20.0, 30U}, {40.0, 50U}, {50.0, 60U}, {60.0, 72U}, {70.0, 80U}, {80.0, 90U}}) {
            TouchState state;
            TouchTuning tuning;
            TouchResult r;
            for (double z = 2.1; z > 1.99; z -= 1e-3) r = touch_tick(state, *scene, tuning, at + Vec3(x, 0, z), 1e-3);
            EXPECT_NEAR(r.proxy_m.z - at.z, 2.005, 1e-8) << x;
            EXPECT_EQ(r.contacts.contacts[r.contacts.strongest].feature.value, feature);
            EXPECT_NEAR(r.force_n.z, 800 * (r.proxy_m.z - at.z - 1.991), 0.9);
        }
    }
}

// The solver must need at most three rounds to slide over a round solid, not dozens, even if the hand is deeper than
// the proxy's radius.
TEST(HapticScene, slides_over_round_solids_in_few_solver_rounds) {
    TouchWorld sphere, capsule, cylinder, cone;
    sphere.sphere({0, 0, 0}, .05);
    capsule.capsule({0, -.1, 0}, {0, .1, 0}, .05);
    cylinder.cylinder({0, -.1, 0}, {0, .1, 0}, .05);
    cone.cone({0, -.3, 0}, {0, .3, 0}, .1);
    for (const TouchWorld* world : {&sphere, &capsule, &cylinder, &cone}) {
        for (const double depth : {0.001, 0.004, 0.02, 0.04}) {
            TouchState state;
            TouchTuning tuning;
            const auto scene = world->scene();
            int most = 0;
            double rounds = 0, ticks = 0;
            for (double lift = 0.03; lift > -depth; lift -= 1e-4)
                touch_tick(state, *scene, tuning, {0, 0, 0.055 + lift}, 1e-3);
            // The hand rests until the proxy has reached its resting place. Then the hand circles at 0.1 m/s.
            for (int i = 0; i < 300; ++i) touch_tick(state, *scene, tuning, {0, 0, 0.055 - depth}, 1e-3);
            for (double turn = 0.0; turn < 2 * kPi; turn += 1e-4 / (0.055 - depth)) {
                const Vec3 goal = (0.055 - depth) * Vec3(std::sin(turn), 0, std::cos(turn));
                const TouchResult r = touch_tick(state, *scene, tuning, goal, 1e-3);
                most = std::max(most, int{r.contacts.iterations});
                rounds += r.contacts.iterations;
                ++ticks;
                ASSERT_TRUE(r.contacts.converged || r.contacts.capped);
            }
            std::cout << fmt::format("kind {}, {} mm deep: {:.2f} rounds a tick, {} at most\n",
                                     static_cast<int>(scene->obstacles[0].kind), 1e3 * depth, rounds / ticks, most);
            EXPECT_LE(rounds / ticks, 2.0);
            EXPECT_LE(most, 3);
        }
    }
}

}  // namespace haptic_scene_test
}  // namespace handrail::test
