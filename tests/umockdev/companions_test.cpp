// Runs a session with gamepads and SpaceMouse pucks. A stick moves the walker into a wall, and the pad signals the
// wall. The real hidapi runs on hidraw nodes that umockdev emulates.
#include "app/companions/companion_session.h"
#include "haptic/drivers/playstation_pad.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/umockdev/mock_hidraw.h"
#include "tests/umockdev/mock_stick.h"

namespace handrail {
namespace companions_test {

using test::MockHidraw;
using testing::Contains;
using testing::HasSubstr;

// Returns a hall with a brick wall in the north, which is two metres ahead of the base.
std::shared_ptr<const Scene> hall() {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {6, 4, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    b.box({-0.2, 4, 0}, {6.2, 4.2, 2.6}, "north wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    b.start({3, 2, 0}, 0.0);
    return b.share();
}

class Companions : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(umockdev_in_mock_environment()) << "this program needs LD_PRELOAD=libumockdev-preload.so.0";
    }

    // Runs in virtual time until the condition is true or `seconds` have passed. In each frame, the pad's thread, the
    // app and the cues run in a fixed order.
    template <class Condition>
    bool run_until(Condition&& condition, double seconds) {
        for (const double end_s = clock_.now_s() + seconds; clock_.now_s() < end_s;) {
            clock_.advance_s(1.0 / 60.0);
            session_.devices().step();
            for (std::string& sentence : session_.guide(app_, clock_.now_s(), busy_elsewhere_))
                news_.push_back(std::move(sentence));
            app_.tick(clock_.now_s(), {});
            for (const CueRequest& cue : cues_ = app_.take_cues())
                if (cue.kind == CueRequestKind::Say) said_.push_back(cue.text);
            session_.follow(app_, cues_, nullptr, clock_.now_s());
            if (condition()) return true;
        }
        return false;
    }
    void push(test::PadEmulator& pad, MockHidraw& node, std::array<std::uint8_t, 4> sticks,
              std::array<std::uint8_t, 3> keys = {8, 0, 0}) {
        {
            const std::lock_guard guard(node.lock);
            pad.sticks = sticks;
            pad.keys = keys;
            pad.send();
        }
        node.ring();
    }
    void walk_into_the_wall(bool bluetooth);

    struct Bed {
        UMockdevTestbed* bed = umockdev_testbed_new();
        ~Bed() { g_object_unref(bed); }
    } bed_;
    bool busy_elsewhere_ = false;
    VirtualClock clock_;
    CompanionSession session_{clock_, false};
    Session app_{Settings{}, HandFacts{}};
    std::vector<std::string> news_, said_;
    std::vector<CueRequest> cues_;
};

void Companions::walk_into_the_wall(bool bluetooth) {
    app_.apply(WorldEntered{make_ready(hall())}, 0.0);
    test::PadEmulator pad(true, bluetooth);
    MockHidraw node(bed_.bed, pad, {0, bluetooth, 0x054c, 0x0ce6, "DualSense Wireless Controller"});
    ASSERT_TRUE(run_until([&] { return session_.devices().any(); }, 5.0));
    EXPECT_THAT(news_, Contains(HasSubstr("I found a DualSense. The left stick walks")));

    push(pad, node, {128, 0, 128, 128});
    // The trigger must stiffen as the walker comes nearer to the wall.
    ASSERT_TRUE(run_until([&] { return app_.feet_m().y > 2.8; }, 5.0));
    {
        const std::lock_guard guard(node.lock);
        EXPECT_EQ(pad.right_effect[0], 0x21) << "resists";
        EXPECT_EQ(pad.strong, 0) << "no wall was met yet";
    }
    bool knocked = false;
    ASSERT_TRUE(run_until(
        [&] {
            const std::lock_guard guard(node.lock);
            knocked = knocked || pad.strong > 200;
            return knocked && pad.right_effect == trigger_resists(2, 8);  // the stiffest setting, for brick
        },
        5.0))
        << app_.feet_m().y;
    EXPECT_NEAR(app_.feet_m().y, 4.0 - 0.25, 0.01) << "the body stands at the wall";
    EXPECT_TRUE(run_until([&] { return pad.strong == 0; }, 1.0)) << "a knock is short";

    // The right stick must turn the walker to the right. When the person releases the stick, the session must announce
    // the new direction.
    push(pad, node, {128, 128, 255, 128});
    ASSERT_TRUE(run_until([&] { return app_.heading_rad() > radians_from_degrees(80.0); }, 5.0));
    said_.clear();
    push(pad, node, {128, 128, 128, 128});
    ASSERT_TRUE(run_until([&] { return !said_.empty(); }, 1.0));
    EXPECT_EQ(said_.front(), "East");

    // The cross button must announce where the walker is.
    said_.clear();
    push(pad, node, {128, 128, 128, 128}, {8 | 0x20, 0, 0});
    ASSERT_TRUE(run_until([&] { return !said_.empty(); }, 1.0));
    EXPECT_THAT(said_.front(), HasSubstr("Test world, facing"));
    {
        const std::lock_guard guard(node.lock);
        EXPECT_EQ(pad.bad, 0U);
        EXPECT_EQ(pad.sequence_breaks, 0);
        pad.unplugged = true;
    }
    node.ring();
    news_.clear();
    ASSERT_TRUE(run_until([&] { return !session_.devices().any(); }, 5.0));
    EXPECT_THAT(news_, Contains("The DualSense was unplugged."));
    EXPECT_EQ(session_.devices().steering(), Steering{});
}

TEST_F(Companions, a_dual_sense_on_usb_walks_the_body_into_a_wall_and_gets_the_cue) { walk_into_the_wall(false); }
TEST_F(Companions, a_dual_sense_on_bluetooth_walks_the_body_into_a_wall_and_gets_the_cue) { walk_into_the_wall(true); }

TEST_F(Companions, a_press_while_the_person_is_busy_elsewhere_has_no_effect_then_or_later) {
    app_.apply(WorldEntered{make_ready(hall())}, 0.0);
    test::PadEmulator pad(true, false);
    MockHidraw node(bed_.bed, pad, {0, false, 0x054c, 0x0ce6, "DualSense Wireless Controller"});
    busy_elsewhere_ = true;
    ASSERT_TRUE(run_until([&] { return session_.devices().any(); }, 5.0));
    EXPECT_THAT(news_, Contains(HasSubstr("I found a DualSense"))) << "what was found is told all the same";
    said_.clear();
    push(pad, node, {128, 0, 128, 128}, {8 | 0x20, 0, 0});
    ASSERT_TRUE(run_until([&] { return session_.devices().steering().ahead > 0.9; }, 5.0));
    push(pad, node, {128, 0, 128, 128});
    EXPECT_FALSE(run_until([&] { return app_.feet_m().y > 2.01 || !said_.empty(); }, 1.0));
    // The person is still pushing the stick, which must have an effect from now on. The earlier press of the button
    // must have no effect.
    busy_elsewhere_ = false;
    EXPECT_TRUE(run_until([&] { return app_.feet_m().y > 2.2; }, 5.0));
    EXPECT_TRUE(said_.empty()) << said_.front();
}

TEST_F(Companions, a_space_mouse_walks_and_turns_and_counts_as_at_rest_when_it_falls_silent) {
    app_.apply(WorldEntered{make_ready(hall())}, 0.0);
    test::PuckEmulator puck;
    MockHidraw node(bed_.bed, puck, {2, false, 0x046d, 0xc626, "SpaceNavigator"});
    ASSERT_TRUE(run_until([&] { return session_.devices().any(); }, 5.0));
    EXPECT_THAT(news_, Contains(HasSubstr("I found a SpaceMouse. Push it to walk")));
    {
        const std::lock_guard guard(node.lock);
        EXPECT_TRUE(puck.light);
        puck.send(1, {0, -20, 0});  // this deflection is within the dead band
    }
    node.ring();
    const Vec3 at = app_.feet_m();
    EXPECT_FALSE(run_until([&] { return app_.feet_m() != at; }, 0.1));
    {
        const std::lock_guard guard(node.lock);
        puck.send(1, {0, -350, 0});
        puck.send(2, {0, 0, 350});
    }
    node.ring();
    ASSERT_TRUE(run_until([&] { return app_.feet_m().y > 2.04 && app_.heading_rad() > 0.05; }, 1.0));
    EXPECT_TRUE(run_until([&] { return session_.devices().steering() == Steering{}; }, 1.0)) << "silent for 100 ms";
    session_.devices().stop();
    const std::lock_guard guard(node.lock);
    EXPECT_FALSE(puck.light);
}

TEST_F(Companions, triggers_are_loose_and_coils_still_when_the_session_ends) {
    app_.apply(WorldEntered{make_ready(hall())}, 0.0);
    test::PadEmulator pad(true, false);
    MockHidraw node(bed_.bed, pad, {0, false, 0x054c, 0x0ce6, "DualSense Wireless Controller"});
    push(pad, node, {128, 0, 128, 128});
    ASSERT_TRUE(run_until(
        [&] {
            const std::lock_guard guard(node.lock);
            return pad.strong > 0;
        },
        10.0));
    session_.devices().stop();
    const std::lock_guard guard(node.lock);
    EXPECT_EQ(pad.strong, 0);
    EXPECT_EQ(pad.right_effect, trigger_off());
}

TEST_F(Companions, a_rumble_only_pad_knocks_at_the_wall_and_is_still_afterwards) {
    app_.apply(WorldEntered{make_ready(hall())}, 0.0);
    test::MockStick pad(bed_.bed, false);
    ASSERT_TRUE(run_until([&] { return session_.devices().any(); }, 5.0));
    EXPECT_THAT(news_, Contains(HasSubstr("I found a Test Stick.")));
    app_.apply(CommandDown{Command::Forward}, clock_.now_s());
    EXPECT_TRUE(run_until(
        [&] {
            const std::lock_guard guard(pad.lock);
            return pad.playing && pad.effect.u.rumble.strong_magnitude > 50000;
        },
        10.0));
    EXPECT_TRUE(run_until(
        [&] {
            const std::lock_guard guard(pad.lock);
            return pad.effect.u.rumble.strong_magnitude == 0;
        },
        2.0));
    session_.devices().stop();
    const std::lock_guard guard(pad.lock);
    EXPECT_FALSE(pad.playing);
    EXPECT_FALSE(pad.loaded);
    EXPECT_EQ(pad.bad_uploads, 0);
}

// Runs the whole program. The program must use the pad for cues and for walking, but not as a hand.
TEST_F(Companions, the_program_uses_a_dual_sense_for_cues_and_walking) {
    test::PadEmulator pad(true, false);
    MockHidraw node(bed_.bed, pad, {0, false, 0x054c, 0x0ce6, "DualSense Wireless Controller"});
    push(pad, node, {128, 128, 128, 128}, {8 | 0x40, 0, 0});
    test::ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"--no-window", "--device", "dualsense"};
    call.input = "forward 8\nwhere\n";
    const test::ProgramRun run = test::run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("The DualSense gives cues and lets you walk, but you cannot touch with it."));
    EXPECT_THAT(run.out, HasSubstr("I found a DualSense. The left stick walks"));
    EXPECT_THAT(run.out, HasSubstr("There is no touch device")) << "asked by circle";
    const std::lock_guard guard(node.lock);
    EXPECT_GT(pad.good, 5U);
    EXPECT_EQ(pad.bad, 0U);
    EXPECT_EQ(pad.right_effect, trigger_off()) << "let go at the end";
}

}  // namespace companions_test
}  // namespace handrail
