// Tests marks, landmarks, the beacon, "warmer and colder" and laps of guidance, and how the session uses them.
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/app_session.h"
#include "worlds/navigation/route_place.h"

namespace handrail {
namespace guide_test {

namespace fs = std::filesystem;
using test::SceneBuilder;
using testing::HasSubstr;

// Makes a room of 6 by 4 metres with a table in the north-west and a radiator in the east. The base is at (3, 0.5) and
// faces north.
std::shared_ptr<const Scene> room(double table_x = 1.0, bool landmarks = false) {
    SceneBuilder b;
    b.box({0, 0, -0.2}, {6, 4, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    b.box({-0.2, 4, 0}, {6.2, 4.2, 2.6}, "north wall", SolidRole::Solid, "plaster", FeatureKind::Wall);
    b.box({6, 0, 0}, {6.2, 4, 2.6}, "east wall", SolidRole::Solid, "wood", FeatureKind::Wall);
    b.box({-0.2, 0, 0}, {0, 4, 2.6}, "west wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    b.box({table_x, 3, 0}, {table_x + 1.0, 3.5, 0.7}, "Table", SolidRole::Solid, "wood", FeatureKind::Object);
    b.box({5.8, 1, 0.1}, {6.0, 2, 0.7}, "Radiator", SolidRole::Solid, "metal", FeatureKind::Object);
    if (landmarks)
        for (Feature& feature : b.scene().features) {
            feature.landmark = feature.name == "Table";
            feature.clue = feature.name == "Radiator";
        }
    b.scene().name = "test room";
    b.start({3, 0.5, 0}, 0.0);
    return b.share();
}

struct Person : test::AppSession {
    explicit Person(bool device = false, const Settings& settings = {}) : AppSession(settings, facts(device)) {}
    static HandFacts facts(bool device) {
        HandFacts f;
        f.present = f.simulated = device;
        f.spec = *find_device_spec("sim-t");
        return f;
    }
    void enter(const fs::path& world = {}, std::shared_ptr<const Scene> scene = room()) {
        WorldEntered entered{make_ready(std::move(scene))};
        if (!world.empty()) entered.additions = SideFile::of_world(world, {});
        app.apply(std::move(entered), now);
        run(0.1);
    }
    void tap(Command command) {
        said.clear();
        app.apply(CommandDown{command}, now);
        run(0.1);
        app.apply(CommandUp{command}, now);
    }
    void key(const char* name) {
        said.clear();
        app.apply(KeyTapped{name}, now);
        run(0.05);
    }
    void type(const char* text) {
        app.apply(TextTyped{text}, now);
        run(0.05);
    }
    void hand_at(const Vec3& world_m) {
        tool.ticks = 1;
        tool.waiting_for_hand = false;
        tool.hip_m = tool.proxy_m = world_m;
        tool.workspace_jump = app.hand().pose.jump;
    }
    void stand_at(const Vec3& feet_m, double heading_rad = 0.0) {
        app.apply(Placed{feet_m, heading_rad}, now);
        run(0.05);
    }
};

TEST(Marks, are_set_named_saved_found_again_and_deleted) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.write("room.map", "one");
    {
        Person p;
        p.enter(world);
        p.tap(Command::DropMark);
        EXPECT_TRUE(p.heard("Mark 1")) << testing::PrintToString(p.said);
        EXPECT_EQ(p.count(SoundKind::Mark), 1);
        p.key("Escape");
        p.stand_at({2.5, 2.9, 0.0});
        p.tap(Command::DropMark);
        EXPECT_TRUE(p.heard("Mark 2, near Table")) << testing::PrintToString(p.said);
        for (int i = 0; i < 30; ++i) p.app.apply(KeyTapped{"Backspace"}, p.now);
        p.type("Książki 本");
        p.key("Enter");
        EXPECT_TRUE(p.heard("Książki 本"));
        ASSERT_EQ(p.app.world().marks.size(), 2U);
        EXPECT_EQ(p.app.world().marks[1].name, "Książki 本");
    }
    Person p;
    p.enter(world);
    EXPECT_EQ(p.app.world().marks.size(), 2U);
    EXPECT_FALSE(p.heard("no longer fit"));
    p.tap(Command::DeleteMark);
    p.key("Enter");
    EXPECT_TRUE(p.heard("deleted"));
    Person again;
    again.enter(world);
    ASSERT_EQ(again.app.world().marks.size(), 1U);
    EXPECT_EQ(again.app.world().marks[0].name, "Książki 本");
}

TEST(Marks, are_set_and_found_in_german_near_things_with_english_names_in_the_world) {
    const test::InLanguage german("de");
    Scene scene = *room(4.0);
    for (Feature& feature : scene.features) feature.made_name = feature.kind == FeatureKind::Wall;
    Person p;
    p.enter({}, std::make_shared<const Scene>(std::move(scene)));
    p.tap(Command::DeleteMark);
    EXPECT_TRUE(p.heard("Es gibt noch keine Marken. Einfügen oder Umschalt+M setzt eine."))
        << testing::PrintToString(p.said);
    p.stand_at({0.5, 1.0, 0.0});
    p.tap(Command::DropMark);
    EXPECT_TRUE(p.heard("Marke 1, bei Westwand gesetzt. Anderen Namen tippen oder Enter drücken"))
        << testing::PrintToString(p.said);
    p.key("Enter");
    ASSERT_EQ(p.app.world().marks.size(), 1U);
    EXPECT_EQ(p.app.world().marks[0].near, "west wall");
    p.stand_at({3.0, 0.5, 0.0});
    p.tap(Command::Marks);
    EXPECT_TRUE(p.heard("Marken und Signal")) << testing::PrintToString(p.said);
    EXPECT_TRUE(p.heard("Signal, aus")) << testing::PrintToString(p.said);
    p.key("Down");
    EXPECT_TRUE(p.heard("Hilfe auf dem Weg, 100 Prozent")) << testing::PrintToString(p.said);
    p.key("Down");
    EXPECT_TRUE(p.heard("Marke 1, bei Westwand, 4 Schritte, links")) << testing::PrintToString(p.said);
    p.key("Enter");
    p.key("Enter");
    EXPECT_TRUE(p.heard("Signal auf Marke 1, bei Westwand, 4 Schritte, links")) << testing::PrintToString(p.said);
    p.stand_at({1.2, 1.0, 0.0});
    EXPECT_TRUE(p.heard("Hier: Marke 1, bei Westwand")) << testing::PrintToString(p.said);
    p.stand_at({3.0, 0.5, 0.0});
    p.tap(Command::SetBeacon);
    EXPECT_TRUE(p.heard("Signal auf Nordwand, 5 Schritte vorn")) << testing::PrintToString(p.said);
    p.tap(Command::DropMark);
    EXPECT_TRUE(p.heard("Marke 2, bei Table gesetzt")) << testing::PrintToString(p.said);
}

TEST(Marks, that_no_longer_fit_an_edited_world_are_reported) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.write("room.map", "one");
    Settings settings;
    settings.marks.ask_name = false;
    {
        Person p(false, settings);
        p.enter(world);
        p.stand_at({2.3, 2.7, 0.0});
        p.tap(Command::DropMark);
        p.stand_at({5.0, 1.5, 0.0});
        p.tap(Command::DropMark);
        EXPECT_TRUE(p.heard("Mark 2, near Radiator set"));
    }
    folder.write("room.map", "two");
    Person same(false, settings);
    same.enter(world);
    EXPECT_FALSE(same.heard("no longer fit")) << "edited elsewhere; what the marks stand by is where it was";
    Person p(false, settings);
    p.enter(world, room(4.5));
    EXPECT_TRUE(p.heard("This world has changed since you set marks. 1 of 2 no longer fits: Mark 1, near Table."))
        << testing::PrintToString(p.said);
    EXPECT_EQ(p.app.world().marks.size(), 2U);
    p.tap(Command::Marks);
    EXPECT_THAT(p.app.dialogue().view().items[2].value, HasSubstr("may no longer fit"));
}

TEST(Marks, that_are_damaged_are_set_aside_and_reported) {
    const test::TemporaryFolder folder;
    const fs::path world = folder.write("room.map", "one");
    folder.write("room.map.handrail.toml", "[[mark]\n");
    Person p;
    p.enter(world);
    EXPECT_TRUE(p.heard("saved as room.map.handrail.toml.damaged"));
    EXPECT_TRUE(p.app.world().marks.empty());
    folder.write("room.map.handrail.toml",
                 "[[mark]]\nname = \"a\"\n[[mark]]\nname = \"b\"\nplace_m = [1.0, 1.0, 0.0]\n");
    Person q;
    q.enter(world);
    EXPECT_TRUE(
        q.heard("room.map.handrail.toml, line 1: the mark a needs place_m with three decimal numbers, such as [1.0, "
                "2.5, 0.0]. Add them, or "
                "delete the entry. The rest of your additions was read."))
        << testing::PrintToString(q.said);
    ASSERT_EQ(q.app.world().marks.size(), 1U);
    q.tap(Command::DropMark);
    EXPECT_THAT(test::content_of(folder.path() / "room.map.handrail.toml"), HasSubstr("name = \"a\""))
        << "what could not be read stays in the file";
}

TEST(Marks, are_set_at_the_hand_also_by_the_devices_button_and_announced_once_when_near) {
    Settings settings;
    settings.marks.ask_name = false;
    Person p(true, settings);
    p.enter();
    p.hand_at({1.5, 2.9, 0.4});
    p.run(0.1);
    p.said.clear();
    p.tool.buttons = 2;
    p.run(0.2);
    p.tool.buttons = 0;
    p.run(0.1);
    EXPECT_TRUE(p.heard("Mark 1, near Table set"));
    ASSERT_EQ(p.app.world().marks.size(), 1U);
    EXPECT_EQ(p.app.world().marks[0].place_m, Vec3(1.5, 2.9, 0.4));
    p.sounds.clear();
    p.said.clear();
    p.hand_at({4.0, 1.0, 1.0});
    p.run(0.2);
    EXPECT_EQ(p.count(SoundKind::Mark), 0);
    p.hand_at({1.6, 2.8, 0.5});  // The hand is near the mark: 3 mm away at the hand.
    p.run(1.0);
    EXPECT_EQ(p.count(SoundKind::Mark), 1);
    EXPECT_TRUE(p.heard("Mark 1"));
    // By default, the first button grabs the world. The settings can let it set marks instead.
    p.tool.buttons = 1;
    p.run(0.2);
    EXPECT_EQ(p.app.world().marks.size(), 1U);
}

TEST(Landmarks, and_clues_sound_different_when_touched_or_passed) {
    Person p(true);
    p.enter({}, room(1.0, true));
    p.stand_at({1.5, 1.8, 0.0});
    p.run(0.5);
    EXPECT_EQ(p.count(SoundKind::Landmark), 1);
    EXPECT_EQ(p.count(SoundKind::Clue), 0);
    p.stand_at({4.8, 1.5, 0.0});
    p.run(0.5);
    EXPECT_EQ(p.count(SoundKind::Clue), 1);
    p.stand_at({3.0, 0.5, 0.0});
    const auto table = std::find_if(p.app.scene()->features.begin(), p.app.scene()->features.end(),
                                    [](const Feature& f) { return f.name == "Table"; });
    p.hand_at({1.5, 2.95, 0.4});
    p.tool.contacts.count = 1;
    p.tool.contacts.strongest = 0;
    p.tool.contacts.contacts[0].feature =
        FeatureId{static_cast<std::uint32_t>(table - p.app.scene()->features.begin())};
    p.run(0.5);
    EXPECT_EQ(p.count(SoundKind::Landmark), 2);
}

TEST(BeaconTest, beats_faster_when_nearer_and_distinguishes_ahead_side_and_behind) {
    Beacon beacon;
    const Aabb thing{{-0.1, 9.9, 0.9}, {0.1, 10.1, 1.1}};
    const auto clear = [](const Vec3&) { return 0.0; };
    double last_s = 0.0;
    for (const double y : {8.0, 4.0, 0.0, -8.0, -15.0}) {
        EXPECT_GE(Beacon::interval_s(10.0 - y), last_s);
        last_s = Beacon::interval_s(10.0 - y);
    }
    const auto sound = [&](double heading_deg, double muffled_db = 0.0) {
        beacon.set("thing", thing, kNoFeature);
        const Listener ears{{0.0, 0.0, 1.6}, radians_from_degrees(heading_deg), 0.0};
        return *beacon
                    .tick(
                        {0, 0, 0}, ears, [&](const Vec3&) { return muffled_db; }, true, 0.0)
                    .sound;
    };
    EXPECT_EQ(sound(0.0).sound, SoundKind::BeaconAhead);
    EXPECT_EQ(sound(10.0).sound, SoundKind::BeaconAhead);
    EXPECT_EQ(sound(-30.0).sound, SoundKind::Beacon);
    EXPECT_EQ(sound(90.0).sound, SoundKind::Beacon);
    EXPECT_EQ(sound(180.0).sound, SoundKind::BeaconBehind);
    EXPECT_EQ(sound(0.0, 5.0).muffled_db, 5.0);
    EXPECT_EQ(sound(0.0, 60.0).muffled_db, Beacon::kMostMuffled_db) << "obeys walls and stays audible";
    EXPECT_FALSE(beacon.tick({0, 0, 0}, {}, clear, false, 9.0).sound) << "stopped";
    EXPECT_FALSE(beacon.tick({0, 9.5, 5.0}, {}, clear, true, 9.0).arrived) << "another storey";
    EXPECT_TRUE(beacon.tick({0, 9.5, 0.0}, {}, clear, true, 9.0).arrived);
    EXPECT_FALSE(beacon.on());
}

TEST(BeaconTest, is_set_on_the_thing_ahead_muted_and_restored) {
    Person p;
    p.enter();
    p.stand_at({2.6, 1.0, 0.0});
    p.run(0.2);
    p.tap(Command::SetBeacon);
    EXPECT_TRUE(p.heard("Beacon on North wall")) << testing::PrintToString(p.said);
    p.run(3.0);
    EXPECT_GE(p.count(SoundKind::BeaconAhead), 5);
    p.tap(Command::MuteBeacon);
    const int before = p.count(SoundKind::BeaconAhead);
    p.run(2.0);
    EXPECT_EQ(p.count(SoundKind::BeaconAhead), before);
    p.tap(Command::MuteBeacon);
    p.run(2.0);
    EXPECT_GT(p.count(SoundKind::BeaconAhead), before);
    p.tap(Command::StopEverything);
    const int stopped = p.count(SoundKind::BeaconAhead);
    p.run(2.0);
    EXPECT_EQ(p.count(SoundKind::BeaconAhead), stopped);
}

// Chooses a thing in the list of what can be found, and then a tool to find it.
void seek(Person& p, const std::string& thing, const std::string& way) {
    p.tap(Command::Find);
    const std::vector<ListItem> items = p.app.dialogue().view().items;
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const ListItem& item) { return item.name == thing; });
    ASSERT_NE(found, items.end()) << thing;
    ASSERT_TRUE(p.app.apply(LineTyped{std::to_string(found - items.begin() + 1)}, p.now));
    p.run(0.05);
    p.said.clear();
    ASSERT_TRUE(p.app.apply(LineTyped{way}, p.now));
    p.run(0.05);
}

TEST(BeaconTest, is_set_on_the_thing_ahead_or_else_on_the_surface_ahead) {
    Person p;
    p.enter();
    p.stand_at({1.5, 1.0, 0.0});
    p.run(0.2);
    p.tap(Command::SetBeacon);
    EXPECT_TRUE(p.heard("Beacon on Table")) << testing::PrintToString(p.said);
    p.stand_at({3.0, 1.0, 0.0});
    p.run(0.2);
    p.tap(Command::SetBeacon);
    EXPECT_TRUE(p.heard("Beacon on North wall")) << testing::PrintToString(p.said);
}

// A ray at waist height passes over the table, so the radiator beyond it is in sight. But nobody can walk through a
// table.
TEST(BeaconTest, calls_along_the_route_if_the_target_is_visible_but_the_direct_line_is_blocked) {
    Person p;
    p.enter();
    p.stand_at({0.3, 3.7, 0.0}, 0.5 * kPi);
    p.run(0.2);
    ASSERT_NO_FATAL_FAILURE(seek(p, "Radiator", "Beacon"));
    EXPECT_TRUE(p.heard("Beacon on Radiator")) << testing::PrintToString(p.said);
    EXPECT_TRUE(p.heard("Along the route")) << testing::PrintToString(p.said);
    p.run(3.0);
    EXPECT_EQ(p.count(SoundKind::BeaconAhead), 0);
    EXPECT_GE(p.count(SoundKind::Beacon), 5);
}

TEST(WarmerTest, ticks_faster_when_nearer_is_silent_at_rest_and_ends_on_the_target) {
    for (double felt_m = 0.0; felt_m < 0.3; felt_m += 0.001)
        EXPECT_LE(Warmer::interval_s(felt_m), Warmer::interval_s(felt_m + 0.001)) << felt_m;
    for (double felt_m = 0.005; felt_m < 0.3; felt_m += 0.005)
        EXPECT_GT(Warmer::interval_s(2.0 * felt_m), 1.09 * Warmer::interval_s(felt_m))
            << "twice as far is heard, " << felt_m;
    EXPECT_GE(Warmer::interval_s(0.0), 0.06) << "single ticks, no buzz";
    EXPECT_LE(Warmer::interval_s(9.0), 0.5) << "never lost";

    Warmer warmer;
    double now_s = 0.0;
    const auto ticks_in_10_s = [&](double felt_m, bool heard) {
        int ticks = 0;
        for (int i = 0; i < 10000; ++i, now_s += 0.001)
            ticks += warmer.tick(felt_m, Vec3(0.0), false, heard, now_s).sound;
        return ticks;
    };
    EXPECT_EQ(ticks_in_10_s(0.02, true), 0) << "nothing is sought";
    warmer.set("cup", {{0, 0, 0}, {1, 1, 1}}, kNoFeature);
    int before = 0;
    for (const double felt_m : {0.2, 0.1, 0.05, 0.02, 0.01, 0.005}) {
        const int ticks = ticks_in_10_s(felt_m, true);
        EXPECT_GT(ticks, before) << felt_m;
        EXPECT_NEAR(ticks, 10.0 / Warmer::interval_s(felt_m), 2.0) << felt_m;
        before = ticks;
    }
    EXPECT_EQ(ticks_in_10_s(0.02, false), 0) << "stopped";
    EXPECT_TRUE(warmer.on()) << "and still sought";
    const Warmer::Beat last = warmer.tick(Warmer::kFound_hand_m, Vec3(0.0), true, true, now_s);
    EXPECT_TRUE(last.found);
    EXPECT_FALSE(last.sound);
    EXPECT_FALSE(warmer.on());
    EXPECT_FALSE(warmer.tick(0.0, Vec3(0.0), true, true, now_s + 9.0).found) << "told once";
}

TEST(WarmerTest, is_announced_ticks_for_hand_or_body_and_is_switched_off_by_a_second_request) {
    for (const bool device : {true, false}) {
        Person p(device);
        p.enter();
        // Returns a place at this distance in front of the radiator, at the height of the radiator.
        const auto away = [&](double metres) {
            const Vec3 place(5.8 - metres, 1.5, device ? 0.5 : 0.0);
            if (device) p.hand_at(place);
            else p.stand_at(place);
        };
        const auto ticks = [&] {
            const int before = p.count(SoundKind::Warmer);
            p.run(3.0);
            return p.count(SoundKind::Warmer) - before;
        };
        away(4.0);
        EXPECT_EQ(ticks(), 0) << "not asked for";
        ASSERT_NO_FATAL_FAILURE(seek(p, "Radiator", "Warmer and colder"));
        EXPECT_TRUE(p.heard("Radiator: faster ticking means you are nearer")) << testing::PrintToString(p.said);
        int before = 0;
        for (const double metres : {4.0, 2.8, 2.0, 1.4}) {
            away(metres);
            const int now = ticks();
            EXPECT_GT(now, before) << metres;
            before = now;
        }
        away(4.0);
        EXPECT_LT(ticks(), before) << "colder";
        ASSERT_NO_FATAL_FAILURE(seek(p, "Radiator", "Warmer and colder"));
        EXPECT_TRUE(p.heard("Warmer and colder off")) << testing::PrintToString(p.said);
        EXPECT_EQ(ticks(), 0);

        ASSERT_NO_FATAL_FAILURE(seek(p, "Radiator", "Warmer and colder"));
        EXPECT_GT(ticks(), 0);
        p.said.clear();
        away(device ? 0.2 : 1.0);
        p.run(0.1);
        EXPECT_TRUE(p.heard("Here: Radiator")) << testing::PrintToString(p.said);
        EXPECT_EQ(p.count(SoundKind::Arrived), 1);
        EXPECT_EQ(ticks(), 0) << "found";

        away(4.0);
        ASSERT_NO_FATAL_FAILURE(seek(p, "Radiator", "Warmer and colder"));
        p.tap(Command::StopEverything);
        EXPECT_EQ(ticks(), 0) << "all sound is stopped";
    }
}

TEST(WarmerTest, signals_by_pitch_how_directly_the_person_approaches_or_moves_away) {
    Warmer warmer;
    warmer.set("cup", {{0, 0, 0}, {0, 0, 0}}, kNoFeature);
    double now_s = 0.0;
    const auto goes_to = [&](const Vec3& hand_m) {
        now_s += 1.0;
        const Warmer::Beat beat = warmer.tick(glm::length(hand_m), hand_m, false, true, now_s);
        EXPECT_TRUE(beat.sound);
        return beat.nearer;
    };
    EXPECT_EQ(goes_to({0.1, 0, 0}), 0.0) << "the first";
    EXPECT_NEAR(goes_to({0.08, 0, 0}), 1.0, 1e-9);
    EXPECT_EQ(goes_to({0.08, 0, 0}), 0.0) << "at rest";
    EXPECT_NEAR(goes_to({0.09, 0, 0}), -1.0, 1e-9);
    EXPECT_NEAR(goes_to({0.09, 0.005, 0}), 0.0, 0.05) << "past it";
    EXPECT_NEAR(goes_to({0.085, 0.0, 0}), 0.73, 0.05) << "half round to it";
}

// The route has two legs in the form of an L. A walker who goes round its corner hears the walking distance. The
// distance does not jump if the route is planned again.
TEST(SoughtRouteTest, measures_walking_distance_calls_from_the_next_turn_and_is_continuous_on_replanning) {
    SoughtRoute way;
    const auto follow = [&](const Vec3& at_m) { way.follow(at_m, kHeightCountsForWalkers, {}); };
    EXPECT_TRUE(way.wants_plan(false, 0.0));
    way.plan({{0, 0, 0}, {0, 10, 0}, {10, 10, 0}}, {}, 0.5, {0, 0, 0}, 0.0);
    EXPECT_TRUE(way.known());
    EXPECT_FALSE(way.wants_plan(false, 5.0));
    EXPECT_TRUE(way.wants_plan(true, 5.0)) << "something stands elsewhere";
    EXPECT_FALSE(way.wants_plan(true, 0.5)) << "no sooner than after a second";
    EXPECT_NEAR(way.left_m(), 20.5, 1e-9);
    EXPECT_EQ(way.next_turning_m(), Vec3(0, 10, 0));
    double before_m = way.announced_m();
    for (double y = 0.1; y < 9.55; y += 0.1) {
        follow({0, y, 0});
        EXPECT_NEAR(before_m - way.announced_m(), 0.1, 1e-9);
        before_m = way.announced_m();
    }
    EXPECT_EQ(way.next_turning_m(), Vec3(0, 10, 0));
    follow({0, 9.7, 0});
    EXPECT_EQ(way.next_turning_m(), Vec3(10, 10, 0)) << "at the turning the next is called from";
    // Away from the route, the distance first grows little, then by as much as the walker moves away. After that, the
    // route must be planned again.
    follow({3, 10.3, 0});
    EXPECT_NEAR(way.left_m(), 7.5 + SoughtRoute::kSlope * 0.3 * 0.3 / 1.2, 1e-9);
    way.follow({3, 11.5, 0}, kHeightCountsForWalkers, [](const Vec3&) { return false; });
    EXPECT_TRUE(way.wants_plan(false, 5.0));
    // The new route is 4 m longer. The announced distance stays the same, and approaches that of the new route only
    // while the walker moves. So an approach never sounds like moving away.
    before_m = way.announced_m();
    way.plan({{3, 11.5, 0}, {3, 16, 0}, {10, 16, 0}}, {}, 1.0, {3, 11.5, 0}, 6.0);
    EXPECT_NEAR(way.announced_m(), before_m, 1e-9);
    Vec3 at(3, 11.5, 0);
    for (int i = 0; i < 38; ++i) {
        at.y += 0.1;
        follow(at);
        EXPECT_LT(way.announced_m(), before_m);
        EXPECT_GT(way.announced_m(), before_m - 0.16);
        before_m = way.announced_m();
    }
    follow(at);
    EXPECT_NEAR(way.announced_m(), before_m, 1e-9) << "who rests hears no change";
    // If the route is in sight, even from afar, the walker can return to it. If the route is hidden, it must be planned
    // again.
    for (const bool seen : {true, false}) {
        way.follow(Vec3(5, 14, 0), kHeightCountsForWalkers, [&](const Vec3&) { return seen; });
        EXPECT_EQ(way.wants_plan(false, 8.0), !seen);
    }
    way.follow(Vec3(5, 9, 0), kHeightCountsForWalkers, {});
    EXPECT_TRUE(way.wants_plan(false, 8.0)) << "seen, but far";
    way.no_route(9.0);
    EXPECT_FALSE(way.known());
}

TEST(LapsTest, help_decreases_with_success_and_never_increases_automatically) {
    Laps laps;
    laps.begin("table");
    for (const double strength : {1.0, 0.6, 0.3, 0.0, 0.0}) {
        EXPECT_EQ(laps.strength(), strength);
        laps.begin("table");
        laps.finish(0, true);
    }
    laps.finish(9, true);
    EXPECT_EQ(laps.strength(), 0.0);
    laps.change(1);
    EXPECT_EQ(laps.strength(), 0.3);
    laps.begin("door");
    EXPECT_EQ(laps.strength(), 1.0);
    laps.finish(5, true);
    EXPECT_EQ(laps.strength(), 1.0);
    laps.finish(5, true);
    EXPECT_EQ(laps.strength(), 1.0);
    laps.finish(3, true);
    EXPECT_EQ(laps.strength(), 0.6);
    laps.finish(1, false);
    EXPECT_EQ(laps.strength(), 0.6) << "switched off";
}

TEST(TakeMe, is_announced_a_second_before_the_servo_starts_it_and_only_one_target_is_active) {
    Person p(true);
    p.enter();
    p.hand_at({3.0, 1.0, 1.0});
    p.run(0.1);
    p.tap(Command::TakeMe);
    EXPECT_TRUE(p.app.dialogue().is_open()) << "nothing chosen yet";
    p.type("radiator");
    p.key("Enter");
    p.key("Down");
    p.key("Enter");
    EXPECT_TRUE(p.heard("Taking your hand to Radiator"));
    EXPECT_EQ(p.count(SoundKind::GuideStart), 1);
    EXPECT_EQ(p.app.guide().path().number, 0U);
    p.run(0.7);
    EXPECT_EQ(p.app.guide().path().number, 0U);
    p.run(0.4);
    EXPECT_NE(p.app.guide().path().number, 0U);
    EXPECT_EQ(p.app.guide().path().points_m[p.app.guide().path().count - 1].x, 5.8);
    p.tap(Command::TakeMe);
    EXPECT_TRUE(p.heard("Guiding stopped"));
    EXPECT_EQ(p.app.guide().path().number, 0U);
}

// The session says why there is no force any more, and not only that it has ended.
TEST(TakeMe, gives_the_reason_when_guidance_ends) {
    struct Case {
        void (*happens)(Person&);
        const char* said;
    };
    const Case cases[] = {
        {[](Person& p) { p.tool.fault = Fault::Stalled; },
         "You are no longer guided. The computer stopped for a moment. The force comes back slowly."},
        {[](Person& p) { p.tool.pause = Fault::ButtonReleased; },
         "You are no longer guided. Button released. The force is off until you hold the button again."},
        {[](Person&) {}, "You are no longer guided. The force was off for a moment. Use H to be guided again."},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.said);
        Person p(true);
        p.enter();
        p.hand_at({3.0, 1.0, 1.0});
        p.run(0.1);
        p.tap(Command::TakeMe);
        for (const char* key : {"Enter", "Down", "Enter"}) {
            if (std::string(key) == "Enter" && p.app.dialogue().view().title != "Radiator") p.type("radiator");
            p.key(key);
        }
        p.run(1.1);
        ASSERT_NE(p.app.guide().path().number, 0U);
        p.tool.guidance.number = p.app.guide().path().number;
        p.tool.guidance.phase = GuidancePhase::Ended;
        one.happens(p);
        p.run(0.1);
        EXPECT_TRUE(p.heard(one.said)) << testing::PrintToString(p.said);
    }
}

// The servo withholds its force until somebody holds the grip.
TEST(TakeMe, waits_for_a_hand_on_the_grip_and_announces_it) {
    Person p(true);
    p.enter();
    p.hand_at({3.0, 1.0, 1.0});
    p.tool.waiting_for_hand = true;
    p.run(0.1);
    p.tap(Command::Find);
    p.type("radiator");
    p.key("Enter");
    p.key("Down");
    p.key("Enter");
    EXPECT_TRUE(p.heard("The force waits until you move the grip. Follow the beacon to Radiator"))
        << testing::PrintToString(p.said);
    p.run(2.0);
    EXPECT_FALSE(p.heard("You are no longer guided"));
}

TEST(TakeMe, leads_around_obstacles_along_the_planned_path_and_by_ear_without_force) {
    Person p(true);
    p.enter();
    p.hand_at({1.2, 3.7, 0.3});  // The hand is behind the table.
    p.run(0.1);
    const auto request = [&] {
        p.tap(Command::Find);
        p.type("radiator");
        p.key("Enter");
        p.key("Down");
        p.key("Enter");
    };
    request();
    EXPECT_TRUE(p.heard("Taking your hand to Radiator")) << testing::PrintToString(p.said);
    p.run(1.1);
    const GuidancePath& path = p.app.guide().path();
    ASSERT_GT(path.count, 2U);
    EXPECT_EQ(path.points_m[0], Vec3(1.2, 3.7, 0.3));
    const WalkerWorld world(p.app.scene());
    for (std::uint32_t i = 0; i + 2 < path.count; ++i)
        EXPECT_TRUE(world.crossings(path.points_m[i], path.points_m[i + 1]).empty()) << i;
    EXPECT_NEAR(path.points_m[path.count - 1].x, 5.85, 0.06) << "on the radiator";
    EXPECT_FALSE(p.app.guide().beacon().on());
    p.tap(Command::TakeMe);
    p.hand_at({3.0, 1.0, 1.0});
    p.tap(Command::ToggleForces);
    request();
    EXPECT_TRUE(p.heard("Forces are off. Follow the beacon"));
}

TEST(TakeMe, reports_an_unreachable_target_and_goes_to_the_nearest_reachable_place) {
    // The goal is behind a wall without a door.
    SceneBuilder b;
    b.box({0, 0, -0.2}, {10, 4, 0}, "floor", SolidRole::Solid, "carpet", FeatureKind::Floor);
    for (const double x : {-0.2, 5.0, 10.0})
        b.box({x, 0, 0}, {x + 0.2, 4, 2.6}, "wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    b.box({-0.2, -0.2, 0}, {10.2, 0, 2.6}, "south wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    b.box({-0.2, 4, 0}, {10.2, 4.2, 2.6}, "north wall", SolidRole::Solid, "brick", FeatureKind::Wall);
    b.box({8, 2, 0}, {8.5, 2.5, 0.7}, "Chest", SolidRole::Solid, "wood", FeatureKind::Object);
    b.scene().name = "walled up";
    b.start({2, 2, 0}, 0.0);
    const auto scene = b.share();
    const auto request = [](Person& p) {
        p.tap(Command::Find);
        p.type("chest");
        p.key("Enter");
        p.key("Down");
        p.key("Enter");
    };
    Person hand(true);
    hand.enter({}, scene);
    hand.hand_at({2.0, 2.0, 1.0});
    hand.run(0.1);
    request(hand);
    EXPECT_TRUE(
        hand.heard("No walking route found to Chest. Taking your hand to the nearest place that can be reached, "))
        << testing::PrintToString(hand.said);
    hand.run(1.1);
    const GuidancePath& path = hand.app.guide().path();
    ASSERT_GE(path.count, 2U);
    EXPECT_NEAR(path.points_m[path.count - 1].x, 4.7, 0.1) << "before the wall";
    Person keys;
    keys.enter({}, scene);
    request(keys);
    EXPECT_TRUE(keys.heard("No walking route found to Chest. The nearest place you can reach is"))
        << testing::PrintToString(keys.said);
    EXPECT_TRUE(keys.heard("To the nearest place to Chest.")) << testing::PrintToString(keys.said);
    keys.stand_at({4.65, 2.2, 0.0});
    keys.run(0.2);
    EXPECT_TRUE(keys.heard("The nearest place to Chest. You are there.")) << testing::PrintToString(keys.said);
}

TEST(TakeMe, without_a_device_gives_directions_follows_the_route_and_stops_when_requested_again) {
    Person p;
    p.enter();
    p.stand_at({0.5, 3.6, 0.0});  // The table is between the walker and the goal.
    p.tap(Command::Find);
    p.type("radiator");
    p.key("Enter");
    p.key("Down");
    p.key("Enter");
    EXPECT_TRUE(p.heard("To Radiator. ")) << testing::PrintToString(p.said);
    EXPECT_TRUE(p.heard("12 steps in all: 3 turns. Turn sharp right, then slightly right. 2 steps."))
        << testing::PrintToString(p.said);
    p.tap(Command::TakeMe);
    EXPECT_TRUE(p.heard("You are no longer following a route."));
    EXPECT_FALSE(p.app.guide().beacon().on());
    p.tap(Command::TakeMe);
    EXPECT_TRUE(p.heard("To Radiator. "));
    p.stand_at({5.4, 1.5, 0.0});
    p.run(0.3);
    EXPECT_TRUE(p.heard("Radiator. You are there.") || p.heard("Here: Radiator")) << testing::PrintToString(p.said);
}

}  // namespace guide_test
}  // namespace handrail
