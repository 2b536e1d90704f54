// Runs each effect law on 40 random smooth loops of 4 s, with and without an encoder's quantum. A law may give the hand
// at most 5 microjoules. Its force and its stiffness must stay within their bounds.
#include <fmt/format.h>

#include "haptic/render/effects.h"
#include "haptic/render/tick_math.h"
#include "tests/support/names.h"
#include "tests/unit/effects/loops.h"

namespace handrail::test {
namespace effect_laws_test {

constexpr double kAllowed_j = 5e-6;

Aabb cube(double half_m) { return {Vec3(-half_m), Vec3(half_m)}; }

EffectVolume effect_of(EffectLaw law, EffectRegion region, double edge_hand_m = 0.01) {
    EffectVolume effect;
    effect.region = std::move(region);
    effect.law = std::move(law);
    effect.edge_hand_m = edge_hand_m;
    return effect;
}

std::shared_ptr<const HapticScene> scene_of(std::vector<EffectVolume> effects) {
    HapticSceneBuilder builder;
    for (EffectVolume& effect : effects) EXPECT_TRUE(builder.add_effect(std::move(effect)));
    return builder.build();
}

ConvexRegion slanted(double half_m) {
    ConvexRegion region;
    for (const Vec3& n : {Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(0, -1, 0.2), Vec3(0, 0.1, 1), Vec3(0.3, 0, -1)})
        region.planes.push_back({glm::normalize(n), half_m});
    return region;
}

// Returns regions of each kind. They are half as large as the loops, so that the loops cross every border.
std::vector<EffectRegion> regions(double half_m) {
    return {cube(half_m), SphereRegion{Vec3(0.1 * half_m), 1.2 * half_m},
            CapsuleRegion{Vec3(-half_m, 0, 0), Vec3(half_m, half_m, 0), 0.7 * half_m}, slanted(0.7 * half_m)};
}

struct Law {
    const char* name;
    EffectLaw law;
    double most_n;
};

std::vector<Law> passive_laws(double world_m_per_hand_m) {
    const double m = world_m_per_hand_m;
    const Vec3 along = glm::normalize(Vec3(1, 2, -1));
    const MagnetTarget point{Vec3(0.002, 0, 0) * m}, line{Vec3(0, 0.004, 0) * m, Vec3(0.03, 0, 0) * m},
        surface{Vec3(0.0), Vec3(0.02, 0, 0) * m, Vec3(0, 0.02, 0) * m};
    MagnetLaw faces;
    for (const double side : {-0.03, 0.03}) {
        faces.targets.push_back({Vec3(side, 0, 0) * m, Vec3(0, 0.03, 0) * m, Vec3(0, 0, 0.03) * m});
        faces.targets.push_back({Vec3(0, side, 0) * m, Vec3(0.03, 0, 0) * m, Vec3(0, 0, 0.03) * m});
        faces.targets.push_back({Vec3(0, 0, side) * m, Vec3(0.03, 0, 0) * m, Vec3(0, 0.03, 0) * m});
    }
    return {{"magnet, point", MagnetLaw{{point}}, 4.0},
            {"magnet, line, repels", MagnetLaw{{line}, -2.0, 0.01}, 4.0},
            {"magnet, surface", MagnetLaw{{surface}}, 4.0},
            {"magnet, six faces", faces, 4.0},
            {"detent", DetentLaw{Vec3(0.0), along}, 2.4},
            {"button", ButtonLaw{Vec3(0.0), along}, 2.0},
            {"fly-paper", FlyPaperLaw{}, 3.0},
            {"inertia", InertiaLaw{}, 4.0}};
}

TEST(EffectLaws, give_no_energy_on_random_loops) {
    for (const double scale : {1.0, 60.0})
        for (const Law& law : passive_laws(scale)) {
            LoopOutcome worst;
            worst.given_j = -1e9;
            for (unsigned seed = 1; seed <= (scale == 1.0 ? 40U : 8U); ++seed) {
                const auto kinds = regions(0.05 * scale);
                const auto scene = scene_of({effect_of(law.law, kinds[seed % kinds.size()])});
                TouchTuning tuning;
                tuning.world_m_per_hand_m = scale;
                const std::vector<Vec3> smooth = random_loop(seed, 0.08);
                for (const bool quantum : {false, true}) {
                    const LoopOutcome out = go_round(*scene, tuning, quantum ? quantised(smooth) : smooth);
                    EXPECT_LE(out.given_j, kAllowed_j)
                        << law.name << ", seed " << seed << (quantum ? ", quantum" : "") << ", scale " << scale;
                    EXPECT_LE(out.largest_n, law.most_n + 1e-9) << law.name << ", seed " << seed;
                    if (!quantum && law.law.index() < 3) {
                        EXPECT_LE(out.steepest_n_per_m, stiffness_bound_n_per_m(law.law) * 1.01)
                            << law.name << ", seed " << seed << ", scale " << scale;
                    }
                    worst.given_j = std::max(worst.given_j, out.given_j);
                    worst.largest_n = std::max(worst.largest_n, out.largest_n);
                    worst.steepest_n_per_m = std::max(worst.steepest_n_per_m, quantum ? 0.0 : out.steepest_n_per_m);
                    worst.largest_step_n = std::max(worst.largest_step_n, out.largest_step_n);
                    worst.felt += out.felt / (scale == 1.0 ? 80.0 : 16.0);
                }
            }
            EXPECT_GT(worst.felt, 0.2) << law.name << " was hardly felt";
            if (law.law.index() >= 3) {
                EXPECT_LE(worst.largest_step_n, 0.15) << law.name << " tears gently";
            }
            std::cout << fmt::format(
                "{:22} scale {:2}: {:+9.4f} mJ, {:.2f} N, {:5.0f} N/m, {:.3f} N a tick, felt {:.0f} %\n", law.name,
                scale, worst.given_j * 1e3, worst.largest_n, worst.steepest_n_per_m, worst.largest_step_n,
                100 * worst.felt);
        }
}

// Returns a pool from z = -0.5 up to 0, in hand metres. Its basin is open only at the top.
LiquidVolume pool(double scale, double half_m = 0.3) {
    LiquidVolume liquid;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 n(0.0);
        n[axis] = 1.0;
        liquid.planes.push_back({n, axis == 2 ? 0.0 : half_m * scale});
        liquid.planes.push_back({-n, (axis == 2 ? 0.5 : half_m) * scale});
    }
    liquid.hidden.assign(6, true);
    liquid.hidden[4] = false;
    return liquid;
}

std::shared_ptr<const HapticScene> scene_of(const LiquidVolume& liquid, double scale,
                                            std::vector<EffectVolume> effects = {}) {
    HapticSceneBuilder builder;
    builder.add_liquid(liquid, {Vec3(-0.3, -0.3, -0.5) * scale, Vec3(0.3, 0.3, 0.0) * scale});
    for (EffectVolume& effect : effects) EXPECT_TRUE(builder.add_effect(std::move(effect)));
    return builder.build();
}

TEST(LiquidLaws, give_no_energy_on_random_loops_through_the_surface) {
    struct Row {
        const char* name;
        double viscosity, buoyancy, film;
        bool passive;
    };
    for (const double scale : {1.0, 60.0})
        for (const Row& row :
             {Row{"drag 2 Ns/m", 2, 0, 0, true}, Row{"drag 8 Ns/m", 8, 0, 0, true}, Row{"buoyancy 1 N", 0, 1, 0, true},
              Row{"film 0.32 N", 0, 0, 0.32, true}, Row{"all of them", 4, 1, 0.5, true}}) {
            LiquidVolume liquid = pool(scale);
            liquid.viscosity_ns_per_m = row.viscosity;
            liquid.buoyancy_n = row.buoyancy;
            liquid.film_n = row.film;
            const auto scene = scene_of(liquid, scale);
            double worst = -1e9, steepest = 0.0, felt = 0.0;
            for (unsigned seed = 1; seed <= (scale == 1.0 ? 40U : 8U); ++seed) {
                TouchTuning tuning;
                tuning.world_m_per_hand_m = scale;
                const std::vector<Vec3> smooth = random_loop(seed, 0.08);
                for (const bool quantum : {false, true}) {
                    const LoopOutcome out = go_round(*scene, tuning, quantum ? quantised(smooth) : smooth);
                    EXPECT_LE(out.given_j, kAllowed_j)
                        << row.name << ", seed " << seed << (quantum ? ", quantum" : "") << ", scale " << scale;
                    worst = std::max(worst, out.given_j);
                    if (!quantum) steepest = std::max(steepest, out.steepest_n_per_m);
                    felt += out.felt / (scale == 1.0 ? 80.0 : 16.0);
                }
            }
            EXPECT_GT(felt, 0.2) << row.name;
            EXPECT_LE(steepest, 583.0 * row.film + 75.0 * row.buoyancy + (row.viscosity > 0 ? 400.0 : 1.0)) << row.name;
            std::cout << fmt::format("{:14} scale {:2}: {:+9.4f} mJ, {:4.0f} N/m\n", row.name, scale, worst * 1e3,
                                     steepest);
        }
}

TEST(LiquidLaws, a_stream_gives_at_most_two_newtons_times_its_speed) {
    LiquidVolume river = pool(1.0);
    river.viscosity_ns_per_m = 8.0;
    river.flow_hand_m_per_s = Vec3(0.1, 0.0, 0.0);
    const auto scene = scene_of(river, 1.0);
    // A hand at rest must feel a force of the viscosity times the speed of the flow.
    TouchState state;
    TouchTuning tuning;
    TouchResult r;
    for (int i = 0; i < 500; ++i) r = touch_tick(state, *scene, tuning, Vec3(0, 0, -0.1), kTick_s);
    EXPECT_NEAR(r.force_n.x, 0.8, 0.8 * 1e-3);
    EXPECT_NEAR(glm::length(Vec2(r.force_n.y, r.force_n.z)), 0.0, 1e-12);
    tuning.held = false;
    for (int i = 0; i < 500; ++i) r = touch_tick(state, *scene, tuning, Vec3(0, 0, -0.1), kTick_s);
    EXPECT_NEAR(r.force_n.x, 0.0, 1e-6) << "nobody is driven who does not hold the device";
    tuning.held = true;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const LoopOutcome out = go_round(*scene, tuning, random_loop(seed, 0.08));
        EXPECT_LE(out.given_j, 2.0 * 0.1 * 4.0);
        EXPECT_LE(out.largest_n, 2.0 + 1e-9);
    }
}

TEST(LiquidLaws, lift_with_buoyancy_and_hold_the_hand_back_at_the_surface_film) {
    LiquidVolume liquid = pool(60.0);
    liquid.buoyancy_n = 0.7;
    TouchTuning tuning;
    tuning.world_m_per_hand_m = 60.0;
    const auto lifts = scene_of(liquid, 60.0);
    liquid.buoyancy_n = 0.0;
    liquid.film_n = 0.32;
    const auto holds = scene_of(liquid, 60.0);
    const auto force_at = [&](const HapticScene& scene, double depth_hand_m) {
        TouchState state;
        TouchResult r;
        for (int i = 0; i < 300; ++i) r = touch_tick(state, scene, tuning, Vec3(0, 0, -depth_hand_m * 60.0), kTick_s);
        EXPECT_EQ(r.force_n.x, 0.0);
        return r.force_n.z;
    };
    EXPECT_EQ(force_at(*lifts, -0.0101), 0.0);
    EXPECT_NEAR(force_at(*lifts, 0.0), 0.35, 1e-9);
    EXPECT_NEAR(force_at(*lifts, 0.01), 0.7, 1e-9);
    EXPECT_NEAR(force_at(*lifts, 0.2), 0.7, 1e-9) << "as far down as the pool goes";
    // The film pulls to the surface from both sides. The pull is strongest at a distance of w / sqrt 2 = 2.8 mm.
    EXPECT_NEAR(force_at(*holds, 0.004 / std::sqrt(2.0)), 0.32, 1e-6);
    EXPECT_NEAR(force_at(*holds, -0.004 / std::sqrt(2.0)), -0.32, 1e-6);
    EXPECT_NEAR(force_at(*holds, 0.0), 0.0, 1e-12);
    EXPECT_EQ(force_at(*holds, 0.03), 0.0);
}

TEST(LiquidLaws, a_pressed_pool_wall_does_not_cancel_the_buoyancy) {
    // The pool's side at x = 0.3 is a wall. The hand presses 8 mm into the wall, so the hand itself is outside the
    // pool.
    HapticSceneBuilder builder;
    LiquidVolume liquid = pool(1.0);
    liquid.buoyancy_n = 1.0;
    builder.add_liquid(liquid, {Vec3(-0.3, -0.3, -0.5), Vec3(0.3, 0.3, 0.0)});
    builder.add_box({{0.3, -1, -1}, {0.4, 1, 1}});
    const auto scene = builder.build();
    TouchState state;
    TouchResult r;
    for (int i = 0; i <= 1000; ++i)
        r = touch_tick(state, *scene, TouchTuning{}, Vec3(0.2 + 0.108e-3 * i, 0, -0.2), kTick_s);
    EXPECT_NEAR(r.force_n.z, 1.0, 1e-9);
    EXPECT_NEAR(r.force_n.x, -0.013 * 800.0, 1e-6);
    // Behind the wall, outside the pool, the hand must feel no liquid.
    state.reset();
    for (int i = 0; i < 300; ++i) r = touch_tick(state, *scene, TouchTuning{}, Vec3(0.5, 0, -0.2), kTick_s);
    EXPECT_EQ(r.force_n, Vec3(0.0));
}

TEST(EffectLaws, keep_energy_sources_within_their_bounds) {
    const auto wind = scene_of({effect_of(ForceLaw{Vec3(0, 1, 0), 2.0}, cube(0.05), 0.02)});
    const auto shaker = scene_of({effect_of(VibrationLaw{Vec3(0, 0, 1), 0.5, 100.0}, cube(0.05))});
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const std::vector<Vec3> loop = random_loop(seed, 0.08);
        const LoopOutcome blown = go_round(*wind, {}, loop), shaken = go_round(*shaker, {}, loop);
        EXPECT_LE(blown.largest_n, 2.0 + 1e-12);
        double longest = 0.0, way = 0.0;
        for (int i = 0; i < kLoopTicks; ++i) {
            const Vec3 step = loop[static_cast<std::size_t>((i + 1) % kLoopTicks)] - loop[static_cast<std::size_t>(i)];
            longest += std::abs(step.y);
            way += std::abs(step.z);
        }
        EXPECT_LE(blown.given_j, 2.0 * longest);
        EXPECT_LE(shaken.largest_n, 0.5 + 1e-12);
        EXPECT_LE(shaken.given_j, 0.5 * way);
    }
    // The hand rests in the middle. The wind reaches its full force after 100 ms, with steps of at most 0.03 N a tick.
    // The shaker is a sine of 100 Hz.
    TouchState state;
    Vec3 last(0.0);
    for (int i = 1; i <= 150; ++i) {
        const Vec3 force = touch_tick(state, *wind, {}, Vec3(0.0), kTick_s).force_n;
        EXPECT_LE(glm::length(force - last), 0.031);
        last = force;
    }
    EXPECT_EQ(last, Vec3(0, 2.0, 0));
    state.reset();
    double square = 0.0;
    for (int i = 1; i <= 520; ++i) {
        const double force = touch_tick(state, *shaker, {}, Vec3(0.0), kTick_s).force_n.z;
        if (i <= 20) continue;
        EXPECT_NEAR(force, 0.5 * std::sin(2.0 * kPi * 0.1 * i), 1e-9) << i;
        square += force * force;
    }
    EXPECT_NEAR(std::sqrt(square / 500.0), 0.5 / std::sqrt(2.0), 1e-9);
    TouchTuning nobody;
    nobody.held = false;
    EXPECT_EQ(touch_tick(state, *shaker, nobody, Vec3(0.0), kTick_s).force_n, Vec3(0.0));
}

TEST(EffectLaws, follow_their_formulas) {
    const TouchTuning tuning;
    const auto force_at = [&](const HapticScene& scene, const Vec3& at) {
        TouchState state;
        return touch_tick(state, scene, tuning, at, kTick_s).force_n;
    };
    // Magnet of 2 N with a width of 10 mm: a point in the middle of a wide region. The force is greatest at a distance
    // of one width.
    const auto magnet = scene_of({effect_of(MagnetLaw{{{Vec3(0.0)}}}, cube(0.2))});
    EXPECT_NEAR(force_at(*magnet, {0.01, 0, 0}).x, -2.0, 1e-7);
    EXPECT_NEAR(force_at(*magnet, {0, 0.005, 0}).y, -0.5 * 2.0 * std::exp(0.5 * (1 - 0.25)), 1e-7);
    EXPECT_NEAR(force_at(*magnet, {0, 0, -0.03}).z, 3.0 * 2.0 * std::exp(0.5 * (1 - 9.0)), 1e-7);
    EXPECT_EQ(force_at(*magnet, Vec3(0.0)), Vec3(0.0));
    // Magnet along a line from (-0.05, 0, 0) to (0.05, 0, 0). To the side of the line, the force depends only on the
    // distance from the line. Beyond an end, the force acts along the direction to that end.
    const auto line = scene_of({effect_of(MagnetLaw{{{Vec3(0.0), Vec3(0.05, 0, 0)}}, -1.0, 0.02}, cube(0.3))});
    EXPECT_NEAR(force_at(*line, {0.03, 0, 0.02}).z, 1.0, 1e-7) << "it pushes away";
    EXPECT_NEAR(force_at(*line, {0.07, 0, 0}).x, 1.0, 1e-7);
    // Detent: the force is zero at each notch and strongest a quarter of the pitch away from it.
    const auto detent = scene_of({effect_of(DetentLaw{Vec3(0.0), Vec3(0, 1, 0)}, cube(0.2))});
    for (int notch = -3; notch <= 3; ++notch) {
        EXPECT_NEAR(force_at(*detent, {0, 0.01 * notch, 0}).y, 0.0, 1e-9);
        EXPECT_NEAR(force_at(*detent, {0, 0.01 * notch + 0.0025, 0}).y, -1.5, 1e-9);
        EXPECT_NEAR(force_at(*detent, {0, 0.01 * notch - 0.0025, 0}).y, 1.5, 1e-9);
    }
    // Button: the force is zero at both ends of its travel and in the middle, where it is unstable. In between, it is
    // strongest.
    const auto button = scene_of({effect_of(ButtonLaw{Vec3(0.0), Vec3(1, 0, 0)}, cube(0.2))});
    EXPECT_NEAR(force_at(*button, {0.01, 0, 0}).x, 0.0, 1e-9);
    EXPECT_NEAR(force_at(*button, {-0.01, 0, 0}).x, 0.0, 1e-9);
    EXPECT_NEAR(force_at(*button, {0.01 / std::sqrt(3.0), 0, 0}).x, 1.0, 1e-9) << "snaps on";
    EXPECT_NEAR(force_at(*button, {-0.01 / std::sqrt(3.0), 0, 0}).x, -1.0, 1e-9) << "snaps back";
    EXPECT_NEAR(force_at(*button, {0.02 / std::sqrt(3.0), 0, 0}).x, -1.0, 1e-9) << "and stops";
}

TEST(EffectLaws, fly_paper_holds_until_it_tears_and_then_holds_again) {
    const auto scene = scene_of({effect_of(FlyPaperLaw{2.0}, cube(0.5))});
    TouchState state;
    touch_tick(state, *scene, {}, Vec3(0.0), kTick_s);
    double largest = 0.0;
    Vec3 force(0.0);
    for (int i = 1; i <= 48; ++i) {  // 4.8 mm at 400 N/m give 1.92 N
        force = touch_tick(state, *scene, {}, Vec3(1e-4 * i, 0, 0), kTick_s).force_n;
        EXPECT_NEAR(force.x, -400.0 * 1e-4 * i, 1e-9);
    }
    for (int i = 0; i < 5000; ++i)
        EXPECT_NEAR(touch_tick(state, *scene, {}, Vec3(0.0048, 0, 0), kTick_s).force_n.x, -1.92, 1e-9)
            << "stuck for ever";
    for (int i = 49; i <= 60; ++i)
        largest = std::max(largest, glm::length(touch_tick(state, *scene, {}, Vec3(1e-4 * i, 0, 0), kTick_s).force_n));
    EXPECT_LE(largest, 2.0 + 1e-12);
    for (int i = 0; i < 300; ++i) force = touch_tick(state, *scene, {}, Vec3(0.006, 0, 0), kTick_s).force_n;
    EXPECT_LT(glm::length(force), 400.0 * 0.2e-3) << "torn, and stuck again here";
    EXPECT_NEAR(touch_tick(state, *scene, {}, Vec3(0.007, 0, 0), kTick_s).force_n.x - force.x, -0.4, 1e-9);
    // A teleport or a fault must make the law forget the place where the proxy stuck.
    state.reset_filters();
    EXPECT_EQ(touch_tick(state, *scene, {}, Vec3(0.009, 0, 0), kTick_s).force_n, Vec3(0.0));
}

TEST(EffectLaws, for_inertia_resist_acceleration_but_not_steady_motion) {
    InertiaLaw law;
    law.mass_kg = 0.2;
    law.damping_ns_per_m = 0.2;
    const auto scene = scene_of({effect_of(law, Aabb{Vec3(-10.0), Vec3(10.0)})});
    TouchState state;
    double x = 0.0, v = 0.0, mean = 0.0, late = 0.0;
    for (int i = 0; i < 8000; ++i) {
        // Acceleration of half a metre per second squared for 2 s, then constant speed.
        v += i < 2000 ? 1e-3 * 0.5 : 0.0;
        x += v * 1e-3;
        const double force = touch_tick(state, *scene, {}, Vec3(x, 0, 0), kTick_s).force_n.x;
        if (i >= 1000 && i < 2000) mean += force / 1000.0;
        if (i >= 7000) late += force / 1000.0;
    }
    EXPECT_NEAR(mean, -(0.2 * 0.5 + 0.2 * 0.75), 0.01) << "mass times acceleration and the damping at 0.75 m/s";
    EXPECT_NEAR(late, -0.2 * 1.0, 0.005) << "only the damping at 1 m/s";
}

TEST(EffectLaws, of_neighbouring_magnets_blend_without_an_edge_between_targets) {
    // Between two equal magnets, the force must reverse gradually, without a step at the plane of equal distance.
    const auto scene = scene_of({effect_of(MagnetLaw{{{Vec3(-0.012, 0, 0)}, {Vec3(0.012, 0, 0)}}}, cube(0.2))});
    TouchState state;
    Vec3 last = touch_tick(state, *scene, {}, Vec3(-0.005, 0, 0), kTick_s).force_n;
    for (int i = 1; i <= 1000; ++i) {
        const Vec3 force = touch_tick(state, *scene, {}, Vec3(-0.005 + 1e-5 * i, 0, 0), kTick_s).force_n;
        EXPECT_LE(glm::length(force - last), 1e-5 * 600.0 * 1.001);
        last = force;
    }
    EXPECT_GT(last.x, 0.5) << "and draws to the other one now";
}

TEST(EffectLaws, stay_bounded_in_stiffness_and_force_where_many_overlap) {
    // Combines all effects in one place, several times over. No direction may get stiffer than the device allows, and
    // the effects together may not push with more than 4 N.
    for (const double rated : {300.0, 1000.0}) {
        std::vector<EffectVolume> effects;
        for (const Law& law : passive_laws(1.0))
            if (law.law.index() < 3) {
                effects.push_back(effect_of(law.law, cube(0.06)));
                effects.push_back(effect_of(law.law, SphereRegion{Vec3(0.01), 0.06}));
            }
        const auto potentials = scene_of(effects);
        for (const Law& law : passive_laws(1.0))
            if (law.law.index() >= 3) effects.push_back(effect_of(law.law, cube(0.06)));
        LiquidVolume liquid = pool(1.0);
        liquid.viscosity_ns_per_m = 4.0;
        liquid.buoyancy_n = 1.0;
        liquid.film_n = 0.3;
        const auto all = scene_of(liquid, 1.0, effects);
        TouchTuning tuning;
        tuning.rated_stiffness_n_per_m = rated;
        for (unsigned seed = 1; seed <= 15; ++seed) {
            const std::vector<Vec3> loop = random_loop(seed, 0.08);
            const LoopOutcome slopes = go_round(*potentials, tuning, loop);
            EXPECT_LE(slopes.steepest_n_per_m, rated * 1.001) << seed;
            EXPECT_LE(slopes.given_j, kAllowed_j) << seed;
            const LoopOutcome together = go_round(*all, tuning, quantised(loop));
            EXPECT_LE(together.largest_n, kLargestEffect_n + 1e-9) << seed;
            EXPECT_LE(together.given_j, kAllowed_j) << seed;
        }
    }
}

TEST(EffectLaws, move_with_the_body_to_which_they_are_attached) {
    // A crate carries a magnet, a row of notches or fly-paper. The crate is moved, turned and enlarged, but the force
    // in the crate's own frame must not change.
    for (const EffectLaw& law : {EffectLaw(MagnetLaw{{{Vec3(0.01, 0, 0)}}}),
                                 EffectLaw(DetentLaw{Vec3(0.0), Vec3(0, 0, 1)}), EffectLaw(FlyPaperLaw{})}) {
        const EffectVolume effect = effect_of(law, cube(0.05));
        const auto still = scene_of({effect});
        const auto crate = HapticSceneBuilder().build();
        HapticSceneBuilder builder;
        ASSERT_TRUE(builder.add_body(FeatureId{3}, crate, Placement{}));
        EffectVolume hanging = effect;
        hanging.body = 1;
        EXPECT_FALSE(builder.add_effect(hanging)) << "there is no such body";
        hanging.body = 0;
        ASSERT_TRUE(builder.add_effect(hanging));
        const auto moving = builder.build();
        TouchState still_state, moving_state;
        TouchTuning one, grown;
        grown.world_m_per_hand_m = 2.0;  // the crate and the hand are both twice as large
        const std::vector<Vec3> loop = random_loop(11, 0.06);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 own = loop[static_cast<std::size_t>(i)];
            const Placement at{Vec3(1.0 + 1e-3 * i, 2.0, -3.0), rotation_about(Vec3(0, 0, 1), 0.002 * i), 2.0};
            const PlacedFrame frame(at);
            const std::array<BodyPose, 1> poses{BodyPose{at, true}};
            // The library gives the widths of magnet and edge in hand metres, so they do not grow with the crate. At
            // twice the scale, only the crate's region is twice as large.
            const Vec3 expected = touch_tick(still_state, *still, one, own, kTick_s).force_n;
            const TouchResult r = touch_tick(moving_state, *moving, grown, frame.to_world(own), kTick_s, Vec3(0.0),
                                             BodyPoses{poses, static_cast<std::uint64_t>(i + 1)});
            // Near obstacles, including bodies, effects may use 60 % of the device's stiffness of 1,000 N/m. That is
            // 600 N/m.
            const double share = std::min(1.0, 600.0 / stiffness_bound_n_per_m(law));
            EXPECT_LE(glm::length(frame.turned_back(r.force_n) - expected * share), 1e-9) << i;
        }
        const std::array<BodyPose, 1> gone{BodyPose{Placement{}, false}};
        EXPECT_EQ(
            touch_tick(moving_state, *moving, one, Vec3(0.01, 0.01, 0.01), kTick_s, Vec3(0.0), BodyPoses{gone, 9999})
                .force_n,
            Vec3(0.0));
    }
}

TEST(EffectLaws, report_when_more_than_sixteen_act_on_the_hand) {
    std::vector<EffectVolume> effects(17, effect_of(ForceLaw{Vec3(1, 0, 0), 0.1}, cube(0.05)));
    effects[0].region = Aabb{Vec3(0.02, -0.05, -0.05), Vec3(0.1, 0.05, 0.05)};
    const auto scene = scene_of(effects);
    TouchState state;
    TouchResult r;
    for (int i = 0; i < 200; ++i) r = touch_tick(state, *scene, {}, Vec3(0.0), kTick_s);
    EXPECT_FALSE(r.effects_truncated);
    EXPECT_NEAR(r.force_n.x, 1.6, 1e-9);
    for (int i = 0; i < 200; ++i) r = touch_tick(state, *scene, {}, Vec3(0.045, 0, 0), kTick_s);
    EXPECT_TRUE(r.effects_truncated);
    EXPECT_LE(glm::length(r.force_n), 1.6 + 1e-9);
}

TEST(EffectLaws, enter_and_leave_without_a_jump_in_force) {
    for (const double scale : {1.0, 12.0})
        for (const Law& law : passive_laws(scale)) {
            const auto scene = scene_of({effect_of(law.law, cube(0.05 * scale))});
            TouchTuning tuning;
            tuning.world_m_per_hand_m = scale;
            TouchState state;
            Vec3 last(0.0);
            for (int i = 0; i <= 4800; ++i) {  // the hand moves straight through at 25 mm/s
                const Vec3 at = Vec3(-0.06 + 2.5e-5 * i, 0.003, 0.007) * scale;
                const Vec3 force = touch_tick(state, *scene, tuning, at, kTick_s).force_n;
                EXPECT_LE(glm::length(force - last), law.law.index() < 3 ? 2.5e-5 * 1000.0 : 0.12)
                    << law.name << ' ' << i;
                if (std::abs(at.x) > 0.05 * scale) {
                    EXPECT_EQ(force, Vec3(0.0)) << law.name;
                }
                last = force;
            }
        }
}

TEST(EffectLaws, survive_extreme_step_sizes) {
    std::vector<EffectVolume> effects;
    for (const Law& law : passive_laws(1.0)) effects.push_back(effect_of(law.law, cube(0.05)));
    effects.push_back(effect_of(ForceLaw{}, SphereRegion{Vec3(0.0), 0.1}));
    effects.push_back(effect_of(VibrationLaw{}, CapsuleRegion{Vec3(0.0), Vec3(0.1), 0.1}));
    effects.push_back(effect_of(FlyPaperLaw{}, slanted(0.1)));
    const auto scene = scene_of(effects);
    EffectState state;
    HandMotion hand;
    for (const double step : {0.0, 1e-3, 1.0, 1e6, 1e30, -1e30, 1e-310, 1e100})
        for (const double place : {0.0, 0.01, 0.05, 1e6, 1e30, -1e30, 1e100})
            for (const double dt : {1e-6, 1e-3, 0.1, 10.0})
                for (const double scale : {1.0, 60.0, 1e-3, 1e4}) {
                    hand.goal_m = Vec3(place, -place, 0.5 * place);
                    hand.step_m = Vec3(step, 0.3 * step, -step);
                    hand.dt_s = dt;
                    hand.scale = scale;
                    const Vec3 force = state.force_n(*scene, hand);
                    EXPECT_TRUE(is_finite(force)) << step << ' ' << place << ' ' << dt << ' ' << scale;
                }
    // After all the extreme values, a reset must restore the original behaviour.
    hand = HandMotion{};
    state.reset();
    EXPECT_TRUE(is_finite(state.force_n(*scene, hand)));
}

TEST(EffectLaws, feel_the_same_far_from_the_origin_and_in_any_order) {
    std::vector<EffectVolume> here, there;
    const Vec3 far(3.7e5, -2.1e5, 1.3e4);
    for (const EffectRegion& region : regions(0.05)) {
        here.push_back(effect_of(MagnetLaw{{{Vec3(0.01, 0, 0)}}, 1.0, 0.02}, region));
        here.push_back(effect_of(DetentLaw{Vec3(0.0), Vec3(0, 0, 1), 0.5}, region));
        here.push_back(effect_of(FlyPaperLaw{}, region));
    }
    for (auto effect = here.rbegin(); effect != here.rend(); ++effect) {
        there.push_back(*effect);
        if (auto* box = std::get_if<Aabb>(&there.back().region)) *box = {box->min_m + far, box->max_m + far};
        if (auto* ball = std::get_if<SphereRegion>(&there.back().region)) ball->centre_m += far;
        if (auto* capsule = std::get_if<CapsuleRegion>(&there.back().region)) capsule->a_m += far, capsule->b_m += far;
        if (auto* convex = std::get_if<ConvexRegion>(&there.back().region))
            for (Plane& plane : convex->planes) plane.offset_m += glm::dot(plane.normal, far);
        if (auto* magnet = std::get_if<MagnetLaw>(&there.back().law)) magnet->targets[0].centre_m += far;
        if (auto* detent = std::get_if<DetentLaw>(&there.back().law)) detent->origin_m += far;
    }
    const auto near_scene = scene_of(here), far_scene = scene_of(there);
    TouchState near_state, far_state;
    for (const Vec3& p : random_loop(5, 0.08)) {
        const Vec3 a = touch_tick(near_state, *near_scene, {}, p, kTick_s).force_n,
                   b = touch_tick(far_state, *far_scene, {}, far + p, kTick_s).force_n;
        EXPECT_LE(glm::length(a - b), 1e-6);
    }
}

TEST(EffectLaws, refuse_regions_without_size_and_values_that_are_not_numbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    HapticSceneBuilder builder;
    const auto refused = [&](EffectLaw law, EffectRegion region) {
        return !builder.add_effect(effect_of(std::move(law), std::move(region)));
    };
    EXPECT_TRUE(refused(FlyPaperLaw{}, cube(0.0)));
    EXPECT_TRUE(refused(FlyPaperLaw{}, Aabb{}));
    EXPECT_TRUE(refused(FlyPaperLaw{}, cube(nan)));
    EXPECT_TRUE(refused(FlyPaperLaw{}, cube(inf)));
    EXPECT_TRUE(refused(FlyPaperLaw{}, SphereRegion{Vec3(0.0), 0.0}));
    EXPECT_TRUE(refused(FlyPaperLaw{}, SphereRegion{Vec3(nan), 1.0}));
    EXPECT_TRUE(refused(FlyPaperLaw{}, CapsuleRegion{Vec3(0.0), Vec3(1.0), -1.0}));
    ConvexRegion open = slanted(0.1);
    open.planes.pop_back();
    EXPECT_TRUE(refused(FlyPaperLaw{}, open)) << "an open volume";
    EXPECT_TRUE(refused(FlyPaperLaw{}, ConvexRegion{}));
    EXPECT_TRUE(refused(MagnetLaw{{{Vec3(0.0)}}, 2.0, 0.0}, cube(0.1))) << "no width";
    EXPECT_TRUE(refused(MagnetLaw{}, cube(0.1))) << "no target";
    EXPECT_TRUE(refused(MagnetLaw{{{Vec3(0.0)}}, nan}, cube(0.1)));
    EXPECT_TRUE(refused(MagnetLaw{{{Vec3(0.0)}}, 4.1}, cube(0.1)));
    EXPECT_TRUE(refused(DetentLaw{Vec3(0.0), Vec3(0.0)}, cube(0.1))) << "no direction";
    EXPECT_TRUE(refused(VibrationLaw{Vec3(0, 0, 1), 0.5, 300.0}, cube(0.1)));
    EXPECT_TRUE(refused(VibrationLaw{Vec3(0, 0, 1), 0.6, 100.0}, cube(0.1)));
    EXPECT_TRUE(refused(InertiaLaw{0.01}, cube(0.1)));
    EXPECT_TRUE(refused(ForceLaw{Vec3(1, 0, 0), 2.1}, cube(0.1)));
    EXPECT_TRUE(refused(CustomLaw{}, cube(0.1)));
    EXPECT_FALSE(refused(FlyPaperLaw{}, slanted(0.1))) << "and the sound ones are taken";
    EXPECT_EQ(builder.build()->effects.size(), 1U);
}

TEST(TickMath, agrees_with_the_standard_library) {
    for (double u = 0.0; u < 45.0; u += 0.0137) {
        EXPECT_NEAR(exp_minus(u), u < 40.0 ? std::exp(-u) : 0.0, 1e-8 * std::exp(-u) + (u < 40.0 ? 0.0 : 1e-17)) << u;
        EXPECT_NEAR(sine_of_turns(u).sine, std::sin(2.0 * kPi * u), 1e-11 + 1e-14 * u) << u;
        EXPECT_NEAR(sine_of_turns(-u).cosine, std::cos(2.0 * kPi * u), 1e-11 + 1e-14 * u) << u;
        EXPECT_NEAR(smooth_step_area(u + 1e-6) - smooth_step_area(u), 1e-6 * smooth_step(u), 1e-11) << u;
    }
    for (const double turns : {1e15, -1e15, 1e30, -1e300, 0.5, -0.5})
        EXPECT_LE(std::abs(sine_of_turns(turns).sine), 1.0 + 1e-11) << turns;
}
}  // namespace effect_laws_test
}  // namespace handrail::test
