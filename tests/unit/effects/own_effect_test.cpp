// The developer's guide shows how to hang a force of one's own in a world. What it shows stands here, compiled and run; the last test compares.
#include <fstream>
#include <sstream>

#include "tests/unit/effects/loops.h"

namespace handrail::test {
namespace {

// [example: a new effect]
// A whirlpool: pushes round its axis, strongest at its radius. A source, so its force is kept small.
struct Whirlpool {
    Vec3 centre_m{0.0};
    double radius_hand_m = 0.02;
    double force_n = 0.5;
};

Vec3 whirl(const EffectPoint& point, const void* data) noexcept {
    const Whirlpool& pool = *static_cast<const Whirlpool*>(data);
    const Vec3 away = (point.at_m - pool.centre_m) / point.scale;  // hand metres, so it feels the same at every scale
    const double u2 = (away.x * away.x + away.y * away.y) / (pool.radius_hand_m * pool.radius_hand_m);
    return Vec3(-away.y, away.x, 0.0) * (2.0 * pool.force_n / pool.radius_hand_m / (1.0 + u2));
}

std::shared_ptr<const HapticScene> room_with_whirlpool() {
    const auto pool = std::make_shared<Whirlpool>();
    pool->centre_m = Vec3(3.0, 2.0, 1.0);
    EffectVolume effect;
    effect.region = SphereRegion{pool->centre_m, 2.0};
    effect.law = CustomLaw{whirl, pool, 2.0 * pool->force_n / pool->radius_hand_m};  // no slope is steeper
    HapticSceneBuilder builder;
    builder.add_box({{0, 0, -0.2}, {6, 4, 0}});  // a floor
    builder.add_effect(effect);
    return builder.build();
}
// [end]

TEST(OwnEffect, is_computed_each_tick) {
    const auto scene = room_with_whirlpool();
    ASSERT_EQ(scene->effects.size(), 1U);
    TouchTuning tuning;
    tuning.world_m_per_hand_m = 10.0;
    TouchState state;
    for (int i = 0; i < 360; ++i) {
        const double angle = radians_from_degrees(i);
        const Vec3 away(std::cos(angle), std::sin(angle), 0.0);
        const Vec3 force = touch_tick(state, *scene, tuning, Vec3(3, 2, 1) + away * 0.2, kTick_s).force_n;  // 20 mm of the hand
        EXPECT_NEAR(glm::length(force), 0.5, 1e-9);
        EXPECT_NEAR(glm::dot(force, away), 0.0, 1e-9) << "round its axis";
    }
    EXPECT_EQ(touch_tick(state, *scene, tuning, Vec3(0.5, 2, 1), kTick_s).force_n, Vec3(0.0)) << "and only in its place";
}

TEST(OwnEffect, stands_in_the_guide_as_it_stands_here) {
    const auto content = [](const std::string& file) {
        std::ifstream in(std::string(HANDRAIL_SOURCE_DIR) + file);
        std::stringstream all;
        all << in.rdbuf();
        return all.str();
    };
    const std::string source = content("/tests/unit/effects/own_effect_test.cpp"), begin = "// [example: a new effect]\n";
    const std::size_t from = source.find(begin) + begin.size();
    std::istringstream example(source.substr(from, source.find("// [end]") - from));
    std::string indented;
    for (std::string line; std::getline(example, line);) indented += line.empty() ? "\n" : "    " + line + "\n";
    EXPECT_GT(indented.size(), 500U);
    EXPECT_NE(content("/docs/developer.md").find(indented), std::string::npos) << "copy the example into docs/developer.md:\n" << indented;
}

}  // namespace
}  // namespace handrail::test
