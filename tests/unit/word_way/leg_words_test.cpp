// Tests a leg as a sentence: first what to do, then how far, then where to. Each turn must have its own words in both
// languages.
#include "app/core/wayfinding/leg_words.h"
#include "tests/support/child_process.h"

#include <set>

#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/core/app_session.h"

namespace handrail {
namespace leg_words_test {

SpokenLeg leg(int turn, int steps, PaceEnd end, const std::string& to) {
    SpokenLeg spoken;
    spoken.turn_notches = turn;
    spoken.steps = steps;
    spoken.end = end;
    spoken.to = to;
    return spoken;
}

TEST(LegWords, give_the_action_first_then_the_distance_and_then_the_target) {
    EXPECT_EQ(leg_words(leg(0, 6, PaceEnd::Steps, ""), {}), "Straight on. 6 steps.");
    EXPECT_EQ(leg_words(leg(-4, 1, PaceEnd::Steps, "Kitchen"), {}), "Turn left. 1 step to Kitchen.");
    SpokenLeg door = leg(-4, 4, PaceEnd::Stopped, "Living room door, shut");
    door.open = true;
    EXPECT_EQ(leg_words(door, {}), "Turn left. 4 steps, until you meet Living room door, shut. Open it.");
    SpokenLeg leaf = leg(0, 2, PaceEnd::Steps, "Toilet");
    leaf.leaf = "front door";
    EXPECT_EQ(leg_words(leaf, {}), "Straight on. 2 steps to Toilet. Front door is open and in the way. Shut it.");
    EXPECT_EQ(leg_words(leg(8, 3, PaceEnd::Stopped, ""), {}), "Turn round. 3 steps, until something stops you.");
    SpokenLeg stairs = leg(1, 4, PaceEnd::Stairs, "");
    stairs.risers = 17;
    stairs.up = true;
    EXPECT_EQ(leg_words(stairs, {}), "Turn slightly right. 17 stairs up, in 4 steps, to the end.");
    stairs.steps = 0;
    stairs.up = false;
    EXPECT_EQ(leg_words(stairs, {}), "Turn slightly right. 17 stairs down, just ahead, to the end.");
    SpokenLeg over = leg(4, 9, PaceEnd::Steps, "Landing");
    over.risers = 17;
    over.up = true;
    over.to_stairs = 2;
    EXPECT_EQ(leg_words(over, {}), "Turn right. 9 steps to Landing. On the way 17 stairs up, in 2 steps.");
    EXPECT_EQ(leg_words(leg(2, 3, PaceEnd::Steps, ""), {false, 0.7, true}), "Turn half right. 2 metres.");
}

TEST(LegWords, add_up_to_the_steps_and_to_the_stairs_of_flights_at_whose_end_a_leg_ends) {
    SpokenLeg flight = leg(0, 2, PaceEnd::Stairs, "");
    flight.risers = 17;
    SpokenLeg over = leg(0, 9, PaceEnd::Steps, "");
    over.risers = 5;
    const std::vector<SpokenLeg> legs{leg(4, 3, PaceEnd::Stopped, ""), flight, over};
    EXPECT_EQ(total_words(legs, {true, 0.7}), "14 steps and 17 stairs");
    EXPECT_EQ(total_words(std::span(legs).first(1), {true, 0.7}), "3 steps");
    EXPECT_EQ(total_words(std::span(legs).first(1), {false, 0.7}), "2 metres");
    const test::InLanguage german("de");
    EXPECT_EQ(total_words(legs, {true, 0.7}), "14 Schritte und 17 Stufen");
}

TEST(LegWords, give_one_instruction_at_a_time) {
    SpokenLeg leaf = leg(0, 2, PaceEnd::Stopped, "Toilet door, shut");
    leaf.leaf = "front door";
    for (const bool by_itself : {false, true}) {
        leaf.open = !by_itself;
        leaf.by_itself = by_itself;
        EXPECT_EQ(
            leg_words(leaf, {}),
            "Straight on. 2 steps, until you meet Toilet door, shut. Front door is open and in the way. Shut it.");
    }
}

TEST(LegWords, have_the_same_form_in_german) {
    const test::InLanguage german("de");
    EXPECT_EQ(leg_words(leg(0, 6, PaceEnd::Steps, ""), {}), "Geradeaus. 6 Schritte.");
    EXPECT_EQ(leg_words(leg(-4, 1, PaceEnd::Steps, "Küche"), {}), "Links abbiegen. 1 Schritt bis Küche.");
    SpokenLeg door = leg(3, 4, PaceEnd::Stopped, "Haustür, zu");
    door.open = true;
    EXPECT_EQ(leg_words(door, {}),
              "Halb rechts abbiegen, dann leicht rechts. 4 Schritte, bis zum Anstoßen: Haustür, zu. Öffnen.");
    SpokenLeg stairs = leg(-6, 1, PaceEnd::Stairs, "");
    stairs.risers = 17;
    EXPECT_EQ(leg_words(stairs, {}), "Scharf links abbiegen. 17 Stufen hinab, in 1 Schritt, bis zum Ende.");
}

TEST(LegWords, differ_for_each_of_the_sixteen_turns) {
    for (const char* language : {"en", "de"}) {
        const test::InLanguage spoken(language);
        std::set<std::string> all;
        for (int turn = -7; turn <= 8; ++turn) all.insert(leg_words(leg(turn, 2, PaceEnd::Steps, ""), {}));
        EXPECT_EQ(all.size(), 16U) << language;
    }
}

// If a background task finds the rooms, another background task plans the route for directions. So the session
// announces the length immediately and the first leg later.
TEST(LegWords, arrive_from_the_background_while_the_session_continues) {
    test::AppSession person({}, {}, SessionOptions{.executor = on_threads()});
    person.app.apply(WorldEntered{make_ready(test::our_world("house.map"))}, person.now);
    const auto wait_for = [&](const std::function<bool()>& there) {
        return test::eventually([&] {
            person.run(0.05);
            return there();
        });
    };
    ASSERT_TRUE(
        wait_for([&] { return !person.request(Command::Exits).starts_with("The rooms of this world are still"); }));
    person.request(Command::Routes);
    const std::string way = person.line("Music room");
    EXPECT_TRUE(way.starts_with("To Music room. ")) << way;
    EXPECT_TRUE(way.ends_with("Through Stairs, Landing.")) << way;
    person.said.clear();
    EXPECT_EQ(person.request(Command::NextLeg), "One moment.");
    EXPECT_TRUE(wait_for([&] {
        return person.said.back() != "One moment." && person.said.back() != "Rooms and routes have been worked out.";
    }));
    // The length of the route comes with the first leg, and only once.
    const std::string length_and_leg = person.said.back(), repeated = person.request(Command::RepeatLeg);
    EXPECT_TRUE(length_and_leg.find(" in all") != std::string::npos && length_and_leg.ends_with(". " + repeated))
        << length_and_leg << " and then: " << repeated;
    // If a person requests the rest of the route during the planning, the session must announce the rest when it is
    // known.
    person.request(Command::Routes);
    person.line("Bathroom");
    person.said.clear();
    EXPECT_EQ(person.request(Command::RestOfRoute), "One moment.");
    EXPECT_TRUE(wait_for([&] { return person.said.back() != "One moment."; }));
    const std::string rest = person.said.back();
    EXPECT_EQ(person.request(Command::RestOfRoute), rest);
    const std::string leg = person.request(Command::RepeatLeg);
    EXPECT_TRUE(rest.starts_with(leg)) << rest;
    EXPECT_GT(rest.size(), leg.size() + 10) << rest;
    // Another world or another request must cancel the planning.
    person.request(Command::Routes);
    person.line("Kitchen");
    person.app.apply(WorldEntered{make_ready(test::our_world("first_room.map"))}, person.now);
    person.run(0.1);
    EXPECT_EQ(person.request(Command::NextLeg), "You are not following a route.");
}

}  // namespace leg_words_test
}  // namespace handrail
