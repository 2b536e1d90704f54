// Measures with libebur128 how loud each sound is. Checks the order of the ranks, the table in docs, the true peaks of
// mixes, and how the beacon differs between the ears.
#include "audio-cues/sinks/loudness.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <fstream>
#include <map>

#include "audio-cues/plan/sound_rank.h"
#include "audio-cues/plan/sound_table.h"
#include "audio-cues/sinks/openal_sink.h"
#include "audio-cues/sinks/synth.h"
#include "tests/support/loudness_meter.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/vec.h"

namespace handrail {
namespace loudness_test {

using test::Measured;
using test::measured;

// Returns the loudness of a sound in LUFS, at the volume of a new settings file.
double lufs_of(SoundKind kind, SoundClass material) {
    std::vector<float> samples = levelled_sound(kind, material);
    const double volume = Settings::Sound{}.*info(kind).volume;
    for (float& s : samples) s *= static_cast<float>(volume);
    return measured(samples, 1).lufs;
}

struct Row {
    double quietest = 0.0, loudest = -120.0;
};

std::map<SoundKind, Row> all_sounds() {
    std::map<SoundKind, Row> rows;
    for (const SoundInfo& sound : sound_table())
        for (int m = 0; m < kSoundClasses; ++m) {
            const double lufs = lufs_of(sound.kind, static_cast<SoundClass>(m));
            Row& row = rows[sound.kind];
            row.quietest = std::min(row.quietest, lufs);
            row.loudest = std::max(row.loudest, lufs);
            if (!varies_by_material(sound.kind)) break;
        }
    return rows;
}

std::string table_of(const std::map<SoundKind, Row>& rows) {
    std::string text = "| Sound | Class | Loudness (LUFS) |\n|---|---|---|\n";
    for (int rank = 0; rank < kSoundRanks; ++rank)
        for (const auto& [kind, row] : rows)
            if (rank_of(kind) == static_cast<SoundRank>(rank))
                text += fmt::format("| {} | {} | {:.1f} |\n", info(kind).name, rank_name(rank_of(kind)), row.loudest);
    return text;
}

TEST(Loudness, is_measured_as_libebur128_measures_it) {
    for (const SoundKind kind : {SoundKind::Alarm, SoundKind::Bump, SoundKind::Rain, SoundKind::Click}) {
        const std::vector<float> samples = synthesise(kind, SoundClass::Wood);
        EXPECT_NEAR(momentary_lufs(samples), measured(samples, 1).lufs, 0.3) << info(kind).name;
    }
    EXPECT_EQ(momentary_lufs(std::vector<float>(4800)), -120.0);
}

TEST(Loudness, follows_the_order_of_importance_and_danger_stands_out_by_3_units) {
    const std::map<SoundKind, Row> rows = all_sounds();
    std::array<Row, kSoundRanks> ranks{};
    for (const auto& [kind, row] : rows) {
        Row& rank = ranks.at(static_cast<std::size_t>(rank_of(kind)));
        rank.quietest = std::min(rank.quietest, row.loudest);
        rank.loudest = std::max(rank.loudest, row.loudest);
    }
    for (std::size_t rank = 0; rank + 1 < ranks.size(); ++rank)
        EXPECT_GE(ranks[rank].quietest, ranks[rank + 1].loudest + (rank == 0 ? 3.0 : 1.0))
            << rank_name(static_cast<SoundRank>(rank)) << '\n'
            << table_of(rows);
}

TEST(Loudness, of_every_sound_is_in_the_results) {
    const std::filesystem::path file = test::project_root() / "docs" / "results" / "sound-and-speech.md";
    const std::string begin = "<!-- loudness -->\n", end = "\nMeasured ";
    std::string page = test::content_of(file);
    const std::size_t from = page.find(begin), to = page.find(end, from);
    ASSERT_TRUE(from != std::string::npos && to != std::string::npos && from < to);
    const std::string shown = page.substr(from + begin.size(), to - from - begin.size()), now = table_of(all_sounds());
    if (const char* write = std::getenv("HANDRAIL_WRITE_TRANSCRIPTS"); write && *write) {
        std::ofstream(file) << page.replace(from + begin.size(), shown.size(), now);
        GTEST_SKIP() << "written to " << file.filename();
    }
    EXPECT_EQ(shown, now) << "HANDRAIL_WRITE_TRANSCRIPTS=1 writes it anew; read what has changed";
}

// Plays all of `cues` at once, together with a voice if `voice_hz` is not zero. Returns what both ears hear, left and
// right samples in turn.
std::vector<float> heard(const std::vector<SoundCue>& cues, double seconds = 0.6, int voice_hz = 0) {
    auto voice = std::make_shared<VoiceChannel>();
    auto sink = OpenALSink::open(voice, {.output = OpenALSink::Output::OnDemand});
    if (!sink) throw std::runtime_error(sink.error().sentence());
    if (voice_hz > 0) {
        // The voice is at full scale, as loud as a voice can be.
        std::vector<std::int16_t> speech(22050);
        for (std::size_t i = 0; i < speech.size(); ++i)
            speech[i] =
                static_cast<std::int16_t>(32000.0 * std::sin(2.0 * kPi * voice_hz * static_cast<double>(i) / 22050.0));
        const auto ticket = voice->begin(22050, 1.0);
        voice->append(ticket, speech);
        voice->end(ticket);
    }
    std::vector<float> both;
    double now_s = 1.0;
    const auto run = [&](double until_s) {
        for (; now_s < until_s; now_s += 256.0 / kSampleRate_hz) {
            (*sink)->tick(now_s);
            const auto mix = (*sink)->render(256);
            both.insert(both.end(), mix.begin(), mix.end());
        }
    };
    run(1.1);
    for (const SoundCue& cue : cues) (*sink)->play(cue);
    run(1.1 + seconds);
    return both;
}

SoundCue cue_at(SoundKind kind, const Vec3& place_m, SoundClass material = SoundClass::Wood) {
    return {
        .kind = kind, .material = material, .position_m = place_m, .loudness = Settings::Sound{}.*info(kind).volume};
}

TEST(Loudness, true_peak_of_the_worst_mixes_stays_3_db_below_full_scale) {
    for (const Vec3& place : {Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(-0.7, 0.7, 0.0)})
        for (const int voice_hz : {0, 180}) {
            const std::vector<float> mix = heard(
                {cue_at(SoundKind::Alarm, place), cue_at(SoundKind::DropNear, place), cue_at(SoundKind::Bump, place)},
                0.6, voice_hz);
            const Measured all = measured(mix, 2);
            std::cout << "    " << all.true_peak_db << " dB true peak, " << all.lufs << " LUFS\n";
            EXPECT_LT(all.true_peak_db, -3.0) << "with a voice: " << voice_hz;
        }
}

// The alerts about a device must not be louder than the mix allows, nor any other sound.
TEST(Loudness, true_peak_of_every_single_sound_stays_3_db_below_full_scale) {
    auto sink = OpenALSink::open(std::make_shared<VoiceChannel>(), {.output = OpenALSink::Output::OnDemand});
    ASSERT_TRUE(sink) << sink.error().sentence();
    double now_s = 1.0;
    const auto run = [&](double seconds) {
        std::vector<float> both;
        for (const double until_s = now_s + seconds; now_s < until_s; now_s += 256.0 / kSampleRate_hz) {
            (*sink)->tick(now_s);
            const auto mix = (*sink)->render(256);
            both.insert(both.end(), mix.begin(), mix.end());
        }
        return both;
    };
    for (const SoundInfo& sound : sound_table()) {
        const bool loop =
            is_world_sound(sound.kind) || sound.kind == SoundKind::Slide || sound.kind == SoundKind::WallTone;
        SoundCue cue = cue_at(sound.kind, {0.7, 0.7, 0.0});
        cue.loudness = 1.0;  // the person may have set the volume to its maximum
        if (loop) (*sink)->set_loop(cue);
        else (*sink)->play(cue);
        const Measured alone = measured(run(0.6), 2);
        EXPECT_LT(alone.true_peak_db, -3.0) << sound.name;
        EXPECT_GT(alone.true_peak_db, -60.0) << sound.name << " is silent";
        (*sink)->stop_all();
        run(0.2);
    }
}

// Returns the energy at each ear between two frequencies.
std::array<double, 2> energies(const std::vector<float>& both, double from_hz, double to_hz) {
    std::array<double, 2> sums{};
    for (std::size_t ear = 0; ear < 2; ++ear)
        for (double hz = from_hz; hz < to_hz; hz += 40.0) {
            const std::complex<double> turn = std::polar(1.0, -2.0 * kPi * hz / kSampleRate_hz);
            std::complex<double> phase = 1.0, sum = 0.0;
            for (std::size_t i = ear; i < both.size(); i += 2, phase *= turn)
                sum += static_cast<double>(both[i]) * phase;
            sums.at(ear) += std::norm(sum);
        }
    return sums;
}

TEST(Beacon, at_the_side_differs_by_10_db_between_the_ears_and_reaches_up_to_8_khz) {
    for (const double side : {-1.0, 1.0}) {
        const std::vector<float> both = heard({cue_at(SoundKind::Beacon, {2.0 * side, 0.0, 0.0})}, 0.3);
        const auto all = energies(both, 100.0, 16000.0), high = energies(both, 6000.0, 8000.0);
        const std::size_t near = side > 0.0 ? 1 : 0;
        const double level_db = 10.0 * std::log10(all.at(near) / all.at(1 - near));
        std::cout << "    " << level_db << " dB between the ears\n";
        EXPECT_GE(level_db, 10.0);
        EXPECT_GE(10.0 * std::log10(high.at(near) / all.at(near)), -20.0);
    }
}

TEST(Beacon, ahead_is_bright_and_behind_is_dull) {
    const auto bright_db = [](SoundKind kind) {
        const std::vector<float> both = heard({cue_at(kind, {0.0, 2.0, 0.0})}, 0.3);
        return 10.0 * std::log10(energies(both, 1000.0, 16000.0)[0] / energies(both, 100.0, 16000.0)[0]);
    };
    EXPECT_GE(bright_db(SoundKind::BeaconAhead), bright_db(SoundKind::BeaconBehind) + 10.0);
}

}  // namespace loudness_test
}  // namespace handrail
