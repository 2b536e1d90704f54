// Tests cushions and clay. They must follow the documented force law, give no energy, and keep or lose their dents.
// They must not change anything else.
#include <chrono>

#include <fmt/format.h>

#include "haptic/render/soft_patch.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/effects/loops.h"

namespace handrail::test {
namespace soft_patch_test {

constexpr double kRated = 1000.0;

// Returns a patch of 0.2 by 0.16 hand metres with a corner at the origin. It is soft to a depth of 0.03.
SoftPatch patch_of(bool plastic, double scale = 1.0, const Vec3& at_m = Vec3(0.0)) {
    SoftPatch patch;
    patch.feature = FeatureId{5};
    patch.corner_m = at_m;
    patch.size_u_m = 0.2 * scale;
    patch.size_v_m = 0.16 * scale;
    patch.depth_m = 0.03 * scale;
    patch.plastic = plastic;
    return patch;
}

std::shared_ptr<const HapticScene> scene_of(const SoftPatch& patch, bool with_base = false) {
    HapticSceneBuilder builder;
    const Vec3 far = patch.corner_m + patch.u * patch.size_u_m + patch.v * patch.size_v_m;
    if (with_base)
        builder.add_box(
            {patch.corner_m - patch.normal() * (2.0 * patch.depth_m), far - patch.normal() * patch.depth_m});
    EXPECT_TRUE(builder.add_soft(patch));
    return builder.build();
}

// A second implementation of the law that the header documents. It uses plain loops in long double, and computes the
// dent in many small explicit steps.
class Law {
public:
    explicit Law(const SoftPatch& patch, double radius_m, double scale)
        : patch_(patch), radius_(radius_m), scale_(scale), s_(patch.cells_u * patch.cells_v, 0.0L) {}

    Vec3 tick(const Vec3& goal_m, double dt_s) {
        const long double du = patch_.size_u_m / patch_.cells_u, dv = patch_.size_v_m / patch_.cells_v;
        const long double footprint = std::max<long double>(radius_, 3.0L * std::max(du, dv));
        const Vec3 own = goal_m - patch_.corner_m;
        const long double e = radius_ - glm::dot(own, patch_.normal());
        const long double K = patch_.stiffness_fraction * kRated;
        const auto weight = [&](std::uint32_t iu, std::uint32_t iv) {
            const long double x = (iu + 0.5L) * du - glm::dot(own, patch_.u),
                              y = (iv + 0.5L) * dv - glm::dot(own, patch_.v);
            const long double t = 1.0L - (x * x + y * y) / (footprint * footprint);
            return t > 0.0L ? t * t : 0.0L;
        };
        const int steps = 4;
        for (int k = 0; k < (patch_.plastic ? 1 : steps); ++k) {
            const std::vector<long double> before = s_;
            for (std::uint32_t iv = 0; iv < patch_.cells_v; ++iv)
                for (std::uint32_t iu = 0; iu < patch_.cells_u; ++iu) {
                    long double around = 0.0L, links = 0.0L;
                    const auto link = [&](int ju, int jv) {
                        if (ju < 0 || jv < 0 || ju >= int(patch_.cells_u) || jv >= int(patch_.cells_v)) return;
                        around += before[std::size_t(jv) * patch_.cells_u + std::size_t(ju)];
                        links += 1.0L;
                    };
                    link(int(iu) - 1, int(iv)), link(int(iu) + 1, int(iv)), link(int(iu), int(iv) - 1),
                        link(int(iu), int(iv) + 1);
                    long double& s = s_[iv * patch_.cells_u + iu];
                    const long double w = std::max(0.0L, std::min<long double>(e, patch_.depth_m) - s),
                                      g = weight(iu, iv);
                    const long double drive = g * w + 0.5L * (around - links * s);
                    if (!patch_.plastic) {
                        s += (drive - s) * dt_s / patch_.recovery_s / steps;
                    } else if (const long double yield = patch_.yield_n / K * scale_; drive > yield) {
                        s = std::min<long double>(patch_.depth_m,
                                                  s + (drive - yield) / ((w > 0.0L ? g : 0.0L) + 0.5L * links));
                    }
                }
        }
        Vec3 force(0.0);
        for (std::uint32_t iv = 0; iv < patch_.cells_v; ++iv)
            for (std::uint32_t iu = 0; iu < patch_.cells_u; ++iu) {
                const long double w = std::max(0.0L, e - s_[iv * patch_.cells_u + iu]);
                const long double k = 3.0L * du * dv / (3.14159265358979323846L * footprint * footprint);
                // The force along the face, by finite differences of the energy instead of the formula.
                const auto energy = [&](long double shift_u, long double shift_v) {
                    const long double x = (iu + 0.5L) * du - glm::dot(own, patch_.u) - shift_u,
                                      y = (iv + 0.5L) * dv - glm::dot(own, patch_.v) - shift_v;
                    const long double t = std::max(0.0L, 1.0L - (x * x + y * y) / (footprint * footprint));
                    return 0.5L * K * k * t * t * w * w / scale_;
                };
                const long double h = 1e-6L * footprint;
                force += patch_.u * double((energy(-h, 0) - energy(h, 0)) / (2 * h)) +
                         patch_.v * double((energy(0, -h) - energy(0, h)) / (2 * h));
                force += patch_.normal() * double(K * k * weight(iu, iv) * w / scale_);
            }
        return force;
    }

private:
    SoftPatch patch_;
    long double radius_, scale_;
    std::vector<long double> s_;
};

TEST(SoftPatch, pushes_back_with_stiffness_times_depth_on_an_untouched_face) {
    // The Winkler model gives 200 N/m of the device's 1,000, at any scale and anywhere inside the face.
    std::mt19937 random(7);
    const auto unit = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    for (const double scale : {1.0, 60.0})
        for (const bool plastic : {false, true})
            for (int i = 0; i < 60; ++i) {
                SoftPatch patch = patch_of(plastic, scale);
                patch.recovery_s = 60.0;
                patch.yield_n = 4.0;
                const auto scene = scene_of(patch);
                TouchTuning tuning;
                tuning.world_m_per_hand_m = scale;
                tuning.radius_m = (0.002 + 0.008 * unit()) * scale;
                TouchState state;
                const double depth = 0.01 * unit();
                const Vec3 at = Vec3(0.04 + 0.12 * unit(), 0.04 + 0.08 * unit(), 0.0) * scale +
                                Vec3(0, 0, tuning.radius_m - depth * scale);
                const TouchResult r = touch_tick(state, *scene, tuning, at, 1e-3);
                EXPECT_NEAR(r.force_n.z, 200.0 * depth, 0.02 * 200.0 * depth)
                    << "radius " << tuning.radius_m << " scale " << scale;
                EXPECT_LE(glm::length(Vec2(r.force_n)), 0.02 * 200.0 * depth);
                EXPECT_EQ(r.soft, FeatureId{5});
                EXPECT_EQ(r.contacts.count, 0) << "nothing hard is touched";
            }
}

TEST(SoftPatch, follows_its_formula_within_two_percent) {
    // The hand wanders and presses at random. The second implementation computes the dent in steps of a quarter of the
    // size. The loops must be complete, because their beginnings hardly press. Sanitizers run fewer loops.
    const unsigned seeds = static_cast<unsigned>(std::max(2, scaled(6)));
    for (const bool plastic : {false, true})
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            SoftPatch patch = patch_of(plastic, seed % 2 ? 1.0 : 12.0);
            const double scale = seed % 2 ? 1.0 : 12.0;
            patch.recovery_s = 0.05 * seed;
            const auto scene = scene_of(patch);
            TouchTuning tuning;
            tuning.world_m_per_hand_m = scale;
            tuning.radius_m = 0.004 * seed * scale;
            TouchState state;
            Law law(scene->soft_patches[0], tuning.radius_m, scale);
            const std::vector<Vec3> loop = random_loop(seed, 0.05);
            double largest = 0.0, worst = 0.0;
            for (int i = 0; i < 1200; ++i) {
                const Vec3 p = loop[static_cast<std::size_t>(i)];
                const Vec3 goal = Vec3(0.1 + p.x, 0.08 + p.y, tuning.radius_m / scale + 0.3 * p.z - 0.004) * scale;
                const Vec3 expected = law.tick(goal, 1e-3),
                           force = touch_tick(state, *scene, tuning, goal, 1e-3).force_n;
                largest = std::max(largest, glm::length(expected));
                worst = std::max(worst, glm::length(force - expected));
            }
            EXPECT_GT(largest, 0.3);
            EXPECT_LE(worst, 0.02 * largest) << (plastic ? "plastic" : "elastic") << ", seed " << seed;
        }
}

TEST(SoftPatch, gives_no_energy_on_closed_loops) {
    double worst = -1e9;
    for (const bool plastic : {false, true})
        for (const double scale : {1.0, 60.0})
            for (unsigned seed = 1; seed <= 10; ++seed) {
                SoftPatch patch = patch_of(plastic, scale);
                patch.recovery_s = 0.02 * seed * seed;
                patch.yield_n = 0.2 * seed;
                const auto scene = scene_of(patch, true);
                TouchTuning tuning;
                tuning.world_m_per_hand_m = scale;
                tuning.radius_m = 0.004 * scale;
                // Follows each path twice. The path begins in the air, enters the patch, wanders in it and over its
                // borders, and goes back.
                const std::vector<Vec3> smooth = random_loop(seed, 0.06);
                for (const bool quantum : {false, true}) {
                    const LoopOutcome out =
                        go_round(*scene, tuning, quantum ? quantised(smooth) : smooth, Vec3(0.1, 0.08, 0.02) * scale);
                    EXPECT_LE(out.given_j, 1e-6)
                        << (plastic ? "plastic" : "elastic") << ", seed " << seed << (quantum ? ", quantum" : "");
                    worst = std::max(worst, out.given_j);
                }
            }
    std::cout << fmt::format("worst loop {:+.4f} mJ\n", worst * 1e3);
}

// Presses straight down in the middle until the hand is `depth_m` below the face, rests there for `rest_ticks`, and
// leaves. Returns the force at rest in newtons.
double press_middle(TouchState& state, const HapticScene& scene, double depth_m, int rest_ticks = 300) {
    double force = 0.0;
    const TouchTuning tuning;
    for (double z = 0.03; z > 0.005 - depth_m; z -= 1e-4) touch_tick(state, scene, tuning, {0.1, 0.08, z}, 1e-3);
    for (int i = 0; i < rest_ticks; ++i)
        force = touch_tick(state, scene, tuning, {0.1, 0.08, 0.005 - depth_m}, 1e-3).force_n.z;
    for (double z = 0.005 - depth_m; z < 0.03; z += 1e-4) touch_tick(state, scene, tuning, {0.1, 0.08, z}, 1e-3);
    return force;
}

TEST(SoftPatch, as_clay_keeps_a_dent_but_as_a_cushion_loses_it) {
    const auto clay = scene_of(patch_of(true)), cushion = scene_of(patch_of(false));
    TouchState in_clay, in_cushion;
    const double first_clay = press_middle(in_clay, *clay, 0.02),
                 first_cushion = press_middle(in_cushion, *cushion, 0.02);
    // The hand is elsewhere for ten minutes, after a teleport and a fault.
    for (TouchState* state : {&in_clay, &in_cushion}) {
        const auto& scene = state == &in_clay ? clay : cushion;
        state->reset();
        state->reset_filters();
        for (int i = 0; i < 10000; ++i) EXPECT_EQ(touch_tick(*state, *scene, {}, {5, 5, 5}, 0.06).force_n, Vec3(0.0));
    }
    EXPECT_LT(press_middle(in_clay, *clay, 0.005), 0.2 * 200.0 * 0.005)
        << "the dent is there: of the newton of untouched clay only its rim is left";
    EXPECT_GT(first_clay, 1.0);
    EXPECT_NEAR(press_middle(in_cushion, *cushion, 0.02), first_cushion, 1e-6) << "the cushion is as before";
    // In another world, all patches must be new. In the same world with an added object, the dent must remain.
    const auto fresh = scene_of(patch_of(true));
    EXPECT_GT(press_middle(in_clay, *fresh, 0.005, 1), 0.5);
    HapticSceneBuilder builder;
    builder.add_soft(patch_of(true));
    builder.add_box({{3, 3, 3}, {4, 4, 4}});
    press_middle(in_clay, *fresh, 0.02);
    EXPECT_LT(press_middle(in_clay, *builder.build(fresh->world), 0.005, 1), 0.2);
}

TEST(SoftPatch, as_a_cushion_recovers_with_its_time_constant) {
    SoftPatch patch = patch_of(false);
    patch.recovery_s = 0.2;
    const auto scene = scene_of(patch);
    TouchState state;
    press_middle(state, *scene, 0.01);  // presses and rests for 0.3 s
    // In the middle of a wide press, there is hardly any shear. This narrow press has shear, so the cushion recovers
    // faster than its cells alone would, and never slower.
    const auto probe = [&](double after_s) {
        TouchState again;
        press_middle(again, *scene, 0.01);
        for (int i = 0; i < static_cast<int>(after_s * 1e3); ++i)
            touch_tick(again, *scene, {}, {0.1, 0.08, 0.05}, 1e-3);
        return 200.0 * 0.005 -
               // By how much the force of a 5 mm press is still too small.
               touch_tick(again, *scene, {}, {0.1, 0.08, 0.0}, 1e-3).force_n.z;
    };
    const double early = probe(0.05), later = probe(0.25), late = probe(2.0);
    EXPECT_GT(early, 0.02);
    EXPECT_LE(later, early * std::exp(-0.2 / 0.2) * 1.05);
    EXPECT_NEAR(late, 0.0, 0.02 * 200.0 * 0.005);
}

TEST(SoftPatch, stops_at_its_hard_floor_and_leaves_everything_else_unchanged) {
    HapticSceneBuilder with, without;
    for (HapticSceneBuilder* builder : {&with, &without}) {
        builder->add_box({{0, 0, -0.06}, {0.2, 0.16, -0.03}}, SurfaceLabel{FeatureId{1}, 0, false});
        builder->add_box({{0.3, -1, -1}, {1, 1, 1}}, SurfaceLabel{FeatureId{2}, 0, false});
        builder->add_triangle({-1, -1, -0.2}, {1, -1, -0.2}, {0, 2, -0.2});
    }
    ASSERT_TRUE(with.add_soft(patch_of(true)));
    const auto soft = with.build(), hard = without.build();
    TouchTuning tuning;
    tuning.damping_ns_per_m = 5.0;
    tuning.default_friction_static = tuning.default_friction_kinetic = 0.3;
    TouchState a, b;
    int touched = 0;
    for (const Vec3& p : random_loop(3, 0.15)) {  // the hand moves along the wall and the sheet, away from the patch
        const Vec3 goal = Vec3(0.33, 0.4, -0.15) + p;
        const TouchResult x = touch_tick(a, *soft, tuning, goal, 1e-3), y = touch_tick(b, *hard, tuning, goal, 1e-3);
        ASSERT_EQ(x.force_n, y.force_n);
        ASSERT_EQ(x.proxy_m, y.proxy_m);
        touched += x.contacts.count > 0;
    }
    EXPECT_GT(touched, 500);
    // On the patch, the hard surfaces must exert the same force as in the scene without the patch. The cushion must add
    // its own force.
    a.reset();
    b.reset();
    bool on_floor = false;
    for (double z = 0.02; z > -0.028; z -= 1e-4) {
        const TouchResult x = touch_tick(a, *soft, tuning, {0.1, 0.08, z}, 1e-3),
                          y = touch_tick(b, *hard, tuning, {0.1, 0.08, z}, 1e-3);
        EXPECT_EQ(x.contact_force_n, y.contact_force_n);
        on_floor = on_floor || x.contacts.count > 0;
    }
    EXPECT_TRUE(on_floor);
    // From below, through the floor, the hand must not feel the patch.
    a.reset();
    for (double z = -0.1; z < -0.06; z += 1e-4)
        EXPECT_EQ(touch_tick(a, *soft, tuning, {0.1, 0.08, z}, 1e-3).soft, kNoFeature);
}

TEST(SoftPatch, survives_a_proxy_larger_than_itself_at_any_place_and_step) {
    for (const bool plastic : {false, true}) {
        SoftPatch patch = patch_of(plastic);
        patch.size_u_m = patch.size_v_m = 0.01;
        const auto scene = scene_of(patch);
        TouchTuning tuning;
        tuning.radius_m = 0.05;
        TouchState state;
        Law law(scene->soft_patches[0], tuning.radius_m, 1.0);
        for (double z = 0.06; z > 0.03; z -= 1e-4) {
            const Vec3 goal(0.003, 0.004, z);
            const Vec3 expected = law.tick(goal, 1e-3), force = touch_tick(state, *scene, tuning, goal, 1e-3).force_n;
            EXPECT_LE(glm::length(force - expected), 0.02 * glm::length(expected) + 1e-6);
            EXPECT_LE(force.z, 200.0 * std::max(0.0, 0.05 - z) + 1e-9) << "less than on a wide face";
        }
        for (const double x : {0.0, 0.005, -1e6, 1e6, 1e-300})
            for (const double z : {0.0, 0.05, -1e6, 1e6})
                for (const double dt : {1e-6, 1e-3, 10.0}) {
                    const Vec3 force = touch_tick(state, *scene, tuning, {x, x, z}, dt).force_n;
                    EXPECT_TRUE(is_finite(force));
                    EXPECT_LE(glm::length(force), 4.0 + 1e-9);
                }
    }
}

TEST(SoftPatch, feels_the_same_far_away_and_rotated) {
    const Vec3 far(3.1e5, -2.2e5, 800.0);
    SoftPatch turned = patch_of(true, 1.0, far);
    turned.u = Vec3(0, 0.6, 0.8);
    turned.v = Vec3(0, -0.8, 0.6);
    const auto here = scene_of(patch_of(true)), there = scene_of(turned);
    TouchState a, b;
    for (const Vec3& p : random_loop(9, 0.05)) {
        const Vec3 own(0.1 + p.x, 0.08 + p.y, 0.3 * p.z);
        const Vec3 x = touch_tick(a, *here, {}, own, 1e-3).force_n;
        const Vec3 y =
            touch_tick(b, *there, {}, far + turned.u * own.x + turned.v * own.y + turned.normal() * own.z, 1e-3)
                .force_n;
        EXPECT_LE(glm::length(y - (turned.u * x.x + turned.v * x.y + turned.normal() * x.z)), 1e-6);
    }
}

TEST(SoftPatch, is_soft_only_within_its_face) {
    SoftPatch patch = patch_of(false);
    patch.outline_m = {{0, 0, 0}, {0.2, 0, 0}, {0, 0.16, 0}};  // the triangle has half the rectangle's area
    const auto scene = scene_of(patch);
    const auto at = [&](double x, double y) {
        TouchState state;
        return touch_tick(state, *scene, {}, {x, y, 0.0}, 1e-3).force_n.z;
    };
    EXPECT_NEAR(at(0.05, 0.05), 1.0, 0.02);
    EXPECT_NEAR(at(0.1, 0.08), 0.5, 0.05) << "half of the footprint on the slanted border";
    EXPECT_EQ(at(0.15, 0.12), 0.0);
}

TEST(SoftPatch, cells_are_shared_by_many_patches_and_invalid_patches_are_refused) {
    HapticSceneBuilder builder;
    for (std::uint32_t i = 0; i < kMostSoftPatches; ++i) {
        SoftPatch patch = patch_of(i % 2 == 0, 1.0, Vec3(i, 0, 0));
        patch.size_u_m *= i % 3 == 0 ? 40.0 : 1.0;
        EXPECT_TRUE(builder.add_soft(patch));
    }
    EXPECT_FALSE(builder.add_soft(patch_of(true))) << "one too many";
    const auto scene = builder.build();
    std::uint32_t cells = 0;
    for (const SoftPatch& patch : scene->soft_patches) {
        EXPECT_EQ(patch.first_cell, cells);
        EXPECT_GE(patch.cells_u * patch.cells_v, 1U);
        cells += patch.cells_u * patch.cells_v;
    }
    EXPECT_LE(cells, kMostSoftCells);
    HapticSceneBuilder refusing;
    const auto refused = [&](auto change) {
        SoftPatch patch = patch_of(true);
        change(patch);
        return !refusing.add_soft(patch);
    };
    EXPECT_TRUE(refused([](SoftPatch& p) { p.size_u_m = 0.0; }));
    EXPECT_TRUE(refused([](SoftPatch& p) { p.depth_m = 0.0; }));
    EXPECT_TRUE(refused([](SoftPatch& p) { p.u = Vec3(2, 0, 0); }));
    EXPECT_TRUE(refused([](SoftPatch& p) { p.v = p.u; }));
    EXPECT_TRUE(refused([](SoftPatch& p) { p.corner_m.x = std::numeric_limits<double>::quiet_NaN(); }));
    EXPECT_TRUE(refused([](SoftPatch& p) { p.stiffness_fraction = 0.7; }));
    EXPECT_TRUE(refused([](SoftPatch& p) { p.recovery_s = 0.0; }));
    EXPECT_TRUE(refused([](SoftPatch& p) { p.yield_n = 0.0; }));
}

TEST(SoftPatch, prints_the_cost_of_many_patches_pressed_at_once) {
    // Presses eight cushions at once, which share the largest possible number of cells. The test prints the cost but
    // does not assert it.
    HapticSceneBuilder builder;
    for (int i = 0; i < 8; ++i) builder.add_soft(patch_of(false, 1.0, Vec3(0, 0, -0.004 * i)));
    const auto scene = builder.build();
    TouchState state;
    const auto run = [&](const Vec3& at, int ticks) {
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < ticks; ++i) touch_tick(state, *scene, {}, at + Vec3(1e-6 * i, 0, 0), 1e-3);
        return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count() / ticks;
    };
    const double away = run({5, 5, 5}, 1000), pressed = run({0.1, 0.08, -0.04}, 500);
    std::cout << fmt::format("8 cushions pressed at once: {:.1f} us a tick; none: {:.2f} us\n", pressed, away);
    EXPECT_GT(pressed, away);
}

}  // namespace soft_patch_test
}  // namespace handrail::test
