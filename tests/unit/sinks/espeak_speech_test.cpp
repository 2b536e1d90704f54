#include "audio-cues/sinks/espeak_speech.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "audio-cues/sinks/openal_sink.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"

namespace handrail {
namespace espeak_speech_test {

// Replaces the sound sink: fetches the samples and treats them as played immediately.
struct Listening {
    std::vector<std::int16_t> samples;
    int rate_hz = 0;
    double length_s() const { return rate_hz > 0 ? static_cast<double>(samples.size()) / rate_hz : 0.0; }
};

// Fetches the samples until the real synthesis thread has ended the text.
Listening listen_to_the_end(VoiceChannel& channel) {
    Listening heard;
    EXPECT_TRUE(test::eventually([&] {
        VoiceChannel::Update update = channel.take();
        heard.samples.insert(heard.samples.end(), update.samples.begin(), update.samples.end());
        heard.rate_hz = update.rate_hz;
        if (update.ended) channel.finished(update.ticket);
        return update.ended;
    })) << "the voice did not come to an end";
    return heard;
}

class EspeakSpeechTest : public ::testing::Test {
protected:
    void SetUp() override {
        auto opened = EspeakSpeech::open(channel, {});
        if (!opened) GTEST_SKIP() << "no embedded voice here: " << opened.error().sentence();
        speech = std::move(*opened);
    }
    Listening hear(const std::string& text) {
        speech->say({.text = text});
        return listen_to_the_end(*channel);
    }

    std::shared_ptr<VoiceChannel> channel = std::make_shared<VoiceChannel>();
    std::unique_ptr<EspeakSpeech> speech;
};

TEST_F(EspeakSpeechTest, turns_a_sentence_into_sound_of_plausible_length) {
    const auto before = std::chrono::steady_clock::now();
    const Listening heard = hear("North wall, plaster, two metres ahead");
    const double spent_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
    EXPECT_EQ(heard.rate_hz, 22050);
    EXPECT_GT(heard.length_s(), 1.2);
    EXPECT_LT(heard.length_s(), 5.0);
    double energy = 0.0;
    for (const std::int16_t s : heard.samples) energy += static_cast<double>(s) * s;
    EXPECT_GT(std::sqrt(energy / static_cast<double>(heard.samples.size())), 300.0);
    std::cout << "    " << heard.length_s() << " s of speech in " << spent_ms << " ms\n";
}

TEST_F(EspeakSpeechTest, counts_as_speaking_from_say_until_the_last_sample_was_played) {
    EXPECT_FALSE(speech->speaking());
    speech->say({.text = "Door"});
    EXPECT_TRUE(speech->speaking());
    listen_to_the_end(*channel);
    EXPECT_FALSE(speech->speaking());
}

TEST_F(EspeakSpeechTest, stop_silences_at_once_and_the_next_text_is_complete) {
    const double whole_s = hear("Facing north").length_s();
    std::string novel;
    for (int i = 0; i < 2000; ++i) novel += "The corridor continues to the right. ";
    speech->say({.text = novel});
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    speech->stop();
    EXPECT_FALSE(speech->speaking());
    EXPECT_TRUE(channel->take().samples.empty());
    EXPECT_NEAR(hear("Facing north").length_s(), whole_s, 0.1);
}

TEST_F(EspeakSpeechTest, a_newer_text_interrupts_an_older_one) {
    const double door_s = hear("Door").length_s();
    std::string novel;
    for (int i = 0; i < 2000; ++i) novel += "The corridor continues to the right. ";
    speech->say({.text = novel});
    EXPECT_NEAR(hear("Door").length_s(), door_s, 0.1);
}

TEST_F(EspeakSpeechTest, rate_and_voice_follow_the_settings) {
    const std::string text = "You are at the door of the long room, facing north";
    const double slow_s = hear(text).length_s();
    Settings::Speech settings;
    settings.rate_wpm = 350;
    speech->set_speech(settings);
    EXPECT_LT(hear(text).length_s(), slow_s / 1.5);
    EXPECT_EQ(speech->news(), std::nullopt);
    settings.voice = "no-such-voice";
    speech->set_speech(settings);
    EXPECT_GT(hear(text).length_s(), 0.5) << "English instead";
    EXPECT_EQ(speech->news(), "There is no voice named no-such-voice; an English voice is used instead.");
    settings.voice = "en-gb";
    speech->set_speech(settings);
    hear(text);
    EXPECT_EQ(speech->news(), std::nullopt);
}

TEST_F(EspeakSpeechTest, only_one_voice_speaks_at_a_time) {
    const auto second = EspeakSpeech::open(channel, {});
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().message, "The built-in voice is already in use.");
    speech.reset();
    EXPECT_TRUE(EspeakSpeech::open(channel, {}));
}

TEST_F(EspeakSpeechTest, empty_and_odd_texts_finish) {
    for (const char* text : {"", " ", "...", "<speak>x", "[[h@l'oU]]", "東京", "\xf0\x9f\x9a\xaa"}) {
        speech->say({.text = text});
        listen_to_the_end(*channel);
        EXPECT_FALSE(speech->speaking()) << text;
    }
}

TEST_F(EspeakSpeechTest, is_heard_through_the_sound_sink_within_50_ms_of_stream_time) {
    // Synthesis runs in real time, while the stream runs in virtual time. So the test waits for the synthesis first.
    const Listening spoken = hear("North wall, plaster");
    const auto stream = std::make_shared<VoiceChannel>();
    auto opened = OpenALSink::open(stream, {.output = OpenALSink::Output::OnDemand});
    ASSERT_TRUE(opened) << opened.error().sentence();
    const auto ticket = stream->begin(spoken.rate_hz, 1.0);
    stream->append(ticket, spoken.samples);
    stream->end(ticket);
    double now_s = 0.0, onset_s = -1.0, last_s = 0.0;
    for (; stream->playing() && now_s < 10.0; now_s += 256.0 / 48000.0) {
        (*opened)->tick(now_s);
        const auto mix = (*opened)->render(256);
        for (std::size_t i = 0; i < mix.size(); i += 2)
            if (std::abs(mix[i]) > 0.003F) {
                last_s = now_s + static_cast<double>(i / 2) / 48000.0;
                if (onset_s < 0.0) onset_s = last_s;
            }
    }
    EXPECT_GE(onset_s, 0.0);
    EXPECT_LE(onset_s, 0.050);
    EXPECT_GT(last_s, 0.7);
    EXPECT_NEAR(now_s, spoken.length_s(), 0.03);
}

TEST_F(EspeakSpeechTest, without_a_voice_it_beeps_and_gives_the_reason) {
    const auto other = std::make_shared<VoiceChannel>();
    // open_voice() cannot open espeak-ng, because another object uses the only instance.
    const auto fallback = open_voice(other, {});
    EXPECT_EQ(fallback->news(), "The built-in voice is already in use. Beeps mean that there is text to read.");
    fallback->say({.text = "Door"});
    EXPECT_TRUE(fallback->speaking());
    EXPECT_FALSE(other->take().samples.empty());
}

TEST(BeepSpeech, each_class_of_message_has_its_own_rhythm) {
    const auto channel = std::make_shared<VoiceChannel>();
    BeepSpeech speech(channel, "There is no voice.");
    EXPECT_EQ(speech.news(), "There is no voice.");
    EXPECT_EQ(speech.news(), std::nullopt);
    std::vector<std::vector<std::int16_t>> patterns;
    for (const SpeechClass c : {SpeechClass::Alarm, SpeechClass::Answer, SpeechClass::Contact, SpeechClass::Ambient}) {
        speech.say({.text = "Text", .speech_class = c});
        EXPECT_TRUE(speech.speaking());
        const VoiceChannel::Update update = channel->take();
        EXPECT_TRUE(update.ended);
        EXPECT_GT(*std::max_element(update.samples.begin(), update.samples.end()), 1000);
        for (const auto& other : patterns) EXPECT_NE(update.samples, other);
        patterns.push_back(update.samples);
    }
    speech.stop();
    EXPECT_FALSE(speech.speaking());
}

}  // namespace espeak_speech_test
}  // namespace handrail
