#include "audio-cues/sinks/openal_sink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "audio-cues/plan/cue_planner.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "audio-cues/sinks/synth.h"

namespace handrail {
namespace {

constexpr int kPeriod = 256;
constexpr double kPeriod_s = static_cast<double>(kPeriod) / kSampleRate_hz;

// OpenAL reads its configuration once per process. The null back end is a playback device that needs no sound card.
const int null_back_end = ::setenv("ALSOFT_DRIVERS", "null", 1);

// The sink on a loopback device, ticked and rendered period by period on virtual time, with everything that was heard.
class OpenALSinkTest : public ::testing::Test {
protected:
    OpenALSinkTest() {
        auto opened = OpenALSink::open(voice, {.output = OpenALSink::Output::OnDemand});
        if (!opened) throw std::runtime_error(opened.error().sentence());
        sink = std::move(*opened);
    }
    void period() {
        sink->tick(now_s);
        hear();
        now_s += kPeriod_s;
    }
    void hear() {
        const auto mix = sink->render(kPeriod);
        for (std::size_t i = 0; i < mix.size(); i += 2) {
            left.push_back(mix[i]);
            right.push_back(mix[i + 1]);
        }
    }
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(std::ceil(seconds / kPeriod_s)); ++i) period();
    }
    // Plays for that long and returns what the left ear heard of it.
    std::vector<float> listen(double seconds) {
        const std::size_t from = left.size();
        run(seconds);
        return {left.begin() + static_cast<std::ptrdiff_t>(from), left.end()};
    }
    void forget() {
        left.clear();
        right.clear();
    }
    static double rms(std::span<const float> x) {
        double e = 0.0;
        for (const float s : x) e += static_cast<double>(s) * static_cast<double>(s);
        return std::sqrt(e / static_cast<double>(std::max<std::size_t>(1, x.size())));
    }
    // Seconds by which the right ear hears it before the left one, by cross-correlation; negative: after.
    double right_leads_s() const {
        const int reach = kSampleRate_hz / 1000;
        const int n = static_cast<int>(left.size());
        double best = -1.0;
        int lag = 0;
        for (int k = -reach; k <= reach; ++k) {
            double sum = 0.0;
            for (int i = reach; i < n - reach; ++i)
                sum += static_cast<double>(right[static_cast<std::size_t>(i)]) * static_cast<double>(left[static_cast<std::size_t>(i + k)]);
            if (sum > best) best = sum, lag = k;
        }
        return static_cast<double>(lag) / kSampleRate_hz;
    }
    std::size_t first_loud(const std::vector<float>& x, std::size_t from = 0, float threshold = 0.003F) const {
        const auto found = std::find_if(x.begin() + static_cast<std::ptrdiff_t>(from), x.end(), [&](float s) { return std::abs(s) > threshold; });
        return static_cast<std::size_t>(found - x.begin());
    }
    static SoundCue cue(SoundKind kind, Vec3 position_m, SoundClass material = SoundClass::Plaster) {
        return {.kind = kind, .material = material, .position_m = position_m, .loudness = 1.0};
    }

    std::shared_ptr<VoiceChannel> voice = std::make_shared<VoiceChannel>();
    std::unique_ptr<OpenALSink> sink;
    double now_s = 5.0;
    std::vector<float> left, right;
};

TEST_F(OpenALSinkTest, silence_is_silent) {
    run(0.05);
    EXPECT_EQ(rms(left), 0.0);
    EXPECT_EQ(rms(right), 0.0);
}

TEST_F(OpenALSinkTest, first_sample_of_a_contact_comes_within_15_ms_of_the_touch_in_stream_time) {
    // The whole way: 200 audio ticks and 187.5 mixing periods a second, each at its own time, and touches at times unrelated to both.
    CuePlanner planner{Settings{}};
    RecordingSpeech speech;
    double tick_s = now_s, mix_s = now_s, worst_s = 0.0;
    for (int touch = 0; touch < 40; ++touch) {
        const double touch_s = std::max(tick_s, mix_s) + 0.0137 * (touch % 7) / 7.0;
        ContactEvent event;
        event.time_s = touch_s;
        event.feature = FeatureId{static_cast<std::uint32_t>(touch)};
        event.speed_m_per_s = 0.1;
        event.position_m = {0.0, 0.4, 0.0};
        forget();
        double stream_s = mix_s;  // of left[0]
        bool told = false;
        for (int i = 0; i < 100; ++i) {
            if (tick_s <= mix_s) {
                std::vector<ContactEvent> events;
                if (!told && tick_s >= touch_s) events.push_back(event), told = true;
                planner.tick({.now_s = tick_s, .contacts = events, .requests = {}, .listener = {}}, *sink, speech);
                tick_s += 0.005;
            } else {
                hear();
                mix_s += kPeriod_s;
            }
        }
        const std::size_t onset = first_loud(left);
        ASSERT_LT(onset, left.size());
        const double latency_s = stream_s + static_cast<double>(onset) / kSampleRate_hz - touch_s;
        EXPECT_GE(latency_s, 0.0);
        worst_s = std::max(worst_s, latency_s);
        for (int i = 0; i < 60; ++i) {  // until it has rung out
            planner.tick({.now_s = tick_s, .contacts = {}, .requests = {}, .listener = {}}, *sink, speech);
            tick_s += kPeriod_s;
            hear();
            mix_s += kPeriod_s;
        }
    }
    EXPECT_LE(worst_s, 0.015);
    std::cout << "    worst contact latency in stream time " << 1e3 * worst_s << " ms\n";
}

TEST_F(OpenALSinkTest, sound_in_the_east_reaches_the_right_ear_first_when_facing_north) {
    sink->set_loop(cue(SoundKind::WallTone, {2.0, 0.0, 0.0}));
    run(0.1);
    forget();
    run(0.3);
    const double lead_s = right_leads_s();
    EXPECT_GT(lead_s, 300e-6);
    EXPECT_LT(lead_s, 900e-6);
    EXPECT_GT(rms(right), 1.5 * rms(left));
}

TEST_F(OpenALSinkTest, turning_round_changes_the_ear_and_the_middle_has_no_lead) {
    sink->set_loop(cue(SoundKind::WallTone, {2.0, 0.0, 0.0}));
    sink->set_listener({.ears_m = {0.0, 0.0, 0.0}, .heading_rad = kPi});
    run(0.1);
    forget();
    run(0.3);
    EXPECT_LT(right_leads_s(), -300e-6);
    sink->set_listener({.ears_m = {0.0, 0.0, 0.0}, .heading_rad = kPi / 2.0});
    run(0.1);
    forget();
    run(0.3);
    EXPECT_NEAR(right_leads_s(), 0.0, 25e-6);
}

TEST_F(OpenALSinkTest, listener_far_from_the_origin_hears_the_same_directions) {
    const Vec3 far_m{90'000.0, -40'000.0, 12.0};
    sink->set_listener({.ears_m = far_m, .heading_rad = 0.0});
    sink->set_loop(cue(SoundKind::WallTone, far_m + Vec3{-2.0, 0.0, 0.0}));
    run(0.1);
    forget();
    run(0.3);
    EXPECT_LT(right_leads_s(), -300e-6);
}

TEST_F(OpenALSinkTest, nearer_sound_is_louder_but_a_far_one_is_still_heard) {
    sink->set_loop(cue(SoundKind::WallTone, {0.0, 1.0, 0.0}));
    run(0.1);
    const double near = rms(listen(0.2));
    sink->set_loop(cue(SoundKind::WallTone, {0.0, 9.0, 0.0}));
    run(0.1);
    const double far = rms(listen(0.2));
    EXPECT_LT(far, 0.6 * near);
    EXPECT_GT(far, 0.2 * near);
}

TEST_F(OpenALSinkTest, stop_all_fades_without_a_click_and_is_silent_within_25_ms) {
    sink->set_loop(cue(SoundKind::WallTone, {0.5, 1.0, 0.0}));
    sink->play(cue(SoundKind::Beep, {}));
    const std::vector<float> before = listen(0.08);
    // A click is curvature that the sound itself does not have.
    const auto sharpest = [](std::span<const float> x) {
        float most = 0.0F;
        for (std::size_t i = 2; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - 2.0F * x[i - 1] + x[i - 2]));
        return most;
    };
    ASSERT_GT(rms(before), 0.01);
    const std::size_t cut = left.size();
    sink->stop_all();
    run(0.06);
    const std::vector<float> across{left.begin() + static_cast<std::ptrdiff_t>(cut) - 4, left.end()};
    EXPECT_LE(sharpest(across), sharpest(before));
    const std::span<const float> rest = std::span(left).subspan(cut + 1200);  // 25 ms
    EXPECT_LT(rms(rest), 1e-5);
    EXPECT_EQ(sink->sounds_playing(), 0);
}

TEST_F(OpenALSinkTest, hard_stop_would_have_clicked) {
    // Shows that the test above can fail: the same sound cut at a sample has far more curvature.
    sink->set_loop(cue(SoundKind::WallTone, {0.5, 1.0, 0.0}));
    std::vector<float> x = listen(0.1);
    float most = 0.0F, cut = 0.0F;
    for (std::size_t i = 2; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - 2.0F * x[i - 1] + x[i - 2]));
    for (std::size_t i = 2400; i < x.size() - 1; ++i) cut = std::max(cut, std::abs(x[i] - x[i - 1]) + std::abs(x[i]));
    EXPECT_GT(cut, 1.5F * most);
}

TEST_F(OpenALSinkTest, at_most_three_sounds_play_and_the_least_important_gives_way) {
    for (int i = 0; i < 6; ++i) {
        sink->play(cue(SoundKind::Footstep, {0.0, 1.0 + i, 0.0}));
        period();
        EXPECT_LE(sink->sounds_playing(), 3);
    }
    sink->set_loop(cue(SoundKind::WallTone, {1.0, 0.0, 0.0}));
    sink->set_loop(cue(SoundKind::Slide, {1.0, 0.0, 0.0}));
    period();
    EXPECT_EQ(sink->sounds_playing(), 3);
    sink->play(cue(SoundKind::Alarm, {}));
    period();
    EXPECT_EQ(sink->sounds_playing(), 3);
    // 10 one-shots at once are more than there are sources.
    for (int i = 0; i < 10; ++i) sink->play(cue(SoundKind::Contact, {0.0, 1.0, 0.0}, SoundClass::Metal));
    period();
    EXPECT_EQ(sink->sounds_playing(), 3);
}

TEST_F(OpenALSinkTest, loop_that_had_to_give_way_comes_back) {
    sink->set_loop(cue(SoundKind::WallTone, {1.0, 0.0, 0.0}));
    run(0.1);
    const double alone = rms(listen(0.1));
    for (int i = 0; i < 3; ++i) sink->play({.kind = SoundKind::Contact, .material = SoundClass::Glass, .position_m = {1.0, 0.0, 0.0}, .loudness = 1e-4});
    run(0.1);
    EXPECT_LT(rms(listen(0.05)), 0.05 * alone);
    run(0.7);
    EXPECT_NEAR(rms(listen(0.1)), alone, 0.2 * alone);
}

TEST_F(OpenALSinkTest, sounds_fall_by_9_db_while_the_voice_speaks_and_alarms_do_not) {
    sink->set_loop(cue(SoundKind::WallTone, {0.0, 1.0, 0.0}));
    run(0.1);
    const double before = rms(listen(1.0));
    const std::vector<std::int16_t> silent_speech(2 * 22050, 0);
    const auto ticket = voice->begin(22050, 1.0);
    voice->append(ticket, silent_speech);
    voice->end(ticket);
    run(0.1);
    const double during = rms(listen(1.0));
    EXPECT_NEAR(20.0 * std::log10(during / before), -9.0, 0.5);
    run(1.5);
    EXPECT_FALSE(voice->playing());
    EXPECT_NEAR(rms(listen(1.0)), before, 0.05 * before);
}

TEST_F(OpenALSinkTest, voice_is_heard_in_both_ears_alike_within_two_periods_and_reports_its_end) {
    std::vector<std::int16_t> tone(4410);
    for (std::size_t i = 0; i < tone.size(); ++i) tone[i] = static_cast<std::int16_t>(8000.0 * std::sin(2.0 * kPi * 500.0 * static_cast<double>(i) / 22050.0));
    run(0.05);
    const std::size_t from = left.size();
    const auto ticket = voice->begin(22050, 1.0);
    EXPECT_TRUE(voice->playing());
    voice->append(ticket, tone);
    run(0.1);
    EXPECT_LE(first_loud(left, from) - from, 2U * kPeriod);
    EXPECT_NEAR(rms(left), rms(right), 0.02 * rms(left));
    run(0.2);
    EXPECT_TRUE(voice->playing()) << "more may come until end()";
    voice->append(ticket, tone);
    voice->end(ticket);
    run(0.1);
    EXPECT_TRUE(voice->playing());
    run(0.2);
    EXPECT_FALSE(voice->playing());
}

TEST_F(OpenALSinkTest, new_utterance_cuts_the_old_one_and_stopping_is_silent_within_25_ms) {
    const std::vector<std::int16_t> loud(48000, 8000), pulse{30000, -30000, 30000, -30000};
    const auto first = voice->begin(48000, 1.0);
    voice->append(first, loud);
    run(0.1);
    const auto second = voice->begin(48000, 1.0);
    EXPECT_TRUE(voice->cut(first));
    EXPECT_FALSE(voice->append(first, loud));
    voice->append(second, pulse);
    voice->end(second);
    run(0.025);
    EXPECT_LT(rms(listen(0.1)), 1e-3);
    EXPECT_FALSE(voice->playing());

    voice->append(voice->begin(48000, 1.0), loud);
    run(0.1);
    voice->stop();
    EXPECT_FALSE(voice->playing());
    run(0.025);
    EXPECT_LT(rms(listen(0.1)), 1e-5);
}

TEST_F(OpenALSinkTest, earcons_are_in_the_middle_wherever_the_body_stands) {
    sink->set_listener({.ears_m = {50.0, -20.0, 1.7}, .heading_rad = 1.0});
    sink->play(cue(SoundKind::Arrived, {}));
    run(0.3);
    EXPECT_NEAR(rms(left), rms(right), 0.02 * rms(left));
    EXPECT_GT(rms(left), 0.02);
}

TEST_F(OpenALSinkTest, same_cues_give_the_same_samples) {
    const auto perform = [&] {
        sink->set_loop(cue(SoundKind::Slide, {1.0, 1.0, 0.0}, SoundClass::Wood));
        sink->play(cue(SoundKind::Contact, {-1.0, 1.0, 0.0}, SoundClass::Tile));
        run(0.2);
        return left;
    };
    const std::vector<float> once = perform();
    sink.reset();
    sink = std::move(*OpenALSink::open(voice, {.output = OpenALSink::Output::OnDemand}));
    forget();
    now_s = 5.0;
    EXPECT_EQ(perform(), once);
}

TEST(OpenALSinkDevice, without_a_sound_device_it_says_so_and_goes_on_at_the_pace_of_time) {
    const auto voice = std::make_shared<VoiceChannel>();
    auto opened = OpenALSink::open(voice, {.device = "a device that is not there"});
    ASSERT_TRUE(opened) << opened.error().sentence();
    OpenALSink& sink = **opened;
    EXPECT_FALSE(sink.has_device());
    EXPECT_EQ(sink.news(), "No sound device was found. Everything that would be spoken is printed as text.");
    EXPECT_EQ(sink.news(), std::nullopt);
    EXPECT_EQ(sink.description(), "There is no sound device; sound is not heard.");
    const std::vector<std::int16_t> second(48000, 1000);
    const auto ticket = voice->begin(48000, 1.0);
    voice->append(ticket, second);
    voice->end(ticket);
    double ended_s = 0.0;
    for (double now_s = 3.0; now_s < 6.0 && ended_s == 0.0; now_s += 0.005) {
        sink.tick(now_s);
        if (!voice->playing()) ended_s = now_s;
    }
    EXPECT_NEAR(ended_s, 4.0, 0.05) << "a second of speech takes a second though nobody hears it";
}

TEST(OpenALSinkDevice, lost_device_is_replaced_and_loops_go_on) {
    if (null_back_end != 0) GTEST_SKIP() << "the environment cannot be set here";
    bool plugged = true;
    const auto voice = std::make_shared<VoiceChannel>();
    auto opened = OpenALSink::open(voice, {.still_connected = [&] { return plugged; }});
    ASSERT_TRUE(opened) << opened.error().sentence();
    OpenALSink& sink = **opened;
    ASSERT_TRUE(sink.has_device()) << "OpenAL has no null back end here";
    EXPECT_EQ(sink.news(), std::nullopt);
    sink.tick(1.0);
    sink.set_loop({.kind = SoundKind::WallTone, .position_m = {1.0, 0.0, 0.0}});
    voice->append(voice->begin(48000, 1.0), std::vector<std::int16_t>(480000, 1000));
    sink.tick(1.1);
    EXPECT_TRUE(voice->playing());
    plugged = false;
    sink.tick(2.0);
    plugged = true;
    const auto said = sink.news();
    ASSERT_TRUE(said);
    EXPECT_THAT(*said, ::testing::StartsWith("The sound device was lost. Sound goes on through "));
    sink.tick(2.1);
    EXPECT_TRUE(sink.has_device());
    EXPECT_EQ(sink.sounds_playing(), 1);
    EXPECT_FALSE(voice->playing()) << "what was being said was lost with the device, so that nobody waits for its end";
    sink.stop_all();
}

TEST(OpenALSinkDevice, device_that_does_not_come_back_is_asked_for_every_5_s) {
    bool plugged = true;
    const auto voice = std::make_shared<VoiceChannel>();
    auto opened = OpenALSink::open(voice, {.device = "No Output", .still_connected = [&] { return plugged; }});
    ASSERT_TRUE(opened) << opened.error().sentence();
    OpenALSink& sink = **opened;
    ASSERT_TRUE(sink.has_device());
    sink.tick(1.0);
    plugged = false;
    sink.tick(2.0);  // lost, and the same one opened again; still reported as lost
    for (double now_s = 2.0; now_s < 30.0; now_s += 0.25) sink.tick(now_s);
    EXPECT_TRUE(sink.news());
    plugged = true;
    for (double now_s = 30.0; now_s < 40.0; now_s += 0.25) sink.tick(now_s);
    EXPECT_TRUE(sink.has_device());
}

}  // namespace
}  // namespace handrail
