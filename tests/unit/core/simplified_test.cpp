// Tests things that are too small to feel at a scale. They are changed for the hand, announced and listed, and
// everything else stays the same.
#include <gmock/gmock.h>

#include <random>

#include "haptic/render/free_place.h"
#include "tests/support/box_scene.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/random_families.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/sphere_mesh.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/explorer.h"
#include "worlds/navigation/rooms.h"

namespace handrail {
namespace simplified_test {

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
    return std::any_of(scene.labels.begin(), scene.labels.end(),
                       [&](const SurfaceLabel& label) { return label.feature == feature; });
}

double room_round(const Session& app, const Vec3& at_m) {
    return surrounding_of(*app.haptic_scene(), app.bodies().poses(), at_m, 1.0).distance_m;
}

TEST(Simplified, view_is_announced_at_each_scale_if_it_differs_and_undone_on_returning) {
    Explorer p(test::our_world("house.map"), "sim-t");
    EXPECT_TRUE(p.heard("Simplified: 1 small thing left out.")) << p.all_heard();
    const FeatureId stand = feature_named(*p.app().scene(), "Globe's stand"),
                    coats = feature_named(*p.app().scene(), "Coat stand");
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
    p.tap(Command::ScaleRoom, 5.0);
    EXPECT_TRUE(p.heard("Room, 9 metres wide, 13 steps", from)) << p.all_heard(from);
    EXPECT_TRUE(p.heard("Simplified: 1 small thing left out.", from)) << p.all_heard(from);
    EXPECT_TRUE(is_felt(*p.app().haptic_scene(), coats));
    EXPECT_FALSE(is_felt(*p.app().haptic_scene(), stand));
    EXPECT_LT(room_round(p.app(), {4.78, 1.3, 1.0}), 0.0);
    from = p.lines();
    p.tap(Command::ScaleRoom, 0.2);
    EXPECT_TRUE(p.heard("Room, 9 metres wide, 13 steps", from));
    EXPECT_FALSE(p.heard("Simplified", from)) << "not twice";
    p.tap(Command::ScaleDetail, 5.0);
    EXPECT_TRUE(p.heard("Nothing is simplified.", from)) << p.all_heard(from);
    EXPECT_TRUE(is_felt(*p.app().haptic_scene(), stand));
    EXPECT_EQ(p.app().scene()->solids.size(),
              Explorer(test::our_world("house.map"), nullptr).app().scene()->solids.size())
        << "the true scene stays";
}

TEST(Simplified, parts_are_listed_and_each_can_be_gone_to) {
    Explorer p(test::our_world("house.map"), "sim-t");
    p.tap(Command::ScaleBuilding, 0.2);
    p.key("Shift+6");
    const std::vector<ListItem> items = p.app().dialogue().view().items;
    const auto item = [&](const std::string& name) {
        const auto found =
            std::find_if(items.begin(), items.end(), [&](const ListItem& one) { return one.name == name; });
        return found == items.end() ? std::string("none") : found->value;
    };
    EXPECT_THAT(item("Front door"), HasSubstr("feels 1.7 metres wide but is really 1 metre, "));
    EXPECT_THAT(item("Bedroom door"), HasSubstr("above"));
    EXPECT_THAT(item("Coat stand"), HasSubstr("left out, "));
    EXPECT_EQ(item("Grandfather clock"), "none") << "a landmark stays";
    p.line("Coat stand");
    ASSERT_TRUE(p.app().guide().goal());
    EXPECT_EQ(p.app().guide().goal()->feature, feature_named(*p.app().scene(), "Coat stand"));
    p.leave_lists();
    p.tap(Command::ScaleDetail, 0.2);
    const std::size_t from = p.lines();
    p.tap(Command::Simplified);
    EXPECT_TRUE(p.heard("Nothing is simplified.", from));
}

TEST(Simplified, view_can_be_switched_off_by_a_setting_at_once_which_is_announced) {
    Explorer p(test::our_world("house.map"), "sim-t");
    p.tap(Command::ScaleBuilding, 0.2);
    const FeatureId coats = feature_named(*p.app().scene(), "Coat stand");
    std::size_t from = p.lines();
    ASSERT_TRUE(p.app().apply(SettingSet{"haptic.simplify", "false"}, p.now_s()));
    p.run(0.3);
    EXPECT_TRUE(p.heard("Nothing is simplified.", from)) << p.all_heard(from);
    EXPECT_TRUE(is_felt(*p.app().haptic_scene(), coats));
    from = p.lines();
    p.tap(Command::Simplified);
    EXPECT_TRUE(p.heard("Simplifying is switched off: everything feels as it really is.", from));
    Settings settings = p.app().settings();
    settings.haptic.simplify = true;
    p.app().apply(SettingsChanged{settings}, p.now_s());
    p.run(0.1);
    EXPECT_FALSE(is_felt(*p.app().haptic_scene(), coats));
}

// Makes a room with a globe of 10,580 triangles on a post.
test::SceneBuilder room_with_globe() {
    test::SceneBuilder b;
    b.box({0, 0, -0.2}, {6, 6, 0}, "floor", SolidRole::Solid, "wood", FeatureKind::Floor);
    b.box({2.9, 3.9, 0}, {3.1, 4.1, 0.5}, "post");
    b.box({4.9, 4.9, 0}, {5.0, 5.0, 0.5}, "globe");
    const FeatureId globe{static_cast<std::uint32_t>(b.scene().features.size() - 1)};
    b.scene().solids.pop_back();
    const TriangleMesh sphere = test::sphere_mesh(23, 0.5);
    for (const Corners& t : sphere.triangles)
        b.scene().triangles.push_back({sphere.points_m[t[0]] + Vec3(3, 4, 1), sphere.points_m[t[1]] + Vec3(3, 4, 1),
                                       sphere.points_m[t[2]] + Vec3(3, 4, 1), globe, 0});
    b.scene().features[globe.value].bounds_m = {{2.5, 3.5, 0.5}, {3.5, 4.5, 1.5}};
    b.start({3, 1, 0}, 0.0);
    return b;
}

TEST(Simplified, feels_dense_meshes_with_fewer_triangles_at_coarse_scales_and_says_how_far_off_they_are) {
    const auto world = room_with_globe().share();
    Explorer p(world, "sim-t");
    const auto triangles = [&] { return p.app().haptic_scene()->mesh.triangles.size(); };
    EXPECT_TRUE(p.heard("1 fine mesh made coarser.")) << p.all_heard();
    const std::size_t at_room = triangles();
    EXPECT_LT(at_room, world->triangles.size() / 4);
    p.key("Shift+6");
    const std::vector<ListItem> items = p.app().dialogue().view().items;
    const auto globe =
        std::find_if(items.begin(), items.end(), [](const ListItem& one) { return one.name == "Globe"; });
    ASSERT_NE(globe, items.end());
    EXPECT_THAT(globe->value, HasSubstr(fmt::format("felt with {} of 10580 triangles, at most 0.", at_room)));
    EXPECT_THAT(globe->value, HasSubstr(" millimetres off in the hand, "));
    p.leave_lists();
    p.tap(Command::ScaleDetail, 5.0);
    const std::size_t at_detail = triangles();
    EXPECT_GT(at_detail, at_room) << "a tenth of a millimetre of the hand is less of the world";
    EXPECT_LE(at_detail, world->triangles.size());
    std::size_t from = p.lines();
    p.tap(Command::ScaleRoom, 5.0);
    EXPECT_EQ(triangles(), at_room);
    ASSERT_TRUE(p.app().apply(SettingSet{"haptic.mesh_tolerance_mm", "0"}, p.now_s()));
    p.run(0.3);
    EXPECT_EQ(triangles(), world->triangles.size());
    EXPECT_TRUE(p.heard("Nothing is simplified.", from)) << p.all_heard(from);
    ASSERT_TRUE(p.app().apply(SettingSet{"haptic.mesh_tolerance_mm", "0.1"}, p.now_s()));
    p.run(0.3);
    EXPECT_EQ(triangles(), at_room);
    ASSERT_TRUE(p.app().apply(SettingSet{"haptic.simplify", "false"}, p.now_s()));
    p.run(0.3);
    EXPECT_EQ(triangles(), world->triangles.size()) << "one switch for all that is simplified";
    EXPECT_EQ(p.app().scene()->triangles.size(), world->triangles.size()) << "the true scene stays";
    EXPECT_EQ(Explorer(world, nullptr).app().haptic_scene()->mesh.triangles.size(), world->triangles.size())
        << "nobody waits for it without a hand";
}

TEST(Simplified, view_needs_a_hand_and_keeps_marked_things) {
    Explorer keys(test::our_world("house.map"), nullptr);
    std::size_t from = keys.lines();
    keys.tap(Command::Simplified);
    EXPECT_FALSE(keys.app().dialogue().is_open());
    EXPECT_GT(keys.lines(), from);
    Explorer p(test::our_world("house.map"), "sim-t");
    EXPECT_FALSE(keys.heard("Simplified"));
    p.app().apply(Placed{{5.8, 1.4, 0.0}, 0.0}, p.now_s());
    p.run(0.2);
    const Vec3 stand =
        p.app().scene()->features[feature_named(*p.app().scene(), "Coat stand").value].bounds_m.centre_m();
    const double scale = p.app().hand().tuning.touch.world_m_per_hand_m;
    p.hold((stand + Vec3(0.3, 0.1, 0.2) - p.app().hand().pose.origin_m) / scale);
    p.tap(Command::DropMark);
    p.leave_lists();
    ASSERT_EQ(p.app().world().marks.size(), 1U);
    p.tap(Command::ScaleBuilding, 0.2);
    EXPECT_TRUE(is_felt(*p.app().haptic_scene(), feature_named(*p.app().scene(), "Coat stand")));
}

TEST(Simplified, view_knows_only_the_marks_of_the_current_world_before_its_first_compilation) {
    const auto house = test::our_world("house.map");
    Session app({}, Explorer::facts("sim-t"));
    double now = 0.0;
    const auto enter = [&](SideFile with = {}) {
        app.apply(WorldEntered{make_ready(house), std::move(with)}, now);
        app.tick(now += 0.01, {});
    };
    enter();
    const FeatureId stand = feature_named(*app.scene(), "Globe's stand");
    EXPECT_FALSE(is_felt(*app.haptic_scene(), stand));
    std::uint64_t before = app.haptic_scene()->generation;
    enter();
    const std::uint64_t each = app.haptic_scene()->generation - before;

    SideFile additions;
    Mark mark;
    mark.name = "Globe";
    mark.place_m = app.scene()->features[stand.value].bounds_m.centre_m();
    write_marks(additions, {mark});
    before = app.haptic_scene()->generation;
    enter(std::move(additions));
    ASSERT_EQ(app.world().marks.size(), 1U);
    EXPECT_TRUE(is_felt(*app.haptic_scene(), stand));
    EXPECT_EQ(app.haptic_scene()->generation - before, each);
    enter();
    EXPECT_FALSE(is_felt(*app.haptic_scene(), stand)) << "the mark was in the other world";
}

TEST(Simplified, view_is_described_in_whole_german_sentences) {
    const test::InLanguage german("de");
    Explorer p(test::our_world("house.map"), "sim-t");
    EXPECT_TRUE(p.heard("Vereinfacht: 1 kleines Ding weggelassen.")) << p.all_heard();
    std::size_t from = p.lines();
    p.tap(Command::ScaleBuilding, 0.2);
    EXPECT_TRUE(p.heard(" verbreitert, 6 kleine Dinge weggelassen.", from)) << p.all_heard(from);
    p.tap(Command::Simplified);
    EXPECT_TRUE(p.heard("Vereinfacht in diesem Maßstab", from)) << p.all_heard(from);
    EXPECT_THAT(p.app().dialogue().view().items[0].value,
                HasSubstr("fühlt sich 1,7 Meter breit an, ist aber 1 Meter, "));
    p.leave_lists();
    from = p.lines();
    p.tap(Command::ScaleDetail, 0.2);
    EXPECT_TRUE(p.heard("Nichts ist vereinfacht.", from)) << p.all_heard(from);
}

// Makes two rooms connected by an opening of 0.9 m without a door, and a partition of 0.05 m at x = 6.
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

TEST(Simplified, view_widens_doorless_openings_as_soon_as_the_rooms_are_found) {
    Session app({}, Explorer::facts("sim-t"), {.executor = on_threads()});
    app.apply(WorldEntered{make_ready(open_rooms())}, 0.0);
    app.apply(CommandDown{Command::ScaleBuilding}, 0.0);
    std::string said;
    double now = 0.0;
    // The thread that searches for rooms takes real time, and the session continues meanwhile.
    test::eventually([&] {
        app.tick(now += 1.0 / 60.0, {});
        for (const CueRequest& cue : app.take_cues()) said += cue.text + "\n";
        return said.find("doorway") != std::string::npos;
    });
    EXPECT_THAT(said, HasSubstr("Simplified: 1 doorway widened.")) << said;
    EXPECT_GT(room_round(app, {2.85, 6.1, 1.0}), 0.0);
    app.apply(CommandDown{Command::Simplified}, now);
    ASSERT_EQ(app.dialogue().view().items.size(), 1U);
    EXPECT_THAT(app.dialogue().view().items[0].name, HasSubstr("Opening between "));
}

// Waits in real time until no background task has run for half a second of the session, because tasks may run on a
// thread and one may start another. The rooms widen openings, so it waits for them, too. Returns what the session said.
std::string wait_for_touch(Session& app, double& now) {
    std::string said;
    int idle_frames = 0;
    test::eventually([&] {
        app.tick(now += 1.0 / 60.0, {});
        for (const CueRequest& cue : app.take_cues()) said += cue.text + "\n";
        idle_frames = app.works_in_background() ? 0 : idle_frames + 1;
        return idle_frames >= 30;
    });
    app.tick(now += 1.0 / 60.0, {});
    for (const CueRequest& cue : app.take_cues()) said += cue.text + "\n";
    EXPECT_FALSE(app.works_in_background());
    return said;
}

bool any_rounded(const HapticScene& scene) {
    return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                       [](const Obstacle& o) { return o.rounding != 0; });
}

// The results are bit-identical with and without threads. Until they are ready, the hand feels the previous scene.
// Entering a world does not wait for them.
TEST(Simplified, view_is_bit_identical_with_and_without_threads) {
    const auto house = test::our_world("house.map");
    Session background({}, Explorer::facts("sim-t"), {.executor = on_threads()}), at_once({}, Explorer::facts("sim-t"));
    double now = 0.0, now_at_once = 0.0;
    background.apply(WorldEntered{make_ready_to_touch(house)}, 0.0);
    at_once.apply(WorldEntered{make_ready(house)}, 0.0);
    EXPECT_FALSE(any_rounded(*background.haptic_scene())) << "sharp at first";
    EXPECT_TRUE(background.works_in_background());
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const auto compare = [&](const std::string& when) {
        SCOPED_TRACE(when);
        EXPECT_EQ(background.haptic_scene()->obstacle_counts(), at_once.haptic_scene()->obstacle_counts());
        EXPECT_EQ(any_rounded(*background.haptic_scene()), any_rounded(*at_once.haptic_scene()));
        EXPECT_EQ(background.hand().tuning.touch.radius_m, at_once.hand().tuning.touch.radius_m);
        ASSERT_EQ(background.bodies().poses().size(), at_once.bodies().poses().size());
        EXPECT_EQ(background.bodies().scene(), background.haptic_scene()->generation);
        for (std::size_t i = 0; i < background.bodies().poses().size(); ++i)
            EXPECT_EQ(background.bodies().poses()[i].at.position_m, at_once.bodies().poses()[i].at.position_m) << i;
        for (int i = 0; i < 300; ++i) {
            const Vec3 at =
                house->bounds_m.min_m + house->bounds_m.size_m() * Vec3(part(random), part(random), part(random));
            EXPECT_EQ(room_round(background, at), room_round(at_once, at)) << "seed " << test::seed_of_run();
        }
    };
    wait_for_touch(background, now);
    wait_for_touch(at_once, now_at_once);
    EXPECT_TRUE(any_rounded(*at_once.haptic_scene()));
    compare("entered");
    for (const Command scale : kScales) {
        const std::uint64_t felt = background.haptic_scene()->generation;
        background.apply(CommandDown{scale}, now);
        background.apply(CommandUp{scale}, now);
        EXPECT_EQ(background.haptic_scene()->generation, felt) << "what there was, until the new is there";
        const std::string said = wait_for_touch(background, now);
        at_once.apply(CommandDown{scale}, now_at_once);
        at_once.apply(CommandUp{scale}, now_at_once);
        wait_for_touch(at_once, now_at_once);
        compare(fmt::format("scale {}", static_cast<int>(scale) - static_cast<int>(Command::ScaleBuilding)));
        if (scale == Command::ScaleBuilding) {
            EXPECT_THAT(said, HasSubstr("Simplified: ")) << "told when it is felt";
        }
    }
    // Of many changes, only the last one is rendered. A session that ends does not wait for any of them.
    for (int i = 0; i < 12; ++i) {
        background.apply(CommandDown{kScales[static_cast<std::size_t>(i) % 4]}, now);
        background.apply(CommandUp{kScales[static_cast<std::size_t>(i) % 4]}, now);
    }
    wait_for_touch(background, now);
    compare("after many changes");
}

// The session can find an opened door at its new place, and the walker can see the door and walk through it. That is
// also true after a background task has put that place into the scene.
TEST(Simplified, view_updates_movers_that_came_to_rest_in_the_background) {
    const auto house = test::our_world("house.map");
    Session app({}, Explorer::facts(nullptr), {.executor = on_threads()});
    app.apply(WorldEntered{make_ready(house)}, 0.0);
    double now = 0.0;
    wait_for_touch(app, now);
    const auto before = app.scene();
    app.apply(CommandDown{Command::Use}, now);
    app.apply(CommandUp{Command::Use}, now);
    for (int frame = 0; frame < 600; ++frame) app.tick(now += 1.0 / 60.0, {});
    wait_for_touch(app, now);
    ASSERT_NE(app.scene(), before) << "the door at which one stands has opened";
    bool moved = false;
    for (std::size_t i = 0; i < before->placed.size(); ++i)
        moved = moved || !(before->placed[i].at == app.scene()->placed[i].at);
    EXPECT_TRUE(moved);
}

TEST(Simplified, openings_are_found_on_entering_a_world_without_those_of_the_previous_one) {
    Explorer p(test::our_world("house.map"), "sim-t");
    p.tap(Command::ScaleBuilding, 0.2);
    const std::size_t from = p.lines();
    // This world has no moving doors, and the doors of the house are gone.
    p.app().apply(WorldEntered{make_ready(open_rooms())}, p.now_s());
    p.run(0.2);
    EXPECT_TRUE(p.heard("Simplified: 1 doorway widened.", from)) << p.all_heard(from);
}

// Walls are not made thicker, because even the thinnest wall stops the hand.
TEST(Simplified, view_stops_a_fast_hand_at_a_wall_of_a_fifth_of_a_millimetre) {
    Settings settings;
    settings.desk.use = false;
    settings.workspace.rim = false;
    for (const char* device : {"sim-t", "sim-f"}) {
        Explorer p(open_rooms(), device, settings);
        const double scale = world_m_per_hand_m(NamedScale::Building, p.app().scene()->bounds_m,
                                                find_device_spec(device)->workspace_radius_m);
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
            EXPECT_LT(p.tool().proxy_m.x, 6.0 - 0.9 * p.tool().proxy_radius_m) << device << " at " << speed_m_per_s;
            p.hold(there({4.5, 3.0, 1.0}), speed_m_per_s);
        }
    }
}

// Returns true if the hand feels a liquid: the hand is inside the liquid, or within a centimetre of it in hand metres.
bool feels_liquid(const Scene& scene, const Vec3& hip_m, double world_m_per_hand_m) {
    constexpr double kFelt_hand_m = 0.01;
    return std::any_of(scene.solids.begin(), scene.solids.end(), [&](const Solid& solid) {
        return solid.role == SolidRole::Liquid && contains(solid.shape, hip_m, kFelt_hand_m * world_m_per_hand_m);
    });
}

// A change of scale leaves the proxy outside all solids and cannot be felt, whatever the hand is doing, in or outside
// walls and doorways. The only exception is the current of a pond nearby, because the pond is felt larger or smaller
// after the change.
void changes_under_the_hand(const std::shared_ptr<const Scene>& world, const char* device, int rounds) {
    const WalkerSize size = walker_size(*world, Settings{}.walk.body_radius_m);
    const std::vector<Room> rooms =
        make_rooms(*world,
                   *make_walk_space(*world, walker_measures(*world, size.radius_m, size.height_m, size.step_up_m)))
            .rooms;
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Settings settings;
    settings.desk.use = false;  // At the desk, changes of the scale would wait until the hand has left the desk.
    settings.workspace.rim = false;
    Explorer p(world, device, settings);
    const double reach_m = find_device_spec(device)->workspace_radius_m;
    std::size_t widened = 0;
    for (int round = 0; round < rounds; ++round) {
        if (round % 5 == 0)
            p.app().apply(Placed{rooms[random() % rooms.size()].middle_m, unit(random) * kPi}, p.now_s());
        const Vec3 goal = Vec3(unit(random), unit(random), unit(random)) * (0.55 * reach_m);
        p.hold(goal, 0.1);
        p.run(1.1);
        const Command next =
            round == 0 ? Command::ScaleBuilding : kScales[static_cast<std::size_t>(random() % kScales.size())];
        p.tap(next, 0.0);
        double strongest_n = 0.0;
        for (int ms = 0; ms < 300; ++ms) {
            p.run(1e-3);
            if (ms >= 2 && !feels_liquid(*world, p.tool().hip_m, p.app().hand().tuning.touch.world_m_per_hand_m))
                strongest_n = std::max(strongest_n, glm::length(p.tool().force_n));
        }
        EXPECT_LT(strongest_n, 0.2) << device << " round " << round;
        EXPECT_FALSE(p.tool().contacts.ghosted) << device << " round " << round;
        EXPECT_GT(room_round(p.app(), p.tool().proxy_m), -1e-9)
            << device << " round " << round << " at " << p.tool().proxy_m.x << " " << p.tool().proxy_m.y;
        widened += p.heard("widened", p.lines() - std::min<std::size_t>(p.lines(), 3));
    }
    EXPECT_GT(widened, 0U);
}

TEST(Simplified, view_changes_under_the_hand_without_a_jolt_or_leaving_it_in_a_wall) {
    for (const char* device : {"sim-t", "sim-f"})
        changes_under_the_hand(test::our_world("house.map"), device, test::scaled(60));
}

// Scenario 17: the first level of an architect's house. Each scale is announced with its name and its true width.
// Openings too narrow to feel are widened, and that is announced. The proxy passes through every door. After the return
// to the first scale, everything is as before.
void announces_each_scale_truthfully(const std::shared_ptr<const Scene>& world) {
    {
        Explorer p(world, "sim-t");
        const double hand_m = 2.0 * find_device_spec("sim-t")->workspace_radius_m;
        const auto at_scale = [&](Command scale, const std::string& name) {
            const std::size_t from = p.lines();
            p.tap(scale, 0.3);
            const double per_hand_m = p.app().hand().tuning.touch.world_m_per_hand_m;
            const std::string reported = p.all_heard(from);
            const std::size_t width = reported.find(name + ", ");
            if (width == std::string::npos) ADD_FAILURE() << name << ": " << reported;
            else
                EXPECT_NEAR(std::stod(reported.substr(width + name.size() + 2)), per_hand_m * hand_m,
                            0.06 * per_hand_m * hand_m);
            SimplifyOptions options;
            options.world_m_per_hand_m = per_hand_m;
            const Simplification plan = plan_simplification(*p.app().scene(), options);
            const double proxy_diameter_m = 2.0 * p.app().hand().tuning.touch.radius_m;
            std::size_t doors = 0;
            for (std::uint32_t i = 0; i < p.app().scene()->features.size(); ++i) {
                const Feature& door = p.app().scene()->features[i];
                if (door.kind != FeatureKind::Door) continue;
                ++doors;
                const NarrowOpening* const widened = plan.of_door(FeatureId{i});
                const double width_m =
                    widened ? widened->felt_width_m() : std::max(door.bounds_m.size_m().x, door.bounds_m.size_m().y);
                EXPECT_LT(proxy_diameter_m, width_m) << name << ": " << door.name;
            }
            EXPECT_GE(doors, 14U);
            return reported;
        };
        const std::string building = at_scale(Command::ScaleBuilding, "Building");
        EXPECT_THAT(building, HasSubstr("Simplified: "));
        EXPECT_THAT(building, HasSubstr("widened"));
        at_scale(Command::ScaleFloor, "Storey");
        EXPECT_THAT(at_scale(Command::ScaleRoom, "Room"), Not(HasSubstr("Simplified: ")));
        at_scale(Command::ScaleDetail, "Detail");
        EXPECT_THAT(at_scale(Command::ScaleRoom, "Room"), Not(HasSubstr("Simplified: ")));
        EXPECT_EQ(at_scale(Command::ScaleBuilding, "Building"), building);
    }
    changes_under_the_hand(world, "sim-t", test::scaled(30));
}

TEST(Simplified, view_reports_each_scale_of_a_generated_office_truthfully_and_changes_imperceptibly) {
    const test::TemporaryFolder folder;
    announces_each_scale_truthfully(test::world_in(folder.write("office.ifc", test::office_ifc({2, 1, 4, 24}).text)));
}

TEST(Simplified, view_reports_each_scale_of_an_architects_house_truthfully_and_changes_imperceptibly) {
    const auto path = test::real_world("duplex-apartment.ifc");
    if (!path) GTEST_SKIP() << test::needs_real_world("duplex-apartment.ifc");
    announces_each_scale_truthfully(test::world_once(*path));
}

// Both hands are still, at any place in their workspaces. After a change of scale, each proxy is outside all solids,
// provided that the shared workspace has a position at which both proxies fit.
TEST(Simplified, view_moves_both_hands_out_of_walls_in_their_common_workspace) {
    Settings settings;
    settings.desk.use = false;
    Session app(settings, Explorer::facts("sim-t"));
    app.apply(LeftHandChanged{Explorer::facts("sim-t")}, 0.0);
    app.apply(WorldEntered{make_ready(open_rooms())}, 0.0);
    std::mt19937 random(test::seed_of_run());
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const double reach_m = 0.55 * find_device_spec("sim-t")->workspace_radius_m;
    ToolState right, left;
    const auto at_m = [&](const ToolState& tool, const WorkspacePose& pose) {
        return frame_of(pose.origin_m, pose.heading_rad)
            .to_world(tool.hand_m, app.hand().tuning.touch.world_m_per_hand_m);
    };
    const auto fits = [&](const Vec3& place_m) {
        return room_round(app, place_m) >= 0.998 * app.hand().tuning.touch.radius_m;
    };
    int left_free = 0;
    const int rounds = 200;
    double now_s = 0.0;
    for (int round = 0; round < rounds; ++round) {
        app.apply(Placed{{10.0 + 9.0 * unit(random), 3.0 + 2.5 * unit(random), 0.0}, 0.0}, now_s);
        for (ToolState* tool : {&right, &left}) {
            tool->ticks = 1;
            tool->hand_m = Vec3(unit(random), unit(random), unit(random)) * reach_m;
            tool->workspace_jump = app.hand().pose.jump;
            tool->proxy_m = at_m(*tool, app.hand().pose);
        }
        app.tick(now_s += 1.0 / 60.0, right, left);
        app.apply(CommandDown{kScales[random() % kScales.size()]}, now_s);
        EXPECT_TRUE(fits(at_m(right, app.hand().pose))) << "round " << round;
        left_free += fits(at_m(left, app.hand(1).pose));
    }
    EXPECT_GE(left_free, rounds * 97 / 100);
    std::cout << left_free << " of " << rounds << " left hands are free\n";
}

// The proxy has at most a third of the width of the narrowest doorway as it is felt. So the proxy of each scale passes
// through all doorways.
TEST(Simplified, doorways_let_the_proxy_through_at_each_scale) {
    for (const char* device : {"sim-t", "sim-f"})
        for (const char* file : {"house.map", "school.map"}) {
            if (!test::tried(device == std::string("sim-t") ? 0 : 1, 2)) continue;
            Explorer p(test::our_world(file), device);
            for (const Command scale : kScales) {
                p.tap(scale, 0.1);
                const double proxy_diameter_m = 2.0 * p.app().hand().tuning.touch.radius_m;
                SimplifyOptions options;
                options.world_m_per_hand_m = p.app().hand().tuning.touch.world_m_per_hand_m;
                const Simplification plan = plan_simplification(*p.app().scene(), options);
                for (std::uint32_t i = 0; i < p.app().scene()->features.size(); ++i) {
                    const Feature& door = p.app().scene()->features[i];
                    if (door.kind != FeatureKind::Door) continue;
                    const NarrowOpening* widened = plan.of_door(FeatureId{i});
                    const double width_m = widened ? widened->felt_width_m()
                                                   : std::max(door.bounds_m.size_m().x, door.bounds_m.size_m().y);
                    EXPECT_LE(proxy_diameter_m, width_m / 3.0 + 1e-9) << file << " " << door.name;
                }
            }
        }
}

}  // namespace simplified_test
}  // namespace handrail
