// Tests saved routes in a session. A person plans or walks a route, and saves it under a name next to the world. After
// a restart, the person hears the route, follows it stop by stop by ear and by hand, reverses, changes and deletes it.
// The tests also cover damaged files and worlds that were edited meanwhile.
#include <gmock/gmock.h>

#include "tests/support/child_process.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/core/explorer.h"
#include "tests/unit/core/route_walker.h"
#include "worlds/base/files.h"
#include "worlds/navigation/route_place.h"

namespace handrail {
namespace saved_routes_session_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// A copy of the house in a folder of its own, where additions are stored next to it.
struct House {
    House() { fs::copy_file(test::project_root() / "worlds/maps/house.map", path); }
    fs::path background() const { return path.string() + ".handrail.toml"; }
    test::TemporaryFolder folder;
    fs::path path = folder.path() / "house.map";
};

struct Person : test::AppSession {
    // If `background` is true, the rooms are searched for on a separate thread, as in a session with a window.
    explicit Person(const fs::path& world, bool background = false)
        : AppSession({}, {}, {.executor = background ? on_threads() : at_once()}) {
        app.apply(WorldEntered{make_ready(test::world_in(world)), SideFile::of_world(world, {})}, now);
        run(0.1);
    }
    bool go_to(const std::string& room) { return test::go_to_room(*this, room, 90.0); }
    // Chooses a saved route from the list.
    std::string way(const std::string& name) {
        request(Command::KeptRoutes);
        return line(name);
    }
    std::string way(const std::string& name, const std::string& act) {
        way(name);
        return line(act);
    }
    // Returns the entry of the open list that begins with `begin`, as name and value. The result is empty if there is
    // no such entry.
    std::string item(const std::string& begin) const {
        for (const ListItem& one : app.dialogue().view().items)
            if (one.name.starts_with(begin)) return one.name + ", " + one.value;
        return {};
    }
    std::string keep(const std::string& which, const std::string& name) {
        request(Command::KeepRoute);
        line(which);
        return line(name);
    }
};

TEST(KeptRoutes, from_a_planned_route_are_walked_stop_after_stop_after_a_restart) {
    const House house;
    {
        Person p(house.path);
        EXPECT_THAT(p.request(Command::KeptRoutes),
                    HasSubstr("You have not kept a route here yet. Control+8 keeps the route"));
        ASSERT_TRUE(p.go_to("Living room")) << p.app.feet_m().x << " " << p.app.feet_m().y;
        p.request(Command::Routes);
        p.line("Kitchen");  // This route is planned from the end of the previous route, so both are parts of one route.
        p.request(Command::KeepRoute);
        EXPECT_EQ(p.item("The route you planned last"), "The route you planned last, Hall, Living room, Kitchen");
        EXPECT_THAT(p.line("The route you planned last"),
                    HasSubstr("Hall to Kitchen. Type another name for this route, or press Enter to keep this one"));
        EXPECT_EQ(p.line("To the stove"), "Route To the stove kept");
    }
    const auto text = read_whole_file(house.background());
    ASSERT_TRUE(text);
    EXPECT_THAT(*text, HasSubstr("[[way.stop]]"));
    EXPECT_THAT(*text, HasSubstr("room = \"Living room\""));

    Person p(house.path);
    EXPECT_FALSE(p.heard("fit")) << p.said.back();
    p.request(Command::KeptRoutes);
    EXPECT_EQ(p.item("To the stove"), "To the stove, by way of Living room");
    p.line("To the stove");
    const std::string words = p.line("Hear it");
    EXPECT_THAT(words, StartsWith("To the stove. From Hall, "));
    EXPECT_THAT(words, HasSubstr(" To Living room. "));
    EXPECT_THAT(words, HasSubstr(" to Living room door, shut. Open it. "));
    EXPECT_THAT(words, HasSubstr(" To Kitchen. "));
    EXPECT_THAT(words, HasSubstr(" to Kitchen."));

    EXPECT_THAT(p.way("To the stove", "Follow it by ear"),
                StartsWith("To Living room. "));  // The first stop is left out, because the walker is already there.
    p.said.clear();
    ASSERT_TRUE(test::walk_along(
        p, [&] { return p.heard("Kitchen. You are there."); }, 120.0))
        << p.app.feet_m().x << " " << p.app.feet_m().y;
    EXPECT_TRUE(p.heard("Living room. You are there. To Kitchen. "));
    EXPECT_EQ(p.request(Command::WhereAmI).substr(0, 9), "Kitchen, ");
    p.request(Command::Routes);
    EXPECT_EQ(p.item("Stop following"), "");  // The route has ended.

    // Follows the route backwards, from its end to its beginning.
    EXPECT_THAT(p.way("To the stove", "Reverse the route"), HasSubstr("To the stove, backwards"));
    EXPECT_THAT(p.line("Follow it by ear"), StartsWith("To Living room. "));
    p.said.clear();
    ASSERT_TRUE(test::walk_along(
        p, [&] { return p.heard("Hall. You are there."); }, 120.0));
    EXPECT_TRUE(p.heard("Living room. You are there. To Hall. "));
}

TEST(KeptRoutes, are_listed_resumed_from_the_current_place_and_stopped_on_request) {
    const House house;
    Person p(house.path);
    p.request(Command::Routes);
    p.line("Living room");
    p.keep("The route you planned last", "There");
    p.way("There", "Add a stop");
    EXPECT_EQ(p.line("Kitchen"), "There now goes on to Kitchen.");
    // From the study, the session first leads the walker to the first stop.
    p.app.apply(Placed{{9.5, 3.0, 0.0}, 0.0}, p.now);
    p.run(0.1);
    EXPECT_THAT(p.way("There", "Follow it by ear"), StartsWith("To Hall. "));
    p.said.clear();
    ASSERT_TRUE(test::walk_along(
        p, [&] { return p.heard("Hall. You are there. To Living room."); }, 60.0));
    // The walker is placed far away from the route, and hears the route to the same stop.
    p.app.apply(Placed{{6.0, -4.0, 0.0}, 0.0}, p.now);
    p.said.clear();
    p.run(0.3);
    EXPECT_TRUE(p.heard("You have left the route."));
    EXPECT_TRUE(p.heard("To Living room. "));
    p.request(Command::Routes);
    EXPECT_THAT(p.line("Where the route continues"), HasSubstr("To Living room: "));
    EXPECT_EQ(p.request(Command::TakeMe), "You are no longer following a route.");
    p.said.clear();
    p.app.apply(Placed{{3.0, 3.5, 0.0}, 0.0}, p.now);
    p.run(0.5);
    EXPECT_FALSE(p.heard("You are there."));
}

TEST(KeptRoutes, from_the_trail_keep_its_corners_and_lead_along_them) {
    const House house;
    // A walk in the garden round the far side of the pond: south of the house to the west, and back. No planned route
    // would lead that way.
    const std::vector<Vec3> detour{{6.0, -2.0, 0.0}, {1.0, -2.0, 0.0}, {1.0, -4.0, 0.0}, {8.0, -4.0, 0.0}};
    {
        Person p(house.path);
        p.app.apply(Placed{detour[0], 0.0}, p.now);
        p.run(0.1);
        p.request(Command::DropMark);
        p.line("Gate");
        p.request(Command::KeepRoute);
        EXPECT_EQ(p.item("Everything"), "");  // The walker has not walked yet.
        EXPECT_THAT(p.line("Begin a route here"),
                    HasSubstr("A route begins here. Control+8 keeps what you walk from now on."));
        test::steer_along(p.app, detour, [&](double seconds) {
            p.run(seconds);
            return p.now;
        });
        ASSERT_LT(glm::length(p.app.feet_m() - detour.back()), 0.3);
        p.request(Command::KeepRoute);
        EXPECT_NE(p.item("Everything you walked here"), "");
        EXPECT_NE(p.item("What you walked since Gate"), "");
        p.line("What you walked since you began");
        EXPECT_EQ(p.line("Round"), "Route Round kept");
        EXPECT_EQ(p.keep("Everything", "round"),
                  "Another route is already called round.");  // Two routes cannot have the same name.
    }
    Person p(house.path);
    std::vector<Error> faults;
    const auto ways = read_saved_routes(SideFile::of_world(house.path, {}), faults);
    ASSERT_EQ(ways.size(), 1U);
    ASSERT_EQ(ways[0].stops.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_LT(glm::length(ways[0].stops[i].place_m - detour[i]), 0.5) << i;
        EXPECT_EQ(ways[0].stops[i].name.empty(), i == 1 || i == 2);
    }
    p.app.apply(Placed{detour[0], 0.0}, p.now);
    p.run(0.1);
    p.way("Round", "Follow it by ear");
    // The saved route follows the whole detour, including both corners.
    const std::vector<Vec3> way = p.app.guide().way_m();
    for (const Vec3& corner : detour) EXPECT_LT(nearest_on_path(way, corner).distance_m, 0.6);
    p.said.clear();
    double west_m = 1e9;
    ASSERT_TRUE(test::walk_along(
        p,
        [&] {
            west_m = std::min(west_m, p.app.feet_m().x);
            return p.heard("You are there.");
        },
        60.0));
    EXPECT_LT(west_m, 1.5);
    EXPECT_LT(glm::length(p.app.feet_m() - detour.back()), 1.2);
}

TEST(KeptRoutes, are_renamed_and_deleted_in_the_file_too) {
    const House house;
    {
        Person p(house.path);
        p.request(Command::Routes);
        p.line("Kitchen");
        p.keep("The route you planned last", "One");
        p.keep("The route you planned last", "Two");
        p.way("One", "Change the name");
        EXPECT_EQ(p.line("TWO"), "Another route is already called TWO.");
        p.way("One", "Change the name");
        EXPECT_EQ(p.line("Three"), "Three");
        EXPECT_EQ(p.way("Two", "Delete it"), "Route Two deleted");
        p.request(Command::KeepRoute);
        p.line("The route you planned last");
        p.app.apply(KeyTapped{"Escape"}, p.now);
        p.listen();
        EXPECT_EQ(p.said.back(), "The route was not kept.");
    }
    Person p(house.path);
    p.request(Command::KeptRoutes);
    EXPECT_EQ(p.app.dialogue().view().items.size(), 1U);
    EXPECT_NE(p.item("Three"), "");
}

TEST(KeptRoutes, that_are_damaged_are_set_aside_or_reported_with_their_line) {
    const House house;
    ASSERT_TRUE(write_file_atomically(house.background(), "[[way]]\nname = \"Half"));
    {
        Person p(house.path);
        EXPECT_TRUE(
            p.heard("is damaged in line 2. It has been saved as house.map.handrail.toml.damaged, and you start without "
                    "additions."));
        EXPECT_THAT(p.request(Command::KeptRoutes), HasSubstr("You have not kept a route here yet."));
        EXPECT_TRUE(fs::exists(house.background().string() + ".damaged"));
    }
    ASSERT_TRUE(write_file_atomically(house.background(), "[[way]]\nname = \"Alone\"\n[[way]]\n[[way]]\n"));
    Person p(house.path);
    EXPECT_TRUE(
        p.heard("house.map.handrail.toml, line 1: the route Alone needs 2 to 200 stops, each in a [[way.stop]] table. "
                "Add them, "
                "or delete the entry. "
                "2 more routes cannot be read."))
        << p.said[1];
    p.request(Command::Routes);
    p.line("Kitchen");
    p.keep("The route you planned last", "New");
    EXPECT_THAT(*read_whole_file(house.background()), HasSubstr("Alone"));
}

// ---- a world that was edited ----

// Returns the map of two rooms of 6 by 5 m with a gap of this many units between them, and a table in the eastern room.
std::string two_rooms(double gap_units, double table_x) {
    using test::box_brush;
    const double low = 80.0 - 0.5 * gap_units, high = 80.0 + 0.5 * gap_units;
    std::string text = test::entity("worldspawn", test::key("building", "1"),
                                    test::room_brushes(0, 0, 0, 400, 160, 96) + box_brush(196, 0, 0, 204, low, 96) +
                                        box_brush(196, high, 0, 204, 160, 96)) +
                       test::entity("info_player_start", test::key("origin", "40 80 24")) +
                       test::entity("info_player_coop", test::key("origin", "380 80 24")) +
                       test::entity("info_room", test::key("name", "Shop") + test::key("origin", "40 80 24"));
    if (table_x > 0.0)
        text +=
            test::entity("func_wall", test::key("name", "Table"), box_brush(table_x, 110, 0, table_x + 40, 130, 24));
    return text;
}

TEST(KeptRoutes, report_by_name_what_no_longer_fits_an_edited_world_on_entering_and_when_chosen) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "flat.map";
    const auto write = [&](const std::string& text) { ASSERT_TRUE(write_file_atomically(path, text)); };
    write(two_rooms(32.0, 300.0));
    {
        Person p(path);
        p.request(Command::Exits);
        p.request(Command::Find);
        p.line("Table");
        p.line("Take me there");
        ASSERT_EQ(p.keep("The route you planned last", "To lunch"), "Route To lunch kept");
    }
    // The world was edited, but the stops are the same.
    write(two_rooms(36.0, 300.0));
    {
        Person p(path);
        EXPECT_FALSE(p.heard("fit"));
    }
    const struct {
        double gap_units, table_x;
        const char* reported;
    } edits[] = {
        {36.0, 0.0, "To lunch (Table no longer exists)."},
        {36.0, 206.0, "To lunch (Table has moved and is now 2 steps from its stop)."},
        {0.0, 300.0, "To lunch (no walking route from Shop to Table)."},
    };
    for (const auto& edit : edits) {
        write(two_rooms(edit.gap_units, edit.table_x));
        Person p(path);
        EXPECT_TRUE(p.heard(std::string("This world has changed since you kept routes. 1 of 1 no longer fits: ") +
                            edit.reported))
            << testing::PrintToString(p.said);
        p.request(Command::KeptRoutes);
        EXPECT_EQ(p.item("To lunch"), "To lunch, may no longer fit");
        const std::string chosen = p.line("To lunch");
        const std::string faults(edit.reported + 10, std::strlen(edit.reported) - 12);
        EXPECT_THAT(chosen, HasSubstr("To lunch. This route does not fit this version of the world: " + faults));
        // The session follows the route as far as possible.
        const std::string words = p.line("Follow it by ear");
        EXPECT_THAT(words,
                    edit.gap_units == 0.0 ? HasSubstr("No walking route found to Table.") : HasSubstr("To Table. "));
    }
    // If a background task searches for the rooms, the check of the routes follows as soon as the rooms are known.
    {
        Person p(path, true);
        EXPECT_TRUE(test::eventually([&] {
            p.run(0.1);
            return p.heard("no longer fits: To lunch (no walking route from Shop to Table).");
        })) << testing::PrintToString(p.said);
    }
    // The person has accepted the new place. So nothing more is announced, and the route leads to the new place of the
    // table.
    write(two_rooms(36.0, 206.0));
    {
        Person p(path);
        EXPECT_EQ(p.way("To lunch", "Save it for this version of the world"), "Route To lunch kept");
    }
    Person p(path);
    EXPECT_FALSE(p.heard("fit"));
    p.way("To lunch", "Follow it by ear");
    p.said.clear();
    ASSERT_TRUE(test::walk_along(
        p, [&] { return p.heard("Table. You are there."); }, 60.0));
    EXPECT_LT(p.app.feet_m().x, 8.3);  // The table ends at x = 7.7 m.
}

TEST(KeptRoutes, follow_a_room_that_the_person_renames) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "flat.map";
    ASSERT_TRUE(write_file_atomically(path, two_rooms(32.0, 300.0)));
    {
        Person p(path);
        p.request(Command::Exits);
        p.request(Command::Find);
        p.line("Table");
        p.line("Take me there");
        p.keep("The route you planned last", "To lunch");
        p.request(Command::NameRoom);
        EXPECT_EQ(p.line("Counter"), "This room is now called Counter.");
    }
    ASSERT_TRUE(write_file_atomically(path, two_rooms(36.0, 300.0)));
    Person p(path);
    EXPECT_FALSE(p.heard("no longer fit")) << testing::PrintToString(p.said);
}

// ---- by the hand, and in German ----

// Saves a route, and guides the free hand along it from the base. Returns how many lines had been said before the
// guidance.
std::size_t kept_and_led(test::Explorer& p, const std::string& which) {
    p.tap(Command::KeepRoute);
    p.line(which);
    p.line("Tour");
    p.tap(Command::Home);
    p.hold({0.0, 0.0, 0.0});
    p.run(1.5);
    p.tap(Command::KeptRoutes);
    p.line("Tour");
    const std::size_t before = p.lines();
    p.line("Have your hand led along it");
    p.push();
    return before;
}

TEST(KeptRoutes, guide_the_hand_from_stop_to_stop) {
    test::Explorer p(test::our_world("house.map"), "sim-t");
    p.tap(Command::Exits);
    for (const char* thing : {"Coat stand", "Door mat"}) {
        p.tap(Command::Find);
        p.line(thing);
        p.line("Take me there");
        p.run(0.1);
        if (std::string(thing) == "Coat stand") {
            p.push();
            ASSERT_TRUE(p.wait_for([&] { return p.heard("Here: Coat stand"); }, 40.0)) << p.all_heard();
        }
    }
    p.tap(Command::TakeMe);  // ends the guidance of the hand
    const std::size_t before = kept_and_led(p, "The route you planned last");
    ASSERT_TRUE(p.wait_for([&] { return p.heard("Here: Door mat", before); }, 90.0)) << p.all_heard(before);
    EXPECT_LT(p.find("Taking your hand to Coat stand", before),
              p.find("Here: Coat stand. Taking your hand to Door mat", before))
        << p.all_heard(before);
    EXPECT_FALSE(p.heard("To Coat stand. ", before));
}

TEST(KeptRoutes, guide_the_hand_along_the_corners_of_a_trail) {
    test::Explorer p(test::our_world("house.map"), "sim-t");
    p.tap(Command::Exits);
    // The walker goes along the east of the hall and back to its west, 3 m from the start.
    test::steer_along(p.app(), {{6.9, 1.2, 0.0}, {6.9, 3.2, 0.0}, {5.1, 3.2, 0.0}}, [&](double seconds) {
        p.run(seconds);
        return p.now_s();
    });
    ASSERT_LT(glm::length(p.app().feet_m() - Vec3(5.1, 3.2, 0.0)), 0.4);
    const std::size_t before = kept_and_led(p, "Everything you walked here");
    double east_m = 0.0;
    ASSERT_TRUE(p.wait_for(
        [&] {
            east_m = std::max(east_m, p.tool().proxy_m.x);
            return p.heard("Here: Stairs", before);  // This place is at the end of the hall in the north-west.
        },
        90.0))
        << p.all_heard(before);
    EXPECT_GT(east_m, 6.5);
    EXPECT_LT(p.tool().proxy_m.x, 5.6);
}

TEST(KeptRoutes, are_saved_announced_and_followed_in_german) {
    const test::InLanguage german("de");
    const House house;
    Person p(house.path);
    EXPECT_EQ(p.request(Command::KeptRoutes),
              "Hier ist noch kein Weg aufgehoben. Strg+8 hebt den zuletzt geplanten oder gegangenen auf.");
    p.request(Command::Routes);
    p.line("Wohnzimmer");
    p.request(Command::KeepRoute);
    EXPECT_THAT(p.line("Der zuletzt geplante Weg"),
                HasSubstr("Flur bis Wohnzimmer. Anderen Namen für diesen Weg tippen oder Enter drücken"));
    EXPECT_EQ(p.line("Nach Hause"), "Weg Nach Hause aufgehoben");
    EXPECT_THAT(p.way("Nach Hause", "Anhören"), StartsWith("Nach Hause. Anfang: Flur, insgesamt "));
    EXPECT_THAT(p.way("Nach Hause", "Nach Gehör folgen"), StartsWith("Ziel: Wohnzimmer. "));
    EXPECT_EQ(p.way("Nach Hause", "Löschen"), "Weg Nach Hause gelöscht");
}

}  // namespace saved_routes_session_test
}  // namespace handrail
