// Tests wayfinding: stops, routes by ear and by hand, beacon and "warmer", and the guide that combines them. The tests
// use only plain state, without a session.
#include <gmock/gmock.h>

#include "app/core/wayfinding/guide.h"
#include "app/core/wayfinding/whole_route_words.h"
#include "tests/support/box_scene.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/features/plain_session.h"

namespace handrail {
namespace wayfinding_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Returns a yard. A wall crosses it and ends 6 m east of the base. A bench is 4 m north of the base, behind the wall; a
// well is 4 m south of the base.
std::shared_ptr<const Scene> yard() {
    test::SceneBuilder builder;
    builder.box({-10.0, -10.0, -0.5}, {10.0, 10.0, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    builder.box({-10.0, 2.0, 0.0}, {6.0, 2.2, 3.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({-0.5, 4.0, 0.0}, {0.5, 4.6, 0.8}, "bench");
    builder.box({-0.5, -5.0, 0.0}, {0.5, -4.0, 1.2}, "well");
    builder.start({0.0, 0.0, 0.0}, 0.0);
    return builder.share();
}

struct Yard : test::PlainSession {
    Yard() : PlainSession(yard()) {
        rooms.enter_world(as_read);
        rooms.tick(0.0);
    }

    Goal goal(const std::string& name) const {
        for (const Goal& one : goals(context))
            if (one.name == name) return one;
        ADD_FAILURE() << "no " << name;
        return {};
    }
    // Adds a device that may exert force. Its proxy is at `at_m`.
    void give_hand(const Vec3& at_m) {
        hands.right.present = true;
        hands.right.spec.workspace_radius_m = 0.1;
        hands.tuning.forces_on = true;
        hands.tuning.focused = true;
        hands.tuning.touch.radius_m = 0.02;
        hands.tool.ticks = 1;
        hands.tool.waiting_for_hand = false;
        hands.tool.proxy_m = hands.tool.hip_m = at_m;
    }
    void felt(const GuidancePath& path, GuidancePhase phase) {
        hands.tool.guidance.number = path.number;
        hands.tool.guidance.phase = phase;
    }

    Rooms rooms{context};
    Doors doors{context, world, avatar};
};

struct Plans : Yard {
    RoutePlans plans{context, rooms};
};

Stop stop(const std::string& name, const Vec3& place_m) {
    Stop one;
    one.name = name;
    one.place_m = place_m;
    return one;
}

// ---- stops ----

TEST(Wayfinding, offers_all_named_things_and_marks_with_the_nearest_first) {
    Yard plain;
    Mark mark;
    mark.name = "Puddle";
    mark.place_m = {0.0, 1.0, 0.0};
    plain.world.marks.push_back(mark);
    std::vector<std::string> names;
    for (const Goal& goal : goals(plain.context)) names.push_back(goal.name);
    EXPECT_THAT(names, Contains("Bench"));
    ASSERT_FALSE(names.empty());
    EXPECT_EQ(names.front(), "Puddle");
    plain.stand({0.0, 3.5, 0.0});
    EXPECT_EQ(goals(plain.context).front().name, "Bench");
}

TEST(Wayfinding, plans_a_route_of_stops_with_each_leg_starting_where_the_previous_one_ended) {
    Yard plain;
    ASSERT_TRUE(plain.rooms.known());
    PlannedStops planned(plain.context, plain.rooms);
    const Stop bench = stop_at_goal(plain.context, plain.rooms, plain.goal("Bench"), {0.0, 0.0, 0.0}),
               well = stop_at_goal(plain.context, plain.rooms, plain.goal("Well"), bench.place_m);
    EXPECT_EQ(bench.thing, "bench");
    EXPECT_LT(bench.thing_m, 1.0);
    planned.note(bench, {0.0, 0.0, 0.0});
    ASSERT_EQ(planned.stops().size(), 2U);
    EXPECT_TRUE(near_stop(planned.stops().front(), {0.0, 0.0, 0.0}, 0.5));
    planned.note(bench, bench.place_m);
    EXPECT_EQ(planned.stops().size(), 2U) << "one is on the way there already";
    planned.note(well, bench.place_m);
    ASSERT_EQ(planned.stops().size(), 3U);
    EXPECT_EQ(planned.stops().back().name, "Well");
    planned.note(bench, {-8.0, -8.0, 0.0});
    ASSERT_EQ(planned.stops().size(), 2U) << "from elsewhere: another way";
    EXPECT_TRUE(near_stop(planned.stops().front(), {-8.0, -8.0, 0.0}, 0.5));
}

TEST(Wayfinding, finds_a_moved_thing_of_a_stop_at_its_current_place) {
    Yard plain;
    Stop at = stop("Sit", {0.0, 3.7, 0.0});
    EXPECT_FALSE(goal_of(plain.context, at).feature);
    at.thing = "bench";
    EXPECT_EQ(goal_of(plain.context, at).feature, plain.goal("Bench").feature);
    EXPECT_EQ(goal_of(plain.context, at).name, "Sit");
}

TEST(Wayfinding, describes_a_whole_route_with_its_stops) {
    Yard plain;
    ASSERT_TRUE(plain.rooms.known());
    const std::vector<Stop> stops{stop("Here", {0.0, 0.0, 0.0}), stop("", {8.0, 1.0, 0.0}),
                                  stop("There", {8.0, 6.0, 0.0}), stop("End", {0.0, 8.0, 0.0})};
    const std::string words = whole_route_words(plain.context, plain.rooms, "Round", stops);
    EXPECT_THAT(words, HasSubstr("Round"));
    EXPECT_LT(words.find("There"), words.find("End"));
    EXPECT_THAT(words, Not(HasSubstr("not reached")));
    plain.person.settings.walk.step_length_m *= 0.5;
    EXPECT_NE(whole_route_words(plain.context, plain.rooms, "Round", stops), words) << "told in steps";
}

// ---- planned routes ----

TEST(Wayfinding, follows_the_stops_of_a_saved_route_and_passes_unnamed_ones) {
    Plans plain;
    ASSERT_TRUE(plain.rooms.known());
    RoutePlans& plans = plain.plans;
    EXPECT_FALSE(plans.next());
    plans.begin({stop("Here", {0.0, 0.0, 0.0}), stop("", {8.0, 1.0, 0.0}), stop("There", {8.0, 6.0, 0.0}),
                 stop("End", {0.0, 8.0, 0.0})},
                true, false);
    EXPECT_TRUE(plans.runs_to("There"));
    const Route route = plans.on({0.0, 0.0, 0.0});
    ASSERT_TRUE(route.reaches);
    EXPECT_GT(route.length_m, 8.0 + 4.9) << "by way of the stop without a name";
    plans.pass(9.0);
    EXPECT_LT(plans.looked_at({0.0, 0.0, 0.0}).length_m, route.length_m) << "past it, the nearest way counts";
    ASSERT_TRUE(plans.next());
    EXPECT_TRUE(plans.runs_to("End"));
    EXPECT_FALSE(plans.next()) << "there";
    EXPECT_FALSE(plans.running());
}

TEST(Wayfinding, guides_a_hand_straight_or_around_obstacles) {
    Plans plain;
    plain.give_hand({0.0, 0.0, 1.0});
    const HandRoute straight = plain.plans.for_hand(plain.goal("Well"), GuidancePath::kMostPoints);
    EXPECT_EQ(straight.points_m.size(), 2U);
    EXPECT_EQ(plain.plans.changes(), 0U) << "no walk was planned";
    const HandRoute round = plain.plans.for_hand(plain.goal("Bench"), GuidancePath::kMostPoints);
    EXPECT_TRUE(round.reaches);
    EXPECT_GT(round.points_m.size(), 2U);
    double east_m = -1e9;
    for (const Vec3& point : round.points_m) east_m = std::max(east_m, point.x);
    EXPECT_GT(east_m, 6.0) << "round the end of the wall";
    EXPECT_EQ(plain.plans.changes(), 1U);
    EXPECT_FALSE(plain.plans.last_m().empty());
    plain.plans.enter_world();
    EXPECT_TRUE(plain.plans.last_m().empty());
}

// ---- guidance by ear ----

TEST(Wayfinding, describes_a_route_and_then_each_of_its_steps_by_ear) {
    Plans plain;
    ASSERT_TRUE(plain.rooms.known());
    DirectionsGround ground(plain.context, plain.rooms);
    SpokenRoute ear(plain.context, plain.rooms, plain.plans, ground);
    ear.announce_onward(0.0);
    const std::vector<std::string> none = plain.said();
    ear.follow_to({0.0, 8.0, 0.0}, "Fence", "Well then.", 0.0);
    ASSERT_TRUE(ear.following());
    EXPECT_THAT(plain.said(), ElementsAre(testing::AllOf(testing::StartsWith("Well then. "), HasSubstr("Fence"))));
    EXPECT_EQ(ear.name(), "Fence");
    // The first ticks prepare the ground and plan on it.
    for (int i = 0; i < 3; ++i) {
        ground.tick();
        EXPECT_FALSE(ear.tick(0.0).arrived);
    }
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("steps in all")));
    ear.announce_leg(0.0);
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("steps")));
    bool arrived = false;
    const std::vector<Vec3> way = plain.plans.last_m();
    for (std::size_t i = 1; i < way.size(); ++i)
        for (int step = 1; step <= 20; ++step) {
            plain.stand(way[i - 1] + (way[i] - way[i - 1]) * (step / 20.0));
            const RouteFollower::Said said = ear.tick(0.0);
            EXPECT_FALSE(said.left);
            arrived |= said.arrived;
        }
    EXPECT_TRUE(arrived);
    EXPECT_FALSE(ear.following());
    ear.announce_onward(0.0);
    EXPECT_EQ(plain.said(), none);
    ear.follow_to({0.0, -8.0, 0.0}, "Hedge", {}, 0.0);
    EXPECT_FALSE(ear.tick(0.0).left);
    plain.stand({-9.0, 9.0, 0.0});
    EXPECT_TRUE(ear.tick(0.0).left);
}

TEST(Wayfinding, has_not_arrived_by_ear_while_a_wall_is_in_between) {
    Plans plain;
    ASSERT_TRUE(plain.rooms.known());
    DirectionsGround ground(plain.context, plain.rooms);
    SpokenRoute ear(plain.context, plain.rooms, plain.plans, ground);
    const Vec3 behind_m(0.0, 2.47, 0.0), before_m(0.0, 1.73, 0.0);
    ear.follow_to(behind_m, "Behind", {}, 0.0);
    ASSERT_TRUE(ear.following());
    ASSERT_LT(glm::length(behind_m - before_m), kThere_m);
    plain.stand(before_m);
    EXPECT_FALSE(ear.tick(0.0).arrived);
    plain.stand(behind_m + Vec3(0.5, 0.0, 0.0));
    EXPECT_TRUE(ear.tick(0.0).arrived);
}

// Returns two rooms with a doorway between them.
std::shared_ptr<const Scene> two_rooms() {
    test::SceneBuilder builder;
    builder.box({0.0, 0.0, -0.5}, {6.0, 12.0, 0.0}, "floor", SolidRole::Solid, {}, FeatureKind::Floor);
    builder.box({0.0, 5.9, 0.0}, {2.5, 6.1, 3.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({3.5, 5.9, 0.0}, {6.0, 6.1, 3.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({2.5, 5.9, 2.1}, {3.5, 6.1, 3.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({-0.2, -0.2, 0.0}, {0.0, 12.2, 3.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({6.0, -0.2, 0.0}, {6.2, 12.2, 3.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({-0.2, -0.2, 0.0}, {6.2, 0.0, 3.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.box({-0.2, 12.0, 0.0}, {6.2, 12.2, 3.0}, "wall", SolidRole::Solid, {}, FeatureKind::Wall);
    builder.scene().room_names = {RoomName{Vec3(3, 2, 0), "Study"}, RoomName{Vec3(3, 10, 0), "Kitchen"}};
    builder.start({3.0, 2.0, 0.0}, 0.0);
    return builder.share();
}

// DirectionsGround plans routes for announced directions on a grid that is coarser than the walker. In a plan, the
// walker may slide past an obstacle that stops the real walker.
TEST(Wayfinding, does_not_repeat_a_leg_on_which_the_body_was_just_stopped) {
    test::PlainSession plain(two_rooms());
    Rooms rooms{plain.context};
    rooms.enter_world(plain.as_read);
    rooms.tick(0.0);
    ASSERT_TRUE(rooms.known());
    const std::uint32_t kitchen = room_at(rooms.graph(), rooms.space(), {3.0, 10.0, 0.0});
    ASSERT_NE(kitchen, kNothing);
    DirectionsGround ground(plain.context, rooms);
    RouteDirections word(plain.context, rooms, ground);
    // The first ticks prepare the ground; the next one plans a route on it.
    const auto plan = [&] {
        for (int i = 0; i < 3 && word.state() == RouteDirections::State::Planned; ++i) {
            ground.tick();
            (void)word.tick();
        }
    };
    for (const bool walked_on : {true, false}) {
        plain.stand({3.0, 2.0, 0.0});
        word.begin({kitchen, rooms.graph().rooms[kitchen].middle_m}, "Kitchen");
        plan();
        ASSERT_EQ(word.state(), RouteDirections::State::Known);
        const std::string leg = word.leg();
        ASSERT_THAT(leg, HasSubstr("steps"));
        plain.avatar.heading_rad = plain.avatar.heading_goal_rad = word.heading_rad().value();
        word.note_stop(kNoFeature);
        if (walked_on) plain.stand({3.0, 2.7, 0.0});
        (void)word.leg();
        plan();
        EXPECT_EQ(word.leg().empty(), !walked_on);
        EXPECT_EQ(word.at_work(), walked_on);
    }
}

// ---- guidance by the hand ----

struct Hand : Plans {
    Hand() {
        give_hand({0.0, 0.0, 1.0});
        goal = Yard::goal("Well");
        way = plans.for_hand(*goal, GuidancePath::kMostPoints);
    }
    // Starts an active pull, which the servo renders.
    void pull(double now_s) {
        hand.pull(way, 1.0, "Taking you.", now_s);
        hand.tick(goal, now_s + 1.1);
        felt(hand.path(), GuidancePhase::Acts);
        (void)said();
    }

    std::optional<Goal> goal;
    HandRoute way;
    HandLead hand{context, rooms, plans, doors};
};

TEST(Wayfinding, starts_to_pull_a_hand_a_second_after_the_announcement) {
    Hand plain;
    EXPECT_TRUE(plain.hand.may_lead());
    plain.hands.keys_alone = true;
    EXPECT_FALSE(plain.hand.may_lead());
    plain.hands.keys_alone = false;
    plain.hand.pull(plain.way, 0.6, "Taking you.", 0.0);
    EXPECT_THAT(plain.said(), ElementsAre("Taking you."));
    EXPECT_TRUE(plain.hand.at_work());
    plain.hand.tick(plain.goal, 0.9);
    EXPECT_EQ(plain.hand.path().number, 0U);
    plain.hand.tick(plain.goal, 1.1);
    EXPECT_EQ(plain.hand.path().number, 1U);
    EXPECT_EQ(plain.hand.path().kind, GuidanceKind::Pull);
    EXPECT_EQ(plain.hand.path().strength, 0.6);
    plain.hand.end();
    EXPECT_EQ(plain.hand.path().number, 0U);
    EXPECT_FALSE(plain.hand.at_work());
}

TEST(Wayfinding, numbers_its_servo_messages_continuously_across_worlds) {
    Hand plain;
    plain.pull(0.0);
    const std::uint32_t before = plain.hand.path().number;
    plain.hand.enter_world();
    EXPECT_EQ(plain.hand.path().number, 0U);
    plain.pull(10.0);
    EXPECT_EQ(plain.hand.path().number, before + 1);
}

TEST(Wayfinding, reports_how_guidance_has_ended) {
    Hand plain;
    plain.pull(0.0);
    EXPECT_FALSE(plain.hand.tick(plain.goal, 1.2));
    EXPECT_TRUE(plain.hand.at_work());
    plain.felt(plain.hand.path(), GuidancePhase::Arrived);
    const auto arrival = plain.hand.tick(plain.goal, 1.3);
    ASSERT_TRUE(arrival);
    EXPECT_TRUE(arrival->by_pull);
    EXPECT_FALSE(arrival->to_nearest);
    EXPECT_THAT(plain.said(), IsEmpty()) << "what follows is for others to say";
    plain.pull(10.0);
    plain.felt(plain.hand.path(), GuidancePhase::LetGo);
    EXPECT_FALSE(plain.hand.tick(plain.goal, 12.0));
    EXPECT_EQ(plain.said().size(), 1U);
    EXPECT_FALSE(plain.hand.at_work());
}

TEST(Wayfinding, replans_for_a_walker_who_left_the_route_once_everything_is_at_rest) {
    Hand plain;
    plain.pull(0.0);
    EXPECT_FALSE(plain.hand.wants_new_path(plain.goal, 1.2));
    plain.stand({1.0, 0.0, 0.0});
    EXPECT_FALSE(plain.hand.wants_new_path(plain.goal, 1.3));
    plain.felt(plain.hand.path(), GuidancePhase::LetGo);
    EXPECT_FALSE(plain.hand.tick(plain.goal, 1.3));
    EXPECT_THAT(plain.said(), IsEmpty()) << "nobody held against it";
    EXPECT_TRUE(plain.hand.at_work());
    EXPECT_FALSE(plain.hand.wants_new_path(plain.goal, 1.5));
    EXPECT_TRUE(plain.hand.wants_new_path(plain.goal, 1.7));
}

TEST(Wayfinding, moves_the_workspace_on_if_the_path_leads_out_of_reach) {
    Hand plain;
    plain.pull(0.0);
    EXPECT_EQ(plain.hand.carry(), Vec3(0.0));
    plain.hands.tool.hand_m = {0.0, -0.09, 0.0};  // The well is south of the hand.
    EXPECT_LT(plain.hand.carry().y, 0.0);
    EXPECT_TRUE(plain.hand.take_carried());
    plain.hands.tool.hand_m = Vec3(0.0);
    EXPECT_EQ(plain.hand.carry(), Vec3(0.0));
    EXPECT_TRUE(plain.hand.take_carried()) << "it had until now";
    EXPECT_FALSE(plain.hand.take_carried());
}

TEST(Wayfinding, lays_grooves_along_the_last_path_while_nothing_else_acts) {
    Hand plain;
    plain.hand.tick(plain.goal, 0.0);
    EXPECT_EQ(plain.hand.path().number, 0U) << "not wished for";
    plain.person.settings.guidance.grooves = true;
    plain.plans.know({{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
    plain.hand.tick(plain.goal, 0.1);
    const std::uint32_t first = plain.hand.path().number;
    EXPECT_GT(first, 0U);
    EXPECT_EQ(plain.hand.path().kind, GuidanceKind::Grooves);
    plain.felt(plain.hand.path(), GuidancePhase::Acts);
    plain.hand.tick(plain.goal, 0.2);
    EXPECT_EQ(plain.hand.path().number, first) << "they lie";
    plain.plans.know({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
    plain.hand.tick(plain.goal, 0.3);
    EXPECT_EQ(plain.hand.path().number, first + 1) << "another way";
    plain.hands.tuning.panic = true;
    plain.hand.tick(plain.goal, 0.4);
    EXPECT_EQ(plain.hand.path().number, 0U);
}

// ---- guidance by sounds ----

TEST(Wayfinding, calls_from_a_thing_until_the_walker_arrives) {
    Plans plain;
    Seek seek(plain.context, plain.rooms, plain.plans, plain.doors);
    EXPECT_FALSE(seek.tick_beacon(0.0));
    seek.start_beacon(plain.goal("Bench"));
    EXPECT_THAT(seek.beacon_words(0.0), Not(IsEmpty())) << "round the wall";
    plain.cues.take();
    EXPECT_FALSE(seek.tick_beacon(1.0));
    EXPECT_THAT(plain.cues.take(), Not(IsEmpty()));
    EXPECT_TRUE(seek.beacon_along().planned_in);
    plain.stand({0.0, 3.5, 0.0});
    bool there = false;
    for (int tick = 0; tick < 60 && !there; ++tick) there = seek.tick_beacon(2.0 + 0.1 * tick);
    EXPECT_TRUE(there);
    EXPECT_FALSE(seek.beacon().on());
    EXPECT_FALSE(seek.tick_beacon(9.0));
}

TEST(Wayfinding, reports_the_target_of_warmer_as_found_only_on_its_side_of_a_wall) {
    Plans plain;
    Seek seek(plain.context, plain.rooms, plain.plans, plain.doors);
    Goal bell{"Bell", point_box({0.0, 2.5, 1.0}), kNoFeature};
    plain.stand({0.0, 1.6, 0.0});
    seek.start_warmer(bell);
    (void)seek.warmer_words(0.0);
    for (int tick = 0; tick < 40; ++tick) EXPECT_FALSE(seek.tick_warmer(0.1 * tick));
    EXPECT_TRUE(seek.warmer().on()) << "0.9 m away, beyond the wall";
    plain.stand({0.0, 3.2, 0.0});
    int found = 0;
    for (int tick = 40; tick < 80; ++tick) found += seek.tick_warmer(0.1 * tick) ? 1 : 0;
    EXPECT_FALSE(seek.warmer().on());
    EXPECT_EQ(found, 1);
}

// ---- the guide that combines them ----

struct Guided : Yard {
    // Walks along the last planned route. Returns the announcements on it.
    std::vector<std::string> walk() {
        std::vector<std::string> heard;
        const std::vector<Vec3> way = guide.way_m();
        for (std::size_t i = 1; i < way.size(); ++i)
            for (int step = 1; step <= 40 && guide.way_m() == way; ++step) {
                stand(way[i - 1] + (way[i] - way[i - 1]) * (step / 40.0));
                guide.follow(now_s += 0.1);
                for (std::string& one : said()) heard.push_back(std::move(one));
            }
        return heard;
    }

    Guide guide{context, rooms, doors};
    double now_s = 0.0;
};

TEST(Wayfinding, chooses_a_target_and_forgets_it_in_another_world) {
    Guided plain;
    EXPECT_FALSE(plain.guide.act(Command::Use, 0.0)) << "another's command";
    EXPECT_TRUE(plain.guide.act(Command::TakeMe, 0.0));
    ASSERT_TRUE(plain.lists.dialogue.is_open()) << "of all that has a name";
    const auto items = plain.lists.dialogue.view().items;
    const auto well =
        std::find_if(items.begin(), items.end(), [](const ListItem& item) { return item.name == "Well"; });
    ASSERT_NE(well, items.end());
    plain.lists.dialogue.line(std::to_string(well - items.begin() + 1), 0.0);
    ASSERT_TRUE(plain.guide.goal());
    EXPECT_EQ(plain.guide.goal()->name, "Well");
    plain.guide.enter_world();
    EXPECT_FALSE(plain.guide.goal());
    EXPECT_TRUE(plain.guide.planned().stops().empty());
}

TEST(Wayfinding, sets_and_mutes_the_beacon_on_the_thing_ahead) {
    Guided plain;
    plain.avatar.heading_rad = plain.avatar.heading_goal_rad = kPi;
    EXPECT_TRUE(plain.guide.act(Command::SetBeacon, 0.0));
    EXPECT_TRUE(plain.guide.beacon().on());
    EXPECT_EQ(plain.guide.beacon().name(), "Well");
    plain.guide.act(Command::MuteBeacon, 0.0);
    EXPECT_FALSE(plain.guide.beacon().on());
    plain.guide.act(Command::MuteBeacon, 0.0);
    EXPECT_TRUE(plain.guide.beacon().on()) << "to the same thing again";
}

TEST(Wayfinding, guides_along_a_saved_route_by_ear_from_stop_to_stop) {
    Guided plain;
    ASSERT_TRUE(plain.rooms.known());
    plain.guide.go_along(
        {stop("Gate", {0.0, 0.0, 0.0}), stop("Corner", {8.0, 0.0, 0.0}), stop("Shed", {8.0, 7.0, 0.0})}, false, 0.0);
    EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("Corner"))) << "one is at the first stop";
    EXPECT_THAT(plain.walk(), Contains(HasSubstr("Shed"))) << "on from the second";
    const std::vector<std::string> last = plain.walk();
    ASSERT_FALSE(last.empty());
    EXPECT_THAT(last.back(), HasSubstr("Shed"));
    EXPECT_THAT(plain.walk(), IsEmpty()) << "there";
}

TEST(Wayfinding, says_where_a_thing_is_on_choosing_its_item_and_on_request) {
    for (const char* language : {"en", "de"}) {
        const test::InLanguage spoken(language);
        for (const std::string& typed : {phrase("guide.where_is_it"), phrase("guide.where_is_it_question")}) {
            Guided plain;
            plain.guide.open_tools(plain.goal("Bench"), 0.0);
            plain.said();
            plain.lists.dialogue.line(typed, 0.0);
            EXPECT_THAT(plain.said(), Contains(HasSubstr("Bench"))) << typed;
        }
    }
}

TEST(Wayfinding, guides_by_ear_if_force_is_not_permitted) {
    Guided plain;
    plain.give_hand({0.0, 0.0, 1.0});
    plain.hands.tuning.forces_on = false;
    plain.guide.open_tools(plain.goal("Bench"), 0.0);
    plain.said();
    plain.lists.dialogue.line("2", 0.0);  // chooses "take me there" from the list
    EXPECT_EQ(plain.guide.path().number, 0U);
    EXPECT_THAT(plain.said(), Contains(HasSubstr("Bench")));
    EXPECT_FALSE(plain.guide.way_m().empty());
    EXPECT_EQ(plain.guide.planned().stops().size(), 2U);
    plain.hands.tuning.forces_on = true;
    EXPECT_TRUE(plain.guide.act(Command::TakeMe, 1.0));
    plain.guide.lead(2.5);
    EXPECT_GT(plain.guide.path().number, 0U) << "and by the hand where it may";
}

// ---- events that the guide reports ----

// Returns the reported events as text, such as "led Bench by 1": what happened, the destination, and the LedBy value.
std::vector<std::string> facts(Yard& plain) {
    const auto fact = [](const char* what, const std::string& name, LedBy by) {
        return fmt::format("{} {} by {}", what, name, static_cast<int>(by));
    };
    std::vector<std::string> reported;
    for (const SessionEvent& event : plain.events.take()) {
        if (const auto* led = std::get_if<Led>(&event.what)) reported.push_back(fact("led", led->goal, led->by));
        if (const auto* left = std::get_if<LeftRoute>(&event.what))
            reported.push_back(fact("left", left->goal, left->by));
        if (const auto* stop = std::get_if<StopPassed>(&event.what))
            reported.push_back(fact("passed", stop->stop, stop->by));
        if (const auto* there = std::get_if<Arrived>(&event.what))
            reported.push_back(fact(there->to_nearest ? "near" : "arrived", there->goal, there->by));
    }
    return reported;
}

TEST(Wayfinding, reports_passed_stops_and_the_end_as_events) {
    Guided plain;
    ASSERT_TRUE(plain.rooms.known());
    plain.guide.go_along(
        {stop("Gate", {0.0, 0.0, 0.0}), stop("Corner", {8.0, 0.0, 0.0}), stop("Shed", {8.0, 7.0, 0.0})}, false, 0.0);
    EXPECT_THAT(facts(plain), ElementsAre("led Corner by 2"));
    plain.walk();
    EXPECT_THAT(facts(plain), ElementsAre("passed Corner by 2", "led Shed by 2"));
    plain.walk();
    EXPECT_THAT(facts(plain), ElementsAre("arrived Shed by 2"));
    plain.walk();
    EXPECT_THAT(facts(plain), IsEmpty()) << "once";
}

// A lesson may lead to a single stop. The stop may be nearer than the distance within which a stop has been passed.
TEST(Wayfinding, guides_to_the_only_stop_of_a_route_even_if_it_is_near) {
    for (const double away_m : {0.0, 0.2, 1.0, 1.4}) {
        Guided plain;
        ASSERT_TRUE(plain.rooms.known());
        plain.guide.go_along({stop("Gate", {away_m, 0.0, 0.0})}, false, 0.0);
        EXPECT_THAT(plain.said(), ElementsAre(HasSubstr("Gate"))) << away_m;
        EXPECT_THAT(facts(plain), ElementsAre("led Gate by 2")) << away_m;
        plain.guide.follow(0.1);
        plain.walk();
        EXPECT_THAT(facts(plain), ElementsAre("arrived Gate by 2")) << away_m;

        Guided held;
        held.give_hand({0.0, 0.0, 1.0});
        held.guide.go_along({stop("Gate", {away_m, 0.0, 0.0})}, true, 0.0);
        EXPECT_THAT(facts(held), ElementsAre("led Gate by 0")) << away_m;
        held.guide.lead(1.1);
        held.felt(held.guide.path(), GuidancePhase::Arrived);
        held.guide.lead(1.2);
        EXPECT_THAT(facts(held), ElementsAre("arrived Gate by 0")) << away_m;
    }
}

TEST(Wayfinding, reports_leaving_the_route_as_an_event) {
    Guided plain;
    ASSERT_TRUE(plain.rooms.known());
    plain.guide.go_along({stop("Gate", {0.0, 0.0, 0.0}), stop("Shed", {8.0, 7.0, 0.0})}, false, 0.0);
    (void)facts(plain);
    plain.stand({-9.0, -9.0, 0.0});
    plain.guide.follow(1.0);
    EXPECT_THAT(facts(plain), ElementsAre("left Shed by 2", "led Shed by 2"));
}

TEST(Wayfinding, reports_guidance_of_a_hand_as_events) {
    Guided plain;
    plain.give_hand({0.0, 0.0, 1.0});
    plain.guide.open_tools(plain.goal("Well"), 0.0);
    EXPECT_TRUE(plain.guide.act(Command::TakeMe, 0.0));
    EXPECT_THAT(facts(plain), ElementsAre("led Well by 0"));
    plain.guide.lead(1.1);
    plain.felt(plain.guide.path(), GuidancePhase::LetGo);
    plain.stand({1.0, 0.0, 0.0});
    plain.guide.lead(1.2);
    plain.guide.lead(1.6);
    EXPECT_THAT(facts(plain), ElementsAre("left Well by 0", "led Well by 0")) << "by who walked off";
    plain.guide.lead(2.7);
    plain.felt(plain.guide.path(), GuidancePhase::Arrived);
    plain.guide.lead(2.8);
    EXPECT_THAT(facts(plain), ElementsAre("arrived Well by 0"));
    plain.lists.dialogue.line("4", 3.0);  // chooses the fourth way of guidance from the list
    plain.guide.lead(4.1);
    EXPECT_THAT(facts(plain), ElementsAre("led Well by 1"));
}

TEST(Wayfinding, reports_a_beacon_as_an_event) {
    Guided plain;
    plain.guide.call_from(plain.goal("Bench"));
    EXPECT_THAT(facts(plain), ElementsAre("led Bench by 3"));
    plain.stand({0.0, 3.5, 0.0});
    for (int tick = 0; tick < 60; ++tick) plain.guide.call(0.1 * tick);
    EXPECT_THAT(facts(plain), ElementsAre("arrived Bench by 3")) << "once";
}

}  // namespace wayfinding_test
}  // namespace handrail
