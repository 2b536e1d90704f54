// Tests the virtual cane: what its tip meets, how it sweeps, and how much of the ground it covers.

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/with_cane.h"

namespace handrail {
namespace cane_test {

using settings::CaneTechnique;
using test::SceneBuilder;
using test::WithCane;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double kLength_m = 1.3;

SceneBuilder on_a_floor() {
    SceneBuilder b;
    b.box({-20, -20, -0.5}, {20, 20, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.start({0, 0, 0}, 0.0);
    return b;
}

CaneTip tip_on(SceneBuilder& b, double bearing_rad = 0.0, bool lifted = false) {
    const auto scene = b.share();
    const WalkerWorld world(scene);
    return put_cane(world, Vec3(0.0), bearing_rad, kLength_m, ground_rules(*scene, walker_size(*scene, 0.25)), lifted);
}

TEST(CaneTip, meets_the_ground_at_its_reach_and_tells_its_material) {
    SceneBuilder b = on_a_floor();
    const CaneTip tip = tip_on(b);
    EXPECT_EQ(tip.meets, CaneMeets::Ground);
    EXPECT_NEAR(tip.place_m.y, cane_reach_m(kLength_m), 1e-6);
    EXPECT_EQ(b.scene().material(tip.material).sound, SoundClass::Wood);
}

TEST(CaneTip, tells_steps_drops_and_obstacles_apart) {
    struct Case {
        double low_m, high_m;
        CaneMeets meets;
    };
    for (const Case& one : {Case{-0.5, 0.05, CaneMeets::Ground}, Case{-0.5, 0.17, CaneMeets::Higher},
                            Case{0.0, 0.7, CaneMeets::Obstacle}, Case{-3.0, -0.05, CaneMeets::Ground},
                            Case{-3.0, -0.17, CaneMeets::Lower}, Case{-3.0, -0.9, CaneMeets::Drop}}) {
        SceneBuilder b;
        b.box({-5, -5, -3}, {5, 1.0, 0}, "floor");
        b.box({-5, 1.0, one.low_m}, {5, 5, one.high_m}, "block");
        EXPECT_EQ(tip_on(b).meets, one.meets) << one.high_m;
    }
    SceneBuilder nothing;
    nothing.box({-5, -5, -3}, {5, 1.0, 0}, "floor");
    EXPECT_EQ(tip_on(nothing).meets, CaneMeets::Drop);
    EXPECT_FALSE(tip_on(nothing).depth_m);
}

TEST(CaneTip, takes_ramps_for_ground_and_misses_what_hangs_above_its_shaft) {
    SceneBuilder up = on_a_floor();
    up.ramp({-5, 0.5, 0}, {5, 10, 0.95}, "ramp");
    EXPECT_EQ(tip_on(up).meets, CaneMeets::Ground);
    SceneBuilder down;
    down.box({-5, -0.5, -3}, {5, 5, 0}, "floor");
    down.ramp({-5, -6.5, -1.0}, {5, -0.5, 0}, "ramp");
    EXPECT_EQ(tip_on(down, kPi).meets, CaneMeets::Ground);
    SceneBuilder hanging = on_a_floor();
    hanging.box({-1, 1.0, 0.9}, {1, 1.5, 2.0}, "cupboard on the wall");
    EXPECT_EQ(tip_on(hanging).meets, CaneMeets::Ground);
}

TEST(CaneTip, that_is_lifted_meets_only_what_stands_in_its_path) {
    SceneBuilder b;
    b.box({-5, -5, -3}, {5, 1.0, 0}, "floor");
    EXPECT_EQ(tip_on(b, 0.0, true).meets, CaneMeets::Ground) << "a lifted tip cannot feel the drop";
    b.box({-5, 1.0, -3}, {5, 5, 1}, "wall");
    EXPECT_EQ(tip_on(b, 0.0, true).meets, CaneMeets::Obstacle);
}

TEST(Cane, is_silent_until_it_is_taken_out) {
    SceneBuilder b = on_a_floor();
    WithCane person(b.share());
    person.walk(3.0);
    EXPECT_THAT(person.sounds, IsEmpty());
    person.take_out(CaneTechnique::ConstantContact);
    person.walk(3.0);
    ASSERT_FALSE(person.sounds.empty());
    EXPECT_EQ(person.sounds.front().material, SoundClass::Wood);
    person.cane.act(Command::Cane, person.now_s);
    person.sounds.clear();
    person.walk(3.0);
    EXPECT_THAT(person.sounds, IsEmpty());
}

TEST(Cane, finds_drops_that_are_then_not_announced_from_afar) {
    SceneBuilder b;
    b.box({-5, -5, -3}, {5, 4.0, 0}, "floor");
    b.start({0, 0, 0}, 0.0);
    WithCane person(b.share());
    person.walk(2.3);
    EXPECT_THAT(person.said, Contains(HasSubstr("Drop, "))) << "without the cane, from two metres";
    person.stand(Vec3(0.0), 0.0);
    person.take_out(CaneTechnique::ConstantContact);
    person.walk(2.3);
    EXPECT_THAT(person.said, Not(Contains(HasSubstr("Drop"))));
    person.walk(1.0);
    EXPECT_THAT(person.said, Contains("Drop at the cane's tip, very deep"));
}

TEST(Cane, is_swept_by_keys_by_the_stick_by_a_turning_pad_and_by_the_hand) {
    SceneBuilder b = on_a_floor();
    b.box({-1.2, -1, 0}, {-1.0, 1, 1}, "left post", SolidRole::Solid, "metal");
    b.box({1.0, -1, 0}, {1.2, 1, 1}, "right post", SolidRole::Solid, "metal");
    WithCane person(b.share());
    person.cane.act(Command::CaneLeft, 0.0);
    person.tick();
    EXPECT_THAT(person.said, Contains(HasSubstr("The cane is not out.")));
    person.take_out(CaneTechnique::ConstantContact);
    person.cane.act(Command::CaneLeft, person.now_s);
    EXPECT_FALSE(person.cane.idle());
    person.run(0.5);
    EXPECT_TRUE(person.cane.idle());
    EXPECT_THAT(person.said, Not(Contains(HasSubstr("Left post")))) << "a tap ends beside the body";
    EXPECT_THAT(person.said, Contains("Wood")) << "a sweep that meets nothing tells the ground";
    person.keys.press(Command::CaneLeft);
    person.run(1.0);
    person.keys.release(Command::CaneLeft);
    EXPECT_THAT(person.said, Contains(HasSubstr("Left post")));
    const Steering left = person.cane.take({0.5, 0.25, 0.9});
    EXPECT_EQ(left, (Steering{0.5, 0.25, 0.0})) << "the stick points the cane instead of turning the walker";
    person.tick();
    EXPECT_THAT(person.said, Contains(HasSubstr("Right post")));
    person.cane.take({});
    person.run(2.0);
    person.said.clear();
    person.cane.take({.cane_right_rad_per_s = -1.2});
    person.run(2.0);
    EXPECT_THAT(person.said, Contains(HasSubstr("Left post"))) << "a pad that turns in the hand swings the cane";
    person.cane.take({});
    person.run(2.0);
    person.said.clear();
    HandFacts hand;
    hand.present = true;
    person.plain.hands.right = hand;
    person.plain.hands.tool.ticks = 1;
    for (double angle = 0.0; angle > -1.3; angle -= 0.02) {
        person.plain.hands.tool.proxy_m = 2.0 * forward_of_heading(angle);
        person.tick();
    }
    EXPECT_THAT(person.said, Contains(HasSubstr("Left post")));
}

// A sweep that never ended would keep the terminal waiting before it takes the next line.
TEST(Cane, ends_its_sweep_and_makes_no_sound_while_everything_is_stopped) {
    SceneBuilder b = on_a_floor();
    b.box({-1.2, -1, 0}, {-1.0, 1, 1}, "left post", SolidRole::Solid, "metal");
    WithCane person(b.share());
    person.take_out(CaneTechnique::ConstantContact);
    person.cane.act(Command::CaneLeft, person.now_s);
    person.tick();
    person.said.clear();
    person.plain.hands.tuning.panic = true;
    person.run(0.5);
    EXPECT_TRUE(person.cane.idle());
    EXPECT_THAT(person.said, IsEmpty());
    person.cane.act(Command::CaneRight, person.now_s);
    person.tick();
    EXPECT_TRUE(person.cane.idle());
    EXPECT_THAT(person.said, Contains(HasSubstr("turns sounds on again")));
}

TEST(Cane, follows_the_shoreline_and_tells_where_it_ends) {
    SceneBuilder b = on_a_floor();
    b.box({0.7, -5, 0}, {0.9, 5, 2.5}, "wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    WithCane person(b.share());
    person.take_out(CaneTechnique::Shoreline);
    person.walk(4.0);
    EXPECT_THAT(person.said, Contains(HasSubstr("Wall")));
    EXPECT_THAT(person.said, Not(Contains(HasSubstr("Shoreline ends"))));
    person.walk(3.0);
    EXPECT_EQ(std::count(person.said.begin(), person.said.end(), "Shoreline ends on the right"), 1);
}

// Returns the share of the strip in front of the body, as wide as the body, of which the tip has touched a place within
// 15 cm before the body came there.
double covered_share(CaneTechnique technique) {
    SceneBuilder b = on_a_floor();
    WithCane person(b.share());
    person.stand({0, -8, 0}, 0.0);
    person.take_out(technique);
    std::vector<std::pair<double, Vec3>> touched;  // where the body was, and where the tip was
    person.keys.press(Command::Forward);
    while (person.plain.avatar.feet_m().y < 4.0) {
        person.sounds.clear();
        person.tick();
        for (const CueRequest& sound : person.sounds)
            touched.emplace_back(person.plain.avatar.feet_m().y, sound.position_m);
    }
    int cells = 0, covered = 0;
    for (double y = -5.0; y < 4.0; y += 0.05)
        for (double x = -0.25; x <= 0.25; x += 0.05) {
            ++cells;
            covered += std::any_of(touched.begin(), touched.end(), [&](const auto& one) {
                return one.first < y - 0.25 && glm::length(Vec2(one.second.x - x, one.second.y - y)) <= 0.15;
            });
        }
    return static_cast<double>(covered) / cells;
}

TEST(Cane, covers_more_of_the_ground_ahead_in_constant_contact_than_by_two_touches) {
    const double constant = covered_share(CaneTechnique::ConstantContact), two = covered_share(CaneTechnique::TwoPoint);
    std::cout << "covered: constant contact " << constant << ", two-point touch " << two << "\n";
    EXPECT_GT(constant, 0.5);
    EXPECT_LT(two, 0.5 * constant);
}

}  // namespace cane_test
}  // namespace handrail
