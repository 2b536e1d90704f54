// Tests the list of marks and saved routes. Each test uses only plain state, without a session.
#include <gmock/gmock.h>

#include <optional>

#include "app/core/places/kept_routes.h"
#include "app/core/places/mark_list.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace places_features_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Returns a yard with a fountain, which its map marks as a landmark.
std::shared_ptr<const Scene> yard() {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    const FeatureId fountain = builder.box({5.0, 5.0, 0.0}, {6.0, 6.0, 1.5}, "fountain");
    builder.scene().features[fountain.value].landmark = true;
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

struct Place : test::PlainSession {
    Place() : PlainSession(yard()) {
        context.session_requests.save_additions = [this](double) {
            ++saved;
            return saves;
        };
        rooms.enter_world(as_read);
        rooms.tick(0.0);
    }
    // Types a line, or the name of an item of the open list. Returns the announcements.
    std::vector<std::string> line(const std::string& typed) {
        const DialogueReply reply = lists.dialogue.line(typed, context.tick_s);
        EXPECT_TRUE(reply.taken && !reply.denied) << typed << ": " << reply.words;
        return said();
    }
    std::vector<std::string> items() const {
        std::vector<std::string> names;
        for (const ListItem& item : lists.dialogue.view().items) names.push_back(item.name);
        return names;
    }
    int saved = 0;
    bool saves = true;
    Rooms rooms{context};
};

struct Marker : Place {
    Marker() { marks.enter_world(); }
    MarkList marks{context, world.marks};
};

TEST(MarkListFeature, sets_names_and_deletes_marks_and_saves_each_change) {
    Marker m;
    m.stand({1.0, 2.0, 0.0});
    EXPECT_TRUE(m.marks.act(Command::DropMark, 1.0));
    EXPECT_THAT(m.said(), ElementsAre(HasSubstr("Mark 1")));
    EXPECT_EQ(m.saved, 1);
    EXPECT_THAT(m.line("My place"), ElementsAre("My place"));
    EXPECT_EQ(m.saved, 2);
    ASSERT_EQ(m.world.marks.size(), 1U);
    EXPECT_EQ(m.world.marks[0].name, "My place");
    EXPECT_EQ(m.world.marks[0].place_m, m.avatar.feet_m());
    std::vector<Error> faults;
    EXPECT_EQ(read_marks(m.additions, faults).size(), 1U) << "they are among what is saved";

    EXPECT_TRUE(m.marks.act(Command::DeleteMark, 2.0));
    EXPECT_THAT(m.items(), ElementsAre("My place"));
    (void)m.said();
    EXPECT_THAT(m.line("enter"), ElementsAre("My place deleted"));
    EXPECT_EQ(m.saved, 3);
    EXPECT_THAT(m.world.marks, IsEmpty());
    EXPECT_THAT(read_marks(m.additions, faults), IsEmpty());
    EXPECT_TRUE(m.marks.act(Command::DeleteMark, 3.0));
    EXPECT_FALSE(m.lists.dialogue.is_open()) << "there is none to be deleted";
    EXPECT_FALSE(m.marks.act(Command::Find, 4.0)) << "another's command";
}

TEST(MarkListFeature, reports_each_mark_that_is_not_on_the_disk_as_unsaved) {
    Marker m;
    m.saves = false;
    EXPECT_TRUE(m.marks.act(Command::DropMark, 1.0));
    (void)m.said();
    EXPECT_THAT(m.line("My place"), ElementsAre("Not saved yet: My place"));
    EXPECT_TRUE(m.marks.act(Command::DeleteMark, 2.0));
    (void)m.said();
    EXPECT_THAT(m.line("enter"), ElementsAre("Not saved yet: My place deleted"));
}

TEST(MarkListFeature, sets_a_mark_at_the_hand_when_the_device_button_is_pressed) {
    Marker m;
    m.person.settings.marks.button = 2;
    m.hands.right.present = true;
    m.hands.tool.ticks = 1;
    m.hands.tool.waiting_for_hand = false;
    m.hands.tool.proxy_m = {3.0, 1.0, 1.0};
    m.marks.tick_button(0.0);
    EXPECT_THAT(m.world.marks, IsEmpty());
    m.hands.tool.buttons = 1U << 1;
    m.marks.tick_button(0.1);
    m.marks.tick_button(0.2);
    ASSERT_EQ(m.world.marks.size(), 1U) << "once while it is held";
    EXPECT_EQ(m.world.marks[0].place_m, m.hands.tool.proxy_m);
    EXPECT_FALSE(m.lists.dialogue.is_open()) << "a hand that presses a button does not type";
    m.marks.enter_world();
    m.marks.tick_button(0.3);
    EXPECT_EQ(m.world.marks.size(), 1U) << "it was held all the time";
    m.hands.tuning.workspace.grab_buttons = 1U << 1;
    m.hands.tool.buttons = 0;
    m.marks.tick_button(0.4);
    m.hands.tool.buttons = 1U << 1;
    m.marks.tick_button(0.5);
    EXPECT_EQ(m.world.marks.size(), 1U) << "that button grabs the world";
}

TEST(MarkListFeature, announces_a_mark_on_each_approach_but_not_on_entering) {
    Marker m;
    m.person.settings.marks.ask_name = false;
    (void)m.marks.act(Command::DropMark, 0.0);
    m.marks.enter_world();
    m.marks.tick(0.1);
    (void)m.said();
    m.marks.tick(0.2);
    EXPECT_THAT(m.said(), IsEmpty()) << "one stands at it since one came in";
    for (int time = 0; time < 2; ++time) {
        m.stand({4.0, 0.0, 0.0});
        m.marks.tick(1.0);
        EXPECT_THAT(m.said(), IsEmpty());
        m.stand({0.5, 0.0, 0.0});
        m.marks.tick(2.0);
        EXPECT_THAT(m.said(), ElementsAre(HasSubstr("Mark 1")));
        m.marks.tick(2.1);
        EXPECT_THAT(m.said(), IsEmpty()) << "told once";
    }
}

TEST(MarkListFeature, plays_a_landmark_sound_when_the_body_comes_near) {
    Marker m;
    m.marks.tick(0.0);
    EXPECT_EQ(m.heard(SoundKind::Landmark), 0U);
    m.stand({5.5, 4.0, 0.0});
    m.marks.tick(0.1);
    EXPECT_EQ(m.heard(SoundKind::Landmark), 1U);
    m.marks.tick(0.2);
    EXPECT_EQ(m.heard(SoundKind::Landmark), 0U);
    m.stand({0.0, 0.0, 0.0});
    m.marks.tick(0.3);
    m.hands.tuning.panic = true;
    m.stand({5.5, 4.0, 0.0});
    m.marks.tick(0.4);
    EXPECT_EQ(m.heard(SoundKind::Landmark), 0U) << "everything was stopped";
}

TEST(MarkListFeature, lists_the_marks_below_the_rows_of_other_features) {
    Marker m;
    int chosen = 0, adjusted = 0;
    std::optional<Goal> found;
    m.marks.rows_above = [&] {
        return std::vector<MarkList::Row>{
            {{"bell", "off"}, [&](double) { ++chosen; }},
            {{"help", "7", true}, [](double) {}, [&](int by) { return std::to_string(7 + (adjusted += by)); }}};
    };
    m.marks.on_find = [&](const Goal& mark, double) { found = mark; };
    m.person.settings.marks.ask_name = false;
    m.stand({2.0, 0.0, 0.0});
    (void)m.marks.act(Command::DropMark, 0.0);
    EXPECT_TRUE(m.marks.act(Command::Marks, 1.0));
    EXPECT_THAT(m.items(), ElementsAre("bell", "help", HasSubstr("Mark 1")));
    (void)m.line("enter");
    EXPECT_EQ(chosen, 1);
    EXPECT_FALSE(found);
    (void)m.marks.act(Command::Marks, 2.0);
    (void)m.line("down");
    EXPECT_EQ(m.lists.dialogue.line("right", 2.0).words, "8");
    (void)m.line("down");
    (void)m.line("enter");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->box_m.min_m, m.avatar.feet_m());
}

TEST(MarkListFeature, reports_invalid_marks_of_the_file_once) {
    const test::TemporaryFolder folder;
    const auto world = folder.write("yard.map", "a world");
    folder.write("yard.map.handrail.toml",
                 "[[mark]]\nname = \"Well\"\nplace_m = [1.0, 1.0, 0.0]\n\n[[mark]]\nname = \"Nowhere\"\n");
    Marker m;
    m.additions = SideFile::of_world(world, {});
    m.marks.enter_world();
    ASSERT_EQ(m.world.marks.size(), 1U);
    EXPECT_EQ(m.world.marks[0].name, "Well");
    m.marks.announce_faults(0.0);
    EXPECT_THAT(m.said(), ElementsAre(HasSubstr("the mark Nowhere needs place_m")));
    m.marks.announce_faults(0.1);
    EXPECT_THAT(m.said(), IsEmpty());
}

struct Keeper : Place {
    Keeper() { ways.enter_world(0.0); }
    // Walks 6 m east from the base and saves the route under `name`.
    void keep(const std::string& name) {
        for (double x = 0.0; x <= 6.0; x += 0.25) avatar.crumbs_m.emplace_back(x, 0.0, 0.0);
        stand({6.0, 0.0, 0.0});
        EXPECT_TRUE(ways.act(Command::KeepRoute, 1.0));
        EXPECT_THAT(items(), ElementsAre("Everything you walked here", "Begin a route here"));
        (void)line("Everything you walked here");
        EXPECT_THAT(line(name), ElementsAre("Route " + name + " kept"));
        avatar.crumbs_m.clear();
    }
    void choose(const std::string& way) {
        EXPECT_TRUE(ways.act(Command::KeptRoutes, 2.0));
        (void)said();
        (void)line(way);
    }
    PlannedStops planned{context, rooms};
    KeptRoutes ways{context, rooms, planned};
};

TEST(KeptRoutesFeature, save_a_walked_route_under_its_own_name) {
    Keeper k;
    EXPECT_TRUE(k.ways.act(Command::KeptRoutes, 0.0));
    EXPECT_THAT(k.said(), ElementsAre(HasSubstr("You have not kept a route here yet")));
    k.keep("To the east");
    EXPECT_EQ(k.saved, 1);
    std::vector<Error> faults;
    const std::vector<SavedRoute> kept = read_saved_routes(k.additions, faults);
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_LT(glm::length(kept[0].stops.back().place_m - Vec3(6.0, 0.0, 0.0)), 0.3);
    k.choose("To the east");
    (void)k.line("Change the name");
    EXPECT_THAT(k.line("East"), ElementsAre("East"));
    k.choose("East");
    EXPECT_THAT(k.line("Delete it"), ElementsAre("Route East deleted"));
    EXPECT_THAT(read_saved_routes(k.additions, faults), IsEmpty());
    EXPECT_EQ(k.saved, 3);
    EXPECT_FALSE(k.ways.act(Command::Routes, 3.0)) << "another's command";
}

TEST(KeptRoutesFeature, are_called_saved_only_if_they_are_on_the_disk) {
    Keeper k;
    k.keep("To the east");
    k.saves = false;
    for (const char* name : {"Change the name", "East"}) {
        k.choose(name == std::string("East") ? "Change the name" : "To the east");
        (void)k.line("Change the name");
        EXPECT_THAT(k.line(name), ElementsAre("Not saved yet: " + std::string(name)));
    }
    k.choose("East");
    EXPECT_THAT(k.line("Delete it"), ElementsAre("Not saved yet: Route East deleted"));
}

TEST(KeptRoutesFeature, pass_their_stops_to_the_wayfinding) {
    Keeper k;
    std::vector<Stop> gone;
    bool by_hand = false;
    k.ways.on_go = [&](const std::vector<Stop>& stops, bool hand, double) { gone = stops, by_hand = hand; };
    k.keep("East");
    k.choose("East");
    EXPECT_THAT(k.items(),
                ElementsAre("Hear it", "Follow it by ear", "Have your hand led along it", "Reverse the route",
                            "Add a stop at the end of the route", "Change the name", "Delete it"));
    (void)k.line("Follow it by ear");
    ASSERT_EQ(gone.size(), 2U);
    EXPECT_FALSE(by_hand);
    EXPECT_NEAR(gone.back().place_m.x, 6.0, 0.3);
    k.choose("East");
    (void)k.line("Reverse the route");
    (void)k.line("Have your hand led along it");
    EXPECT_TRUE(by_hand);
    EXPECT_NEAR(gone.back().place_m.x, 0.0, 0.3);
    k.choose("East");
    EXPECT_THAT(k.line("Hear it"), ElementsAre(AllOf(HasSubstr("East. From "), HasSubstr("in all."))));
}

TEST(KeptRoutesFeature, offer_to_save_a_planned_route_with_two_stops) {
    Keeper k;
    ASSERT_TRUE(k.rooms.known());
    k.planned.note({.name = "Fountain", .place_m = {5.5, 4.0, 0.0}, .thing = {}, .room = {}, .kept = {}}, {0, 0, 0});
    EXPECT_TRUE(k.ways.act(Command::KeepRoute, 1.0));
    EXPECT_THAT(k.items(), ElementsAre("The route you planned last", "Begin a route here"));
}

TEST(KeptRoutesFeature, follow_a_renamed_room_and_reload_what_another_session_wrote) {
    Keeper k;
    const Stop here{.name = "Door", .place_m = {0.0, 0.0, 0.0}, .thing = {}, .room = "Old yard", .kept = {}},
        there{.name = "Gate", .place_m = {4.0, 0.0, 0.0}, .thing = {}, .room = "Street", .kept = {}};
    write_saved_routes(k.additions, {{"Out", {here, there}, {}, {}}});
    k.ways.follow_room_name("old yard", "Court");
    std::vector<Error> faults;
    EXPECT_EQ(read_saved_routes(k.additions, faults)[0].stops[0].room, "Old yard") << "it knows nothing of them yet";
    k.ways.take_again();
    k.ways.follow_room_name("", "Nothing");
    k.ways.follow_room_name("old yard", "Court");
    EXPECT_EQ(read_saved_routes(k.additions, faults)[0].stops[0].room, "Court");
    EXPECT_EQ(read_saved_routes(k.additions, faults)[0].stops[1].room, "Street");
    EXPECT_EQ(k.saved, 0) << "who renames a room saves";
}

TEST(KeptRoutesFeature, report_which_routes_no_longer_fit_once_the_rooms_are_known) {
    Keeper k;
    const Stop here{.name = "Base", .place_m = {0.0, 0.0, 0.0}, .thing = {}, .room = {}, .kept = {}},
        there{.name = "Statue", .place_m = {4.0, 0.0, 0.0}, .thing = "statue", .room = {}, .kept = {}};
    write_saved_routes(k.additions, {{"To the statue", {here, there}, "0badf00d", {}}});
    k.ways.enter_world(0.0);
    EXPECT_TRUE(k.rooms.found()) << "a doubtful way is the reason to look for rooms";
    (void)k.said();
    k.ways.announce_unfit(1.0);
    EXPECT_THAT(k.said(), ElementsAre(AllOf(HasSubstr("1 of 1 no longer fits"), HasSubstr("Statue no longer exists"))));
    k.choose("To the statue");
    EXPECT_THAT(k.line("Save it for this version of the world"), ElementsAre("Route To the statue kept"));
    k.ways.announce_unfit(3.0);
    EXPECT_THAT(k.said(), IsEmpty());
}

}  // namespace places_features_test
}  // namespace handrail
