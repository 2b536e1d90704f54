#include "audio-cues/sinks/reader_voice.h"

#include <gtest/gtest.h>

#include <string>

namespace handrail {
namespace reader_voice_test {

struct ReaderVoiceTest : testing::Test {
    ReaderVoiceTest() { voice.want(true); }
    std::shared_ptr<ReaderChannel> channel = std::make_shared<ReaderChannel>();
    ReaderVoice voice{channel};
};

TEST_F(ReaderVoiceTest, is_gone_until_somebody_looks_for_a_reader) {
    EXPECT_EQ(voice.state(), VoiceState::Gone);
    EXPECT_TRUE(channel->wanted());
    voice.want(false);
    EXPECT_FALSE(channel->wanted());
}

TEST_F(ReaderVoiceTest, hands_on_the_newest_message_only) {
    channel->set_state(VoiceState::Ready);
    int calls = 0;
    channel->on_change([&] { ++calls; });
    voice.say({.text = "north wall"});
    voice.say({.text = "door"});
    EXPECT_EQ(calls, 2);
    EXPECT_EQ(channel->take(), "door");
    EXPECT_FALSE(channel->take());
    channel->on_change({});
}

TEST_F(ReaderVoiceTest, an_alarm_that_was_not_read_yet_gives_way_to_alarms_only) {
    channel->set_state(VoiceState::Ready);
    voice.say({.text = "The device is hot.", .speech_class = SpeechClass::Alarm});
    voice.say({.text = "door", .speech_class = SpeechClass::Contact});
    EXPECT_EQ(channel->take(), "The device is hot.");
}

TEST_F(ReaderVoiceTest, stop_takes_back_what_was_not_read) {
    channel->set_state(VoiceState::Ready);
    voice.say({.text = "door"});
    EXPECT_TRUE(voice.speaking());
    voice.stop();
    EXPECT_FALSE(voice.speaking());
    EXPECT_FALSE(channel->take());
}

TEST_F(ReaderVoiceTest, counts_as_speaking_for_as_long_as_its_letters_take) {
    channel->set_state(VoiceState::Ready);
    voice.tick(10.0);
    const std::string text = "The space around you is 6 by 4 metres.";
    voice.say({.text = text});
    const double ends_s = 10.0 + ReaderVoice::kStart_s + ReaderVoice::kLetter_s * static_cast<double>(text.size());
    voice.tick(ends_s - 0.01);
    EXPECT_TRUE(voice.speaking());
    voice.tick(ends_s + 0.01);
    EXPECT_FALSE(voice.speaking());
}

TEST_F(ReaderVoiceTest, what_waits_is_lost_with_the_reader) {
    channel->set_state(VoiceState::Ready);
    voice.say({.text = "door"});
    channel->set_state(VoiceState::Gone);
    EXPECT_FALSE(channel->take());
    voice.say({.text = "window"});
    EXPECT_FALSE(channel->take());
}

}  // namespace reader_voice_test
}  // namespace handrail
