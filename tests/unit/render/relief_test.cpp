// Tests height and friction textures: their depth, slope and borders, and how they change the force.
#include "haptic/render/relief.h"

#include <random>

#include "haptic/render/touch.h"
#include "tests/support/names.h"

namespace handrail::test {
namespace relief_test {

constexpr double kStiffness = 800.0;

std::shared_ptr<const HeightField> random_field(std::mt19937& random, int width, int height) {
    std::vector<float> depths(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (float& d : depths) d = random() % 2 == 0 ? 0.0F : 1.0F;
    return std::make_shared<const HeightField>(width, height, depths);
}

// Returns a picture whose left half is black and whose right half is white. Beyond the right border, the picture
// repeats with black.
std::shared_ptr<const HeightField> half_white() {
    constexpr int kWidth = 64, kHeight = 32;
    std::vector<float> depths(kWidth * kHeight);
    for (int i = 0; i < kWidth * kHeight; ++i)
        depths[static_cast<std::size_t>(i)] = i % kWidth < kWidth / 2 ? 0.0F : 1.0F;
    return std::make_shared<const HeightField>(kWidth, kHeight, depths);
}

std::vector<Relief> reliefs_of_every_kind(std::mt19937& random) {
    std::vector<Relief> all;
    for (const ReliefKind kind : {ReliefKind::Sine, ReliefKind::Square, ReliefKind::Picture})
        for (const double depth : {1e-5, 1e-4, 5e-4, 2e-3, 5e-3})
            for (const double period : {1e-3, 4e-3, 1e-2, 5e-2}) {
                Relief relief;
                relief.kind = kind;
                relief.depth_hand_m = depth;
                relief.period_hand_m = period;
                relief.size_m = 20.0 * period;
                if (kind == ReliefKind::Picture)
                    relief.picture =
                        random_field(random, 5 + static_cast<int>(random() % 40), 5 + static_cast<int>(random() % 40));
                all.push_back(relief);
            }
    return all;
}

TEST(Relief, is_never_steeper_or_more_curved_than_a_hand_can_follow) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    const ReliefAxes axes = relief_axes({0, 0, 1});
    for (const Relief& relief : reliefs_of_every_kind(random))
        for (int i = 0; i < 400; ++i) {
            const Vec3 at(place(random), place(random), 0.0);
            const ReliefValue here = relief_at(relief, axes, at, 1.0, kStiffness, 1.0);
            EXPECT_GE(here.depth_m, -1e-15);
            // The tolerance is needed because pictures are stored in single precision.
            EXPECT_LE(here.depth_m, relief.depth_hand_m * (1.0 + 1e-6));
            EXPECT_LE(glm::length(here.gradient), 0.3 + 1e-9);
            // Compares the slope with differences of the depth. Checks that the differences of the slope stay below the
            // limit for the curvature.
            constexpr double kStep = 1e-6;
            for (const Vec3& way : {Vec3(kStep, 0, 0), Vec3(0, kStep, 0)}) {
                const ReliefValue ahead = relief_at(relief, axes, at + way, 1.0, kStiffness, 1.0),
                                  behind = relief_at(relief, axes, at - way, 1.0, kStiffness, 1.0);
                EXPECT_NEAR((ahead.depth_m - behind.depth_m) / (2.0 * kStep), glm::dot(here.gradient, way) / kStep,
                            2e-3);
                EXPECT_LE(glm::length(ahead.gradient - behind.gradient) / (2.0 * kStep) * Relief::kFullForce_n,
                          0.5 * kStiffness * 1.01);
            }
        }
}

TEST(Relief, has_axes_pointing_right_and_up_for_a_person_facing_the_wall) {
    EXPECT_EQ(relief_axes({0, -1, 0}).u, Vec3(1, 0, 0));  // on a wall that faces south, a person's right is east
    EXPECT_EQ(relief_axes({0, -1, 0}).v, Vec3(0, 0, 1));
    EXPECT_EQ(relief_axes({1, 0, 0}).u, Vec3(0, 1, 0));
    EXPECT_EQ(relief_axes({0, 0, 1}).u, Vec3(1, 0, 0));
    EXPECT_EQ(relief_axes({0, 0, 1}).v, Vec3(0, 1, 0));
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 100; ++i) {
        const Vec3 n = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
        const ReliefAxes axes = relief_axes(n);
        EXPECT_NEAR(glm::length(axes.u), 1.0, 1e-12);
        EXPECT_NEAR(glm::dot(axes.u, n), 0.0, 1e-12);
        EXPECT_NEAR(glm::length(axes.v - glm::cross(n, axes.u)), 0.0, 1e-12);
    }
}

TEST(Relief, keeps_the_row_order_and_width_of_a_picture_when_coarsened) {
    // The first picture has white rows at the top, the second has white columns on the left.
    std::vector<float> rows(64 * 48, 0.0F), columns(64 * 48, 0.0F);
    for (std::size_t x = 0; x < 64; ++x)
        for (std::size_t y = 0; y < 12; ++y) rows[y * 64 + x] = 1.0F;
    for (std::size_t y = 0; y < 48; ++y)
        for (std::size_t x = 0; x < 16; ++x) columns[y * 64 + x] = 1.0F;
    const HeightField top(64, 48, rows), left(64, 48, columns);
    EXPECT_EQ(top.aspect(), 0.75);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(top.at(top.levels()[k], 0.4, 0.66).depth, 1.0, 0.15) << k;
        EXPECT_NEAR(top.at(top.levels()[k], 0.4, 0.2).depth, 0.0, 0.05) << k;
        EXPECT_NEAR(left.at(left.levels()[k], 0.12, 0.3).depth, 1.0, 0.15) << k;
        EXPECT_NEAR(left.at(left.levels()[k], 0.6, 0.3).depth, 0.0, 0.05) << k;
    }
    // The coarsest level must contain only the mean.
    EXPECT_NEAR(left.at(left.levels().back(), 0.7, 0.1).depth, 0.25, 1e-6);
    const std::vector<float> one{0.5F};
    EXPECT_NEAR(HeightField(1, 1, one).at(HeightField(1, 1, one).levels()[0], 12.3, -4.5).depth, 0.5, 1e-6);
}

// Returns a floor z <= 0 that extends from -reach_m to reach_m. Its material has this relief.
std::shared_ptr<const HapticScene> floor_with(const Relief& relief, double reach_m = 1.0, double friction = 0.0) {
    HapticMaterial material;
    material.relief = 0;
    material.friction_static = material.friction_kinetic = friction;
    HapticSceneBuilder builder({material});
    builder.add_box({{-reach_m, -reach_m, -1}, {reach_m, reach_m, 0}});
    builder.set_reliefs({relief});
    return builder.build();
}

TouchResult press(TouchState& state, const HapticScene& scene, const TouchTuning& tuning, double x_m, double depth_m) {
    const double scale = tuning.world_m_per_hand_m;
    state.reset();
    TouchResult r;
    for (int i = 0; i <= 200; ++i)
        r = touch_tick(state, scene, tuning,
                       {x_m, 0, tuning.radius_m + (0.002 - (0.002 + depth_m) * i / 200.0) * scale}, 1e-3);
    for (int i = 0; i < 100; ++i)
        r = touch_tick(state, scene, tuning, {x_m, 0, tuning.radius_m - depth_m * scale}, 1e-3);
    return r;
}

TEST(Relief, lets_the_hand_sink_to_white_and_changes_nothing_over_black) {
    for (const double scale : {1.0, 4.0, 60.0}) {
        Relief relief;
        relief.kind = ReliefKind::Picture;
        relief.depth_hand_m = 0.002;
        relief.size_m = 0.4 * scale;
        relief.low_m = relief.high_m = Vec3(-0.2 * scale, -0.1 * scale, 0.0);
        relief.picture = half_white();
        const auto scene = floor_with(relief, 1.0 * scale);
        TouchTuning tuning;
        tuning.world_m_per_hand_m = scale;
        TouchState state;
        // Over black, the force must be that of a floor without texture. Over white, the hand must be 2 mm deeper for
        // the same force.
        const TouchResult black = press(state, *scene, tuning, -0.1 * scale, 0.002);
        EXPECT_NEAR(black.force_n.z, 0.002 * 800.0, 1e-9);
        EXPECT_NEAR(black.proxy_m.z, tuning.radius_m, 1e-9);
        const TouchResult white = press(state, *scene, tuning, 0.1 * scale, 0.004);
        EXPECT_NEAR(white.force_n.z, 0.002 * 800.0, 1e-6);
        EXPECT_NEAR(white.proxy_m.z, tuning.radius_m - 0.002 * scale, 1e-6 * scale);
        EXPECT_NEAR(glm::length(Vec2(white.force_n)), 0.0, 1e-6);
        // If the hand is in the hollow but above the bottom of the hollow, it must touch nothing.
        const TouchResult hover = press(state, *scene, tuning, 0.1 * scale, 0.001);
        EXPECT_EQ(hover.force_n, Vec3(0.0));
        EXPECT_EQ(hover.contacts.count, 0);
        // The border between black and white is a ramp with a slope of at most 0.3. On the way in, the ramp pulls the
        // hand into the hollow. On the way out, the hand must climb the ramp.
        double steepest = 0.0;
        for (double x = -0.03; x <= 0.03; x += 1e-3) {
            const TouchResult r = press(state, *scene, tuning, x * scale, 0.004);
            EXPECT_GE(r.force_n.x, -1e-6);
            steepest = std::max(steepest, r.force_n.x / r.force_n.z);
        }
        EXPECT_LE(steepest, 0.3 + 1e-9);
        EXPECT_GE(steepest, 0.1);
    }
}

TEST(Relief, fades_out_towards_open_edges_and_continues_under_covered_ones) {
    Relief relief;
    relief.kind = ReliefKind::Picture;
    relief.depth_hand_m = 0.002;
    relief.size_m = 1.0;
    const std::vector<float> white{1.0F};
    relief.picture = std::make_shared<const HeightField>(1, 1, white);
    HapticMaterial material;
    material.relief = 0;
    HapticSceneBuilder builder({material});
    std::array<SurfaceLabel, 6> labels;
    labels[1].hidden = true;  // hides the face at +x, as if another solid covered it
    builder.add_box({{-0.1, -0.5, -1}, {0.1, 0.5, 0}}, labels);
    builder.set_reliefs({relief});
    const auto scene = builder.build();
    TouchState state;
    TouchTuning tuning;
    EXPECT_NEAR(press(state, *scene, tuning, 0.0, 0.004).force_n.z, 0.002 * 800.0, 1e-2);
    EXPECT_NEAR(press(state, *scene, tuning, 0.099, 0.004).force_n.z, 0.002 * 800.0,
                1e-2);  // the relief continues under the covering solid
    double last = 0.0;
    for (double x = -0.08; x > -0.1; x -= 1e-3) {
        const double force = press(state, *scene, tuning, x, 0.004).force_n.z;
        EXPECT_GE(force, last - 1e-9);
        last = force;
    }
    EXPECT_NEAR(press(state, *scene, tuning, -0.0999, 0.004).force_n.z, 0.004 * 800.0, 0.01);
}

TEST(Relief, is_felt_at_every_scale_as_ridges_with_its_period_in_hand_space) {
    for (const double scale : {1.0, 15.0, 60.0}) {
        Relief relief;
        relief.kind = ReliefKind::Sine;
        relief.depth_hand_m = 4e-4;
        relief.period_hand_m = 0.01;
        const auto scene = floor_with(relief, 1.0 * scale);
        TouchTuning tuning;
        tuning.world_m_per_hand_m = scale;
        TouchState state;
        press(state, *scene, tuning, 0.0, 0.003);
        // The hand moves at 5 cm/s for 1 s, so it passes 5 ridges. The test counts the peaks of the normal force.
        int crests = 0;
        double before = 0.0, last = 0.0;
        for (int i = 0; i < 1000; ++i) {
            const double force =
                touch_tick(state, *scene, tuning, {5e-5 * i * scale, 0, tuning.radius_m - 0.003 * scale}, 1e-3)
                    .force_n.z;
            if (i > 1 && last > before && last >= force && last > 0.0028 * 800.0 - 4e-4 * 400.0) ++crests;
            before = last;
            last = force;
        }
        EXPECT_EQ(crests, 5) << scale;
    }
}

TEST(Relief, fades_while_the_hand_is_too_fast_for_its_waves_and_returns) {
    Relief relief;
    relief.kind = ReliefKind::Sine;
    relief.depth_hand_m = 4e-4;
    relief.period_hand_m = 0.004;
    const auto scene = floor_with(relief);
    TouchTuning tuning;
    TouchState state;
    press(state, *scene, tuning, -0.9, 0.003);
    double x = -0.9;
    const auto swing_at = [&](double speed, int ticks) {
        double low = 1e9, high = 0.0;
        for (int i = 0; i < ticks; ++i) {
            x += speed * 1e-3;
            const double force = touch_tick(state, *scene, tuning, {x, 0, tuning.radius_m - 0.003}, 1e-3).force_n.z;
            if (i < ticks / 2) continue;
            low = std::min(low, force);
            high = std::max(high, force);
        }
        return high - low;
    };
    const double slow = swing_at(0.05, 1000);
    EXPECT_GT(slow, 0.02);
    EXPECT_LT(swing_at(1.2, 400), 0.02 * slow);  // faster than the limit l / (4 T) = 1 m/s
    EXPECT_NEAR(swing_at(0.05, 1000), slow, 0.05 * slow);
}

TEST(Relief, varies_friction_along_the_surface_by_its_share) {
    Relief relief;
    relief.kind = ReliefKind::Level;
    relief.period_hand_m = 0.01;
    relief.friction_share = 0.3;
    const auto scene = floor_with(relief, 1.0, 0.5);
    TouchTuning tuning;
    TouchState state;
    press(state, *scene, tuning, 0.0, 0.003);
    double low = 10.0, high = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const TouchResult r = touch_tick(state, *scene, tuning, {5e-5 * i, 0, tuning.radius_m - 0.003}, 1e-3);
        if (i < 400) continue;
        const double mu = -r.force_n.x / r.force_n.z;
        low = std::min(low, mu);
        high = std::max(high, mu);
        EXPECT_NEAR(r.force_n.z, 0.003 * 800.0, 1e-6);
    }
    EXPECT_NEAR(high, 0.5 * 1.3, 0.01);
    EXPECT_NEAR(low, 0.5 * 0.7, 0.03);
}

}  // namespace relief_test
}  // namespace handrail::test
