#include "audio-cues/plan/audio_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "audio-cues/sinks/espeak_speech.h"
#include "audio-cues/sinks/openal_sink.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail {
namespace audio_thread_test {

using ::testing::ElementsAre;

std::shared_ptr<const Scene> room() {
    auto scene = std::make_shared<Scene>();
    scene->materials.resize(1);
    scene->features.resize(2);
    scene->features[0].name = "north wall";
    scene->features[1].name = "table";
    return scene;
}

CueRequest answer(std::string words) {
    CueRequest request;
    request.text = std::move(words);
    return request;
}

ContactEvent begin(std::uint32_t feature, double time_s) {
    ContactEvent event;
    event.feature = FeatureId{feature};
    event.time_s = time_s;
    event.speed_m_per_s = 0.1;
    return event;
}

std::vector<std::string> texts(const std::vector<SpokenLine>& lines) {
    std::vector<std::string> all;
    for (const SpokenLine& line : lines) all.push_back(line.text);
    return all;
}

// The loop of the audio thread in virtual time. The test steps the loop.
struct Ears {
    explicit Ears(double words_per_minute = 0.0) {
        auto a = std::make_unique<RecordingAudio>();
        auto s = std::make_unique<RecordingSpeech>(words_per_minute);
        audio = a.get();
        speech = s.get();
        loop = std::make_unique<AudioThread>(std::move(a), std::move(s), clock, &ring, Settings{});
        loop->enter_world(room());
    }
    void run(double seconds) {
        for (const double end_s = clock.now_s() + seconds; clock.now_s() < end_s;
             clock.advance_s(AudioThread::kPeriod_s))
            loop->step();
    }
    VirtualClock clock;
    AudioThread::ContactRing ring;
    RecordingAudio* audio = nullptr;
    RecordingSpeech* speech = nullptr;
    std::unique_ptr<AudioThread> loop;
};

TEST(AudioThread, a_touched_thing_is_heard_and_its_name_returns_to_the_app_once) {
    Ears ears;
    ears.ring.push(begin(0, 0.0));
    ears.run(0.1);
    ASSERT_EQ(ears.audio->sounds().size(), 1U);
    EXPECT_THAT(texts(ears.loop->take_spoken()), ElementsAre("North wall"));
    EXPECT_TRUE(ears.loop->take_spoken().empty());
}

TEST(AudioThread, listener_position_and_settings_reach_the_audio_sinks) {
    Ears ears;
    ears.loop->set_listener({.ears_m = {1.0, 2.0, 3.0}, .heading_rad = 0.5});
    Settings quiet;
    quiet.speech.verbosity = 0;
    ears.loop->set_settings(quiet);
    ears.ring.push(begin(0, 0.0));
    ears.run(0.1);
    EXPECT_EQ(ears.audio->listener().ears_m, Vec3(1.0, 2.0, 3.0));
    EXPECT_TRUE(ears.loop->take_spoken().empty());
}

TEST(AudioThread, every_line_reaches_the_app_although_the_planner_keeps_only_500) {
    Ears ears;
    std::size_t lines = 0;
    for (int i = 0; i < 300; ++i) {
        for (int k = 0; k < 4; ++k) ears.loop->post(answer(fmt::format("Line {} {}", i, k)));
        ears.run(AudioThread::kPeriod_s);
        lines += ears.loop->take_spoken().size();
    }
    EXPECT_EQ(lines, 1200U);
}

TEST(AudioThread, stopping_writes_unspoken_text_and_silences_everything) {
    Ears ears(120.0);
    for (const char* words : {"One", "Two", "Three"}) ears.loop->post(answer(words));
    ears.loop->stop();
    ASSERT_EQ(ears.speech->lines().size(), 3U);
    EXPECT_TRUE(ears.speech->lines()[0].cut);
    EXPECT_FALSE(ears.speech->lines()[2].voiced);
    EXPECT_EQ(ears.audio->silences_s().size(), 1U);
    EXPECT_THAT(texts(ears.loop->take_spoken()), ElementsAre("One", "Two", "Three"));
}

TEST(AudioThread, stopping_lets_the_voice_finish_on_request) {
    Ears ears(120.0);
    for (const char* words : {"One", "Two", "Three"}) ears.loop->post(answer(words));
    ears.loop->stop(10.0);
    ASSERT_EQ(ears.speech->lines().size(), 3U);
    for (const HeardSpeech& line : ears.speech->lines()) EXPECT_TRUE(line.voiced && !line.cut) << line.utterance.text;
    EXPECT_NEAR(ears.clock.now_s(), 3 * 0.6, 0.1) << "and no longer than it needs";
}

TEST(AudioThread, runs_in_parallel_with_servo_and_app_and_joins) {
    // Uses real threads, and real sinks if the machine has them, so that the thread sanitizer can find races.
    SteadyClock clock;
    AudioThread::ContactRing ring;
    const auto channel = std::make_shared<VoiceChannel>();
    auto audio = OpenALSink::open(channel, {.device = "a device that is not there"});
    ASSERT_TRUE(audio) << audio.error().sentence();
    AudioThread loop(std::move(*audio), open_voice(channel, {}), clock, &ring, Settings{});
    loop.start();
    std::atomic<bool> done{false};
    std::thread servo([&] {
        for (std::uint32_t tick = 0; !done; ++tick) {
            ContactEvent event = begin(tick % 2, clock.now_s());
            event.kind = static_cast<ContactEventKind>(tick % 5);
            ring.push(event);
            clock.sleep_until_s(clock.now_s() + 0.001);
        }
    });
    std::vector<SpokenLine> spoken;
    for (int frame = 0; frame < 40; ++frame) {
        loop.enter_world(room());
        loop.post(answer(fmt::format("Frame {}", frame)));
        CueRequest tone;
        tone.kind = frame % 10 == 9 ? CueRequestKind::SilenceAll : CueRequestKind::WallTone;
        loop.post(tone);
        Settings settings;
        settings.speech.rate_wpm = 200 + frame;
        loop.set_settings(settings);
        loop.set_listener({.ears_m = {0.1 * frame, 0.0, 1.7}, .heading_rad = 0.1 * frame});
        for (SpokenLine& line : loop.take_spoken()) spoken.push_back(std::move(line));
        clock.sleep_until_s(clock.now_s() + 0.01);
    }
    done = true;
    servo.join();
    loop.stop();
    loop.stop();
    for (SpokenLine& line : loop.take_spoken()) spoken.push_back(std::move(line));
    const auto said = texts(spoken);
    for (int frame = 0; frame < 40; ++frame) EXPECT_THAT(said, ::testing::Contains(fmt::format("Frame {}", frame)));
}

}  // namespace audio_thread_test
}  // namespace handrail
