// Tests speech-dispatcher as the voice: first the sink alone, then the whole program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "audio-cues/sinks/speechd_speech.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/voices/speech_server.h"

namespace handrail::test {
namespace speechd_test {

using testing::HasSubstr;

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

class SpeechdVoice : public testing::Test {
protected:
    void start(int word_ms) {
        if (!installed("speech-dispatcher")) GTEST_SKIP() << "speech-dispatcher is not installed";
        server = SpeechServer::start(folder.path(), word_ms);
        ASSERT_TRUE(server->running()) << server->everything();
        for (const auto& [name, value] : server->environment()) ::setenv(name.c_str(), value.c_str(), 1);
        voice = std::make_unique<SpeechdSpeech>(Settings::Speech{});
        voice->want(true);
        ASSERT_TRUE(becomes(VoiceState::Ready)) << server->everything();
    }
    bool becomes(VoiceState state) {
        return eventually([&] {
            voice->tick(now_s());
            return voice->state() == state;
        });
    }
    bool falls_silent() {
        return eventually([&] {
            voice->tick(now_s());
            return !voice->speaking();
        });
    }

    TemporaryFolder folder;
    std::unique_ptr<SpeechServer> server;
    std::unique_ptr<SpeechdSpeech> voice;
};

TEST_F(SpeechdVoice, speaks_every_word_and_knows_when_it_has_ended) {
    ASSERT_NO_FATAL_FAILURE(start(5));
    if (!server) return;
    voice->say({.text = "North wall, plaster & <brick>. \"Door\""});
    EXPECT_TRUE(voice->speaking());
    ASSERT_TRUE(falls_silent()) << server->everything();
    const auto all = server->recorded();
    ASSERT_EQ(all.size(), 2U) << server->everything();
    EXPECT_EQ(all[0].words, "North wall, plaster & <brick>. \"Door\"");
    EXPECT_EQ(all[1].event, "end");
}

TEST_F(SpeechdVoice, is_interrupted_by_a_new_utterance_and_by_silence) {
    ASSERT_NO_FATAL_FAILURE(start(10000));  // each word is so long that no utterance ends during the test
    if (!server) return;
    const double requested_s = now_s();
    voice->say({.text = "one two three", .speech_class = SpeechClass::Alarm});
    ASSERT_TRUE(eventually([&] { return server->spoke("one two three"); })) << server->everything();
    voice->say({.text = "North wall"});
    ASSERT_TRUE(eventually([&] { return server->spoke("North wall"); })) << server->everything();
    EXPECT_TRUE(voice->speaking());
    const double silenced_s = now_s();
    voice->stop();
    EXPECT_FALSE(voice->speaking());
    ASSERT_TRUE(eventually([&] { return server->recorded().size() == 4; })) << server->everything();
    const auto all = server->recorded();
    EXPECT_EQ(all[1].event, "stop");
    EXPECT_EQ(all[3].event, "stop");
    RecordProperty("say_to_voice_ms", static_cast<int>(1000.0 * (all[0].time_s - requested_s)));
    std::printf("speech-dispatcher: say() to the voice's first word %.1f ms, stop() to its silence %.1f ms\n",
                1000.0 * (all[0].time_s - requested_s), 1000.0 * (all[3].time_s - silenced_s));
}

TEST_F(SpeechdVoice, notices_a_killed_server_at_once_and_uses_its_successor) {
    ASSERT_NO_FATAL_FAILURE(start(5));
    if (!server) return;
    server->kill();
    ASSERT_TRUE(becomes(VoiceState::Unavailable));
    voice->say({.text = "lost"});
    EXPECT_FALSE(voice->speaking()) << "nobody is waited for who cannot speak";
    ASSERT_TRUE(server->start_again());
    ASSERT_TRUE(becomes(VoiceState::Ready)) << server->everything();
    voice->say({.text = "back again"});
    EXPECT_TRUE(eventually([&] { return server->spoke("back again"); })) << server->everything();
    EXPECT_FALSE(server->spoke("lost"));
}

TEST_F(SpeechdVoice, gives_up_a_server_that_no_longer_answers_after_the_watchdog_time) {
    ASSERT_NO_FATAL_FAILURE(start(5));
    if (!server) return;
    server->freeze();
    const double requested_s = now_s();
    voice->say({.text = "is anybody there"});
    std::printf("say() to a frozen server returned after %.3f ms\n", 1000.0 * (now_s() - requested_s));
    EXPECT_TRUE(voice->speaking());
    ASSERT_TRUE(becomes(VoiceState::Unavailable));
    EXPECT_FALSE(voice->speaking());
    voice.reset();  // the destructor must return although the server never answers
}

}  // namespace speechd_test
}  // namespace handrail::test
