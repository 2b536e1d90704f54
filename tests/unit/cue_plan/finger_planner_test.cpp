// Tests what a pad signals to the fingers about walls, doors, materials and stairs.
#include "audio-cues/plan/finger_planner.h"

#include "tests/support/names.h"
#include "tests/support/precompiled.h"

namespace handrail {
namespace finger_planner_test {

enum : std::uint32_t { kWall, kCushion, kDoor };
enum : std::uint16_t { kDefault, kBrick, kSoft, kRibbed };

std::shared_ptr<const Scene> world() {
    auto scene = std::make_shared<Scene>();
    scene->materials.resize(4);
    scene->materials[kBrick].sound = SoundClass::Brick;
    scene->materials[kBrick].stiffness_fraction = 1.0;
    scene->materials[kSoft].stiffness_fraction = 0.2;
    scene->materials[kRibbed].wave =
        TextureWave{.shape = WaveShape::Sine, .depth_hand_m = 0.0005, .period_hand_m = 0.002};
    scene->features.resize(3);
    scene->features[kWall].material = kBrick;
    scene->features[kCushion].material = kSoft;
    scene->features[kDoor].kind = FeatureKind::Door;
    return scene;
}

class FingerPlannerTest : public testing::Test {
protected:
    FingerPlannerTest() { planner.enter_world(world()); }
    CueRequest request(CueRequestKind kind, FeatureId feature = kNoFeature) {
        CueRequest made;
        made.kind = kind;
        made.time_s = now_s;
        made.feature = feature;
        return made;
    }
    FingerCue tick(std::vector<CueRequest> requests = {}, const ToolState* tool = nullptr,
                   double passage_width_m = 0.0) {
        const FingerCue cue =
            planner.tick({.now_s = now_s, .requests = requests, .tool = tool, .passage_width_m = passage_width_m});
        now_s += 1.0 / 60.0;
        return cue;
    }
    FingerCue after(double seconds) {
        now_s += seconds;
        return tick();
    }
    FingerPlanner planner;
    double now_s = 1.0;
};

TEST_F(FingerPlannerTest, outputs_nothing_without_input) { EXPECT_EQ(tick(), FingerCue{}); }

TEST_F(FingerPlannerTest, a_bump_knocks_and_then_stays_as_stiff_as_the_wall_is_hard) {
    const FingerCue wall = tick({request(CueRequestKind::Bump, FeatureId{kWall})});
    EXPECT_EQ(wall.nearness, 1.0);
    EXPECT_EQ(wall.hardness, 1.0);
    EXPECT_EQ(wall.knock, 1.0);
    const FingerCue held = after(FingerPlanner::kKnock_s);
    EXPECT_EQ(held.knock, 0.0);
    EXPECT_EQ(held.nearness, 1.0);
    EXPECT_EQ(after(FingerPlanner::kBumpHolds_s), FingerCue{});
    const FingerCue cushion = tick({request(CueRequestKind::Bump, FeatureId{kCushion})});
    EXPECT_EQ(cushion.hardness, 0.2);
    EXPECT_LT(cushion.knock, 0.6);
}

TEST_F(FingerPlannerTest, a_wall_ahead_stiffens_on_approach_but_never_as_much_as_one_that_is_touched) {
    double last = -1.0;
    for (double loudness = 0.0; loudness <= 1.0; loudness += 0.25) {
        CueRequest tone = request(CueRequestKind::WallTone);
        tone.loudness = loudness;
        const double nearness = tick({tone}).nearness;
        EXPECT_GT(nearness, last);
        last = nearness;
    }
    EXPECT_LE(last, 0.5);
    EXPECT_EQ(tick().nearness, last) << "until told otherwise";
    EXPECT_EQ(tick({request(CueRequestKind::SilenceAll)}), FingerCue{}) << "the stop key";
}

TEST_F(FingerPlannerTest, a_passage_no_wider_than_a_door_clicks_once_on_entry) {
    EXPECT_FALSE(tick({}, nullptr, 4.0).doorway);
    EXPECT_TRUE(tick({}, nullptr, 0.9).doorway);
    now_s += FingerPlanner::kClick_s;
    EXPECT_FALSE(tick({}, nullptr, 0.9).doorway) << "a corridor is one click, not a hundred";
    EXPECT_FALSE(tick({}, nullptr, 1.6).doorway);
    EXPECT_FALSE(tick({}, nullptr, 0.9).doorway) << "it did not get wide between";
    tick({}, nullptr, 0.0);
    EXPECT_TRUE(tick({}, nullptr, 0.9).doorway);
}

TEST_F(FingerPlannerTest, a_door_that_is_bumped_or_touched_clicks) {
    EXPECT_TRUE(tick({request(CueRequestKind::Bump, FeatureId{kDoor})}).doorway);
    EXPECT_FALSE(after(FingerPlanner::kBumpHolds_s).doorway);
    ToolState tool;
    tool.contacts.count = 1;
    tool.contacts.contacts[0].feature = FeatureId{kDoor};
    EXPECT_TRUE(tick({}, &tool).doorway);
    now_s += FingerPlanner::kClick_s;
    EXPECT_FALSE(tick({}, &tool).doorway) << "once for each touch";
}

TEST_F(FingerPlannerTest, a_hand_feels_force_as_stiffness_and_texture_at_its_own_frequency) {
    ToolState tool;
    tool.contacts.count = 1;
    tool.contacts.contacts[0].material = kRibbed;
    tool.force_n = {0.0, 0.0, 0.3};
    const FingerCue light = tick({}, &tool);
    tool.force_n = {0.0, 0.0, 1.5};
    const FingerCue heavy = tick({}, &tool);
    EXPECT_LT(light.nearness, heavy.nearness);
    EXPECT_EQ(heavy.nearness, 1.0);
    EXPECT_EQ(heavy.material_hz, 0.0) << "a hand at rest";
    tool.hand_m.x += 0.05 / 60.0;  // the hand moves at 50 mm a second over ribs that are 2 mm apart
    const FingerCue sliding = tick({}, &tool);
    EXPECT_NEAR(sliding.material_hz, 25.0, 0.01);
    EXPECT_GT(sliding.grain, 0.0);
    tool.contacts.contacts[0].material = kBrick;
    tool.hand_m.x += 0.05 / 60.0;
    EXPECT_EQ(tick({}, &tool).material_hz, grain_hz(SoundClass::Brick));
}

TEST_F(FingerPlannerTest, stairs_resist_on_the_left_and_footsteps_give_the_grain_of_the_floor) {
    const auto step = [&](double x, double z) {
        CueRequest made = request(CueRequestKind::Footstep);
        made.material = SoundClass::Stone;
        made.position_m = {x, 0.0, z};
        return made;
    };
    EXPECT_EQ(tick({step(0.0, 0.0)}).slope, 0.0);
    EXPECT_GT(tick({step(0.7, 0.0)}).grain, 0.0);
    EXPECT_NEAR(tick({step(1.0, 0.18)}).slope, 1.0, 1e-9);
    EXPECT_NEAR(tick({step(2.0, 0.0)}).slope, 0.3, 1e-9) << "down a ramp";
    EXPECT_EQ(tick({step(50.0, 3.0)}).slope, 0.0) << "carried elsewhere";
}

TEST_F(FingerPlannerTest, each_kind_of_cue_can_be_switched_off_and_all_can_be_weakened) {
    const auto bump = [&] { return tick({request(CueRequestKind::Bump, FeatureId{kWall})}); };
    planner.set_settings({.triggers = false});
    EXPECT_EQ(bump().nearness, 0.0);
    EXPECT_EQ(bump().knock, 1.0);
    planner.set_settings({.rumble = false});
    EXPECT_EQ(bump().nearness, 1.0);
    EXPECT_EQ(bump().knock, 0.0);
    planner.set_settings({.strength = 0.25});
    EXPECT_EQ(bump().nearness, 0.25);
    EXPECT_EQ(bump().knock, 0.25);
}

}  // namespace finger_planner_test
}  // namespace handrail
