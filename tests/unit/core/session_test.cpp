#include "app/core/session/session.h"

#include "haptic/render/free_place.h"

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "worlds/scene/models.h"

#include <functional>

namespace handrail {
namespace session_test {

using test::SceneBuilder;

// Makes a room of 6 by 4 metres with a plaster wall in the north and a door in the south. The base is at (3, 0.5) and
// faces north.
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

struct SessionAlone {
    explicit SessionAlone(bool device = false) : app(Settings{}, facts(device)) {
        app.apply(WorldEntered{make_ready(room())}, 0.0);
    }
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
        app.apply(CommandDown{command}, now);
        run(0.1);
        app.apply(CommandUp{command}, now);
    }
    std::vector<std::string> said() const {
        std::vector<std::string> lines;
        for (const CueRequest& cue : cues)
            if (cue.kind == CueRequestKind::Say) lines.push_back(cue.text);
        return lines;
    }
    int count(CueRequestKind kind) const {
        return static_cast<int>(
            std::count_if(cues.begin(), cues.end(), [&](const CueRequest& cue) { return cue.kind == kind; }));
    }
    Session app;
    ToolState tool;
    double now = 0.0;
    std::vector<CueRequest> cues;
};

TEST(Session, warns_once_on_entering_if_many_materials_are_close_together_unless_switched_off) {
    Scene scene = *room();
    for (const char* name : {"concrete", "wood", "carpet", "rubber", "steel grille", "glass"}) {
        Material material;
        material.name = name;
        scene.triangles.push_back({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, kNoFeature, material_id(scene, material)});
        if (scene.triangles.size() < 5) continue;
        Settings settings;
        for (const bool hint : {true, false}) {
            settings.speech.crowding_hint = hint;
            Session app(settings, SessionAlone::facts(false));
            app.apply(WorldEntered{make_ready(std::make_shared<Scene>(scene))}, 0.0);
            int reported = 0;
            for (double now = 0.0; now < 1.0; now += 0.1) {
                app.tick(now, ToolState{});
                for (const CueRequest& cue : app.take_cues())
                    reported += cue.text.find("6 materials are close together") != std::string::npos;
            }
            EXPECT_EQ(reported, hint && scene.triangles.size() == 6 ? 1 : 0);
        }
    }
}

TEST(Session, rounds_edges_in_hand_millimetres_at_room_scale_and_leaves_them_sharp_at_detail_scales) {
    Settings settings;
    Session app(settings, SessionAlone::facts(true));
    app.apply(WorldEntered{make_ready(room())}, 0.0);
    app.tick(0.1, {});
    const auto largest = [&] {
        const auto& all = app.haptic_scene()->roundings_m;
        return *std::max_element(all.begin(), all.end());
    };
    EXPECT_NEAR(largest(), 0.09, 1e-12) << "1.5 millimetres at 1:60: the table";
    const std::uint32_t world = app.haptic_scene()->world;
    settings.workspace.scale = 120.0;
    app.apply(SettingsChanged{settings}, 1.0);
    app.tick(1.1, {});
    EXPECT_GT(largest(), 0.1);
    EXPECT_EQ(app.haptic_scene()->world, world) << "the same world, so nothing ramps but the scale";
    settings.workspace.scale = 15.0;
    app.apply(SettingsChanged{settings}, 2.0);
    app.tick(2.1, {});
    EXPECT_EQ(largest(), 0.0);
    settings.workspace.scale = 60.0;
    settings.haptic.edge_rounding_mm = 0.0;
    app.apply(SettingsChanged{settings}, 3.0);
    app.tick(3.1, {});
    EXPECT_EQ(largest(), 0.0);
}

TEST(Session, announces_on_entering_the_place_its_size_the_position_the_heading_and_what_to_try) {
    SessionAlone s;
    s.run(0.1);
    ASSERT_FALSE(s.said().empty());
    const std::string line = s.said().front();
    for (const char* part :
         {"Test room, 6 by 4 metres", "At the base, facing north", "Ahead: north wall, plaster, 5 steps", "Press Up"})
        EXPECT_THAT(line, testing::HasSubstr(part));
}

TEST(Session, a_tap_is_one_step_and_a_bump_names_the_wall_once) {
    SessionAlone s;
    s.tap(Command::Forward);
    s.run(1.0);
    EXPECT_NEAR(s.app.feet_m().y, 1.2, 1e-3);
    EXPECT_EQ(s.count(CueRequestKind::Footstep), 1);
    s.app.apply(CommandDown{Command::Forward}, s.now);
    s.run(5.0);
    s.app.apply(CommandUp{Command::Forward}, s.now);
    EXPECT_NEAR(s.app.feet_m().y, 3.75, 1e-3);
    EXPECT_EQ(s.count(CueRequestKind::Bump), 1);
    s.tap(Command::Forward);
    s.run(0.5);
    EXPECT_EQ(s.count(CueRequestKind::Bump), 2);
}

TEST(Session, performs_taps_during_walking_one_after_the_other) {
    SessionAlone s;
    for (int i = 0; i < 3; ++i) s.tap(Command::Forward);
    s.run(3.0);
    EXPECT_NEAR(s.app.feet_m().y, 0.5 + 3 * 0.7, 1e-3);
    EXPECT_EQ(s.count(CueRequestKind::Footstep), 3);
}

TEST(Session, turns_snap_to_notches_and_the_body_follows_at_a_limited_rate) {
    SessionAlone s;
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

TEST(SessionSteering, a_stick_walks_as_fast_as_it_is_pushed_and_stops_when_released) {
    SessionAlone s;
    s.app.apply(Steered{{.ahead = 0.5}}, s.now);
    s.run(1.0);
    EXPECT_NEAR(s.app.feet_m().y, 1.0, 0.02);
    s.app.apply(Steered{{.right = 1.0}}, s.now);
    s.run(1.0);
    EXPECT_NEAR(s.app.feet_m().x, 4.0, 0.02);
    EXPECT_NEAR(s.app.feet_m().y, 1.0, 0.02);
    s.app.apply(Steered{{.ahead = 1.0, .right = 1.0}}, s.now);
    const Vec3 before = s.app.feet_m();
    s.run(0.5);
    EXPECT_NEAR(glm::length(s.app.feet_m() - before), 0.5, 0.02) << "aslant no faster";
    s.app.apply(Steered{{}}, s.now);
    const Vec3 at = s.app.feet_m();
    s.run(1.0);
    EXPECT_EQ(s.app.feet_m(), at);
}

TEST(SessionSteering, a_stick_turns_at_90_degrees_a_second_and_the_heading_is_announced_once_it_rests) {
    SessionAlone s;
    s.app.apply(Steered{{.turn_right = 1.0}}, s.now);
    s.run(0.5);
    EXPECT_NEAR(s.app.heading_rad(), 0.8, 0.02);
    EXPECT_EQ(s.said().size(), 1U) << "only what was said on entering";
    s.app.apply(Steered{{}}, s.now);
    s.run(0.1);
    EXPECT_EQ(s.said().back(), "North-east");
    EXPECT_EQ(s.said().size(), 2U);
}

TEST(SessionSteering, invalid_numbers_count_as_rest_and_losing_the_keyboard_releases_the_stick) {
    SessionAlone s;
    const Vec3 at = s.app.feet_m();
    s.app.apply(
        Steered{{std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}},
        s.now);
    s.run(0.5);
    EXPECT_EQ(s.app.feet_m(), at);
    EXPECT_EQ(s.app.heading_rad(), 0.0);
    s.app.apply(Steered{{.ahead = 1.0}}, s.now);
    s.app.apply(FocusChanged{false}, s.now);
    s.run(0.5);
    EXPECT_EQ(s.app.feet_m(), at);
}

TEST(SessionSteering, the_passage_width_is_the_width_of_the_room_across_the_heading) {
    SessionAlone s;
    EXPECT_NEAR(s.app.passage_width_m(), 6.0, 1e-3);
}

TEST(Session, map_frame_never_turns_the_felt_world_but_walk_frame_does) {
    SessionAlone s(true);
    s.tap(Command::TurnRight);
    s.run(0.5);
    EXPECT_EQ(s.app.hand().pose.heading_rad, 0.0);
    const std::uint32_t jump = s.app.hand().pose.jump;
    s.tap(Command::SwitchFrame);
    s.run(0.1);
    EXPECT_EQ(s.said().back(), "Walk: the workspace turns with you");
    EXPECT_NE(s.app.hand().pose.jump, jump);
    EXPECT_NEAR(degrees_from_radians(s.app.hand().pose.heading_rad), 22.5, 1e-9);
    s.tap(Command::SwitchFrame);
    EXPECT_EQ(s.said().back(), "Map: north stays up");
    EXPECT_EQ(s.app.take_setting_changes().back().second, "map");
}

TEST(Session, the_measured_profile_of_the_connected_device_sets_workspace_and_ceiling) {
    Settings settings;
    settings.haptic.ceiling = ForceCeiling::Full;
    settings.workspace.devices["sim-t"].scale = 90.0;
    DeviceProfile& measured = settings.profiles["sim-t 7"];
    measured.ceiling_n = 1.7;
    measured.scale = 30.0;
    measured.offset_ahead_m = 0.02;
    measured.offset_up_m = 0.01;
    settings.damaged_profiles.insert("sim-t 8");
    const auto core_of = [&](const std::string& serial) {
        Session core(settings, HandFacts{true, true, *find_device_spec("sim-t"), serial});
        core.apply(WorldEntered{make_ready(room())}, 0.0);
        return std::pair(core.hand().tuning, core.hand().pose.origin_m - core.feet_m());
    };
    const auto [tuning, middle_m] = core_of("7");
    EXPECT_EQ(tuning.force_ceiling_n, 1.7);
    EXPECT_EQ(tuning.touch.world_m_per_hand_m, 30.0);
    EXPECT_NEAR(middle_m.y, 0.02 * 30.0, 1e-12);
    EXPECT_NEAR(middle_m.z, 1.0 + 0.01 * 30.0, 1e-12);
    EXPECT_EQ(core_of("8").first.force_ceiling_n, kLightCeiling_n) << "a damaged profile is no reason for full force";
    EXPECT_EQ(core_of("8").first.touch.world_m_per_hand_m, 90.0)
        << "what was written for devices of that name still holds";
    EXPECT_EQ(core_of("9").first.force_ceiling_n, find_device_spec("sim-t")->peak_force_n);
}

TEST(Session, the_workspace_reaches_further_ahead_than_behind_in_the_current_frame) {
    SessionAlone s(true);
    s.run(0.1);
    EXPECT_NEAR(s.app.hand().pose.origin_m.y - s.app.feet_m().y, 0.01 * 60.0, 1e-12);
    for (int i = 0; i < 4; ++i) s.tap(Command::TurnRight);
    s.run(1.0);
    s.tap(Command::SwitchFrame);
    s.run(0.1);
    EXPECT_NEAR(s.app.hand().pose.origin_m.x - s.app.feet_m().x, 0.01 * 60.0, 1e-9);
}

TEST(Session, leaving_needs_a_second_escape_within_five_seconds) {
    SessionAlone s;
    s.tap(Command::Leave);
    EXPECT_FALSE(s.app.requests().leave);
    s.run(6.0);
    s.tap(Command::Leave);
    EXPECT_FALSE(s.app.requests().leave);
    s.tap(Command::Leave);
    EXPECT_TRUE(s.app.requests().leave);
}

TEST(Session, f12_raises_panic_until_f_confirms) {
    SessionAlone s(true);
    const std::uint32_t confirm = s.app.hand().tuning.confirm;
    s.tap(Command::StopEverything);
    EXPECT_TRUE(s.app.hand().tuning.panic);
    EXPECT_EQ(s.count(CueRequestKind::SilenceAll), 1);
    s.tap(Command::ToggleForces);
    EXPECT_FALSE(s.app.hand().tuning.panic);
    EXPECT_TRUE(s.app.hand().tuning.forces_on);
    EXPECT_NE(s.app.hand().tuning.confirm, confirm);
    s.tap(Command::ToggleForces);
    EXPECT_FALSE(s.app.hand().tuning.forces_on);
}

TEST(Session, follows_a_stop_seen_by_the_servo_switch_and_only_f_releases_it) {
    SessionAlone s(true);
    s.app.apply(Stopped{1}, s.now);
    s.app.apply(CommandDown{Command::StopEverything}, s.now);  // the window reports the same press of the stop key
    s.run(0.1);
    EXPECT_TRUE(s.app.hand().tuning.panic);
    EXPECT_EQ(s.app.hand().tuning.stops_let_go, 0U);
    EXPECT_EQ(s.count(CueRequestKind::SilenceAll), 1) << "one press, told twice";
    EXPECT_THAT(s.said().back(), testing::HasSubstr("Stopped."));
    s.tap(Command::ToggleForces);
    EXPECT_FALSE(s.app.hand().tuning.panic);
    EXPECT_TRUE(s.app.hand().tuning.forces_on);
    EXPECT_EQ(s.app.hand().tuning.stops_let_go, 1U);
}

TEST(Session, f_explains_why_there_is_no_force_yet_and_when_it_will_come) {
    SessionAlone s(true);
    s.tool.fault = Fault::Unplugged;
    s.tool.fault_latched = s.tool.fault_lasts = true;
    s.run(0.1);
    s.tap(Command::ToggleForces);
    EXPECT_EQ(s.said().back(), "The touch device is not plugged in.");
    s.tool.fault_lasts = false;
    s.run(0.1);
    EXPECT_EQ(s.said().back(),
              "The touch device is plugged in again. Press F or the key to the left of 1 to feel again.");
    const std::uint32_t confirm = s.app.hand().tuning.confirm;
    s.tap(Command::ToggleForces);
    EXPECT_NE(s.app.hand().tuning.confirm, confirm);
    EXPECT_EQ(s.said().back(), "Forces on");
    s.tool = ToolState{};
    s.run(0.1);
    s.tool.fault = Fault::TooHot;
    s.tool.fault_latched = s.tool.fault_lasts = true;
    s.run(0.1);
    s.tap(Command::ToggleForces);
    EXPECT_EQ(s.said().back(), "The motors of the touch device are still too warm.");
}

TEST(Session, passes_the_loss_of_the_keyboard_to_the_servo_and_releases_keys) {
    SessionAlone s(true);
    s.app.apply(CommandDown{Command::Forward}, s.now);
    s.app.apply(FocusChanged{false}, s.now);
    EXPECT_FALSE(s.app.hand().tuning.focused);
    EXPECT_TRUE(s.app.hand().tuning.forces_on) << "the person still wants them";
    s.run(1.0);
    const double y = s.app.feet_m().y;
    s.run(1.0);
    EXPECT_EQ(s.app.feet_m().y, y);
    s.app.apply(FocusChanged{true}, s.now);
    EXPECT_TRUE(s.app.hand().tuning.focused);
}

TEST(Session, a_device_plugged_in_later_is_offered_and_accepted_with_the_force_key) {
    SessionAlone s(false);
    s.app.apply(HandOffered{"Falcon"}, s.now);
    s.run(0.1);
    EXPECT_EQ(s.said().back(), "I found a Falcon. Press F or the key to the left of 1 to use it.");
    EXPECT_FALSE(s.app.requests().take_offered_hand());
    s.tap(Command::ToggleForces);
    EXPECT_TRUE(s.app.requests().take_offered_hand());
    EXPECT_FALSE(s.app.requests().take_offered_hand()) << "once";
    EXPECT_TRUE(s.app.hand().tuning.forces_on);
    const Vec3 feet = s.app.feet_m();
    s.tool.contact_s = 500.0;
    s.run(0.1);
    s.app.apply(HandChanged{SessionAlone::facts(true), Settings{}}, s.now);
    s.tool = ToolState{};
    s.tap(Command::ToggleForces);
    EXPECT_FALSE(s.app.hand().tuning.forces_on) << "now it is the force key again";
    EXPECT_EQ(s.app.feet_m(), feet);
    // Contact time with the new device. Together with the contact time of the old device, it is more than a quarter of
    // an hour.
    s.tool.contact_s = 401.0;
    s.run(0.2);
    EXPECT_THAT(s.said().back(), testing::HasSubstr("15 minutes"));
}

TEST(Session, suggests_a_break_once_for_each_quarter_hour_of_contact) {
    SessionAlone s(true);
    const auto hints = [&] {
        const auto lines = s.said();
        return std::count_if(lines.begin(), lines.end(),
                             [](const std::string& l) { return l.find("break") != std::string::npos; });
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

TEST(Session, what_is_this_gives_the_name_and_when_repeated_the_size) {
    SessionAlone s(true);
    s.tool.contacts.count = 1;
    s.tool.contacts.contacts[0].feature = FeatureId{5};
    s.run(0.1);
    s.tap(Command::WhatIsThis);
    EXPECT_EQ(s.said().back(), "Table, wood");
    s.tap(Command::WhatIsThis);
    EXPECT_THAT(s.said().back(), testing::HasSubstr("1 by 0.5 metres"));
}

TEST(Session, the_proxy_is_four_percent_as_wide_as_a_six_metre_room_and_never_too_big_for_a_door) {
    SessionAlone s(true);
    EXPECT_NEAR(s.app.hand().tuning.touch.radius_m, 0.12, 1e-12);
    SceneBuilder b;
    b.box({0, 0, 0}, {0.6, 0.1, 2}, "Door", SolidRole::Mover, "wood", FeatureKind::Door);
    Session narrow(Settings{}, SessionAlone::facts(true));
    narrow.apply(WorldEntered{make_ready(b.share())}, 0.0);
    EXPECT_NEAR(narrow.hand().tuning.touch.radius_m, 0.1, 1e-12);
}

TEST(Session, returns_a_walker_who_falls_out_of_the_world_to_the_base) {
    SceneBuilder b;
    b.box({-1, -1, -0.2}, {1, 1, 0}, "floor");
    b.start({0, 0, 0}, 0.0);
    Settings settings;
    settings.walk.stop_at_drops = false;
    Session app(settings, SessionAlone::facts(false));
    app.apply(WorldEntered{make_ready(b.share())}, 0.0);
    app.apply(CommandDown{Command::Forward}, 0.0);
    double lowest = 0.0;
    for (int i = 1; i < 60 * 6; ++i) {
        app.tick(i / 60.0, ToolState{});
        lowest = std::min(lowest, app.feet_m().z);
        if (lowest < -15.0) app.apply(CommandUp{Command::Forward}, 0.0);
    }
    EXPECT_LT(lowest, -15.0);
    EXPECT_NEAR(app.feet_m().z, 0.0, 1e-3);
}

TEST(Session, home_returns_to_the_base_and_every_command_is_safe) {
    SessionAlone s(true);
    for (int round = 0; round < 2; ++round)
        for (const CommandInfo& row : command_table())
            if (row.command != Command::Leave) s.tap(row.command);
    s.run(1.0);
    s.tap(Command::Home);
    EXPECT_NEAR(s.app.feet_m().x, 3.0, 1e-9);
    EXPECT_NEAR(s.app.feet_m().y, 0.5, 1e-9);
    EXPECT_EQ(s.app.heading_rad(), 0.0);
    EXPECT_FALSE(s.app.requests().leave);
}

TEST(Session, places_moves_and_removes_things_while_everything_continues) {
    SessionAlone s(true);
    s.run(0.1);
    const auto world = s.app.haptic_scene()->world;
    const auto box = box_model({0.5, 0.5, 0.5});
    ASSERT_TRUE(box);
    ASSERT_TRUE(s.app.add_thing("crate", *box, {Vec3(3, 2, 0.25), {}, 1.0}, "wood", s.now));
    EXPECT_EQ(s.app.haptic_scene()->world, world) << "the same world: force goes on";
    ASSERT_EQ(s.app.haptic_scene()->bodies.size(), 1U);
    EXPECT_EQ(s.app.bodies().scene(), s.app.haptic_scene()->generation);
    EXPECT_EQ(spoken_name(*s.app.scene(), s.app.haptic_scene()->bodies[0].feature), "crate, wood");
    EXPECT_FALSE(s.app.add_thing("Crate", *box, {}, "", s.now)) << "the name is taken";
    const auto unknown = s.app.add_thing("chest", *box, {}, "wod", s.now);
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.find("wood"), std::string::npos);
    EXPECT_FALSE(s.app.add_thing("chest", *box, {Vec3(0.0), {}, 0.0}, "", s.now));
    EXPECT_FALSE(s.app.send_thing("chest", {}, 1.0));
    EXPECT_FALSE(s.app.send_thing("crate", {}, 0.0));

    // The walker bumps into the thing at its first place and, after the thing was moved, at its second place.
    s.app.apply(Placed{{3, 0.6, 0}, 0.0}, s.now);
    s.app.apply(CommandDown{Command::Forward}, s.now);
    s.run(3.0);
    s.app.apply(CommandUp{Command::Forward}, s.now);
    EXPECT_NEAR(s.app.feet_m().y, 1.5, 0.01);
    const std::uint64_t number = s.app.bodies().number();
    ASSERT_TRUE(s.app.send_thing("crate", {Vec3(1, 2, 0.25), {}, 1.0}, 1.0));
    s.run(1.0);
    EXPECT_NEAR(s.app.thing_at("crate")->position_m.x, 2.0, 0.05);
    EXPECT_GT(s.app.bodies().number(), number + 30);
    s.run(1.5);
    EXPECT_EQ(s.app.thing_at("crate")->position_m, Vec3(1, 2, 0.25));
    s.app.apply(CommandDown{Command::Forward}, s.now);
    s.run(4.0);
    s.app.apply(CommandUp{Command::Forward}, s.now);
    EXPECT_NEAR(s.app.feet_m().y, 3.75, 0.01) << "the way is free up to the north wall";
    ASSERT_TRUE(s.app.remove_thing("crate", s.now));
    EXPECT_TRUE(s.app.haptic_scene()->bodies.empty());
    EXPECT_FALSE(s.app.remove_thing("crate", s.now));
}

TEST(Session, moves_body_and_hand_out_of_solids_that_they_are_in) {
    SessionAlone s(true);
    s.tool.hip_m = Vec3(3.0, 1.5, 1.0);
    s.run(0.1);
    s.tap(Command::BringOut);
    EXPECT_EQ(s.said().back(), "You are not inside anything.");
    s.tool.hip_m = Vec3(1.5, 3.25, 0.6);  // puts the hand inside the table
    s.run(0.1);
    const Vec3 before = s.app.hand().pose.origin_m;
    s.tap(Command::BringOut);
    EXPECT_NE(s.said().back().find("Your hand was inside Table"), std::string::npos) << s.said().back();
    const Vec3 hand = s.tool.hip_m + s.app.hand().pose.origin_m - before;
    EXPECT_GE(surrounding_of(*s.app.haptic_scene(), {}, hand, 1.0).distance_m, s.app.hand().tuning.touch.radius_m);
    s.app.apply(Placed{{3, 2, 0}, 0.0}, s.now);
    const auto box = box_model({2.0, 2.0, 2.0});
    ASSERT_TRUE(s.app.add_thing("block", *box, {Vec3(3, 2, 1), {}, 1.0}, "", s.now));
    s.tool.hip_m = Vec3(0.5, 0.5, 1.0);
    s.run(0.1);
    s.tap(Command::BringOut);
    EXPECT_NE(s.said().back().find("You were inside something"), std::string::npos) << s.said().back();
    EXPECT_GE(std::max(std::abs(s.app.feet_m().x - 3.0), std::abs(s.app.feet_m().y - 2.0)), 1.25 - 1e-3);
}

TEST(Session, announces_the_scale_first_and_keeps_the_place_under_the_hand) {
    SessionAlone s(true);
    s.run(0.1);
    s.tool.ticks = 10;
    s.tool.workspace_jump = s.app.hand().pose.jump;
    s.tool.hand_m = Vec3(0.01, 0.02, 0.0);
    s.tool.proxy_m = s.app.hand().pose.origin_m + s.tool.hand_m * 60.0;
    s.run(0.1);
    s.cues.clear();
    for (const auto& [command, sentence, scale] :
         {std::tuple{Command::ScaleDetail, "Detail, 2.4 metres wide, 3 steps", 15.0},
          std::tuple{Command::ScaleFloor, "Storey, 19 metres wide, 25 steps", 120.0},
          std::tuple{Command::ScaleRoom, "Room, 9.6 metres wide, 14 steps", 60.0}}) {
        const std::uint32_t jump = s.app.hand().pose.jump;
        s.app.apply(CommandDown{command}, s.now);
        s.app.apply(CommandUp{command}, s.now);
        EXPECT_EQ(s.app.hand().tuning.touch.world_m_per_hand_m, scale);
        EXPECT_NEAR(glm::length(s.app.hand().pose.origin_m + s.tool.hand_m * scale - s.tool.proxy_m), 0.0, 1e-9);
        EXPECT_EQ(s.app.hand().pose.jump, jump + 1);
        s.tool.workspace_jump = jump + 1;
        s.run(0.1);
        EXPECT_EQ(s.said().front(), sentence);
        s.cues.clear();
    }
    EXPECT_EQ(s.app.settings().workspace.scale, 60.0) << "a named scale changes no setting";
}

TEST(Session, building_scale_places_the_building_around_the_hand_and_never_the_hand_in_a_wall) {
    SessionAlone s(true);
    s.run(0.1);
    s.tool.ticks = 10;
    s.tool.workspace_jump = s.app.hand().pose.jump;
    // The middle of the bounds is (3, 2). At the scale at which 6.4 by 4.4 m fit into the workspace, the hand would be
    // in the north wall.
    s.tool.hand_m = Vec3(0.0, 0.035, 0.0);
    s.tool.proxy_m = s.app.hand().pose.origin_m + s.tool.hand_m * 60.0;
    s.run(0.1);
    s.app.apply(CommandDown{Command::ScaleBuilding}, s.now);
    const double scale = s.app.hand().tuning.touch.world_m_per_hand_m;
    EXPECT_NEAR(scale, 0.5 * std::hypot(6.4, 4.4) / (0.8 * 0.08), 1e-9);
    const Vec3 hand = s.app.hand().pose.origin_m + s.tool.hand_m * scale;
    EXPECT_GE(surrounding_of(*s.app.haptic_scene(), {}, hand, 1.0).distance_m, s.app.hand().tuning.touch.radius_m);
    EXPECT_LT(glm::length(s.app.hand().pose.origin_m - Vec3(3.0, 2.0, 1.0)), 1.0);
}

TEST(Session, the_workspace_stays_if_it_does_not_follow_the_walker) {
    SessionAlone s(true);
    Settings own;
    own.workspace.follows_walk = false;
    s.app.apply(SettingsChanged{own}, s.now);
    s.run(0.1);
    const Vec3 before = s.app.hand().pose.origin_m;
    s.tap(Command::Forward);
    s.run(1.0);
    EXPECT_NEAR(s.app.feet_m().y, 1.2, 1e-3);
    EXPECT_EQ(s.app.hand().pose.origin_m, before);
    s.tap(Command::WorkspaceCentre);
    EXPECT_NEAR(s.app.hand().pose.origin_m.y, before.y + 0.7, 1e-3);
}

TEST(Session, grabbing_by_key_ends_with_the_key_the_stop_key_and_loss_of_focus) {
    SessionAlone s(true);
    s.run(0.1);
    for (const auto& end : std::vector<std::function<void()>>{
             [&] { s.tap(Command::Grab); }, [&] { s.tap(Command::StopEverything); },
             [&] { s.app.apply(FocusChanged{false}, s.now); }, [&] { s.tap(Command::Home); }}) {
        s.tap(Command::Grab);
        EXPECT_TRUE(s.app.hand().tuning.workspace.grab_key);
        end();
        EXPECT_FALSE(s.app.hand().tuning.workspace.grab_key);
    }
}

TEST(Session, lets_the_person_choose_how_the_workspace_is_moved) {
    SessionAlone s(true);
    EXPECT_TRUE(s.app.hand().tuning.workspace.rim);
    EXPECT_EQ(s.app.hand().tuning.workspace.grab_buttons, 1U);
    Settings own;
    own.workspace.rim = false;
    own.workspace.grab_button = 3;
    s.app.apply(SettingsChanged{own}, s.now);
    EXPECT_FALSE(s.app.hand().tuning.workspace.rim);
    EXPECT_EQ(s.app.hand().tuning.workspace.grab_buttons, 4U);
    own.workspace.grab_button = 1;
    own.haptic.button_to_feel = true;
    s.app.apply(SettingsChanged{own}, s.now);
    EXPECT_EQ(s.app.hand().tuning.workspace.grab_buttons, 0U)
        << "the button that is held to feel anything does not grab";
}

TEST(Session, two_hands_have_separate_limits_and_follow_each_others_workspace) {
    SessionAlone s(true);
    HandFacts left;
    left.present = left.simulated = true;
    left.spec = *find_device_spec("sim-t");
    s.app.apply(LeftHandChanged{left}, s.now);
    s.run(0.1);
    Settings own;
    own.haptic.ceiling = ForceCeiling::Full;
    s.app.apply(SettingsChanged{own}, s.now);
    EXPECT_EQ(s.app.hand(1).tuning.force_ceiling_n, 3.3);
    EXPECT_EQ(s.app.hand(1).tuning.touch.rated_stiffness_n_per_m, 400.0);
    own.profiles[profile_key("sim-t", "")].ceiling_n = 0.9;
    s.app.apply(SettingsChanged{own}, s.now);
    EXPECT_EQ(s.app.hand(1).tuning.force_ceiling_n, 0.9) << "what was found comfortable with this device";
    EXPECT_EQ(s.app.hand().tuning.force_ceiling_n, ideal_device_spec().peak_force_n) << "and not with that one";
    EXPECT_EQ(s.app.hand().tuning.touch.rated_stiffness_n_per_m, ideal_device_spec().rated_stiffness_n_per_m);
    ToolState right_tool, left_tool;
    const Vec3 origin = s.app.hand().pose.origin_m;
    right_tool.workspace_jump = left_tool.workspace_jump = s.app.hand().pose.jump;
    right_tool.workspace_shift_m = Vec3(1.0, 0.0, 0.0);
    left_tool.workspace_shift_m = Vec3(0.0, 0.0, 0.5);
    s.app.tick(s.now += 0.02, right_tool, left_tool);
    // Each servo adds the shift by its own hand, so both workspaces are at the sum of both shifts.
    EXPECT_LT(glm::length(s.app.hand().pose.origin_m + right_tool.workspace_shift_m - origin - Vec3(1.0, 0.0, 0.5)),
              1e-3);
    EXPECT_LT(glm::length(s.app.hand(1).pose.origin_m + left_tool.workspace_shift_m - origin - Vec3(1.0, 0.0, 0.5)),
              1e-3);
}

}  // namespace session_test
}  // namespace handrail
