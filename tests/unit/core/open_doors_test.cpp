// Tests routes past open doors in the house. The walker passes a leaf that blocks the route, whether the leaf is there
// from the start or moves later.
#include <array>
#include <map>

#include "app/core/wayfinding/leaf_ahead.h"
#include "tests/support/every.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/word_walker.h"
#include "tests/unit/core/route_walker.h"

namespace handrail {
namespace open_doors_test {

struct HouseWalker : test::AppSession {
    HouseWalker() {
        app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, 0.0);
        run(0.1);
        request(Command::Routes);
        for (const ListItem& item : app.dialogue().view().items)
            if (item.name != "Pond" && item.name != "Pond steps" && item.name != "Stairs")
                // These rooms are left out, because their edges ask a question and nobody stays there.
                rooms.push_back(item.name);
        app.apply(KeyTapped{"Escape"}, now);
    }
    // Returns true if the walker arrives in the room. `bumped` receives what the walker bumped into on the way.
    bool go_to(const std::string& room) { return test::go_to_room(*this, room, 60.0); }
    // Opens a door from the side to which its leaf does not swing.
    void open(const Mover& door) {
        const Aabb leaf = app.scene()->features[door.feature.value].bounds_m;
        const Vec3 shut = leaf.centre_m(), open = PlacedFrame(door.at(1.0)).to_world(shut - door.pivot_m);
        Vec3 side = leaf.size_m().x < leaf.size_m().y ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        if (glm::dot(side, open - shut) > 0.0) side = -side;
        const Vec3 feet = Vec3(shut.x, shut.y, leaf.min_m.z) + 0.6 * side;
        app.apply(Placed{feet, std::atan2(-side.x, -side.y)}, now);
        run(0.1);
        said.clear();
        request(Command::Use);
        run(2.0);
        EXPECT_TRUE(heard("opens")) << app.scene()->features[door.feature.value].name << ": "
                                    << testing::PrintToString(said);
    }
    int bumps_into(const std::string& door) const {
        return static_cast<int>(std::count_if(
            bumped.begin(), bumped.end(), [&](FeatureId id) { return app.scene()->features[id.value].name == door; }));
    }
    std::vector<std::string> rooms;
};

std::vector<std::string> doors_of(const Scene& scene) {
    std::vector<std::string> doors;
    for (const Mover& mover : scene.movers)
        if (const Feature& feature = scene.features[mover.feature.value]; feature.kind == FeatureKind::Door)
            doors.push_back(feature.name);
    return doors;
}

TEST(OpenDoors, block_no_route_between_two_rooms_of_the_house) {
    HouseWalker p;
    const std::vector<std::string> doors = doors_of(*p.app.scene());
    ASSERT_EQ(doors.size(), 11U);
    ASSERT_EQ(p.rooms.size(), 12U);
    const std::vector<Mover> movers = p.app.scene()->movers;
    for (const Mover& mover : movers)
        if (p.app.scene()->features[mover.feature.value].kind == FeatureKind::Door) p.open(mover);
    // Walks from the hall to each room, and from each room to every other. Each walk starts where the last one ended.
    std::map<std::string, Vec3> places{{"Hall", {6.0, 0.7, 0.0}}};
    const auto walk = [&](const std::string& from, const std::string& to) {
        SCOPED_TRACE(from + " to " + to);
        p.app.apply(Placed{places.at(from), 0.0}, p.now);
        p.run(0.1);
        EXPECT_TRUE(p.go_to(to)) << "stands at " << p.app.feet_m().x << " " << p.app.feet_m().y << " "
                                 << p.app.feet_m().z;
        for (const std::string& door : doors) EXPECT_EQ(p.bumps_into(door), 0) << door;
    };
    for (const std::string& room : p.rooms) {
        walk("Hall", room);
        places.emplace(room, p.app.feet_m());
    }
    std::uint32_t pair = 0;
    for (const auto& [from, place] : places)
        for (const auto& [to, other] : places)
            if (from != to && pair++ % test::every(7, 29) == 0) walk(from, to);
}

TEST(OpenDoors, that_the_walker_opens_on_the_way_are_avoided_from_then_on) {
    HouseWalker first;
    const std::vector<std::string> doors = doors_of(*first.app.scene());
    std::uint32_t number = 0;
    for (const std::string& room : first.rooms) {
        if (number++ % test::every(3, 6) != 0) continue;
        SCOPED_TRACE(room);
        HouseWalker p;
        EXPECT_TRUE(p.go_to(room)) << "stands at " << p.app.feet_m().x << " " << p.app.feet_m().y << " "
                                   << p.app.feet_m().z;
        // The walker may have bumped once into each door, while it was shut.
        for (const std::string& door : doors) EXPECT_LE(p.bumps_into(door), 1) << door;
        EXPECT_TRUE(p.go_to("Hall")) << "stands at " << p.app.feet_m().x << " " << p.app.feet_m().y << " "
                                     << p.app.feet_m().z;
        for (const std::string& door : doors) EXPECT_EQ(p.bumps_into(door), 0) << door;
    }
}

TEST(OpenDoors, that_are_open_from_the_start_are_avoided_from_the_start) {
    using test::box_brush;
    using test::key;
    // Makes two rooms with a gap of a metre in the wall between them. The door in the gap has its hinge in the south
    // and stands open into the eastern room. The destination is behind its leaf.
    auto scene = read_quake_map(
        test::entity("worldspawn", key("building", "1"),
                     test::room_brushes(0, 0, 0, 400, 160, 96) + box_brush(196, 0, 0, 204, 64, 96) +
                         box_brush(196, 96, 0, 204, 160, 96)) +
            test::entity("func_door",
                         key("name", "Door") + key("hinge", "south") + key("opens", "east") + key("spawnflags", "1"),
                         box_brush(199, 64, 0, 201, 96, 80)) +
            test::entity("func_wall", key("name", "Stool"), box_brush(208, 8, 0, 224, 24, 16)) +
            test::entity("info_player_start", key("origin", "40 80 24")),
        "two_rooms.map");
    ASSERT_TRUE(scene) << scene.error().sentence();
    ASSERT_EQ(scene->movers.size(), 1U);
    ASSERT_TRUE(scene->movers[0].rests_far);
    test::AppSession p;
    p.app.apply(WorldEntered{make_ready(std::make_shared<const Scene>(std::move(*scene)))}, 0.0);
    p.run(0.1);
    p.request(Command::Exits);  // The answer waits until the routes are known.
    p.request(Command::Find);
    p.line("Stool");
    p.line("Take me there");
    EXPECT_TRUE(test::walk_along(
        p, [&] { return p.heard("Stool. You are there."); }, 60.0))
        << "stands at " << p.app.feet_m().x << " " << p.app.feet_m().y;
    EXPECT_TRUE(p.bumped.empty()) << p.app.scene()->features[p.bumped[0].value].name;
}

TEST(OpenDoors, that_are_shut_again_leave_the_routes_unchanged) {
    HouseWalker p;
    const auto way = [&] {
        p.request(Command::Routes);
        p.line("Music room");
        return p.app.guide().way_m();
    };
    const std::vector<Mover> movers = p.app.scene()->movers;
    const auto door = std::find_if(movers.begin(), movers.end(), [&](const Mover& m) {
        return p.app.scene()->features[m.feature.value].name == "Music room door";
    });
    ASSERT_NE(door, movers.end());
    p.app.apply(Placed{{6.0, 8.0, 2.9}, 0.0}, p.now);
    p.run(0.1);
    const std::vector<Vec3> shut = way();
    p.open(*door);
    const Vec3 before = p.app.feet_m();
    p.app.apply(Placed{{6.0, 8.0, 2.9}, 0.0}, p.now);
    p.run(0.1);
    EXPECT_NE(way(), shut);
    p.app.apply(Placed{before, kPi / 2.0}, p.now);
    p.run(0.1);
    p.request(Command::Use);
    p.run(2.0);
    p.app.apply(Placed{{6.0, 8.0, 2.9}, 0.0}, p.now);
    p.run(0.1);
    EXPECT_EQ(way(), shut);
}

// Makes a corridor, 1.1 m wide by default. On its north side is a closet, whose door opens into the corridor, and
// farther east an opening to a hall. In a narrow corridor, the leaf of the open door leaves no room to pass. If `open`
// is true, the door is open from the start.
std::shared_ptr<const Scene> corridor_with_closet(int wide_units = 36, bool open = false,
                                                  const std::string& further = {}) {
    const int south = 96 - wide_units;
    const std::string rooms = test::room_brushes(0, 0, 0, 320, 640, 128);
    const std::string walls =
        test::entity("func_wall", test::key("name", "wall"),
                     test::box_brush(0, south - 4, 0, 320, south, 128) + test::box_brush(0, 96, 0, 144, 104, 128) +
                         test::box_brush(176, 96, 0, 256, 104, 128) + test::box_brush(288, 96, 0, 320, 104, 128) +
                         test::box_brush(144, 96, 72, 176, 104, 128) + test::box_brush(132, 104, 0, 136, 150, 128) +
                         test::box_brush(184, 104, 0, 188, 150, 128) + test::box_brush(132, 150, 0, 188, 154, 128));
    const std::string door =
        test::entity("func_door",
                     test::key("hinge", "west") + test::key("opens", "south") + test::key("name", "Closet") +
                         (open ? test::key("spawnflags", "1") : std::string()),
                     test::box_brush(144, 98, 0, 176, 102, 72));
    const std::string base =
        test::entity("info_player_start", test::key("origin", "48 78 24") + test::key("angle", "0"));
    auto scene = read_quake_map(
        test::entity("worldspawn", test::key("message", "Corridor") + test::key("building", "1"), rooms) + base +
            walls + door + further,
        "corridor.map", {});
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().sentence());
    scene->room_names = {RoomName{Vec3(1.5, 2.4, 0.0), "Corridor"}, RoomName{Vec3(8.0, 12.0, 0.0), "Hall"},
                         RoomName{Vec3(5.0, 4.0, 0.0), "Pantry"}};
    return std::make_shared<const Scene>(std::move(*scene));
}

// Enters the world with the corridor, and opens the closet from the corridor.
void open_the_closet(test::AppSession& p) {
    p.app.apply(WorldEntered{make_ready(corridor_with_closet())}, 0.0);
    p.run(0.1);
    p.app.apply(Placed{{5.0, 2.3, 0.0}, 0.0}, p.now);
    p.tap(Command::Use, 2.0);
    ASSERT_TRUE(p.heard("Closet opens"));
}

TEST(OpenDoors, whose_leaf_leaves_no_room_to_pass_are_announced_and_can_be_shut) {
    test::AppSession p;
    open_the_closet(p);
    p.app.apply(Placed{{1.5, 2.43, 0.0}, 0.5 * kPi}, p.now);
    p.run(0.2);
    p.request(Command::Routes);
    p.line("Hall");
    p.run(0.1);  // By now, the route is planned.
    const std::string leg = p.request(Command::RepeatLeg);
    EXPECT_NE(leg.find("Closet is open and in the way. Shut it."), std::string::npos) << leg << " | " << p.news();
    p.walk(5.0);
    EXPECT_LT(p.app.feet_m().x, 4.3) << "the leaf stops one";
    p.said.clear();
    p.tap(Command::Use, 2.0);
    EXPECT_TRUE(p.heard("Closet is shut")) << p.news();
    EXPECT_EQ(p.request(Command::RepeatLeg).find("in the way"), std::string::npos) << p.news();
}

// A walker who follows the directions passes the open leaf. If there is room next to the leaf, nothing is announced.
// Otherwise, the directions say to shut the door.
TEST(OpenDoors, are_passed_next_to_the_leaf_or_shut_as_the_directions_say) {
    for (const int wide_units : {34, 36, 64, 80}) {
        SCOPED_TRACE(wide_units);
        test::WordWalker walker(corridor_with_closet(wide_units, true));
        for (const char* room : {"Hall", "Corridor"}) {
            SCOPED_TRACE(room);
            EXPECT_EQ(walker.go(room), test::WordWalker::End::Arrived) << walker.last_lines(20);
            const std::string heard = walker.last_lines(1000);
            const bool narrow = wide_units < 40, first = std::string(room) == "Hall";
            EXPECT_EQ(heard.find("Closet is open and in the way. Shut it.") != std::string::npos, narrow && first)
                << heard;
            EXPECT_EQ(heard.find("Closet is shut") != std::string::npos, narrow && first) << heard;
            if (!narrow) {
                EXPECT_EQ(heard.find("Closet, open"), std::string::npos) << "met its leaf: " << heard;
            }
        }
    }
}

// A door that is open from the start is described and shut like any other door.
TEST(OpenDoors, that_stay_open_are_described_as_open) {
    test::AppSession p;
    p.app.apply(WorldEntered{make_ready(corridor_with_closet(36, true))}, 0.0);
    p.run(0.1);
    p.app.apply(Placed{{5.2, 4.0, 0.0}, kPi}, p.now);
    for (const char* reported : {"Closet is shut", "Closet opens", "Closet is shut"}) {
        p.said.clear();
        p.tap(Command::Use, 4.0);
        EXPECT_TRUE(p.heard(reported)) << reported << ": " << p.news();
        EXPECT_EQ(shut(p.app.world(), 0), std::string(reported) == "Closet is shut");
    }
}

// The walker has drifted to the side of the closet's doorway, so that the wall is ahead. The door of a locker in the
// south wall is nearer, but the directions name the closet.
TEST(OpenDoors, are_those_that_the_directions_name_even_if_another_is_nearer) {
    const std::string locker = test::entity(
        "func_door", test::key("name", "Locker") + test::key("hinge", "west") + test::key("opens", "south"),
        test::box_brush(170, 60, 0, 202, 62, 72));
    test::AppSession p;
    p.app.apply(WorldEntered{make_ready(corridor_with_closet(36, false, locker))}, 0.0);
    p.run(0.1);
    const auto place = [&](const Vec3& feet_m, double heading_rad) {
        p.app.apply(Placed{feet_m, heading_rad}, p.now);
        p.run(0.1);
    };
    const auto use = [&] {
        p.said.clear();
        p.tap(Command::Use, 4.0);
    };
    const Vec3 aside_m{5.6, 2.5, 0.0};
    place(aside_m, 0.0);
    for (const char* reported : {"Locker opens", "Locker is shut"}) {
        use();
        ASSERT_TRUE(p.heard(reported)) << "without directions, the nearest door moves: " << p.news();
    }
    place({5.0, 2.2, 0.0}, 0.0);
    p.request(Command::Routes);
    p.line("Pantry");
    p.run(0.1);
    const std::string leg = p.request(Command::RepeatLeg);
    ASSERT_EQ(leg.rfind("Straight on.", 0), 0U) << leg;
    ASSERT_NE(leg.find("Closet, shut. Open it."), std::string::npos) << leg;
    place(aside_m, kPi);
    use();
    EXPECT_TRUE(p.heard("Locker opens")) << "the person has turned to the locker: " << p.news();
    place(aside_m, 0.0);
    use();
    EXPECT_TRUE(p.heard("Closet opens")) << p.news();
}

// Two doors face each other across a corridor, and the areas of their swings overlap.
TEST(OpenDoors, on_both_sides_of_a_corridor_open_and_shut_without_collision) {
    const auto door = [](const char* name, const char* hinge, const char* opens, const std::string& brush) {
        return test::entity("func_door",
                            test::key("name", name) + test::key("hinge", hinge) + test::key("opens", opens), brush);
    };
    auto scene = read_quake_map(
        test::entity("worldspawn", test::key("building", "1"),
                     test::room_brushes(0, 0, 0, 320, 160, 96) + test::box_brush(0, 56, 0, 136, 60, 96) +
                         test::box_brush(176, 56, 0, 320, 60, 96) + test::box_brush(0, 98, 0, 144, 102, 96) +
                         test::box_brush(176, 98, 0, 320, 102, 96)) +
            door("Office", "west", "south", test::box_brush(144, 99, 0, 176, 101, 80)) +
            door("Store", "east", "north", test::box_brush(136, 57, 0, 176, 59, 80)) +
            test::entity("info_player_start", test::key("origin", "48 78 24")),
        "corridor.map");
    ASSERT_TRUE(scene) << scene.error().sentence();
    ASSERT_EQ(scene->movers.size(), 2U);
    const auto world = std::make_shared<const Scene>(std::move(*scene));
    for (const bool store_first : {false, true}) {
        SCOPED_TRACE(store_first);
        test::AppSession p;
        p.app.apply(WorldEntered{make_ready(world)}, 0.0);
        p.run(0.1);
        // Two places behind the doors, outside the areas of both swings.
        const Vec3 at_office{5.0, 3.8, 0.0}, at_store{5.0, 1.1, 0.0};
        const auto use = [&](bool store) {
            p.app.apply(Placed{store ? at_store : at_office, store ? 0.0 : kPi}, p.now);
            p.said.clear();
            p.tap(Command::Use, 6.0);
        };
        for (const bool opened : {true, false})
            for (const bool store : {store_first, !store_first}) {
                use(store);
                const std::uint32_t mover = store ? 1 : 0;
                EXPECT_EQ(p.app.world().movers.at(mover), p.app.world().scene->movers[mover].at(opened ? 1.0 : 0.0))
                    << (opened ? "opens " : "shuts ") << mover << ": " << p.news();
            }
    }
}

// A walker who comes from the side of the hinge meets the leaf before the doorway through which the route leads.
TEST(OpenDoors, block_their_own_doorway_if_the_route_reaches_the_leaf_first) {
    test::AppSession p;
    open_the_closet(p);
    const WalkerSize size = walker_size(*p.app.scene(), p.app.settings().walk.body_radius_m);
    const Vec3 doorway_m(5.0, 2.95, 0.0);
    const auto across = leaf_across(p.app.world(), size, std::array{Vec3{3.2, 2.25, 0.0}, doorway_m});
    ASSERT_TRUE(across.has_value());
    EXPECT_EQ(p.app.scene()->features[p.app.scene()->movers[*across].feature.value].name, "Closet");
    EXPECT_FALSE(leaf_across(p.app.world(), size, std::array{Vec3{6.8, 2.25, 0.0}, doorway_m}))
        << "from its other side";
    EXPECT_FALSE(leaf_across(p.app.world(), size, std::array{Vec3{5.0, 2.4, 0.0}, Vec3{5.0, 4.0, 0.0}}))
        << "through it";
    EXPECT_TRUE(leaf_across(p.app.world(), size, std::array{Vec3{3.2, 2.4, 0.0}, Vec3{7.0, 2.4, 0.0}})) << "past it";
}

TEST(OpenDoors, that_were_shut_on_the_route_are_announced_as_to_be_opened_again) {
    test::AppSession p;
    p.app.apply(WorldEntered{make_ready(corridor_with_closet())}, 0.0);
    p.run(0.1);
    p.app.apply(Placed{{5.1, 2.3, 0.0}, 0.0}, p.now);
    p.tap(Command::Use, 2.0);
    ASSERT_TRUE(p.heard("Closet opens"));
    p.request(Command::Routes);
    p.line("Pantry");
    const std::string before = p.request(Command::RepeatLeg);
    EXPECT_EQ(before.find("Open it"), std::string::npos) << before;
    p.tap(Command::Use, 2.0);
    ASSERT_TRUE(p.heard("Closet is shut"));
    const std::string after = p.request(Command::RepeatLeg);
    EXPECT_NE(after.find("Open it"), std::string::npos) << before << " | " << after;
}

// No leg names the door, because the walker passes it according to the plan. If the person asks again, the session says
// what to do with the door.
TEST(OpenDoors, that_stop_the_body_on_a_leg_are_named_as_the_obstacle) {
    test::AppSession p;
    p.app.apply(WorldEntered{make_ready(corridor_with_closet(64))}, 0.0);
    p.run(0.1);
    p.app.apply(Placed{{3.0, 2.0, 0.0}, 0.5 * kPi}, p.now);
    p.request(Command::Routes);
    p.line("Hall");
    p.run(0.1);
    const std::string leg = p.request(Command::RepeatLeg);
    ASSERT_EQ(leg.find("Closet"), std::string::npos) << leg;
    ASSERT_TRUE(leg.starts_with("Straight on.")) << leg;
    const FeatureId closet = p.app.scene()->movers[0].feature;
    p.app.guide().note_stop(closet);
    EXPECT_EQ(p.request(Command::RepeatLeg), "Straight on. 1 step, until you meet Closet, shut. Open it.");
    p.app.apply(Placed{{5.0, 2.3, 0.0}, 0.0}, p.now);
    p.tap(Command::Use, 2.0);
    ASSERT_TRUE(p.heard("Closet opens"));
    p.app.apply(Placed{{3.0, 2.0, 0.0}, 0.5 * kPi}, p.now);
    p.run(0.2);
    p.app.guide().note_stop(closet);
    const std::string shut_it = p.request(Command::RepeatLeg);
    EXPECT_NE(shut_it.find("Closet is open and in the way. Shut it."), std::string::npos) << shut_it;
    // After a door has stopped the walker several times, the session no longer suggests using it.
    for (int i = 0; i < 4; ++i) p.app.guide().note_stop(closet);
    EXPECT_EQ(p.request(Command::RepeatLeg).find("Closet is open"), std::string::npos) << p.news();
}

}  // namespace open_doors_test
}  // namespace handrail
