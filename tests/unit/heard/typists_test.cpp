// Simulates people who type at different paces. The voice takes realistic time in virtual time. Each person must hear
// everything important, whatever keys they press meanwhile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/heard/heard.h"
#include "tests/unit/heard/typist.h"
#include "worlds/base/language.h"

namespace handrail {
namespace typists_test {

using test::kAfterLastKey_s;
using test::Typist;
using ::testing::IsEmpty;

struct Pace {
    double words_per_minute, pause_s;
};

class Paced : public ::testing::TestWithParam<Pace> {
protected:
    void SetUp() override { ASSERT_TRUE(speak_language("en")); }
};

// Returns the paces of the typists. Under a sanitizer these are a fast typist, a slow typist and a fast voice.
std::vector<Pace> paces() {
    const std::vector<Pace> all{{180.0, 0.5}, {180.0, 2.0}, {180.0, 4.0}, {180.0, 6.0},
                                {120.0, 2.0}, {120.0, 0.5}, {350.0, 2.0}, {350.0, 0.5}};
    std::vector<Pace> some;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (test::tried(i, 3)) some.push_back(all[i]);
    return some;
}

INSTANTIATE_TEST_SUITE_P(Typists, Paced, ::testing::ValuesIn(paces()));

// The house starts in the hall. The typist only presses keys, and requests the rest of the route leg by leg.
TEST_P(Paced, who_walks_through_the_house_hears_rooms_and_the_whole_of_a_route) {
    Typist typist("house.map", GetParam().words_per_minute, GetParam().pause_s);
    typist.press(Command::Routes);
    typist.key("Enter");
    for (int i = 0; i < 6; ++i) {
        typist.press(Command::FaceRoute);
        typist.press(Command::Forward, 5);
    }
    typist.press(Command::TurnRight, 3);
    typist.press(Command::Forward, 6);
    typist.finish();
    // If a stay is shorter than two pauses and the announcement of a name, it may end before the voice has any time to
    // speak.
    const double stay_s = GetParam().pause_s < 2.0 ? kAfterLastKey_s : 2.0 * GetParam().pause_s + 3.0;
    EXPECT_THAT(test::never_heard(typist.rooms_to_hear(stay_s), typist.spoken()), IsEmpty()) << typist.all();
    EXPECT_FALSE(typist.rooms.empty());
    EXPECT_THAT(test::unheard(typist.voice, {SpeechTopic::Place, SpeechTopic::Arrival, SpeechTopic::Lesson}), IsEmpty())
        << typist.all();
    if (typist.app().guide().leads()) {
        EXPECT_THAT(test::unheard(typist.voice, {SpeechTopic::Summary, SpeechTopic::Leg}), IsEmpty()) << typist.all();
    }
    EXPECT_THAT(test::cut_warnings(typist.voice), IsEmpty()) << typist.all();
}

TEST_P(Paced, a_person_who_requests_a_route_and_walks_on_at_once_hears_how_it_goes) {
    Typist typist("house.map", GetParam().words_per_minute, GetParam().pause_s);
    typist.press(Command::Routes);
    typist.key("Enter");
    typist.press(Command::TurnRight, 4);
    typist.finish();
    ASSERT_TRUE(typist.app().guide().leads());
    EXPECT_THAT(test::unheard(typist.voice, {SpeechTopic::Summary, SpeechTopic::Leg}), IsEmpty()) << typist.all();
    EXPECT_THAT(typist.all(), ::testing::HasSubstr("steps in all"));
}

// A person who arrives and presses the next key at once must still hear that they have arrived.
TEST_P(Paced, who_presses_a_key_on_arrival_hears_the_arrival_afterwards) {
    for (const char* goal : {"find desk", "routes study"}) {
        Typist typist("house.map", GetParam().words_per_minute, GetParam().pause_s);
        typist.press(Command::Exits);  // so that the session knows the rooms from now on
        typist.listen();
        typist.type(goal);
        if (goal[0] == 'f') typist.key("Enter");  // selects the beacon
        typist.listen();
        typist.app().apply(Placed{{8.8, 0.9, 0.0}, 0.5 * kPi}, typist.now_s());
        typist.wait(0.5);
        typist.press(Command::TurnRight);
        typist.finish();
        ASSERT_EQ(typist.arrivals.size(), 1U) << typist.all();
        EXPECT_THAT(test::never_heard(typist.arrivals, typist.spoken()), IsEmpty()) << typist.all();
        EXPECT_THAT(test::never_heard({{typist.arrivals[0].from_s, typist.now_s(), "Study", SpeechTopic::Place}},
                                      typist.spoken()),
                    IsEmpty())
            << typist.all();
    }
}

// A person who presses a key while the beacon is announced must still hear where it is.
TEST_P(Paced, who_sets_a_beacon_and_walks_on_at_once_hears_where_it_is) {
    for (const auto& [tool, row] : {std::pair{"Beacon on Desk", 0}, {"Desk: faster ticking", 2}}) {
        Typist typist("house.map", GetParam().words_per_minute, GetParam().pause_s);
        typist.press(Command::Exits);  // so that the session knows the rooms from now on
        typist.listen();
        typist.type("find desk");
        for (int i = 0; i < row; ++i) typist.key("Down");
        const double from_s = typist.now_s();
        typist.key("Enter");
        typist.press(Command::TurnRight, 2);
        typist.finish();
        EXPECT_THAT(test::never_heard({{from_s, typist.now_s(), tool}}, typist.spoken()), IsEmpty()) << typist.all();
    }
}

TEST_P(Paced, who_walks_on_in_the_first_minutes_hears_what_the_next_step_wants) {
    Typist typist("first_room.map", GetParam().words_per_minute, GetParam().pause_s);
    typist.app().apply(FirstMinutesBegun{"a voice", false}, typist.now_s());
    typist.key("Enter");
    typist.press(Command::Forward, 12);
    typist.press(Command::TurnLeft, 4);
    typist.press(Command::Forward, 6);
    typist.finish();
    EXPECT_THAT(test::unheard(typist.voice, {SpeechTopic::Praise, SpeechTopic::Lesson}), IsEmpty()) << typist.all();
    // A key every 2 s leaves 1 s of speech between keys, which is too short for the praise before this instruction.
    if (GetParam().pause_s >= 4.0) {
        EXPECT_THAT(typist.all(), ::testing::HasSubstr("radiator"));
    }
}

TEST_P(Paced, who_walks_towards_an_edge_hears_every_warning_to_its_end) {
    Typist typist("stairs_hall.map", GetParam().words_per_minute, GetParam().pause_s);
    typist.app().apply(Placed{{6.0, 0.0, 0.0}, 0.5 * kPi}, typist.now_s());
    typist.press(Command::Forward, 8);
    typist.press(Command::TurnLeft, 2);
    typist.finish();
    int warnings = 0;
    for (const HeardSpeech& said : typist.voice.lines())
        if (said.voiced && said.utterance.speech_class == SpeechClass::Warning) ++warnings;
    EXPECT_GE(warnings, 1) << typist.all();
    EXPECT_THAT(test::cut_warnings(typist.voice), IsEmpty()) << typist.all();
}

// Returns the text of the last line about the topic that was heard in full.
std::string last_heard(const Typist& typist, SpeechTopic topic) {
    std::string text;
    for (const HeardSpeech& said : typist.voice.lines())
        if (said.utterance.topic == topic && test::in_full(said, typist.now_s())) text = said.utterance.text;
    return text;
}

TEST(Typist, hears_a_leg_that_was_cut_as_it_is_after_the_steps_walked_meanwhile) {
    ASSERT_TRUE(speak_language("en"));
    Typist typist("house.map", 180.0, 0.5);
    typist.press(Command::Exits);  // so that the session knows the rooms from now on
    typist.listen();
    typist.type("routes utility room");
    typist.press(Command::FaceRoute);
    typist.listen();
    typist.press(Command::RepeatLeg);
    typist.listen();
    const std::string first = last_heard(typist, SpeechTopic::Leg);
    typist.press(Command::RepeatLeg);
    typist.press(Command::Forward, 2);
    typist.finish();
    const std::string anew = last_heard(typist, SpeechTopic::Leg);
    EXPECT_NE(anew, first) << typist.all();
    typist.press(Command::RepeatLeg);
    typist.listen();
    EXPECT_EQ(last_heard(typist, SpeechTopic::Leg), anew) << typist.all();
}

TEST(Typist, does_not_hear_a_room_that_was_cut_and_is_left) {
    ASSERT_TRUE(speak_language("en"));
    Typist typist("house.map", 180.0, 0.5);
    typist.press(Command::Exits);  // so that the session knows the rooms from now on
    typist.listen();
    typist.app().apply(Placed{{3.0, 3.0, 0.0}, 0.0}, typist.now_s());
    typist.wait(0.2);
    typist.press(Command::TurnRight);
    typist.app().apply(Placed{{8.8, 0.9, 0.0}, 0.0}, typist.now_s());
    typist.finish();
    ASSERT_EQ(typist.rooms.size(), 3U) << typist.all();
    EXPECT_THAT(typist.all(), ::testing::HasSubstr("cut: Living room\n"));
    EXPECT_EQ(last_heard(typist, SpeechTopic::Place), "Study") << typist.all();
    for (const HeardSpeech& said : typist.voice.lines())
        EXPECT_FALSE(said.utterance.text == "Living room" && test::in_full(said, typist.now_s())) << typist.all();
}

TEST(Typist, hears_how_to_open_a_shut_door_but_not_of_the_door_that_they_have_just_shut) {
    ASSERT_TRUE(speak_language("en"));
    Typist typist("house.map", 180.0, 2.0);
    typist.press(Command::Exits);  // so that the session knows the rooms from now on
    typist.listen();
    typist.type("find sofa");
    typist.key("Enter");  // selects the beacon
    typist.listen();
    const auto& features = typist.app().scene()->features;
    const auto door =
        std::find_if(features.begin(), features.end(), [](const Feature& f) { return f.name == "Living room door"; });
    const Vec3 middle = door->bounds_m.centre_m();
    typist.app().apply(Placed{{middle.x + 0.8, middle.y, 0.0}, -0.5 * kPi}, typist.now_s());
    typist.listen();
    const auto hints = [&] {
        int count = 0;
        for (const HeardSpeech& said : typist.voice.lines())
            count += said.utterance.text == "Living room door, wood is shut. Enter opens it." ? 1 : 0;
        return count;
    };
    EXPECT_EQ(hints(), 1) << typist.all();
    for (const char* what : {"Living room door opens", "Living room door is shut"}) {
        typist.press(Command::Use);
        typist.listen();
        EXPECT_EQ(test::never_heard({{0.0, typist.now_s(), what}}, typist.spoken()).size(), 0U) << typist.all();
    }
    EXPECT_EQ(hints(), 1) << typist.all();
}

}  // namespace typists_test
}  // namespace handrail
