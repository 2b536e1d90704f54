// Tests what the hand feels, where its workspace is and when it has force. The tests use only plain state, without a
// session.
#include <gmock/gmock.h>

#include "app/core/hand/forces.h"
#include "app/core/hand/workspace.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace hand_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Returns a floor with a block 2 m north of the base. The bead on top of the block is too small to feel at large
// scales.
std::shared_ptr<const Scene> block_with_bead() {
    test::SceneBuilder builder;
    builder.box({-5.0, -5.0, -0.5}, {5.0, 5.0, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    builder.box({-0.5, 2.0, 0.0}, {0.5, 3.0, 1.5}, "block");
    builder.box({0.0, 2.5, 1.5}, {0.02, 2.52, 1.52}, "bead");
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

struct WithHand {
    explicit WithHand(bool present = true) : plain(block_with_bead()) {
        plain.hands.right.present = present;
        plain.hands.right.simulated = true;
        plain.hands.right.spec = *find_device_spec("sim-t");
    }
    void enter() {
        touch.enter_world(nullptr, 0.0);
        workspace.publish(0.0, PoseChange::Placed);
        feel_at(plain.hands.pose.origin_m);
    }
    // Makes the servo report that the hand is at `place_m`, in the present workspace.
    void feel_at(const Vec3& place_m) {
        ToolState& tool = plain.hands.tool;
        tool.ticks = 1;
        tool.waiting_for_hand = false;
        tool.hip_m = tool.proxy_m = place_m;
        tool.workspace_jump = plain.hands.pose.jump;
        // This formula requires that the workspace faces north.
        tool.hand_m = (place_m - plain.hands.pose.origin_m) / scale_now();
    }
    double scale_now() const { return plain.hands.tuning.touch.world_m_per_hand_m; }
    // Returns the place in the world of a hand at `hand_m` in the device's frame.
    Vec3 world_m(const Vec3& hand_m) const { return plain.hands.pose.origin_m + hand_m * scale_now(); }

    test::PlainSession plain;
    HeldKeys keys;
    TouchView touch{plain.context, plain.world, plain.avatar, plain.hands};
    Workspace workspace{plain.context, plain.hands, keys, touch};
    Forces forces{plain.context, plain.hands};
};

TEST(TouchViewFeature, announces_once_what_the_scale_omits) {
    WithHand one;
    one.plain.person.settings.workspace.scale = 200.0;
    one.enter();
    ASSERT_TRUE(one.touch.take_made(0.5));
    ASSERT_EQ(one.touch.plan().left_out.size(), 1U);
    EXPECT_EQ(one.plain.world.scene->features[one.touch.plan().left_out[0].value].name, "bead");
    EXPECT_THAT(one.touch.news(), HasSubstr("small thing"));
    EXPECT_EQ(one.touch.news(), "");
    EXPECT_EQ(one.scale_now(), 200.0);
    one.plain.person.settings.haptic.simplify = false;
    one.touch.retune();
    EXPECT_TRUE(one.touch.stale());
    const auto felt = one.touch.felt();
    one.touch.adapt();
    EXPECT_EQ(one.touch.felt(), felt) << "until it is taken";
    EXPECT_TRUE(one.touch.take_made(1.0));
    EXPECT_NE(one.touch.felt(), felt);
    EXPECT_FALSE(one.touch.stale());
    EXPECT_EQ(one.touch.news(), phrase("simplify.nothing"));
}

TEST(TouchViewFeature, keeps_the_old_felt_scene_until_the_new_one_is_adopted) {
    WithHand one;
    one.plain.person.settings.workspace.scale = 200.0;
    one.enter();
    const auto sharp = one.touch.felt();
    EXPECT_TRUE(one.touch.busy());
    EXPECT_TRUE(one.touch.plan().changes_nothing());
    ASSERT_TRUE(one.touch.take_made(1.0));
    EXPECT_NE(one.touch.felt(), sharp);
    EXPECT_FALSE(one.touch.plan().changes_nothing());
}

TEST(TouchViewFeature, requests_openings_again_that_were_not_known_yet) {
    WithHand one;
    int queries = 0;
    bool awaited = true;
    one.touch.openings = [&] {
        ++queries;
        return KnownOpenings{{}, awaited};
    };
    one.plain.person.settings.workspace.scale = 400.0;
    one.enter();
    ASSERT_GT(queries, 0);
    one.touch.take_made(0.5);
    const int before = queries;
    one.touch.widen_openings(false);
    EXPECT_EQ(queries, before) << "nobody has found the rooms yet";
    awaited = false;
    one.touch.widen_openings(true);
    EXPECT_GT(queries, before);
    EXPECT_FALSE(one.touch.take_made(1.0)) << "there were none, so nothing is felt otherwise";
    const int after = queries;
    one.touch.widen_openings(true);
    EXPECT_EQ(queries, after) << "they are known now";
}

TEST(WorkspaceFeature, keeps_the_place_under_the_hand_when_the_scale_changes) {
    WithHand one;
    one.enter();
    const Vec3 place = one.plain.hands.pose.origin_m + Vec3(2.0, -0.6, 0.3);
    one.feel_at(place);
    const Vec3 hand = one.plain.hands.tool.hand_m;
    const std::uint32_t jump = one.plain.hands.pose.jump;
    EXPECT_TRUE(one.workspace.act(Command::ScaleDetail, 1.0));
    EXPECT_THAT(one.plain.said(), ElementsAre(HasSubstr("etail")));
    EXPECT_GT(one.plain.hands.pose.jump, jump);
    EXPECT_LT(glm::length(one.world_m(hand) - place), 1e-9);
}

TEST(WorkspaceFeature, needs_a_hand_and_reports_if_there_is_none) {
    WithHand one(false);
    one.enter();
    for (const Command command : {Command::ScaleRoom, Command::WorkspaceLeft, Command::WorkspaceCentre, Command::Grab,
                                  Command::WorkspaceTurnLeft}) {
        EXPECT_TRUE(one.workspace.act(command, 0.0));
        EXPECT_THAT(one.plain.said(), ElementsAre(phrase("session.no_hand")));
    }
    EXPECT_FALSE(one.workspace.act(Command::Forward, 0.0)) << "another's command";
    EXPECT_FALSE(one.workspace.pushed(0.0));
}

TEST(WorkspaceFeature, moves_briefly_on_a_tap_and_for_as_long_as_a_key_is_held) {
    WithHand one;
    one.enter();
    EXPECT_TRUE(one.workspace.act(Command::WorkspaceRight, 1.0));
    one.plain.context.tick_s = 1.1;
    EXPECT_FALSE(one.workspace.idle());
    one.workspace.push(Vec3(0.0), 1.1);
    EXPECT_GT(one.plain.hands.tuning.workspace.push_hand_m_per_s.x, 0.0);
    one.plain.context.tick_s = 1.5;
    EXPECT_TRUE(one.workspace.idle());
    one.workspace.push({0.0, 0.01, 0.0}, 1.5);
    EXPECT_EQ(one.plain.hands.tuning.workspace.push_hand_m_per_s, Vec3(0.0, 0.01, 0.0)) << "as it is carried";
    one.keys.press(Command::WorkspaceUp);
    one.workspace.push({0.0, 0.01, 0.0}, 2.0);
    EXPECT_GT(one.plain.hands.tuning.workspace.push_hand_m_per_s.z, 0.0);
    EXPECT_EQ(one.plain.hands.tuning.workspace.push_hand_m_per_s.y, 0.0) << "keys count first";
}

TEST(WorkspaceFeature, moves_a_hand_out_of_a_solid_that_it_is_in) {
    WithHand one;
    one.enter();
    EXPECT_EQ(one.workspace.bring_out(one.workspace.middle_m(), false, 0.0), "");
    const Vec3 inside(0.0, 2.2, 0.7);
    one.feel_at(inside);
    const Vec3 hand = one.plain.hands.tool.hand_m;
    EXPECT_THAT(one.workspace.bring_out(one.workspace.middle_m(), false, 1.0), HasSubstr("lock"));
    const Vec3 out = one.world_m(hand);
    EXPECT_LT(out.y, 2.0 - 0.5 * one.plain.hands.tuning.touch.radius_m) << "the nearest side";
}

TEST(WorkspaceFeature, moves_the_simulated_hand_no_farther_than_its_reach) {
    WithHand one;
    one.enter();
    EXPECT_TRUE(one.workspace.act(Command::HandUp, 0.0));
    EXPECT_GT(one.workspace.hand_target_m().z, 0.0);
    one.keys.press(Command::HandLeft);
    for (int i = 0; i < 600; ++i) one.workspace.move_hand_by_keys(1.0 / 60.0);
    EXPECT_NEAR(glm::length(one.workspace.hand_target_m()), one.plain.hands.right.spec.workspace_radius_m, 1e-9);
    EXPECT_TRUE(one.workspace.act(Command::HandCentre, 0.0));
    EXPECT_EQ(one.workspace.hand_target_m(), Vec3(0.0));
}

TEST(ForcesFeature, stop_at_once_and_return_with_their_key) {
    WithHand one;
    EXPECT_TRUE(one.forces.know_stops(1)) << "the switch was pressed";
    EXPECT_TRUE(one.forces.stop(1.0));
    EXPECT_TRUE(one.plain.hands.tuning.panic);
    EXPECT_THAT(one.plain.said(), ElementsAre(HasSubstr("topped")));
    EXPECT_FALSE(one.forces.stop(1.1)) << "the window tells of the same press";
    EXPECT_FALSE(one.forces.know_stops(1));
    EXPECT_TRUE(one.forces.act(Command::ToggleForces, 2.0));
    EXPECT_FALSE(one.plain.hands.tuning.panic);
    EXPECT_TRUE(one.plain.hands.tuning.forces_on);
    EXPECT_EQ(one.plain.hands.tuning.stops_let_go, 1U);
    EXPECT_THAT(one.plain.said(), ElementsAre(phrase("session.forces_on")));
    EXPECT_TRUE(one.forces.act(Command::ToggleForces, 3.0));
    EXPECT_FALSE(one.plain.hands.tuning.forces_on);
    EXPECT_FALSE(one.forces.act(Command::Home, 3.0)) << "another's command";
}

TEST(ForcesFeature, accept_an_offered_device_with_the_same_key) {
    WithHand one(false);
    one.forces.offer("Touch", 0.0);
    EXPECT_FALSE(one.plain.requests.take_offered_hand());
    EXPECT_TRUE(one.forces.act(Command::ToggleForces, 1.0));
    EXPECT_TRUE(one.plain.requests.take_offered_hand());
    EXPECT_FALSE(one.plain.requests.take_offered_hand()) << "true once";
    EXPECT_EQ(one.plain.said().size(), 1U);
    EXPECT_TRUE(one.forces.act(Command::ToggleForces, 2.0));
    EXPECT_THAT(one.plain.said(), ElementsAre(phrase("session.no_hand")));
}

TEST(ForcesFeature, suggest_a_break_after_every_quarter_hour_of_touching_with_any_device) {
    WithHand one;
    one.plain.hands.tool.contact_s = 10.0 * 60.0;
    one.forces.announce_break(1.0);
    EXPECT_THAT(one.plain.said(), IsEmpty());
    one.forces.take(one.plain.hands.right);
    EXPECT_EQ(one.plain.hands.tool.contact_s, 0.0);
    one.plain.hands.tool.contact_s = 6.0 * 60.0;
    one.forces.announce_break(2.0);
    EXPECT_EQ(one.plain.said().size(), 1U) << "sixteen minutes with both";
    one.forces.announce_break(3.0);
    EXPECT_THAT(one.plain.said(), IsEmpty());
}

TEST(ForcesFeature, announce_when_an_overheated_device_may_act_again) {
    WithHand one;
    ToolState& tool = one.plain.hands.tool;
    tool.fault = Fault::TooHot;
    tool.fault_latched = tool.fault_lasts = true;
    EXPECT_TRUE(one.forces.act(Command::ToggleForces, 0.0));
    one.forces.tick(0.0);
    EXPECT_THAT(one.plain.said(), ElementsAre(phrase("session.too_warm")));
    tool.fault_lasts = false;
    one.forces.tick(1.0);
    EXPECT_EQ(one.plain.said().size(), 1U);
    one.forces.tick(2.0);
    EXPECT_THAT(one.plain.said(), IsEmpty());
}

}  // namespace hand_test
}  // namespace handrail
