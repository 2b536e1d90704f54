#include "audio-cues/sinks/openal_sink.h"

#include <AL/alc.h>
#include <AL/alext.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "audio-cues/plan/cue_planner.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "audio-cues/sinks/synth.h"
#include "tests/support/names.h"

namespace handrail {
namespace openal_sink_test {

constexpr int kPeriod = 256;
constexpr double kPeriod_s = static_cast<double>(kPeriod) / kSampleRate_hz;
// Any sound above this level is audible. OpenAL Soft 1.24 renders sounds up to 4 dB quieter than 1.19.
constexpr double kHeard = 0.0015;

// The driver must be set before the first use of OpenAL, which reads its configuration once per process. The null back
// end is a playback device that needs no sound card.
const int null_back_end = ::setenv("ALSOFT_DRIVERS", "null", 1);

// The sink on a loopback device. The tests tick and render it period by period in virtual time. Keeps everything that
// both ears heard.
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
    // Plays for `seconds` and returns what the left ear heard in that time.
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
    // Returns by how many seconds the right ear hears the sound before the left ear; negative if the right ear hears it
    // later. Uses the cross-correlation.
    double right_leads_s() const {
        const int reach = kSampleRate_hz / 1000;
        const int n = static_cast<int>(left.size());
        double best = -1.0;
        int lag = 0;
        for (int k = -reach; k <= reach; ++k) {
            double sum = 0.0;
            for (int i = reach; i < n - reach; ++i)
                sum += static_cast<double>(right[static_cast<std::size_t>(i)]) *
                       static_cast<double>(left[static_cast<std::size_t>(i + k)]);
            if (sum > best) best = sum, lag = k;
        }
        return static_cast<double>(lag) / kSampleRate_hz;
    }
    std::size_t first_loud(const std::vector<float>& x, std::size_t from = 0, float threshold = 0.003F) const {
        const auto found = std::find_if(x.begin() + static_cast<std::ptrdiff_t>(from), x.end(),
                                        [&](float s) { return std::abs(s) > threshold; });
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

TEST_F(OpenALSinkTest, no_cue_gives_no_sound) {
    run(0.05);
    EXPECT_EQ(rms(left), 0.0);
    EXPECT_EQ(rms(right), 0.0);
}

TEST_F(OpenALSinkTest, the_first_sample_of_a_contact_comes_within_15_ms_of_the_touch_in_stream_time) {
    // Tests the whole chain. The 200 audio ticks and 187.5 mixing periods a second each have their own clock, and the
    // touches happen at unrelated times.
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
        double stream_s = mix_s;  // time of left[0]
        bool reported = false;
        for (int i = 0; i < 100; ++i) {
            if (tick_s <= mix_s) {
                std::vector<ContactEvent> events;
                if (!reported && tick_s >= touch_s) events.push_back(event), reported = true;
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
        for (int i = 0; i < 60; ++i) {  // waits until the sound has died away
            planner.tick({.now_s = tick_s, .contacts = {}, .requests = {}, .listener = {}}, *sink, speech);
            tick_s += kPeriod_s;
            hear();
            mix_s += kPeriod_s;
        }
    }
    EXPECT_LE(worst_s, 0.015);
    std::cout << "    worst contact latency in stream time " << 1e3 * worst_s << " ms\n";
}

TEST_F(OpenALSinkTest, a_sound_in_the_east_reaches_the_right_ear_first_when_facing_north) {
    sink->set_loop(cue(SoundKind::WallTone, {2.0, 0.0, 0.0}));
    run(0.1);
    forget();
    run(0.3);
    const double lead_s = right_leads_s();
    EXPECT_GT(lead_s, 300e-6);
    EXPECT_LT(lead_s, 900e-6);
    EXPECT_GT(rms(right), 1.5 * rms(left));
}

TEST_F(OpenALSinkTest, swapped_sides_exchange_the_ears_at_once) {
    for (const bool swapped : {false, true}) {
        Settings::Sound settings;
        settings.swap_sides = swapped;
        sink->set_sound(settings);
        forget();
        sink->play(cue(SoundKind::Bell, {-1.5, 0.0, 0.0}));
        run(1.2);
        EXPECT_GT(rms(swapped ? right : left), 1.5 * rms(swapped ? left : right));
    }
}

TEST_F(OpenALSinkTest, turning_round_swaps_the_ears_and_a_centred_sound_leads_in_neither) {
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

TEST_F(OpenALSinkTest, a_listener_far_from_the_origin_hears_the_same_directions) {
    const Vec3 far_m{90'000.0, -40'000.0, 12.0};
    sink->set_listener({.ears_m = far_m, .heading_rad = 0.0});
    sink->set_loop(cue(SoundKind::WallTone, far_m + Vec3{-2.0, 0.0, 0.0}));
    run(0.1);
    forget();
    run(0.3);
    EXPECT_LT(right_leads_s(), -300e-6);
}

TEST_F(OpenALSinkTest, a_nearer_sound_is_louder_but_a_far_one_is_still_heard) {
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
    // A click would show as a curvature that the sound itself does not have.
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
    const std::span<const float> rest = std::span(left).subspan(cut + 1200);  // from 25 ms after the stop
    EXPECT_LT(rms(rest), 1e-5);
    EXPECT_EQ(sink->sounds_playing(), 0);
}

TEST_F(OpenALSinkTest, an_abrupt_stop_would_click) {
    // The same sound has far more curvature if it is cut between two samples. So the check above can fail.
    sink->set_loop(cue(SoundKind::WallTone, {0.5, 1.0, 0.0}));
    std::vector<float> x = listen(0.1);
    float most = 0.0F, cut = 0.0F;
    for (std::size_t i = 2; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - 2.0F * x[i - 1] + x[i - 2]));
    for (std::size_t i = 2400; i < x.size() - 1; ++i) cut = std::max(cut, std::abs(x[i] - x[i - 1]) + std::abs(x[i]));
    EXPECT_GT(cut, 1.5F * most);
}

TEST_F(OpenALSinkTest, plays_at_most_three_sounds_and_drops_the_least_important) {
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
    // Plays 10 sounds at once, which are more than the sink has sources.
    for (int i = 0; i < 10; ++i) sink->play(cue(SoundKind::Contact, {0.0, 1.0, 0.0}, SoundClass::Metal));
    period();
    EXPECT_EQ(sink->sounds_playing(), 3);
}

TEST_F(OpenALSinkTest, a_loop_that_had_to_give_way_comes_back) {
    sink->set_loop(cue(SoundKind::WallTone, {1.0, 0.0, 0.0}));
    run(0.1);
    const double alone = rms(listen(0.1));
    for (int i = 0; i < 3; ++i)
        sink->play({.kind = SoundKind::Contact,
                    .material = SoundClass::Glass,
                    .position_m = {1.0, 0.0, 0.0},
                    .loudness = 1e-4});
    run(0.1);
    EXPECT_LT(rms(listen(0.05)), 0.05 * alone);
    run(0.7);
    EXPECT_NEAR(rms(listen(0.1)), alone, 0.2 * alone);
}

// Returns the energy of a signal between two frequencies in dB, relative to an arbitrary reference. Uses Goertzel's
// algorithm on frames of 20 ms.
double band_db(std::span<const float> x, double from_hz, double to_hz) {
    constexpr std::size_t kFrame = 960;
    double sum = 0.0;
    for (double hz = from_hz; hz <= to_hz; hz += 50.0) {
        const double c = 2.0 * std::cos(2.0 * kPi * hz / kSampleRate_hz);
        for (std::size_t at = 0; at + kFrame <= x.size(); at += kFrame) {
            double s1 = 0.0, s2 = 0.0;
            for (std::size_t i = 0; i < kFrame; ++i) {
                const double window = 0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(i) / kFrame);
                const double s0 = window * static_cast<double>(x[at + i]) + c * s1 - s2;
                s2 = s1;
                s1 = s0;
            }
            sum += s1 * s1 + s2 * s2 - c * s1 * s2;
        }
    }
    return 10.0 * std::log10(sum + 1e-30);
}

TEST_F(OpenALSinkTest, a_closed_door_takes_at_least_12_db_and_more_of_the_high_tones) {
    SoundCue rain = cue(SoundKind::Rain, {0.0, 3.0, 0.0});  // rain is broadband, and steady over seconds
    sink->set_loop(rain);
    run(1.0);
    const std::vector<float> open = listen(4.0);
    rain.muffled_db = 14.0;
    sink->set_loop(rain);
    run(4.0);
    const std::vector<float> closed = listen(4.0);
    const double all_db = 20.0 * std::log10(rms(open) / rms(closed));
    const double low_db = band_db(open, 200.0, 800.0) - band_db(closed, 200.0, 800.0);
    const double high_db = band_db(open, 6000.0, 12000.0) - band_db(closed, 6000.0, 12000.0);
    EXPECT_GE(all_db, 12.0);
    EXPECT_GE(low_db, 12.0);
    EXPECT_GE(high_db, low_db + 10.0);
    std::cout << "    a closed door takes " << all_db << " dB, " << low_db << " dB at 0.2 to 0.8 kHz, " << high_db
              << " dB at 6 to 12 kHz\n";
    rain.muffled_db = 0.0;
    sink->set_loop(rain);
    run(4.0);
    EXPECT_NEAR(20.0 * std::log10(rms(listen(4.0)) / rms(open)), 0.0, 0.5) << "the door is open again";
}

TEST_F(OpenALSinkTest, world_sounds_give_way_to_the_walkers_own_sounds_without_pumping) {
    for (std::uint32_t i = 0; i < 3; ++i) {
        SoundCue lamp = cue(SoundKind::Buzz, {2.0 + i, 0.0, 0.0});
        lamp.source = i;
        sink->set_loop(lamp);
    }
    run(0.5);
    EXPECT_EQ(sink->sounds_playing(), 3);
    // A step sounds every 0.6 s. At the first step, the quietest lamp must fall silent, and it must not come back
    // between the steps.
    int changes = 0, before = -1;
    for (int step = 0; step < 8; ++step) {
        sink->play(cue(SoundKind::Footstep, {0.0, 0.0, -1.6}));
        for (int i = 0; i < 112; ++i) {
            period();
            EXPECT_LE(sink->sounds_playing(), 3);
        }
        const int now = sink->sounds_playing();  // by now, the sound of the step has died away
        if (now != before) ++changes;
        before = now;
    }
    EXPECT_EQ(before, 2);
    EXPECT_EQ(changes, 1);
    run(2.0);
    EXPECT_EQ(sink->sounds_playing(), 3) << "it comes back when there is room for longer";
}

TEST_F(OpenALSinkTest, world_sounds_that_are_left_fade_and_make_room_for_others) {
    for (std::uint32_t round = 0; round < 12; ++round) {
        SoundCue fire = cue(SoundKind::Fire, {2.0, 0.0, 0.0});
        fire.source = round;
        sink->set_loop(fire);
        run(0.4);
        EXPECT_EQ(sink->sounds_playing(), 1);
        fire.loudness = 0.0;
        sink->set_loop(fire);
        EXPECT_EQ(sink->sounds_playing(), 0);
    }
    run(0.5);
    EXPECT_LT(rms(listen(0.1)), 1e-6);
}

// Returns the samples after a low-pass filter at `edge_hz` with twelve decibels an octave. The filter is the same for
// both ears.
std::vector<double> low_passed(std::span<const float> x, double edge_hz) {
    const double a = 1.0 - std::exp(-2.0 * kPi * edge_hz / kSampleRate_hz);
    std::vector<double> y(x.size());
    double one = 0.0, two = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = two += a * ((one += a * (static_cast<double>(x[i]) - one)) - two);
    return y;
}

// Returns by how many seconds the right ear hears the sound before the left one, below 1.5 kHz. A parabola through the
// peak of the cross-correlation gives values between samples.
double interaural_s(std::span<const float> left, std::span<const float> right) {
    const std::vector<double> l = low_passed(left, 1500.0), r = low_passed(right, 1500.0);
    constexpr int kReach = 56;
    std::vector<double> sums;
    for (int k = -kReach; k <= kReach; ++k) {
        double sum = 0.0;
        for (std::size_t i = kReach; i + kReach < l.size(); ++i)
            sum += r[i] * l[static_cast<std::size_t>(static_cast<int>(i) + k)];
        sums.push_back(sum);
    }
    const auto peak = std::max_element(sums.begin() + 1, sums.end() - 1);
    const double before = *(peak - 1), at = *peak, after = *(peak + 1);
    return (static_cast<double>(peak - sums.begin()) - kReach + 0.5 * (before - after) / (before - 2.0 * at + after)) /
           kSampleRate_hz;
}

// Returns OpenAL's name of the HRTF data set with which it renders.
std::string hrtf_name() {
    const ALCchar* name = alcGetString(alcGetContextsDevice(alcGetCurrentContext()), ALC_HRTF_SPECIFIER_SOFT);
    return name != nullptr ? name : "";
}

TEST_F(OpenALSinkTest, the_time_difference_between_the_ears_matches_a_sphere_and_is_mirrored) {
    // The data set of OpenAL Soft 1.19 (default-48000) follows a sphere. Version 1.24 has a different one (Default
    // HRTF). Its delays jump between directions that are 5 degrees apart: by 172 us at 35 degrees, 224 us at 80, and
    // 282 us at 135.
    const bool jumps = hrtf_name().find("Default HRTF") != std::string::npos;
    const double most_s = jumps ? 240e-6 : 100e-6, most_mirror_s = jumps ? 30e-6 : 10e-6;
    // Woodworth's formula for a head that is a sphere of 8.75 cm radius, with sound at 343 m/s. A sound behind gives
    // the same result as one ahead.
    const auto sphere_s = [](double azimuth_rad) {
        const double side = std::asin(std::sin(azimuth_rad));
        return 0.0875 / 343.0 * (side + std::sin(side));
    };
    sink->set_sound({.behind = false, .height = false});
    double worst_s = 0.0, worst_mirror_s = 0.0;
    for (int degrees = 0; degrees <= 180; degrees += 15) {
        double heard_s[2];
        for (const int side : {0, 1}) {
            const double azimuth = radians_from_degrees(side == 0 ? degrees : -degrees);
            sink->set_loop(cue(SoundKind::Rain, 2.0 * forward_of_heading(azimuth)));
            run(0.4);
            forget();
            run(0.5);
            heard_s[side] = interaural_s(left, right);
            worst_s = std::max(worst_s, std::abs(heard_s[side] - sphere_s(azimuth)));
            EXPECT_NEAR(heard_s[side], sphere_s(azimuth), most_s) << degrees << (side == 0 ? " right" : " left");
        }
        worst_mirror_s = std::max(worst_mirror_s, std::abs(heard_s[0] + heard_s[1]));
        EXPECT_NEAR(heard_s[0], -heard_s[1], most_mirror_s) << degrees;
    }
    std::cout << "    " << hrtf_name() << ": worst distance from the sphere " << 1e6 * worst_s
              << " us, from the mirror " << 1e6 * worst_mirror_s << " us\n";
}

TEST_F(OpenALSinkTest, the_reverberation_time_of_a_room_is_correct_within_10_percent) {
    sink->set_sound({.reverberation = 1.0});
    for (const double wanted_s : {0.3, 0.6, 1.0, 2.0, 4.0}) {
        sink->set_listener({.ears_m = {0.0, 0.0, 0.0}, .heading_rad = 0.0, .reverberation_s = wanted_s});
        run(wanted_s + 1.0);  // waits until the room has changed and older sounds in it have died away
        // Schroeder's method: the remaining energy in dB falls along a line. A least-squares fit between -5 and -25 dB
        // gives its slope. Three knocks of different colour at both ears are combined, as in measurements of halls,
        // because each knock excites only a few of the room's modes.
        std::vector<double> to_come(static_cast<std::size_t>((0.7 * wanted_s + 0.2) * kSampleRate_hz));
        for (const SoundClass knock : {SoundClass::Brick, SoundClass::Concrete, SoundClass::Stone}) {
            sink->play(cue(SoundKind::Contact, {0.0, 1.0, 0.0}, knock));
            run(0.13);  // the longest knock sounds for 105 ms
            forget();
            run(0.7 * wanted_s + 0.2);
            double energy = 0.0;
            for (std::size_t i = to_come.size(); i-- > 0;) {
                energy += static_cast<double>(left[i]) * static_cast<double>(left[i]) +
                          static_cast<double>(right[i]) * static_cast<double>(right[i]);
                to_come[i] += energy;
            }
            run(wanted_s);
        }
        const double energy = to_come.front();
        ASSERT_GT(energy, 1e-9) << wanted_s;
        double n = 0.0, st = 0.0, sd = 0.0, stt = 0.0, std_ = 0.0;
        for (std::size_t i = 0; i < to_come.size(); ++i) {
            const double db = 10.0 * std::log10(to_come[i] / energy + 1e-30),
                         t = static_cast<double>(i) / kSampleRate_hz;
            if (db > -5.0 || db < -25.0) continue;
            n += 1.0, st += t, sd += db, stt += t * t, std_ += t * db;
        }
        const double slope = (n * std_ - st * sd) / (n * stt - st * st);
        EXPECT_NEAR(-60.0 / slope, wanted_s, 0.1 * wanted_s);
        std::cout << "    wanted " << wanted_s << " s, reverberates " << -60.0 / slope << " s\n";
    }
}

TEST_F(OpenALSinkTest, reverberation_is_weak_leaves_earcons_dry_and_stops_with_everything) {
    const auto after_a_knock = [&](Settings::Sound settings, SoundKind kind) {
        sink->set_sound(settings);
        sink->set_listener({.ears_m = {0.0, 0.0, 0.0}, .heading_rad = 0.0, .reverberation_s = 2.0});
        run(3.0);
        sink->play(cue(kind, {0.0, 1.0, 0.0}, SoundClass::Concrete));
        const double knock = rms(listen(0.1));
        return rms(listen(0.3)) / knock;
    };
    EXPECT_LT(after_a_knock({.reverberation = 0.0}, SoundKind::Contact), 1e-4);
    const double plain = after_a_knock({}, SoundKind::Contact);
    EXPECT_GT(plain, 0.001);
    EXPECT_LT(plain, 0.3);
    EXPECT_LT(after_a_knock({}, SoundKind::TurnTick), 1e-4);
    sink->play(cue(SoundKind::Contact, {0.0, 1.0, 0.0}, SoundClass::Concrete));
    run(0.1);
    sink->stop_all();
    run(0.03);
    EXPECT_LT(rms(listen(0.2)), 1e-5) << "F12 ends the echo too";
}

// Returns the largest difference between two neighbouring samples.
float largest_step(std::span<const float> x) {
    float most = 0.0F;
    for (std::size_t i = 1; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - x[i - 1]));
    return most;
}

TEST_F(OpenALSinkTest, cutting_any_sound_short_makes_no_step_above_a_hundredth_of_full_scale) {
    constexpr float kNoClick =
        // More than the largest step within the sounds; a sound that is cut between two samples gives a step of up to
        // 0.15.
        0.002F;
    const auto quiet_after = [&](const char* what, auto begin, auto cut) {
        for (int phase = 0; phase < 7; ++phase) {
            begin();
            run(0.3 + 0.0011 * phase);
            const float own = largest_step(std::span(left).last(4800));
            const std::size_t from = left.size() - 2;
            ASSERT_GT(rms(std::span(left).last(4800)), kHeard) << what;
            cut();
            run(0.1);
            EXPECT_LE(largest_step(std::span(left).subspan(from)), own + kNoClick) << what << ", phase " << phase;
            sink->stop_all();
            voice->stop();
            run(0.5);
        }
    };
    std::vector<std::int16_t> tone(96000);
    for (std::size_t i = 0; i < tone.size(); ++i)
        tone[i] = static_cast<std::int16_t>(9000.0 * std::sin(2.0 * kPi * 187.0 * static_cast<double>(i) / 48000.0));
    const auto speak = [&] { voice->append(voice->begin(48000, 1.0), tone); };
    const auto hum = [&](double loudness) {
        SoundCue loop = cue(SoundKind::Drone, {0.5, 0.5, 0.0});
        loop.loudness = loudness;
        sink->set_loop(loop);
    };
    quiet_after("speech stopped", speak, [&] { voice->stop(); });
    quiet_after("speech replaced by silence", speak,
                [&] { voice->append(voice->begin(48000, 1.0), std::vector<std::int16_t>(4800)); });
    quiet_after(
        "a sound of the world stopped", [&] { hum(1.0); }, [&] { hum(0.0); });
    quiet_after(
        "everything stopped", [&] { hum(1.0); }, [&] { sink->stop_all(); });
    quiet_after(
        "a sound of the world muffled by a wall", [&] { hum(1.0); },
        [&] {
            SoundCue loop = cue(SoundKind::Drone, {0.5, 0.5, 0.0});
            loop.muffled_db = 24.0;
            sink->set_loop(loop);
        });
    quiet_after(
        "a ringing thing displaced",
        [&] {
            sink->play(cue(SoundKind::Bump, {0.0, 1.0, 0.0}, SoundClass::Metal));
            hum(1.0);
        },
        [&] {
            for (int i = 0; i < 3; ++i) sink->play({.kind = SoundKind::Arrived, .loudness = 1e-5});
        });
}

TEST_F(OpenALSinkTest, a_sound_behind_flutters_but_not_one_ahead_or_with_the_option_off) {
    // Returns how strongly the loudness varies at 9 Hz, relative to its mean. The loudness is measured in frames of 10
    // ms.
    const auto flutter = [&](double y_m, bool on) {
        sink->set_sound({.reverberation = 0.0, .behind = on, .height = on});
        sink->set_loop(cue(SoundKind::Rain, {0.0, y_m, 0.0}));
        run(0.6);
        const std::vector<float> x = listen(2.0);
        double mean = 0.0, c = 0.0, s = 0.0;
        for (std::size_t i = 0; i + 480 <= x.size(); i += 480) {
            const double level = rms(std::span(x).subspan(i, 480)),
                         angle = 2.0 * kPi * 9.0 * static_cast<double>(i) / kSampleRate_hz;
            mean += level;
            c += level * std::cos(angle);
            s += level * std::sin(angle);
        }
        return 2.0 * std::hypot(c, s) / mean;
    };
    const double behind = flutter(-3.0, true);
    EXPECT_GT(behind, 0.3);
    EXPECT_LT(flutter(3.0, true), 0.25 * behind);
    EXPECT_LT(flutter(-3.0, false), 0.25 * behind);
}

TEST_F(OpenALSinkTest, in_mono_both_ears_hear_the_same_and_the_wall_tone_gives_distance_by_rhythm) {
    sink->set_sound({.mono = true});
    SoundCue tone = cue(SoundKind::WallTone, {2.0, 0.0, 0.0});
    // Returns the number of swells in two seconds: how often the loudness rises through its middle value. The loudness
    // is measured in frames of 10 ms.
    const auto swells = [&](double pulses_per_s) {
        tone.pulses_per_s = pulses_per_s;
        sink->set_loop(tone);
        run(0.2);
        forget();
        run(2.0);
        EXPECT_NEAR(rms(left), rms(right), 0.02 * rms(left));
        const double middle = 0.8 * rms(left);
        int count = 0;
        bool up = true;
        for (std::size_t i = 0; i + 480 <= left.size(); i += 480) {
            const double level = rms(std::span(left).subspan(i, 480));
            if (!up && level > middle) ++count, up = true;
            else if (up && level < 0.6 * middle) up = false;
        }
        return count;
    };
    EXPECT_NEAR(swells(1.5), 3, 1);
    EXPECT_NEAR(swells(6.0), 12, 1);
}

TEST_F(OpenALSinkTest, sounds_also_become_quieter_for_an_external_voice) {
    sink->set_loop(cue(SoundKind::WallTone, {0.0, 1.0, 0.0}));
    run(0.1);
    const double before = rms(listen(1.0));
    sink->set_speaking(true);
    run(0.1);
    EXPECT_NEAR(20.0 * std::log10(rms(listen(1.0)) / before), -9.0, 0.5);
    sink->set_speaking(false);
    run(0.5);
    EXPECT_NEAR(rms(listen(1.0)), before, 0.05 * before);
}

TEST_F(OpenALSinkTest, sounds_fall_by_9_db_while_the_voice_speaks_and_danger_does_not) {
    sink->set_loop(cue(SoundKind::WallTone, {0.0, 1.0, 0.0}));
    run(0.1);
    const double before = rms(listen(1.0));
    const auto danger = [&](SoundKind kind) {
        sink->stop_all();
        run(0.1);
        sink->play(cue(kind, {0.0, 1.0, 0.0}));
        const double loud = rms(listen(0.3));
        run(0.5);
        sink->set_loop(cue(SoundKind::WallTone, {0.0, 1.0, 0.0}));
        return loud;
    };
    const double drop = danger(SoundKind::DropNear), alarm = danger(SoundKind::Alarm);
    const std::vector<std::int16_t> silent_speech(6 * 22050, 0);
    const auto ticket = voice->begin(22050, 1.0);
    voice->append(ticket, silent_speech);
    voice->end(ticket);
    run(0.1);
    const double during = rms(listen(1.0));
    EXPECT_NEAR(20.0 * std::log10(during / before), -9.0, 0.5);
    EXPECT_NEAR(danger(SoundKind::DropNear), drop, 0.05 * drop);
    EXPECT_NEAR(danger(SoundKind::Alarm), alarm, 0.05 * alarm);
    ASSERT_TRUE(voice->playing());
    run(4.0);
    EXPECT_FALSE(voice->playing());
    EXPECT_NEAR(rms(listen(1.0)), before, 0.05 * before);
}

TEST_F(OpenALSinkTest, the_voice_is_equal_in_both_ears_within_two_periods_and_reports_its_end) {
    std::vector<std::int16_t> tone(4410);
    for (std::size_t i = 0; i < tone.size(); ++i)
        tone[i] = static_cast<std::int16_t>(8000.0 * std::sin(2.0 * kPi * 500.0 * static_cast<double>(i) / 22050.0));
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

TEST_F(OpenALSinkTest, a_new_utterance_interrupts_the_old_one_and_stopping_is_silent_within_25_ms) {
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

TEST_F(OpenALSinkTest, earcons_are_in_the_middle_at_any_body_position) {
    sink->set_listener({.ears_m = {50.0, -20.0, 1.7}, .heading_rad = 1.0});
    sink->play(cue(SoundKind::Arrived, {}));
    run(0.3);
    EXPECT_NEAR(rms(left), rms(right), 0.02 * rms(left));
    EXPECT_GT(rms(left), 2.0 * kHeard);
}

TEST_F(OpenALSinkTest, identical_cues_give_identical_samples) {
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

TEST(OpenALSinkDevice, absence_is_reported_and_the_sink_continues_in_real_time) {
    const auto voice = std::make_shared<VoiceChannel>();
    auto opened = OpenALSink::open(voice, {.device = "a device that is not there"});
    ASSERT_TRUE(opened) << opened.error().sentence();
    OpenALSink& sink = **opened;
    EXPECT_FALSE(sink.has_device());
    EXPECT_EQ(sink.news(), std::nullopt) << "it does not matter yet";
    sink.play({.kind = SoundKind::Footstep});
    EXPECT_EQ(sink.news(), std::nullopt);
    sink.play({.kind = SoundKind::Beacon});
    EXPECT_EQ(sink.news(), "No sound device was found. Everything that would be spoken is printed as text.");
    EXPECT_EQ(sink.news(), std::nullopt);
    EXPECT_EQ(sink.description(), "There is no sound device, so you hear no sound.");
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

TEST(OpenALSinkDevice, is_replaced_after_its_loss_and_loops_continue) {
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
    EXPECT_THAT(*said, ::testing::StartsWith("The sound device was lost. Sound continues through "));
    sink.tick(2.1);
    EXPECT_TRUE(sink.has_device());
    EXPECT_EQ(sink.sounds_playing(), 1);
    EXPECT_FALSE(voice->playing()) << "what was being said was lost with the device, so that nobody waits for its end";
    sink.stop_all();
}

TEST(OpenALSinkDevice, is_requested_again_every_5_s_if_it_does_not_return) {
    bool plugged = true;
    const auto voice = std::make_shared<VoiceChannel>();
    auto opened = OpenALSink::open(voice, {.device = "No Output", .still_connected = [&] { return plugged; }});
    ASSERT_TRUE(opened) << opened.error().sentence();
    OpenALSink& sink = **opened;
    ASSERT_TRUE(sink.has_device());
    sink.tick(1.0);
    plugged = false;
    sink.tick(2.0);  // the sink loses the device and opens the same device again, which still reports that it is lost
    for (double now_s = 2.0; now_s < 30.0; now_s += 0.25) sink.tick(now_s);
    EXPECT_TRUE(sink.news());
    plugged = true;
    for (double now_s = 30.0; now_s < 40.0; now_s += 0.25) sink.tick(now_s);
    EXPECT_TRUE(sink.has_device());
}

}  // namespace openal_sink_test
}  // namespace handrail
