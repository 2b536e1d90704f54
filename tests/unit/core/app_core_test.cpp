#include "app/core/app_core.h"

#include "haptic/render/free_place.h"

#include "tests/support/box_scene.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace {

using test::SceneBuilder;

// 6 by 4 metres with a plaster wall in the north and a door in the south; base (3, 0.5) facing north.
std::shared_ptr<const Scene> room() {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {6, 4, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    b.box({-0.2, 4, 0}, {6.2, 4.2, 2.6}, "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({-0.2, -0.2, 0}, {6.2, 0, 2.6}, "south wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({6, 0, 0}, {6.2, 4, 2.6}, "east wall", SolidRole::Solid, "wood", FeatureKind::Wall);
    b.box({-0.2, 0, 0}, {0, 4, 2.6}, "west wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    b.box({1, 3, 0}, {2, 3.5, 0.7}, "Table", SolidRole::Solid, "wood", FeatureKind::Object);
    b.scene().name = "test room";
    b.start({3, 0.5, 0}, 0.0);
    return b.share();
}

struct Session {
    explicit Session(bool device = false) : app(Settings{}, facts(device)) { app.enter_world(room(), 0.0); }
    static HandFacts facts(bool device) {
        HandFacts f;
        f.present = f.simulated = device;
        f.spec = ideal_device_spec();
        return f;
    }
    void run(double seconds) {
        for (const double until = now + seconds; now < until - 1e-9;) {
            now += 1.0 / 60.0;
            app.tick(now, tool);
            for (CueRequest& cue : app.take_cues()) cues.push_back(std::move(cue));
        }
    }
    void tap(Command command) {
        app.press(command, now);
        run(0.1);
        app.release(command);
    }
    std::vector<std::string> said() const {
        std::vector<std::string> lines;
        for (const CueRequest& cue : cues)
            if (cue.kind == CueRequestKind::Say) lines.push_back(cue.text);
        return lines;
    }
    int count(CueRequestKind kind) const {
        return static_cast<int>(std::count_if(cues.begin(), cues.end(), [&](const CueRequest& cue) { return cue.kind == kind; }));
    }
    AppCore app;
    ToolState tool;
    double now = 0.0;
    std::vector<CueRequest> cues;
};

TEST(AppCore, says_on_entering_what_how_large_where_which_way_and_what_to_try) {
    Session s;
    s.run(0.1);
    ASSERT_FALSE(s.said().empty());
    const std::string line = s.said().front();
    for (const char* part : {"Test room", "6 by 4 metres, 9 by 6 steps", "at the base", "facing north", "Ahead: north wall, plaster, 5 steps", "Press Up"})
        EXPECT_THAT(line, testing::HasSubstr(part));
}

TEST(AppCore, a_tap_is_one_step_and_a_bump_names_the_wall_once) {
    Session s;
    s.tap(Command::Forward);
    s.run(1.0);
    EXPECT_NEAR(s.app.feet_m().y, 1.2, 1e-3);
    EXPECT_EQ(s.count(CueRequestKind::Footstep), 1);
    s.app.press(Command::Forward, s.now);
    s.run(5.0);
    s.app.release(Command::Forward);
    EXPECT_NEAR(s.app.feet_m().y, 3.75, 1e-3);
    EXPECT_EQ(s.count(CueRequestKind::Bump), 1);
    s.tap(Command::Forward);
    s.run(0.5);
    EXPECT_EQ(s.count(CueRequestKind::Bump), 2);
}

TEST(AppCore, taps_while_walking_are_walked_one_after_the_other) {
    Session s;
    for (int i = 0; i < 3; ++i) s.tap(Command::Forward);
    s.run(3.0);
    EXPECT_NEAR(s.app.feet_m().y, 0.5 + 3 * 0.7, 1e-3);
    EXPECT_EQ(s.count(CueRequestKind::Footstep), 3);
}

TEST(AppCore, turns_snap_to_notches_and_the_body_follows_at_a_bounded_rate) {
    Session s;
    s.tap(Command::TurnRight);
    EXPECT_LT(s.app.heading_rad(), radians_from_degrees(22.5));
    s.run(0.5);
    EXPECT_NEAR(degrees_from_radians(s.app.heading_rad()), 22.5, 1e-9);
    for (int i = 0; i < 3; ++i) {
        s.tap(Command::TurnRight);
        s.run(0.3);
    }
    EXPECT_NEAR(degrees_from_radians(s.app.heading_rad()), 90.0, 1e-9);
    EXPECT_EQ(s.said().back(), "East");
}

TEST(AppCore, map_frame_never_turns_the_felt_world_and_walk_frame_does) {
    Session s(true);
    s.tap(Command::TurnRight);
    s.run(0.5);
    EXPECT_EQ(s.app.pose().heading_rad, 0.0);
    const std::uint32_t jump = s.app.pose().jump;
    s.tap(Command::SwitchFrame);
    s.run(0.1);
    EXPECT_EQ(s.said().back(), "Walk, turning with you");
    EXPECT_NE(s.app.pose().jump, jump);
    EXPECT_NEAR(degrees_from_radians(s.app.pose().heading_rad), 22.5, 1e-9);
    s.tap(Command::SwitchFrame);
    EXPECT_EQ(s.said().back(), "Map, north up");
    EXPECT_EQ(s.app.take_setting_changes().back().second, "map");
}

TEST(AppCore, workspace_reaches_further_ahead_than_behind_in_the_frame_in_force) {
    Session s(true);
    s.run(0.1);
    EXPECT_NEAR(s.app.pose().origin_m.y - s.app.feet_m().y, 0.01 * 60.0, 1e-12);
    for (int i = 0; i < 4; ++i) s.tap(Command::TurnRight);
    s.run(1.0);
    s.tap(Command::SwitchFrame);
    s.run(0.1);
    EXPECT_NEAR(s.app.pose().origin_m.x - s.app.feet_m().x, 0.01 * 60.0, 1e-9);
}

TEST(AppCore, leaving_wants_a_second_escape_within_five_seconds) {
    Session s;
    s.tap(Command::Leave);
    EXPECT_FALSE(s.app.wants_to_leave());
    s.run(6.0);
    s.tap(Command::Leave);
    EXPECT_FALSE(s.app.wants_to_leave());
    s.tap(Command::Leave);
    EXPECT_TRUE(s.app.wants_to_leave());
}

TEST(AppCore, f12_raises_panic_until_f_confirms) {
    Session s(true);
    const std::uint32_t confirm = s.app.tuning().confirm;
    s.tap(Command::StopEverything);
    EXPECT_TRUE(s.app.tuning().panic);
    EXPECT_EQ(s.count(CueRequestKind::SilenceAll), 1);
    s.tap(Command::ToggleForces);
    EXPECT_FALSE(s.app.tuning().panic);
    EXPECT_TRUE(s.app.tuning().forces_on);
    EXPECT_NE(s.app.tuning().confirm, confirm);
    s.tap(Command::ToggleForces);
    EXPECT_FALSE(s.app.tuning().forces_on);
}

TEST(AppCore, hints_at_a_break_once_for_each_quarter_hour_of_contact) {
    Session s(true);
    const auto hints = [&] {
        const auto lines = s.said();
        return std::count_if(lines.begin(), lines.end(), [](const std::string& l) { return l.find("break") != std::string::npos; });
    };
    s.tool.contact_s = 899.0;
    s.run(0.2);
    EXPECT_EQ(hints(), 0);
    s.tool.contact_s = 901.0;
    s.run(1.0);
    EXPECT_EQ(hints(), 1);
    EXPECT_THAT(s.said().back(), testing::HasSubstr("15 minutes"));
    s.tool.contact_s = 1801.0;
    s.run(1.0);
    EXPECT_EQ(hints(), 2);
}

TEST(AppCore, what_is_this_tells_the_name_and_on_asking_again_the_size) {
    Session s(true);
    s.tool.contacts.count = 1;
    s.tool.contacts.contacts[0].feature = FeatureId{5};
    s.run(0.1);
    s.tap(Command::WhatIsThis);
    EXPECT_EQ(s.said().back(), "Table, wood");
    s.tap(Command::WhatIsThis);
    EXPECT_THAT(s.said().back(), testing::HasSubstr("1 by 0.5 metres"));
}

TEST(AppCore, the_ball_is_four_per_cent_of_a_six_metre_room_and_never_too_big_for_a_door) {
    Session s(true);
    EXPECT_NEAR(s.app.tuning().touch.radius_m, 0.12, 1e-12);
    SceneBuilder b;
    b.box({0, 0, 0}, {0.6, 0.1, 2}, "Door", SolidRole::Mover, "wood", FeatureKind::Door);
    AppCore narrow(Settings{}, Session::facts(true));
    narrow.enter_world(b.share(), 0.0);
    EXPECT_NEAR(narrow.tuning().touch.radius_m, 0.1, 1e-12);
}

TEST(AppCore, falling_out_of_the_world_brings_one_back_to_the_base) {
    SceneBuilder b;
    b.box({-1, -1, -0.2}, {1, 1, 0}, "floor");
    b.start({0, 0, 0}, 0.0);
    AppCore app(Settings{}, Session::facts(false));
    app.enter_world(b.share(), 0.0);
    app.press(Command::Forward, 0.0);
    double lowest = 0.0;
    for (int i = 1; i < 60 * 6; ++i) {
        app.tick(i / 60.0, ToolState{});
        lowest = std::min(lowest, app.feet_m().z);
        if (lowest < -15.0) app.release(Command::Forward);
    }
    EXPECT_LT(lowest, -15.0);
    EXPECT_NEAR(app.feet_m().z, 0.0, 1e-3);
}

TEST(AppCore, home_goes_back_and_every_command_can_be_given_without_harm) {
    Session s(true);
    for (int round = 0; round < 2; ++round)
        for (const CommandInfo& row : command_table())
            if (row.command != Command::Leave) s.tap(row.command);
    s.run(1.0);
    s.tap(Command::Home);
    EXPECT_NEAR(s.app.feet_m().x, 3.0, 1e-9);
    EXPECT_NEAR(s.app.feet_m().y, 0.5, 1e-9);
    EXPECT_EQ(s.app.heading_rad(), 0.0);
    EXPECT_FALSE(s.app.wants_to_leave());
}

TEST(AppCore, sets_things_down_moves_and_removes_them_while_everything_goes_on) {
    Session s(true);
    s.run(0.1);
    const auto world = s.app.haptic_scene()->world;
    const auto box = box_model({0.5, 0.5, 0.5});
    ASSERT_TRUE(box);
    ASSERT_TRUE(s.app.add_thing("crate", *box, {Vec3(3, 2, 0.25), {}, 1.0}, "wood", s.now));
    EXPECT_EQ(s.app.haptic_scene()->world, world) << "the same world: force goes on";
    ASSERT_EQ(s.app.haptic_scene()->bodies.size(), 1U);
    EXPECT_EQ(s.app.bodies().scene, s.app.haptic_scene()->generation);
    EXPECT_EQ(spoken_name(*s.app.scene(), s.app.haptic_scene()->bodies[0].feature), "crate, wood");
    EXPECT_FALSE(s.app.add_thing("Crate", *box, {}, "", s.now)) << "the name is taken";
    const auto unknown = s.app.add_thing("chest", *box, {}, "wod", s.now);
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.find("wood"), std::string::npos);
    EXPECT_FALSE(s.app.add_thing("chest", *box, {Vec3(0.0), {}, 0.0}, "", s.now));
    EXPECT_FALSE(s.app.send_thing("chest", {}, 1.0));
    EXPECT_FALSE(s.app.send_thing("crate", {}, 0.0));

    // The body walks into it where it stands, and where it went.
    s.app.place({3, 0.6, 0}, 0.0, s.now);
    s.app.press(Command::Forward, s.now);
    s.run(3.0);
    s.app.release(Command::Forward);
    EXPECT_NEAR(s.app.feet_m().y, 1.5, 0.01);
    const std::uint64_t number = s.app.bodies().number;
    ASSERT_TRUE(s.app.send_thing("crate", {Vec3(1, 2, 0.25), {}, 1.0}, 1.0));
    s.run(1.0);
    EXPECT_NEAR(s.app.thing_at("crate")->position_m.x, 2.0, 0.05);
    EXPECT_GT(s.app.bodies().number, number + 30);
    s.run(1.5);
    EXPECT_EQ(s.app.thing_at("crate")->position_m, Vec3(1, 2, 0.25));
    s.app.press(Command::Forward, s.now);
    s.run(4.0);
    s.app.release(Command::Forward);
    EXPECT_NEAR(s.app.feet_m().y, 3.75, 0.01) << "the way is free up to the north wall";
    ASSERT_TRUE(s.app.remove_thing("crate", s.now));
    EXPECT_TRUE(s.app.haptic_scene()->bodies.empty());
    EXPECT_FALSE(s.app.remove_thing("crate", s.now));
}

TEST(AppCore, brings_body_and_hand_out_of_what_they_are_in) {
    Session s(true);
    s.tool.hip_m = Vec3(3.0, 1.5, 1.0);
    s.run(0.1);
    s.tap(Command::BringOut);
    EXPECT_EQ(s.said().back(), "You are inside nothing.");
    s.tool.hip_m = Vec3(1.5, 3.25, 0.6);  // in the table
    s.run(0.1);
    const Vec3 before = s.app.pose().origin_m;
    s.tap(Command::BringOut);
    EXPECT_NE(s.said().back().find("Your hand was in Table"), std::string::npos) << s.said().back();
    const Vec3 hand = s.tool.hip_m + s.app.pose().origin_m - before;
    EXPECT_GE(surrounding_of(*s.app.haptic_scene(), {}, hand, 1.0).distance_m, s.app.tuning().touch.radius_m);
    s.app.place({3, 2, 0}, 0.0, s.now);
    const auto box = box_model({2.0, 2.0, 2.0});
    ASSERT_TRUE(s.app.add_thing("block", *box, {Vec3(3, 2, 1), {}, 1.0}, "", s.now));
    s.tool.hip_m = Vec3(0.5, 0.5, 1.0);
    s.run(0.1);
    s.tap(Command::BringOut);
    EXPECT_NE(s.said().back().find("You stood in something"), std::string::npos) << s.said().back();
    EXPECT_GE(std::max(std::abs(s.app.feet_m().x - 3.0), std::abs(s.app.feet_m().y - 2.0)), 1.25 - 1e-3);
}

}  // namespace
}  // namespace handrail
