// What is too small to feel at a scale: changed for the hand, told, listed, and nothing else changes.
#include <gmock/gmock.h>

#include <chrono>
#include <random>
#include <thread>

#include "haptic/render/free_place.h"
#include "tests/support/box_scene.h"
#include "tests/support/random_families.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/explorer.h"
#include "worlds/navigation/rooms.h"

namespace handrail {
namespace {

using test::Explorer;
using testing::HasSubstr;
using testing::Not;

constexpr std::array kScales{Command::ScaleBuilding, Command::ScaleFloor, Command::ScaleRoom, Command::ScaleDetail};

FeatureId feature_named(const Scene& scene, const std::string& name) {
    for (std::uint32_t i = 0; i < scene.features.size(); ++i)
        if (scene.features[i].name == name) return FeatureId{i};
    ADD_FAILURE() << name;
    return kNoFeature;
}

bool is_felt(const HapticScene& scene, FeatureId feature) {
    return std::any_of(scene.labels.begin(), scene.labels.end(), [&](const SurfaceLabel& label) { return label.feature == feature; });
}

double room_round(const AppCore& app, const Vec3& at_m) {
    return surrounding_of(*app.haptic_scene(), std::span(app.bodies().poses).first(app.bodies().count), at_m, 1.0).distance_m;
}

TEST(Simplified, is_told_with_each_scale_where_it_differs_and_undone_on_the_way_back) {
    Explorer p(test::our_world("house.map"), "sim-t");
    EXPECT_TRUE(p.heard("Simplified: 1 small thing left out.")) << p.all_heard();
    const FeatureId stand = feature_named(*p.app().scene(), "Globe's stand"), coats = feature_named(*p.app().scene(), "Coat stand");
    std::size_t from = p.lines();
    p.tap(Command::ScaleBuilding, 0.2);
    EXPECT_TRUE(p.heard("Simplified: ", from)) << p.all_heard(from);
    EXPECT_TRUE(p.heard("widened, 6 small things left out.", from)) << p.all_heard(from);
    EXPECT_FALSE(is_felt(*p.app().haptic_scene(), coats));
    EXPECT_LT(room_round(p.app(), {4.725, 2.05, 1.0}), 0.0) << "the leaf of the living room's door closes the middle";
    EXPECT_LT(room_round(p.app(), {4.725, 1.3, 1.0}), 0.0) << "and what the wall closed";
    EXPECT_GT(room_round(p.app(), {4.78, 1.3, 1.0}), 0.0) << "where there is wall in truth";
    from = p.lines();
    p.tap(Command::ScaleFloor, 0.2);
    p.tap(Command::ScaleRoom, 0.2);
    EXPECT_TRUE(p.heard("Room, 9 metres wide, 13 steps. Simplified: 1 small thing left out.", from)) << p.all_heard(from);
    EXPECT_TRUE(is_felt(*p.app().haptic_scene(), coats));
    EXPECT_FALSE(is_felt(*p.app().haptic_scene(), stand));
    EXPECT_LT(room_round(p.app(), {4.78, 1.3, 1.0}), 0.0);
    from = p.lines();
    p.tap(Command::ScaleRoom, 0.2);
    EXPECT_TRUE(p.heard("Room, 9 metres wide, 13 steps", from));
    EXPECT_FALSE(p.heard("Simplified", from)) << "not twice";
    p.tap(Command::ScaleDetail, 0.2);
    EXPECT_TRUE(p.heard("3 steps. Nothing is simplified.", from)) << p.all_heard(from);
    EXPECT_TRUE(is_felt(*p.app().haptic_scene(), stand));
    EXPECT_EQ(p.app().scene()->solids.size(), Explorer(test::our_world("house.map"), nullptr).app().scene()->solids.size()) << "the true scene stays";
}

TEST(Simplified, lists_what_it_is_and_leads_to_each) {
    Explorer p(test::our_world("house.map"), "sim-t");
    p.tap(Command::ScaleBuilding, 0.2);
    p.key("Shift+6");
    const std::vector<ListItem> items = p.app().dialogue().view().items;
    const auto item = [&](const std::string& name) {
        const auto found = std::find_if(items.begin(), items.end(), [&](const ListItem& one) { return one.name == name; });
        return found == items.end() ? std::string("none") : found->value;
    };
    EXPECT_THAT(item("Front door"), HasSubstr("felt 1.7 metres wide, truly 1 metre, "));
    EXPECT_THAT(item("Bedroom door"), HasSubstr("above"));
    EXPECT_THAT(item("Coat stand"), HasSubstr("left out, "));
    EXPECT_EQ(item("Grandfather clock"), "none") << "a landmark stays";
    p.line("Coat stand");
    ASSERT_TRUE(p.app().guiding().goal);
    EXPECT_EQ(p.app().guiding().goal->feature, feature_named(*p.app().scene(), "Coat stand"));
    p.leave_lists();
    p.tap(Command::ScaleDetail, 0.2);
    const std::size_t from = p.lines();
    p.tap(Command::Simplified);
    EXPECT_TRUE(p.heard("Nothing is simplified.", from));
}

TEST(Simplified, is_off_by_a_setting_at_once_and_says_so) {
    Explorer p(test::our_world("house.map"), "sim-t");
    p.tap(Command::ScaleBuilding, 0.2);
    const FeatureId coats = feature_named(*p.app().scene(), "Coat stand");
    std::size_t from = p.lines();
    ASSERT_TRUE(p.app().change_setting("haptic.simplify", "false", p.now_s()));
    p.run(0.3);
    EXPECT_TRUE(p.heard("Nothing is simplified.", from)) << p.all_heard(from);
    EXPECT_TRUE(is_felt(*p.app().haptic_scene(), coats));
    from = p.lines();
    p.tap(Command::Simplified);
    EXPECT_TRUE(p.heard("Simplifying is switched off: everything is felt as it is.", from));
    Settings settings = p.app().settings();
    settings.haptic.simplify = true;
    p.app().change_settings(settings, p.now_s());
    EXPECT_FALSE(is_felt(*p.app().haptic_scene(), coats));
}

TEST(Simplified, needs_a_hand_and_keeps_what_bears_a_mark) {
    Explorer keys(test::our_world("house.map"), nullptr);
    std::size_t from = keys.lines();
    keys.tap(Command::Simplified);
    EXPECT_FALSE(keys.app().dialogue().is_open());
    EXPECT_GT(keys.lines(), from);
    Explorer p(test::our_world("house.map"), "sim-t");
    EXPECT_FALSE(keys.heard("Simplified"));
    p.app().place({5.8, 1.4, 0.0}, 0.0, p.now_s());
    p.run(0.2);
    const Vec3 stand = p.app().scene()->features[feature_named(*p.app().scene(), "Coat stand").value].bounds_m.centre_m();
    const double scale = p.app().tuning().touch.world_m_per_hand_m;
    p.hold((stand + Vec3(0.3, 0.1, 0.2) - p.app().pose().origin_m) / scale);
    p.tap(Command::DropMark);
    p.leave_lists();
    ASSERT_EQ(p.app().guiding().marks.size(), 1U);
    p.tap(Command::ScaleBuilding, 0.2);
    EXPECT_TRUE(is_felt(*p.app().haptic_scene(), feature_named(*p.app().scene(), "Coat stand")));
}

TEST(Simplified, knows_the_marks_of_a_world_and_no_others_before_it_is_compiled_once) {
    const auto house = test::our_world("house.map");
    AppCore app({}, Explorer::facts("sim-t"));
    app.enter_world(house, 0.0);
    const FeatureId stand = feature_named(*app.scene(), "Globe's stand");
    EXPECT_FALSE(is_felt(*app.haptic_scene(), stand));
    std::uint64_t before = app.haptic_scene()->generation;
    app.enter_world(house, 0.0);
    const std::uint64_t each = app.haptic_scene()->generation - before;

    SideFile additions;
    Mark mark;
    mark.name = "Globe";
    mark.place_m = app.scene()->features[stand.value].bounds_m.centre_m();
    write_marks(additions, {mark});
    app.use_side_file(std::move(additions));
    before = app.haptic_scene()->generation;
    app.enter_world(house, 0.0);
    ASSERT_EQ(app.guiding().marks.size(), 1U);
    EXPECT_TRUE(is_felt(*app.haptic_scene(), stand));
    EXPECT_EQ(app.haptic_scene()->generation - before, each);
    app.enter_world(house, 0.0);
    EXPECT_FALSE(is_felt(*app.haptic_scene(), stand)) << "the mark was in the other world";
}

TEST(Simplified, is_said_in_whole_german_sentences) {
    const test::InLanguage german("de");
    Explorer p(test::our_world("house.map"), "sim-t");
    EXPECT_TRUE(p.heard("Vereinfacht: 1 kleines Ding weggelassen.")) << p.all_heard();
    std::size_t from = p.lines();
    p.tap(Command::ScaleBuilding, 0.2);
    EXPECT_TRUE(p.heard(" verbreitert, 6 kleine Dinge weggelassen.", from)) << p.all_heard(from);
    p.tap(Command::Simplified);
    EXPECT_TRUE(p.heard("Vereinfacht in diesem Maßstab", from)) << p.all_heard(from);
    EXPECT_THAT(p.app().dialogue().view().items[0].value, HasSubstr("gefühlt 1,7 Meter breit, in Wahrheit 1 Meter, "));
    p.leave_lists();
    from = p.lines();
    p.tap(Command::ScaleDetail, 0.2);
    EXPECT_TRUE(p.heard("Nichts ist vereinfacht.", from)) << p.all_heard(from);
}

// Two rooms with an opening of 0.9 m between them that has no door, and a partition of 0.05 m at x 6.
std::shared_ptr<const Scene> open_rooms() {
    test::SceneBuilder builder;
    const auto wall = [&](const Vec3& low, const Vec3& high, FeatureKind kind = FeatureKind::Wall) {
        builder.box(low, high, "wall", SolidRole::Solid, "plaster", kind);
    };
    wall({0, 0, -0.3}, {20, 12.2, 0}, FeatureKind::Floor);
    wall({-0.2, 0, 0}, {0, 12.2, 2.6});
    wall({20, 0, 0}, {20.2, 12.2, 2.6});
    wall({0, -0.2, 0}, {20, 0, 2.6});
    wall({0, 12.2, 0}, {20, 12.4, 2.6});
    wall({0, 6, 0}, {3, 6.2, 2.6});
    wall({3.9, 6, 0}, {20, 6.2, 2.6});
    wall({3, 6, 2.1}, {3.9, 6.2, 2.6});
    wall({6, 0, 0}, {6.05, 6, 2.6});
    builder.start({3.4, 3, 0}, 0.0);
    Scene& scene = builder.scene();
    for (const Solid& solid : scene.solids) scene.bounds_m.include(solid.shape.bounds_m);
    return builder.share();
}

TEST(Simplified, widens_openings_without_a_door_as_soon_as_the_rooms_are_found) {
    AppCore app({}, Explorer::facts("sim-t"));
    app.find_rooms_beside();
    app.enter_world(open_rooms(), 0.0);
    app.press(Command::ScaleBuilding, 0.0);
    std::string said;
    double now = 0.0;
    // The thread that looks for rooms takes real time; sessions go on meanwhile.
    for (int frame = 0; frame < 6000 && said.find("doorway") == std::string::npos; ++frame) {
        app.tick(now += 1.0 / 60.0, {});
        for (const CueRequest& cue : app.take_cues()) said += cue.text + "\n";
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_THAT(said, HasSubstr("Simplified: 1 doorway widened.")) << said;
    EXPECT_GT(room_round(app, {2.85, 6.1, 1.0}), 0.0);
    app.press(Command::Simplified, now);
    ASSERT_EQ(app.dialogue().view().items.size(), 1U);
    EXPECT_THAT(app.dialogue().view().items[0].name, HasSubstr("Opening between "));
}

TEST(Simplified, looks_for_openings_on_entering_a_world_with_nothing_of_the_one_before) {
    Explorer p(test::our_world("house.map"), "sim-t");
    p.tap(Command::ScaleBuilding, 0.2);
    const std::size_t from = p.lines();
    p.app().enter_world(open_rooms(), p.now_s());  // no door moves here; the house's have moved out
    p.run(0.2);
    EXPECT_TRUE(p.heard("Simplified: 1 doorway widened.", from)) << p.all_heard(from);
}

// Walls are not made thicker: none is too thin to hold.
TEST(Simplified, holds_a_fast_hand_at_a_wall_of_a_fifth_of_a_millimetre) {
    Settings settings;
    settings.desk.use = false;
    settings.workspace.rim = false;
    for (const char* device : {"sim-t", "sim-f"}) {
        Explorer p(open_rooms(), device, settings);
        const double scale = world_m_per_hand_m(NamedScale::Building, p.app().scene()->bounds_m, find_device_spec(device)->workspace_radius_m);
        EXPECT_LT(0.05 / scale, 0.3e-3);
        const Vec3 middle = p.app().scene()->bounds_m.centre_m();
        const auto there = [&](const Vec3& world_m) { return (world_m - Vec3(middle.x, middle.y, 1.0)) / scale; };
        p.hold(there({4.5, 3.0, 1.0}), 0.05);
        p.tap(Command::ScaleBuilding, 0.2);
        p.hold(there({4.5, 3.2, 1.0}), 0.05);
        p.run(1.2);
        ASSERT_NEAR(p.tool().proxy_m.x, 4.5, 0.01) << device;
        for (const double speed_m_per_s : {0.05, 0.5, 2.0}) {
            p.hold(there({9.0, 3.0, 1.0}), speed_m_per_s);
            EXPECT_LT(p.tool().proxy_m.x, 6.0 - 0.9 * p.tool().ball_radius_m) << device << " at " << speed_m_per_s;
            p.hold(there({4.5, 3.0, 1.0}), speed_m_per_s);
        }
    }
}

// Whatever the hand is doing, in or outside walls and doorways, another scale leaves the ball outside of everything and is not felt.
TEST(Simplified, changes_under_the_hand_without_leaving_it_in_a_wall_or_a_jolt) {
    const auto house = test::our_world("house.map");
    const BodySize size = body_size(*house, Settings{}.walk.body_radius_m);
    const std::vector<Room> rooms = make_rooms(*house, *make_walk_space(*house, walk_body(*house, size.radius_m, size.height_m, size.step_up_m))).rooms;
    for (const char* device : {"sim-t", "sim-f"}) {
        std::mt19937 random(test::seed_of_run());
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        Settings settings;
        settings.desk.use = false;  // where scales wait
        settings.workspace.rim = false;
        Explorer p(house, device, settings);
        const double reach_m = find_device_spec(device)->workspace_radius_m;
        std::size_t widened = 0;
        for (int round = 0; round < test::scaled(60); ++round) {
            if (round % 5 == 0) p.app().place(rooms[random() % rooms.size()].middle_m, unit(random) * kPi, p.now_s());
            const Vec3 goal = Vec3(unit(random), unit(random), unit(random)) * (0.55 * reach_m);
            p.hold(goal, 0.1);
            p.run(1.1);
            const Command next = round == 0 ? Command::ScaleBuilding : kScales[static_cast<std::size_t>(random() % kScales.size())];
            p.tap(next, 0.0);
            double strongest_n = 0.0;
            for (int ms = 0; ms < 300; ++ms) {
                p.run(1e-3);
                if (ms >= 2) strongest_n = std::max(strongest_n, glm::length(p.tool().force_n));
            }
            EXPECT_LT(strongest_n, 0.2) << device << " round " << round;
            EXPECT_FALSE(p.tool().contacts.ghosted) << device << " round " << round;
            EXPECT_GT(room_round(p.app(), p.tool().proxy_m), -1e-9) << device << " round " << round << " at " << p.tool().proxy_m.x << " " << p.tool().proxy_m.y;
            widened += p.heard("widened", p.lines() - std::min<std::size_t>(p.lines(), 3));
        }
        EXPECT_GT(widened, 0U);
    }
}

// Hands held still anywhere in their reach: another scale puts each ball outside of everything wherever the one workspace has room for both.
TEST(Simplified, brings_both_hands_out_of_walls_in_their_one_workspace) {
    Settings settings;
    settings.desk.use = false;
    AppCore app(settings, Explorer::facts("sim-t"));
    app.set_left_hand(Explorer::facts("sim-t"), 0.0);
    app.enter_world(open_rooms(), 0.0);
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const double reach_m = 0.55 * find_device_spec("sim-t")->workspace_radius_m;
    ToolState right, left;
    const auto at_m = [&](const ToolState& tool, const WorkspacePose& pose) {
        return frame_of(pose.origin_m, pose.heading_rad).to_world(tool.hand_m, app.tuning().touch.world_m_per_hand_m);
    };
    const auto fits = [&](const Vec3& place_m) { return room_round(app, place_m) >= 0.998 * app.tuning().touch.radius_m; };
    int left_free = 0;
    const int rounds = 200;
    double now_s = 0.0;
    for (int round = 0; round < rounds; ++round) {
        app.place({10.0 + 9.0 * unit(random), 3.0 + 2.5 * unit(random), 0.0}, 0.0, now_s);
        for (ToolState* tool : {&right, &left}) {
            tool->ticks = 1;
            tool->hand_m = Vec3(unit(random), unit(random), unit(random)) * reach_m;
            tool->workspace_jump = app.pose().jump;
            tool->proxy_m = at_m(*tool, app.pose());
        }
        app.tick(now_s += 1.0 / 60.0, right, left);
        app.press(kScales[random() % kScales.size()], now_s);
        EXPECT_TRUE(fits(at_m(right, app.pose()))) << "round " << round;
        left_free += fits(at_m(left, app.left_pose()));
    }
    EXPECT_GE(left_free, rounds * 97 / 100);
    std::cout << left_free << " of " << rounds << " left hands are free\n";
}

// The rule of thirds holds for doorways as they are felt, so the ball of each scale goes through every one of them.
TEST(Simplified, leaves_a_ball_that_goes_through_every_doorway_at_each_scale) {
    for (const char* device : {"sim-t", "sim-f"})
        for (const char* file : {"house.map", "school.map"}) {
            Explorer p(test::our_world(file), device);
            for (const Command scale : kScales) {
                p.tap(scale, 0.1);
                const double ball_m = 2.0 * p.app().tuning().touch.radius_m;
                SimplifyOptions options;
                options.world_m_per_hand_m = p.app().tuning().touch.world_m_per_hand_m;
                const Simplification plan = plan_simplification(*p.app().scene(), options);
                for (std::uint32_t i = 0; i < p.app().scene()->features.size(); ++i) {
                    const Feature& door = p.app().scene()->features[i];
                    if (door.kind != FeatureKind::Door) continue;
                    const NarrowOpening* widened = plan.of_door(FeatureId{i});
                    const double width_m = widened ? widened->felt_width_m() : std::max(door.bounds_m.size_m().x, door.bounds_m.size_m().y);
                    EXPECT_LE(ball_m, width_m / 3.0 + 1e-9) << file << " " << door.name;
                }
            }
        }
}

}  // namespace
}  // namespace handrail
