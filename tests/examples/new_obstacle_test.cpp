// Defines a custom solid with exact contact. docs/developer/examples.md describes this example.
#include <random>

#include "haptic/render/haptic_scene.h"
#include "haptic/render/touch.h"

namespace handrail {
namespace new_obstacle_test {
using namespace render;

// The knob at the end of a handrail: an ellipsoid with the half axes `half_m`. The servo thread calls
// nearest_on_knob(), so that function must not allocate, lock or throw. It uses only + - * / and the square root, so
// that every machine computes the same numbers.
struct Knob {
    Vec3 half_m{0.05, 0.03, 0.02};
};

ClosestPoint nearest_on_knob(const Vec3& at, const void* data) noexcept {
    const Vec3& a = static_cast<const Knob*>(data)->half_m;
    const Vec3 a2 = a * a;
    // At the nearest point q, the vector at - q has the direction of the normal q / a2. So q = at a2 / (a2 + t), with
    // the t that puts q on the surface. Newton's method never overshoots if it starts from below. From anywhere
    // outside, 30 rounds are exact to rounding.
    double t = 0.0;
    for (int round = 0; round < 30; ++round) {
        const Vec3 share = a * at / (a2 + t);
        const double beyond = glm::dot(share, share) - 1.0;
        if (beyond <= 0.0) break;
        t += 0.5 * beyond / glm::dot(share * share, 1.0 / (a2 + t));
    }
    Vec3 q = at * a2 / (a2 + t);
    // Projects q onto the surface, so that the contact plane there is the surface's tangent plane. For a point inside
    // the knob, any tangent plane is valid.
    const Vec3 unit = q / a;
    const double length = glm::length(unit);
    q = length > 0.0 ? q / length : Vec3(0.0, 0.0, a.z);
    const Vec3 normal = glm::normalize(q / a2);
    return {q, normal, glm::dot(normal, at - q)};
}

std::shared_ptr<const HapticScene> handrail_with_knob() {
    CustomObstacle knob;
    knob.closest = nearest_on_knob;
    knob.data = std::make_shared<Knob>();
    knob.position_m = {0.0, 0.0, 1.0};
    knob.bounds_m = {Vec3(-0.05, -0.03, -0.02), Vec3(0.05, 0.03, 0.02)};
    HapticSceneBuilder builder;
    EXPECT_TRUE(builder.add_custom(knob, {FeatureId{1}}));
    builder.add_capsule({{-1.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 0.96, 0.015}, {FeatureId{2}});
    return builder.build();
}

// Returns the nearest of many sampled points of the knob. Each round samples more closely around the best point of the
// previous round.
Vec3 nearest_by_search(const Vec3& at) {
    const Vec3 half = Knob{}.half_m;
    double middle_u = 0.0, middle_v = 0.0, reach = kPi;
    Vec3 best(0.0);
    double best_m = 1e9;
    for (int round = 0; round < 30; ++round, reach *= 0.5) {
        const double u0 = middle_u, v0 = middle_v;
        for (int i = -12; i <= 12; ++i)
            for (int k = -12; k <= 12; ++k) {
                const double u = u0 + reach * i / 12.0, v = v0 + 0.5 * reach * k / 12.0;
                const Vec3 q = half * Vec3(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
                if (glm::length(at - q) >= best_m) continue;
                best_m = glm::length(at - q);
                best = q;
                middle_u = u;
                middle_v = v;
            }
    }
    return best;
}

TEST(Example, a_custom_solid_is_located_by_search_and_felt_there) {
    const auto scene = handrail_with_knob();
    std::mt19937 random(20261121);
    std::uniform_real_distribution<double> within(-0.15, 0.15);
    int outside = 0;
    while (outside < 200) {
        const Vec3 at(within(random), within(random), within(random));
        const ClosestPoint found = scene->closest(0, at + Vec3(0.0, 0.0, 1.0));
        const Vec3 share = at / Knob{}.half_m;
        if (glm::dot(share, share) <= 1.0) {
            EXPECT_LT(found.distance_m, 0.0);
            continue;
        }
        ++outside;
        EXPECT_NEAR(found.distance_m, glm::length(at - nearest_by_search(at)), 1e-9);
        EXPECT_LE(glm::length(found.point_m - Vec3(0.0, 0.0, 1.0) - nearest_by_search(at)), 1e-6);
        // Every point of the knob must be behind the contact plane.
        for (int k = 0; k < 100; ++k) {
            const Vec3 way(within(random), within(random), within(random));
            const Vec3 other = Knob{}.half_m * (way / glm::length(way));
            EXPECT_LE(glm::dot(found.normal, other + Vec3(0.0, 0.0, 1.0) - found.point_m), 1e-15);
        }
    }
}

TEST(Example, the_proxy_goes_round_a_custom_solid_without_entering_it) {
    const auto scene = handrail_with_knob();
    TouchState state;
    TouchTuning tuning;
    tuning.radius_m = 0.005;
    tuning.slide_cap_hand_m = 1.0;
    int touched = 0;
    for (int i = 0; i <= 2000; ++i) {
        const double angle = -0.6 * kPi + 1.2 * kPi * i / 2000.0;
        const Vec3 ring(0.052 * std::cos(angle), 0.0,
                        0.022 * std::sin(angle) + 1.0);  // the proxy's centre would be 3 mm too near to the knob here
        const TouchResult felt = touch_tick(state, *scene, tuning, i == 0 ? Vec3(-0.1, 0.0, 0.9) : ring, 1e-3);
        EXPECT_GE(scene->closest(0, felt.proxy_m).distance_m, 0.005 - 1e-8);
        for (int k = 0; k < felt.contacts.count; ++k)
            touched += felt.contacts.contacts[static_cast<std::size_t>(k)].feature == FeatureId{1};
    }
    EXPECT_GT(touched, 1500);
}

TEST(Example, a_solid_that_breaks_its_contract_is_refused) {
    HapticSceneBuilder builder;
    CustomObstacle knob;
    knob.bounds_m = {Vec3(-0.05), Vec3(0.05)};
    EXPECT_FALSE(builder.add_custom(knob)) << "no function";
    // A dumb-bell is not convex: the contact plane at one of its balls cuts the other ball.
    knob.closest = [](const Vec3& at, const void*) noexcept {
        const SphereShape one{{0.03, 0.0, 0.0}, 0.02}, other{{-0.03, 0.0, 0.0}, 0.02};
        return closest_point(at.x > 0.0 ? one : other, at);
    };
    EXPECT_FALSE(builder.add_custom(knob));
    EXPECT_TRUE(builder.build()->obstacles.empty());
}

}  // namespace new_obstacle_test
}  // namespace handrail
