// Compares friction in every tick with the static solution, computed by hand. The hand's straight path meets a surface
// at one point. From there the proxy lags behind its resting place by the friction coefficient times the depth. If the
// path along the surface is shorter than that, the lag is the path's length. Motion before that point does not count:
// at any speed, a straight press feels as if there were no friction.
#include <array>
#include <random>

#include "haptic/render/proxy_solver.h"
#include "haptic/render/touch.h"
#include "settings/settings.h"
#include "tests/support/names.h"
#include "tests/support/sphere_mesh.h"
#include "tests/support/touch_worlds.h"

namespace handrail::test {
namespace friction_exact_test {

constexpr double kTick_s = 1e-3, kRadius_m = 0.005;
// Tolerance of lag and position. For a solid, the side of the solid is exact at any distance. For triangles, the proxy
// touches a triangle if it is nearer than 1e-8 m, so lag and position may each differ by this much. No path here
// crosses the seam between two triangles. At a seam the solver's rounds bend the proxy's path aside by up to 0.03 mm,
// and friction preserves the displacement.
constexpr double exact_m(int form) { return form == 2 ? 3e-8 : 1e-12; }

// The friction coefficients of the tests: the program's default, slippery, rough, and too rough to slip at a right
// angle.
std::vector<double> coefficients() { return {Settings().haptic.friction_mu, 0.02, 0.4, 0.9, 2.0}; }

TouchTuning rubbing(double mu) {
    TouchTuning tuning;
    tuning.radius_m = kRadius_m;
    tuning.override_stiffness_n_per_m = 1000.0;
    tuning.default_friction_static = tuning.default_friction_kinetic = mu;
    return tuning;
}

// Returns the same slab, whose upper side is z = 0, as a box, a brush or triangles. If `wall` is true, it has a wall at
// x = 0.1.
TouchWorld slab(int form, bool wall) {
    TouchWorld world;
    const auto add = [&](const Vec3& low, const Vec3& high) {
        if (form == 0) world.box(low, high);
        if (form == 1) world.brush_box(low, high);
        if (form == 2) world.box_of_triangles(low, high);
    };
    add({-1, -1, -0.3}, {1, 1, 0});
    if (wall) add({0.1, -1, -0.2}, {0.4, 1, 0.5});
    return world;
}

// Calls `each` for slabs that are rotated and shifted at random, in every form and with every coefficient and speed.
// `each` receives a scene, the slab's motion, a tuning and the tolerance.
template <class Each>
void on_slabs(bool wall, const Each& each) {
    std::mt19937 random(5);
    for (int form = 0; form < 3; ++form)
        for (const double mu : coefficients())
            for (const double speed : {0.05, 0.3, 1.0, 5.0}) {
                Motion motion = random_turn(random);
                motion.shift_m = Vec3(3.0, -2.0, 1.0);
                SCOPED_TRACE(fmt::format("form {}, mu {}, {} m/s", form, mu, speed));
                each(*slab(form, wall).scene(motion), motion, rubbing(mu), mu, speed, exact_m(form));
            }
}

// Moves the hand from a to b at `speed`, so that it is at b in the last tick. `check` receives the hand's position and
// the force, both in the slab's frame.
template <class Check>
void go(TouchState& state, const HapticScene& scene, const Motion& motion, const TouchTuning& tuning, const Vec3& a,
        const Vec3& b, double speed, const Check& check) {
    const int ticks = std::max(1, static_cast<int>(std::ceil(glm::length(b - a) / (speed * kTick_s))));
    for (int i = 0; i <= ticks; ++i) {
        const Vec3 hand = a + (b - a) * (static_cast<double>(i) / ticks);
        const TouchResult r = touch_tick(state, scene, tuning, motion(hand), kTick_s);
        check(hand, motion.back(r.proxy_m), r);
    }
}

double straight_press_n(double mu, double speed) {
    TouchState state;
    double force_n = 0.0;
    const auto scene = slab(0, false).scene();
    go(state, *scene, {}, rubbing(mu), {0, 0, 0.0303}, {0, 0, kRadius_m - 0.012}, speed,
       [&](const Vec3&, const Vec3&, const TouchResult& r) { force_n = r.force_n.z; });
    return force_n;
}

TEST(FrictionExact, a_straight_press_of_twelve_newtons_is_felt_as_twelve_newtons_at_any_speed) {
    for (const double mu : coefficients())
        for (const double speed : {0.05, 0.3, 1.0, 5.0})
            EXPECT_NEAR(straight_press_n(mu, speed), 12.0, 1e-9) << mu << ", " << speed << " m/s";
}

TEST(FrictionExact, a_straight_press_feels_frictionless_on_every_tick) {
    on_slabs(false, [](const HapticScene& scene, const Motion& motion, const TouchTuning& tuning, double, double speed,
                       double exact_m) {
        TouchState state;
        bool touched = false;
        go(state, scene, motion, tuning, {0.017, 0.431, 0.0303}, {0.017, 0.431, -0.008}, speed,
           [&](const Vec3& hand, const Vec3& proxy, const TouchResult& r) {
               ASSERT_NEAR(glm::length(proxy - Vec3(hand.x, hand.y, std::max(hand.z, kRadius_m))), 0.0, exact_m)
                   << hand.z;
               touched = touched || r.contacts.count > 0;
           });
        EXPECT_TRUE(touched);
    });
}

TEST(FrictionExact, a_slanted_press_lags_by_its_movement_along_the_surface_or_by_the_friction_cone) {
    on_slabs(false, [](const HapticScene& scene, const Motion& motion, const TouchTuning& tuning, double mu,
                       double speed, double exact_m) {
        for (const double slant : {0.1, 0.6, 1.5}) {
            SCOPED_TRACE(slant);
            TouchState state;
            const Vec3 begin(0.0, 0.4, 0.0303), end(slant * 0.0383, 0.4, -0.008);
            const double first_x = slant * (begin.z - kRadius_m);  // x of the point where the path meets the surface
            go(state, scene, motion, tuning, begin, end, speed,
               [&](const Vec3& hand, const Vec3& proxy, const TouchResult&) {
                   const double press = std::max(0.0, kRadius_m - hand.z),
                                lag = std::min(std::max(0.0, hand.x - first_x), mu * press);
                   ASSERT_NEAR(glm::length(proxy - (hand + Vec3(-lag, 0.0, press))), 0.0, exact_m) << hand.z;
               });
        }
    });
}

TEST(FrictionExact, a_slide_drags_in_proportion_to_the_press_and_sticks_first_after_a_reversal) {
    on_slabs(false, [](const HapticScene& scene, const Motion& motion, const TouchTuning& tuning, double mu,
                       double speed, double exact_m) {
        TouchState state;
        const double press = 0.006, depth = kRadius_m - press;
        double x = 0.0;  // position of the proxy
        const auto check = [&](const Vec3& hand, const Vec3& proxy, const TouchResult& r) {
            x = std::clamp(x, hand.x - mu * press, hand.x + mu * press);
            ASSERT_NEAR(glm::length(proxy - Vec3(x, 0.4, kRadius_m)), 0.0, exact_m) << hand.x;
            ASSERT_NEAR(glm::length(r.force_n - 1000.0 * (r.proxy_m - motion(hand))), 0.0, 1e-9);
        };
        go(state, scene, motion, tuning, {0, 0.4, 0.0303}, {0, 0.4, depth}, speed,
           [](const Vec3&, const Vec3&, const TouchResult&) {});
        go(state, scene, motion, tuning, {0, 0.4, depth}, {0.05, 0.4, depth}, speed, check);
        go(state, scene, motion, tuning, {0.05, 0.4, depth}, {-0.03, 0.4, depth}, speed, check);
    });
}

// Until the hand reaches the wall, the floor's friction depends only on the press against the floor. At the wall the
// proxy is in the corner, however hard the hand presses.
TEST(FrictionExact, a_slide_into_a_wall_is_held_only_by_the_floor_until_it_arrives) {
    on_slabs(true, [](const HapticScene& scene, const Motion& motion, const TouchTuning& tuning, double mu,
                      double speed, double exact_m) {
        TouchState state;
        const double press = 0.003, depth = kRadius_m - press, wall_x = 0.1 - kRadius_m;
        const auto check = [&](const Vec3& hand, const Vec3& proxy, const TouchResult&) {
            const double x = std::min(wall_x, std::max(0.06, hand.x - mu * press));
            ASSERT_NEAR(glm::length(proxy - Vec3(x, 0.4, kRadius_m)), 0.0, exact_m) << hand.x;
        };
        go(state, scene, motion, tuning, {0.06, 0.4, 0.0303}, {0.06, 0.4, depth}, speed,
           [](const Vec3&, const Vec3&, const TouchResult&) {});
        go(state, scene, motion, tuning, {0.06, 0.4, depth}, {0.106, 0.4, depth}, speed, check);
    });
}

TEST(FrictionExact, a_press_into_an_edge_between_floor_and_wall_lags_only_along_the_edge) {
    on_slabs(true, [](const HapticScene& scene, const Motion& motion, const TouchTuning& tuning, double, double speed,
                      double exact_m) {
        TouchState state;
        const Vec3 corner(0.1 - kRadius_m, 0.4, kRadius_m), way(0.008, 0.0, -0.008);
        TouchResult last;
        go(state, scene, motion, tuning, corner - 3.17 * way, corner + way, speed,
           [&](const Vec3& hand, const Vec3& proxy, const TouchResult& r) {
               const bool in = hand.x > corner.x + 1e-9;
               ASSERT_NEAR(glm::length(proxy - (in ? corner : hand)), 0.0, exact_m) << hand.x;
               last = r;
           });
        EXPECT_EQ(last.contacts.count, 2);
    });
}

// Presses straight at the centre of a ball from all sides. The ball is solid or tessellated.
TEST(FrictionExact, a_straight_press_on_the_middle_of_a_round_thing_feels_frictionless) {
    const double round_m = 0.05;
    TouchWorld solid;
    solid.sphere(Vec3(0.0), round_m);
    const auto scene = solid.scene();
    std::mt19937 random(11);
    for (const double mu : coefficients())
        for (const double speed : {0.05, 0.3, 1.0, 5.0})
            for (int side = 0; side < 4; ++side) {
                const Vec3 out = random_turn(random).turn * Vec3(0, 0, 1);
                TouchState state;
                go(state, *scene, {}, rubbing(mu), out * (round_m + 0.0303), out * (round_m - 0.006), speed,
                   [&](const Vec3& hand, const Vec3& proxy, const TouchResult&) {
                       ASSERT_NEAR(glm::length(proxy - out * std::max(round_m + kRadius_m, glm::dot(hand, out))), 0.0,
                                   1e-8)
                           << "mu " << mu << ", " << speed << " m/s, " << glm::dot(hand, out);
                   });
            }
}

// A hand moves past a round object. The proxy touches the object whenever the hand is inside it, and the force stays in
// the friction cone of the surface at the proxy.
TEST(FrictionExact, a_slide_over_round_things_touches_them_and_stays_in_the_friction_cone) {
    const double round_m = 0.05;
    TouchWorld solid, hollow;
    solid.sphere(Vec3(0.0), round_m);
    HapticSceneBuilder shell;
    shell.add_mesh(sphere_mesh(40, round_m));
    const std::array<std::shared_ptr<const HapticScene>, 2> scenes{solid.scene(), shell.build()};
    for (std::size_t which = 0; which < scenes.size(); ++which)
        for (const double mu : coefficients())
            for (const double speed : {0.05, 0.3, 1.0}) {
                SCOPED_TRACE(fmt::format("{}, mu {}, {} m/s", which, mu, speed));
                const double tolerance = which == 0 ? 5e-8 : 2e-5;  // greater for facets, which lie inside the sphere
                TouchState state;
                const auto check = [&](const Vec3& hand, const Vec3& proxy, const TouchResult& r) {
                    if (r.contacts.count == 0 || r.contacts.capped) return;
                    ASSERT_NEAR(glm::length(proxy), round_m + kRadius_m, tolerance) << hand.x;
                    const Vec3 out = proxy / glm::length(proxy), pull = proxy - hand;
                    const double normal = glm::dot(pull, out), along = glm::length(pull - out * normal);
                    ASSERT_LE(along, mu * normal + (which == 0 ? 1e-6 : 2e-4)) << hand.x;
                };
                const double depth = round_m + kRadius_m - 0.004;
                go(state, *scenes[which], {}, rubbing(mu), {-0.04, 0.003, 0.08}, {-0.04, 0.003, 0.03}, speed, check);
                go(state, *scenes[which], {}, rubbing(mu), {-0.04, 0.003, 0.03}, {0.0, 0.003, depth}, speed, check);
                go(state, *scenes[which], {}, rubbing(mu), {0.0, 0.003, depth}, {0.04, 0.003, 0.03}, speed, check);
            }
}

// While friction holds the proxy, it does not creep, on round or flat surfaces, however long the hand stays.
TEST(FrictionExact, a_sticking_proxy_does_not_creep) {
    TouchWorld round, flat = slab(2, true);
    round.sphere(Vec3(0.0), 0.05);
    for (const double mu : {0.15, 0.4, 0.9}) {
        for (const bool on_round : {true, false}) {
            const auto scene = (on_round ? round : flat).scene();
            const double top = on_round ? 0.055 : kRadius_m;
            TouchState state;
            go(state, *scene, {}, rubbing(mu), {0.0, 0.0, top + 0.02}, {0.0, 0.0, top - 0.005}, 0.3,
               [](const Vec3&, const Vec3&, const TouchResult&) {});
            go(state, *scene, {}, rubbing(mu), {0.0, 0.0, top - 0.005}, {0.02, 0.0, top - 0.006}, 0.1,
               [](const Vec3&, const Vec3&, const TouchResult&) {});
            Vec3 stuck(0.0);
            go(state, *scene, {}, rubbing(mu), {0.02, 0.0, top - 0.006}, {0.0199, 0.0, top - 0.006}, 1e-4,
               [&](const Vec3&, const Vec3& proxy, const TouchResult&) { stuck = proxy; });
            for (int i = 0; i < 3000; ++i) {
                const Vec3 tremor(2e-5 * std::sin(0.05 * i), 2e-5 * std::sin(0.07 * i), 0.0);
                const Vec3 proxy =
                    touch_tick(state, *scene, rubbing(mu), Vec3(0.0199, 0.0, top - 0.006) + tremor, kTick_s).proxy_m;
                ASSERT_EQ(proxy, stuck) << "mu " << mu << (on_round ? ", round, tick " : ", flat, tick ") << i;
            }
        }
    }
}

}  // namespace friction_exact_test
}  // namespace handrail::test
