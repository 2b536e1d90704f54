// Tests in which order the planner has lines spoken and which lines it drops. The voice takes time in virtual time: 240
// words a minute, so that a word lasts 0.25 s. Each line takes 0.1 s more.
#include "audio-cues/plan/speech_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail {
namespace speech_order_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class SpeechOrderTest : public ::testing::Test {
protected:
    void add(std::string text, SpeechClass speech_class, SpeechTopic topic = SpeechTopic::None) {
        order.add({.utterance = {.text = std::move(text), .speech_class = speech_class, .topic = topic},
                   .requested_s = now_s,
                   .expires_s = now_s + 0.5,
                   .repeatable = true});
    }
    void tick() {
        voice.tick(now_s);
        const SpeechOrder::Knows knows{.touches = [](const SpeechLine&) { return false; },
                                       .said = [](const SpeechLine&) { return false; }};
        while (const auto line = order.next(now_s, voice.speaking(), knows)) voice.say(line->utterance);
        for (const SpeechLine& line : order.take_unspoken()) voice.write(line.utterance);
        if (const SpeechTopics topics = order.take_owed(now_s, voice.speaking()); topics.any()) owed.push_back(topics);
        now_s += 0.005;
    }
    void wait(double seconds) {
        for (const double end_s = now_s + seconds; now_s < end_s;) tick();
    }
    void key() {
        voice.tick(now_s);
        if (order.key(now_s, voice.speaking())) voice.stop();
    }
    // Returns the lines that the voice spoke to the end.
    std::vector<std::string> heard() const {
        std::vector<std::string> texts;
        for (const HeardSpeech& line : voice.lines())
            if (line.voiced && !line.cut && line.end_s <= now_s) texts.push_back(line.utterance.text);
        return texts;
    }
    std::vector<std::string> written() const {
        std::vector<std::string> texts;
        for (const HeardSpeech& line : voice.lines())
            if (!line.voiced) texts.push_back(line.utterance.text);
        return texts;
    }

    double now_s = 1.0;
    SpeechOrder order;
    RecordingSpeech voice{240.0};
    std::vector<SpeechTopics> owed;
};

TEST_F(SpeechOrderTest, a_room_cuts_the_name_of_its_jamb_and_is_heard) {
    add("West wall, plaster", SpeechClass::Contact);
    wait(0.3);
    add("Living room", SpeechClass::Guidance, SpeechTopic::Place);
    tick();
    add("West wall, plaster", SpeechClass::Contact);
    wait(3.0);
    EXPECT_THAT(heard(), ElementsAre("Living room"));
    EXPECT_THAT(owed, IsEmpty());
}

TEST_F(SpeechOrderTest, the_first_leg_waits_for_the_summary_of_its_route) {
    add("To Kitchen. 11 steps in all, through Living room.", SpeechClass::Answer, SpeechTopic::Summary);
    wait(0.2);
    add("5 steps ahead", SpeechClass::Guidance, SpeechTopic::Leg);
    wait(6.0);
    EXPECT_THAT(heard(), ElementsAre("To Kitchen. 11 steps in all, through Living room.", "5 steps ahead"));
}

TEST_F(SpeechOrderTest, lines_of_one_key_follow_each_other_whatever_their_time) {
    for (const char* text : {"One", "Two", "Three", "Four", "Five"}) {
        add(text, SpeechClass::Answer);
        wait(0.007);
    }
    wait(4.0);
    EXPECT_THAT(heard(), ElementsAre("One", "Two", "Three", "Four", "Five"));
    EXPECT_THAT(written(), IsEmpty());
}

TEST_F(SpeechOrderTest, the_newest_leg_room_and_heading_replace_older_ones) {
    for (const SpeechTopic topic : {SpeechTopic::Leg, SpeechTopic::Place, SpeechTopic::Arrival, SpeechTopic::Heading}) {
        const bool answer = topic == SpeechTopic::Heading;
        const SpeechClass speech_class = answer ? SpeechClass::Answer : SpeechClass::Guidance;
        add("An older line that is cut", speech_class, topic);
        wait(0.2);
        add("The newest", speech_class, topic);
        wait(4.0);
        EXPECT_EQ(heard().size(), 1U);
        EXPECT_EQ(heard().back(), "The newest");
        voice = RecordingSpeech{240.0};
    }
    EXPECT_THAT(owed, IsEmpty()) << "a newer line of the topic has told what there is";
}

TEST_F(SpeechOrderTest, what_a_key_cuts_is_due_again_at_the_first_pause_of_a_second) {
    add("Along the wall to your left is a radiator", SpeechClass::Answer, SpeechTopic::Lesson);
    add("Living room", SpeechClass::Guidance, SpeechTopic::Place);
    wait(0.5);
    key();
    wait(0.9);
    key();
    wait(0.9);
    EXPECT_THAT(owed, IsEmpty()) << "less than a second after the last key";
    wait(0.2);
    ASSERT_EQ(owed.size(), 1U);
    EXPECT_TRUE(owed[0].has(SpeechTopic::Lesson));
    EXPECT_TRUE(owed[0].has(SpeechTopic::Place)) << "it had not had its turn";
    EXPECT_FALSE(owed[0].has(SpeechTopic::Leg));
    wait(5.0);
    EXPECT_EQ(owed.size(), 1U) << "each once";
    EXPECT_THAT(heard(), IsEmpty());
    EXPECT_THAT(written(), IsEmpty()) << "the line that is made anew is written";
}

TEST_F(SpeechOrderTest, an_arrival_at_once_after_a_room_replaces_neither) {
    add("Kitchen, with many more words than that", SpeechClass::Guidance, SpeechTopic::Place);
    wait(0.1);
    add("Here: Refrigerator", SpeechClass::Answer, SpeechTopic::Arrival);
    wait(0.3);
    key();
    wait(2.0);
    ASSERT_EQ(owed.size(), 1U);
    EXPECT_TRUE(owed[0].has(SpeechTopic::Arrival)) << "the key cut it";
    EXPECT_TRUE(owed[0].has(SpeechTopic::Place)) << "the arrival cut it";
}

TEST_F(SpeechOrderTest, a_newer_line_of_the_topic_pays_what_is_owed) {
    add("Living room", SpeechClass::Guidance, SpeechTopic::Place);
    wait(0.1);
    key();
    add("Kitchen", SpeechClass::Guidance, SpeechTopic::Place);
    wait(4.0);
    EXPECT_THAT(heard(), ElementsAre("Kitchen"));
    EXPECT_THAT(owed, IsEmpty());
}

TEST_F(SpeechOrderTest, a_warning_that_cuts_a_summary_leaves_it_owed) {
    add("To Kitchen. 11 steps in all", SpeechClass::Answer, SpeechTopic::Summary);
    wait(0.2);
    add("Drop, one step ahead", SpeechClass::Warning);
    wait(3.0);
    EXPECT_THAT(heard(), ElementsAre("Drop, one step ahead"));
    ASSERT_EQ(owed.size(), 1U);
    EXPECT_TRUE(owed[0].has(SpeechTopic::Summary));
}

TEST_F(SpeechOrderTest, no_key_but_the_stop_key_ends_danger) {
    for (const SpeechClass danger : {SpeechClass::Alarm, SpeechClass::Warning}) {
        add("Edge. Drop, two metres deep, and many more words than that", danger);
        wait(2.0);
        key();
        EXPECT_TRUE(voice.speaking());
        wait(3.0);
        EXPECT_EQ(heard().size(), 1U);
        voice = RecordingSpeech{240.0};
    }
}

TEST_F(SpeechOrderTest, counts_of_steps_yield_expire_and_are_written) {
    add("You are in the hall, which is long", SpeechClass::Answer);
    add("5 steps", SpeechClass::Contact, SpeechTopic::Steps);
    wait(6.0);
    EXPECT_THAT(heard(), ElementsAre("You are in the hall, which is long"));
    EXPECT_THAT(written(), ElementsAre("5 steps")) << "2 s later it would be about another walk";
    add("2 steps", SpeechClass::Contact, SpeechTopic::Steps);
    wait(0.1);
    add("Living room", SpeechClass::Guidance, SpeechTopic::Place);
    wait(2.0);
    EXPECT_THAT(heard(), ElementsAre("You are in the hall, which is long", "Living room"));
}

TEST_F(SpeechOrderTest, the_stop_key_owes_nothing) {
    add("Find a wall", SpeechClass::Answer, SpeechTopic::Lesson);
    add("Kitchen", SpeechClass::Guidance, SpeechTopic::Place);
    wait(0.1);
    order.silence(now_s);
    voice.stop();
    wait(5.0);
    EXPECT_THAT(owed, IsEmpty());
    EXPECT_THAT(written(), ElementsAre("Kitchen")) << "what had no turn can still be read";
}

TEST_F(SpeechOrderTest, hints_of_one_time_follow_each_other_and_one_without_a_turn_is_written) {
    add("Two rooms cannot be reached.", SpeechClass::Ambient);
    add("One stair was left out.", SpeechClass::Ambient);
    wait(4.0);
    EXPECT_THAT(heard(), ElementsAre("Two rooms cannot be reached.", "One stair was left out."));
    add("Facing north", SpeechClass::Answer);
    add("Time for a break", SpeechClass::Ambient);
    wait(4.0);
    EXPECT_THAT(written(), ElementsAre("Time for a break"));
}

TEST_F(SpeechOrderTest, keeps_at_most_eight_answers_and_writes_the_older_ones) {
    for (int i = 0; i < 12; ++i) add("Line " + std::to_string(i), SpeechClass::Answer);
    wait(20.0);
    EXPECT_EQ(heard().size(), SpeechOrder::kMostWaiting);
    EXPECT_EQ(heard().back(), "Line 11");
    EXPECT_EQ(written().size(), 12U - SpeechOrder::kMostWaiting);
}

}  // namespace speech_order_test
}  // namespace handrail
