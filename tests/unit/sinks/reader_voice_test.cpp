#include "audio-cues/sinks/reader_voice.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <string>

namespace handrail {
namespace reader_voice_test {

struct ReaderVoiceTest : testing::Test {
    ReaderVoiceTest() { voice.want(true); }
    std::shared_ptr<ReaderChannel> channel = std::make_shared<ReaderChannel>();
    ReaderVoice voice{channel};
};

TEST_F(ReaderVoiceTest, is_unavailable_until_a_screen_reader_is_found) {
    EXPECT_EQ(voice.state(), VoiceState::Unavailable);
    EXPECT_TRUE(channel->wanted());
    voice.want(false);
    EXPECT_FALSE(channel->wanted());
}

TEST_F(ReaderVoiceTest, passes_on_only_the_newest_message) {
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

TEST_F(ReaderVoiceTest, an_unread_alarm_is_replaced_only_by_alarms) {
    channel->set_state(VoiceState::Ready);
    voice.say({.text = "The device is hot.", .speech_class = SpeechClass::Alarm});
    voice.say({.text = "door", .speech_class = SpeechClass::Contact});
    EXPECT_EQ(channel->take(), "The device is hot.");
}

TEST_F(ReaderVoiceTest, stop_withdraws_an_unread_message) {
    channel->set_state(VoiceState::Ready);
    voice.say({.text = "door"});
    EXPECT_TRUE(voice.speaking());
    voice.stop();
    EXPECT_FALSE(voice.speaking());
    EXPECT_FALSE(channel->take());
}

TEST_F(ReaderVoiceTest, counts_as_speaking_for_a_time_proportional_to_its_letters) {
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

TEST_F(ReaderVoiceTest, an_unread_message_is_lost_when_the_reader_disappears) {
    channel->set_state(VoiceState::Ready);
    voice.say({.text = "door"});
    channel->set_state(VoiceState::Unavailable);
    EXPECT_FALSE(channel->take());
    voice.say({.text = "window"});
    EXPECT_FALSE(channel->take());
}

}  // namespace reader_voice_test
}  // namespace handrail
