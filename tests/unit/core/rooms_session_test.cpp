// Tests rooms and routes in a session: the name of the room, its exits, and the route to another room, in words and on
// foot. The rooms are found on a separate thread or at once.
#include <map>
#include <string>
#include <thread>

#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/walker.h"
#include "tests/support/child_process.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"
#include "worlds/stored/stored_navigation.h"

namespace handrail {
namespace rooms_session_test {

std::shared_ptr<const Scene> house() { return test::our_world("house.map"); }

struct Visitor : test::AppSession {
    explicit Visitor(bool background = false)
        : AppSession({}, {}, {.executor = background ? on_threads() : at_once()}) {}
};

TEST(RoomsInASession, without_a_walkable_route_are_announced_on_entering_the_world) {
    using test::box_brush, test::entity, test::key;
    const auto world = [](const std::string& wall) {
        const std::string room = test::room_brushes(0, 0, 0, 320, 640, 128) + box_brush(0, 400, 0, 144, 410, 128) +
                                 box_brush(176, 400, 0, 320, 410, 128) + wall;
        const std::string names = entity("info_room", key("name", "Hall") + key("origin", "160 100 24")) +
                                  entity("info_room", key("name", "Vault") + key("origin", "160 540 24"));
        const std::string chest = entity("func_wall", key("name", "chest"), box_brush(150, 530, 0, 170, 550, 20));
        auto scene = read_quake_map(entity("worldspawn", key("building", "1"), room) +
                                        entity("info_player_start", key("origin", "160 32 24")) + names + chest,
                                    "v.map", {});
        EXPECT_TRUE(scene);
        return std::make_shared<const Scene>(std::move(*scene));
    };
    for (const bool open : {false, true}) {
        Visitor s;
        s.app.apply(WorldEntered{make_ready(
                        world(open ? box_brush(144, 400, 70, 176, 410, 128) : box_brush(144, 400, 0, 176, 410, 128)))},
                    0.0);
        s.run(0.1);
        s.request(Command::Exits);
        s.run(0.1);
        EXPECT_EQ(s.heard("Vault cannot be reached on foot."), !open);
    }
}

TEST(RoomsInASession, are_described_by_name_and_exits_clockwise) {
    Visitor s;
    s.app.apply(WorldEntered{make_ready(house())}, 0.0);
    s.run(0.1);
    EXPECT_TRUE(s.request(Command::WhereAmI).starts_with("Hall, at the base, by the door, facing north. "))
        << s.said.back();
    const std::string exits = s.request(Command::Exits);
    EXPECT_TRUE(exits.starts_with("Hall. ")) << exits;
    // At the front door, facing north: the exit ahead comes first, then east, south, west.
    const auto at = [&](const std::string& part) {
        const std::size_t found = exits.find(part);
        EXPECT_NE(found, std::string::npos) << part << " is missing in: " << exits;
        return found;
    };
    EXPECT_LT(at("Garden door to Garden"), at("Study door to Study"));
    EXPECT_LT(at("Study door to Study"), at("Front door to Garden"));
    EXPECT_LT(at("Front door to Garden"), at("Living room door to Living room"));
    at("Stairs");
    EXPECT_TRUE(s.request(Command::UnvisitedExits).find("exits you have not taken") != std::string::npos)
        << s.said.back();
}

TEST(RoomsInASession, are_announced_on_entering_unless_that_is_switched_off) {
    for (const bool reported : {true, false}) {
        Settings settings;
        settings.speech.rooms = reported;
        Visitor s;
        s.app.apply(WorldEntered{make_ready(house())}, 0.0);
        s.app.apply(SettingsChanged{settings}, 0.0);
        s.run(0.1);
        s.request(Command::Exits);
        s.said.clear();
        s.app.apply(Placed{{9.5, 3.0, 0.0}, 0.0}, s.now);
        s.run(0.2);
        EXPECT_EQ(std::count(s.said.begin(), s.said.end(), "Study"), reported ? 1 : 0);
        EXPECT_TRUE(s.request(Command::WhereAmI).starts_with("Study, facing north. "));
    }
}

TEST(RoomsInASession, give_directions_to_another_room_and_along_the_route) {
    Visitor s;
    s.app.apply(WorldEntered{make_ready(house())}, 0.0);
    s.run(0.1);
    s.request(Command::Routes);
    EXPECT_TRUE(s.said.back().starts_with("Route to which room")) << s.said.back();
    ASSERT_TRUE(s.app.apply(LineTyped{"Music room"}, s.now));
    s.run(0.1);
    const auto reported = std::find_if(s.said.begin(), s.said.end(),
                                       [](const std::string& one) { return one.starts_with("To Music room. "); });
    ASSERT_NE(reported, s.said.end()) << s.news();
    const std::string words = *reported;
    EXPECT_EQ(words, "To Music room. Through Stairs, Landing.");
    EXPECT_TRUE(s.heard(" steps in all: ")) << s.news();
    const std::string rest = s.request(Command::RestOfRoute);
    EXPECT_NE(rest.find(" stairs up, "), std::string::npos) << rest;
    EXPECT_NE(rest.find("Music room door, shut. Open it. "), std::string::npos) << rest;
    EXPECT_TRUE(rest.starts_with(s.request(Command::RepeatLeg))) << "the first of them is the one that one is on";
    // The walker is placed at points along the route, and hears every feature and the arrival.
    s.said.clear();
    for (const Vec3& place : {Vec3(6.3, 2.0, 0.0), Vec3(5.3, 2.7, 0.0)}) {
        s.app.apply(Placed{place, 0.0}, s.now);
        s.run(0.3);
    }
    EXPECT_TRUE(s.heard("Stairs")) << words;
    // The walker is placed far away from the route, and hears a new route.
    s.app.apply(Placed{{6.0, -4.0, 0.0}, 0.0}, s.now);
    s.run(0.3);
    EXPECT_TRUE(s.heard("You have left the route."));
    EXPECT_TRUE(s.heard("To Music room. "));
    s.request(Command::Routes);
    ASSERT_TRUE(s.app.apply(LineTyped{"Stop following the route"}, s.now));
    s.listen();
    EXPECT_EQ(s.said.back(), "You are no longer following a route.");
}

TEST(RoomsInASession, are_plainly_reported_as_unreachable_if_no_route_exists) {
    // This world has a balcony 3 m up that cannot be reached.
    auto scene = read_quake_map(R"({
"classname" "worldspawn"
"building" "1"
{
( 0 0 -16 ) ( 0 320 -16 ) ( 0 0 0 ) plain 0 0 0 1 1
( 640 0 -16 ) ( 640 0 0 ) ( 640 320 -16 ) plain 0 0 0 1 1
( 0 0 -16 ) ( 0 0 0 ) ( 640 0 -16 ) plain 0 0 0 1 1
( 0 320 -16 ) ( 640 320 -16 ) ( 0 320 0 ) plain 0 0 0 1 1
( 0 0 -16 ) ( 640 0 -16 ) ( 0 320 -16 ) plain 0 0 0 1 1
( 0 0 0 ) ( 0 320 0 ) ( 640 0 0 ) plain 0 0 0 1 1
}
{
( 512 0 0 ) ( 512 320 0 ) ( 512 0 96 ) plain 0 0 0 1 1
( 640 0 0 ) ( 640 0 96 ) ( 640 320 0 ) plain 0 0 0 1 1
( 512 0 0 ) ( 512 0 96 ) ( 640 0 0 ) plain 0 0 0 1 1
( 512 320 0 ) ( 640 320 0 ) ( 512 320 96 ) plain 0 0 0 1 1
( 512 0 0 ) ( 640 0 0 ) ( 512 320 0 ) plain 0 0 0 1 1
( 512 0 96 ) ( 512 320 96 ) ( 640 0 96 ) plain 0 0 0 1 1
}
}
{
"classname" "info_player_start"
"origin" "64 160 24"
}
{
"classname" "info_player_coop"
"origin" "576 160 120"
}
{
"classname" "info_room"
"name" "Balcony"
"origin" "576 160 112"
}
)",
                                "balcony.map");
    ASSERT_TRUE(scene);
    Visitor s;
    s.app.apply(WorldEntered{make_ready(std::make_shared<const Scene>(std::move(*scene)))}, 0.0);
    s.run(0.1);
    s.request(Command::Routes);
    ASSERT_TRUE(s.app.apply(LineTyped{"Balcony"}, s.now));
    s.run(0.1);
    s.listen();
    EXPECT_TRUE(s.heard("No walking route found to Balcony. The nearest place you can reach is ")) << s.news();
    EXPECT_EQ(s.said.back(), "Give the room a door, or add stairs or a lift to its storey.");
}

TEST(RoomsInASession, are_found_in_the_background_while_the_session_continues) {
    Visitor s(true);
    s.app.apply(WorldEntered{make_ready(house())}, 0.0);
    // Entering another world cancels the search for rooms.
    s.app.apply(WorldEntered{make_ready(house())}, 0.0);
    EXPECT_TRUE(test::eventually([&] {
        s.run(0.1);
        return !s.request(Command::Exits).starts_with("The rooms of this world are still");
    }));
    EXPECT_TRUE(s.said.back().starts_with("Hall. ")) << s.said.back();
}

// Delivers the rooms in virtual time, as in a recording: they arrive when the session has requested results the given
// number of times.
struct LateRooms {
    // Other background tasks ask for results too, so the constructor gives several consecutive numbers.
    explicit LateRooms(std::uint64_t come_with_question)
        : arrivals({come_with_question, come_with_question + 1, come_with_question + 2, come_with_question + 3}) {
        session.app.apply(WorldEntered{make_ready(house())}, 0.0);
    }
    SessionOptions options() {
        return {.executor = on_threads(), .records_in = {}, .languages_in = {}, .bodies = {}, .arrivals = &arrivals};
    }
    int reported(const std::string& words) const {
        return static_cast<int>(std::count(session.said.begin(), session.said.end(), words));
    }
    Arrivals arrivals;
    test::AppSession session{{}, {}, options()};
    const std::string waited_for = "Rooms and routes are still being worked out. Everything else works.",
                      there = "Rooms and routes have been worked out.";
};

TEST(RoomsInASession, that_take_long_to_find_are_announced_once_at_the_start_and_once_at_the_end) {
    LateRooms late(2000);
    late.session.run(1.9);
    EXPECT_EQ(late.reported(late.waited_for), 0);
    late.session.run(0.2);
    EXPECT_EQ(late.reported(late.waited_for), 1);
    EXPECT_EQ(late.reported(late.there), 0);
    for (int i = 0; i < 600 && late.reported(late.there) == 0; ++i) late.session.run(0.1);
    EXPECT_EQ(late.reported(late.there), 1);
    late.session.run(20.0);
    EXPECT_EQ(late.reported(late.waited_for), 1) << "once";
    EXPECT_EQ(late.reported(late.there), 1) << "once";
}

TEST(RoomsInASession, that_are_found_within_two_seconds_are_not_announced) {
    LateRooms soon(20);
    soon.session.run(20.0);
    EXPECT_EQ(soon.reported(soon.waited_for), 0);
    EXPECT_EQ(soon.reported(soon.there), 0);
    EXPECT_TRUE(soon.session.request(Command::Exits).starts_with("Hall. ")) << soon.session.said.back();
}

TEST(RoomsInASession, are_drawn_on_the_plan_under_their_current_names_and_cost_nothing_without_the_plan) {
    Visitor s;
    s.app.apply(WorldEntered{make_ready(house())}, 0.0);
    s.request(Command::Exits);
    s.run(0.1);
    const ViewState plan = s.app.view({});
    ASSERT_TRUE(plan.rooms);
    ASSERT_LT(plan.room, plan.rooms->size());
    EXPECT_EQ((*plan.rooms)[plan.room].name, "Hall");
    EXPECT_FALSE((*plan.rooms)[plan.room].outline.loops_m.empty());
    s.run(0.5);
    EXPECT_EQ(s.app.view({}).rooms, plan.rooms) << "made once";
    s.request(Command::NameRoom);
    s.app.apply(LineTyped{"Vestibule"}, s.now);
    s.run(0.1);
    EXPECT_EQ((*s.app.view({}).rooms)[plan.room].name, "Vestibule");
    EXPECT_EQ(s.request(Command::PlanView), "Plan view");
    EXPECT_TRUE(s.app.view({}).rooms);
    EXPECT_EQ(s.request(Command::PlanView), "First-person view");
    EXPECT_FALSE(s.app.view({}).rooms);
    EXPECT_EQ(s.request(Command::PlanView), "First-person view and plan");
    EXPECT_TRUE(s.app.view({}).rooms);
}

TEST(RoomsKept, equal_newly_found_rooms_and_belong_to_their_session) {
    const auto world = house(), same_again = std::make_shared<const Scene>(*world);
    const WalkerSize size = walker_size(*world, 0.25);
    const WalkerMeasures body = walker_measures(*world, size.radius_m, size.height_m, size.step_up_m);
    RoomsKept kept;
    ASSERT_EQ(kept.of(world, body), nullptr);
    RoomsOfWorld anew(world, body, at_once(), {}, &kept);
    ASSERT_TRUE(anew.ready() && anew.found());
    ASSERT_NE(kept.of(world, body), nullptr);
    anew.graph().rooms[0].name = "Vestibule";  // the person may give it such a name
    RoomsOfWorld before(world, body, at_once(), {}, &kept);
    RoomsOfWorld other(world, body, at_once());
    ASSERT_TRUE(before.ready() && before.found() && other.ready() && other.found());
    EXPECT_EQ(before.graph().rooms[0].name, other.graph().rooms[0].name);
    EXPECT_EQ(before.graph().room_of_span, other.graph().room_of_span);
    EXPECT_EQ(before.out_of_reach(), other.out_of_reach());
    for (const Room& from : other.graph().rooms)
        for (const Room& to : other.graph().rooms) {
            const Route a = before.navigation().plan(from.middle_m, to.middle_m),
                        b = other.navigation().plan(from.middle_m, to.middle_m);
            EXPECT_EQ(a.points_m, b.points_m) << from.name << " to " << to.name;
            EXPECT_EQ(a.reaches, b.reaches);
        }
    // There is no result for another scene, another size of the walker or another language.
    EXPECT_EQ(kept.of(same_again, body), nullptr);
    EXPECT_EQ(kept.of(world, walker_measures(*world, size.radius_m + 0.01, size.height_m, size.step_up_m)), nullptr);
    const test::InLanguage german("de");
    EXPECT_EQ(kept.of(world, body), nullptr);
    RoomsOfWorld in_german(world, body, at_once(), {}, &kept);
    ASSERT_TRUE(in_german.ready() && in_german.found());
    EXPECT_EQ(in_german.graph().language, "de");
}

TEST(RoomsOfAWorld, are_taken_from_the_cache_unchanged) {
    std::map<std::string, std::string> cache;
    const RoutesKeeper keeper{
        navigation_key, [&](const std::string& key, const std::stop_token&) { return unpacked_navigation(cache[key]); },
        [&](const std::string& key, std::string_view packed) { cache[key] = packed; }};
    const auto scene = house();
    const WalkerMeasures body = walker_measures(*scene, 0.25, 1.8, 0.25);
    const std::string key = navigation_key(*scene, body);
    struct Known {
        bool kept = false;
        std::string ways;
        std::vector<Vec3> way_m;
        std::vector<std::string> out_of_reach;
    };
    const auto look = [&](const Executor& executor) {
        Known known;
        RoomsOfWorld rooms(scene, body, executor, keeper);
        while (!rooms.ready()) std::this_thread::yield();
        EXPECT_TRUE(rooms.found());
        if (!rooms.found()) return known;
        known.kept = rooms.kept();
        known.ways = stored_navigation(rooms.navigation().space(), rooms.graph());
        known.way_m = rooms.navigation().plan(scene->starts[0].feet_m, rooms.graph().rooms.back().middle_m).points_m;
        known.out_of_reach = rooms.out_of_reach();
        return known;
    };
    const Known first = look(at_once()), second = look(on_threads()), third = look(at_once());
    EXPECT_FALSE(first.kept);
    EXPECT_GT(first.way_m.size(), 2U);
    for (const Known& again : {second, third}) {
        EXPECT_TRUE(again.kept);
        EXPECT_EQ(again.ways, first.ways);
        EXPECT_EQ(again.way_m, first.way_m);
        EXPECT_EQ(again.out_of_reach, first.out_of_reach);
    }
    const std::string whole = cache[key];
    EXPECT_EQ(whole, first.ways);
    cache[key] = whole.substr(0, whole.size() / 2);
    const Known anew = look(at_once());
    EXPECT_FALSE(anew.kept);
    EXPECT_EQ(anew.ways, first.ways);
    EXPECT_EQ(cache[key], whole) << "mended";
}

}  // namespace rooms_session_test
}  // namespace handrail
