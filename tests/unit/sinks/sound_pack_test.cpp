// Tests sound packs: files of any rate replace the program's own sounds, and bad files are reported.
#include <gmock/gmock.h>
#include <sndfile.h>

#include <cmath>

#include "audio-cues/sinks/loudness.h"
#include "audio-cues/sinks/openal_sink.h"
#include "audio-cues/sinks/sound_pack.h"
#include "audio-cues/sinks/synth.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace sound_pack_test {

namespace fs = std::filesystem;
using cues::SoundKind;
using sinks::read_sound_pack;
using sinks::SoundPack;
using testing::HasSubstr;

constexpr double kTone_hz = 440.0;

// Writes a tone of half a second.
void write_tone(const fs::path& file, int rate_hz, int channels, int format = SF_FORMAT_WAV | SF_FORMAT_PCM_16,
                double level = 0.5, double seconds = 0.5) {
    SF_INFO info{};
    info.samplerate = rate_hz;
    info.channels = channels;
    info.format = format;
    SNDFILE* sound = sf_open(file.c_str(), SFM_WRITE, &info);
    ASSERT_TRUE(sound) << sf_strerror(nullptr);
    std::vector<float> samples;
    for (int i = 0; i < static_cast<int>(seconds * rate_hz); ++i)
        for (int c = 0; c < channels; ++c)
            samples.push_back(static_cast<float>(level * std::sin(2.0 * kPi * kTone_hz * i / rate_hz)));
    sf_write_float(sound, samples.data(), static_cast<sf_count_t>(samples.size()));
    sf_close(sound);
}

// Returns the frequency of a tone from its zero crossings, at 48 kHz.
double pitch_of(std::span<const float> samples) {
    int crossings = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) crossings += samples[i - 1] < 0.0F && samples[i] >= 0.0F;
    return static_cast<double>(crossings) / (static_cast<double>(samples.size()) / sinks::kSampleRate_hz);
}

TEST(SoundPack, reads_files_of_any_rate_and_format) {
    const test::TemporaryFolder folder;
    std::string table = "[sounds]\n";
    const std::vector<std::tuple<const char*, int, int, int>> files{
        {"arrived", 8000, 1, SF_FORMAT_WAV | SF_FORMAT_PCM_16},
        {"denied", 44100, 2, SF_FORMAT_FLAC | SF_FORMAT_PCM_16},
        {"mark", 48000, 1, SF_FORMAT_WAV | SF_FORMAT_FLOAT},
        {"turn", 96000, 6, SF_FORMAT_AIFF | SF_FORMAT_PCM_24}};
    for (const auto& [name, rate_hz, channels, format] : files) {
        write_tone(folder.path() / name, rate_hz, channels, format);
        table += std::string("\"") + name + "\" = \"" + name + "\"\n";
    }
    folder.write("pack.toml", table);
    const SoundPack pack = read_sound_pack(folder.path());
    EXPECT_TRUE(pack.faults.empty()) << pack.faults.front().sentence();
    for (const SoundKind kind : {SoundKind::Arrived, SoundKind::Denied, SoundKind::Mark, SoundKind::TurnTick}) {
        const auto samples = pack.find(kind, SoundClass::Generic);
        ASSERT_NEAR(static_cast<double>(samples.size()), 24000.0, 10.0);
        EXPECT_NEAR(pitch_of(samples), kTone_hz, 4.0);
        EXPECT_NEAR(*std::max_element(samples.begin(), samples.end()), 0.5, 0.03);
    }
    EXPECT_TRUE(pack.find(SoundKind::Grab, SoundClass::Generic).empty());
}

// A tone above half of the new rate must vanish instead of returning as another tone.
TEST(SoundPack, removes_tones_that_the_rate_of_the_program_cannot_carry) {
    std::vector<float> high(19200);
    for (std::size_t i = 0; i < high.size(); ++i)
        high[i] = static_cast<float>(std::sin(2.0 * kPi * 40000.0 * static_cast<double>(i) / 192000.0));
    const std::vector<float> out = sinks::resampled(high, 192000);
    ASSERT_EQ(out.size(), 4800U);
    for (std::size_t i = 100; i < out.size() - 100; ++i) ASSERT_LT(std::abs(out[i]), 0.01F) << i;
}

TEST(SoundPack, replaces_the_sound_of_one_material_or_of_all) {
    const test::TemporaryFolder folder;
    write_tone(folder.path() / "all.wav", 48000, 1);
    write_tone(folder.path() / "wood.wav", 48000, 1, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 0.25);
    folder.write("pack.toml", "[sounds]\n\"contact\" = \"all.wav\"\n\"contact wood\" = \"wood.wav\"\n");
    const SoundPack pack = read_sound_pack(folder.path());
    EXPECT_TRUE(pack.faults.empty());
    const auto peak = [&](SoundClass material) {
        const auto samples = pack.find(SoundKind::Contact, material);
        return samples.empty() ? 0.0F : *std::max_element(samples.begin(), samples.end());
    };
    EXPECT_NEAR(peak(SoundClass::Metal), 0.5F, 0.01F);
    EXPECT_NEAR(peak(SoundClass::Wood), 0.25F, 0.01F);
}

TEST(SoundPack, reports_each_bad_file_in_one_sentence_and_uses_the_others) {
    const test::TemporaryFolder folder;
    write_tone(folder.path() / "good.wav", 48000, 1);
    write_tone(folder.path() / "silent.wav", 48000, 1, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 0.0);
    write_tone(folder.path() / "long.wav", 8000, 1, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 0.5, 21.0);
    write_tone(folder.path() / "slow.wav", 1000, 1);
    folder.write("text.wav", "This is no sound.");
    folder.write("pack.toml",
                 "[sounds]\n\"arrived\" = \"good.wav\"\n\"denied\" = \"text.wav\"\n\"mark\" = \"missing.wav\"\n"
                 "\"turn\" = \"silent.wav\"\n\"rim\" = \"long.wav\"\n\"grab\" = \"slow.wav\"\n"
                 "\"clik\" = \"good.wav\"\n\"click\" = \"../good.wav\"\n");
    const SoundPack pack = read_sound_pack(folder.path());
    EXPECT_EQ(pack.sounds.size(), 1U);
    EXPECT_EQ(pack.faults.size(), 7U);
    const auto says = [&](const std::string& place, const std::string& what) {
        EXPECT_THAT(pack.faults,
                    testing::Contains(testing::ResultOf([](const Error& fault) { return fault.sentence(); },
                                                        testing::AllOf(HasSubstr(place), HasSubstr(what)))));
    };
    says("text.wav", "Save it as WAV");
    says("missing.wav", "cannot be used");
    says("silent.wav", "it is silent");
    says("long.wav", "longer than 20 seconds");
    says("slow.wav", "1,000 samples a second");
    says("pack.toml, line 8", "Did you mean click?");
    says("pack.toml, line 9", "a file in the folder of the pack");
    for (const char* table : {"", "[sounds\n", "sounds = 3\n"}) {
        folder.write("pack.toml", table);
        EXPECT_EQ(read_sound_pack(folder.path()).faults.size(), 1U) << table;
    }
    EXPECT_THAT(read_sound_pack(folder.path() / "nowhere").faults.at(0).sentence(), HasSubstr("pack.toml"));
}

// The sink plays the pack's sound, as loud as the sound that it replaces.
TEST(SoundPack, is_played_by_the_sink_instead_of_the_programs_sound) {
    const test::TemporaryFolder folder;
    write_tone(folder.path() / "tone.wav", 44100, 1, SF_FORMAT_WAV | SF_FORMAT_PCM_16, 0.02);
    folder.write("pack.toml", "[sounds]\n\"arrived\" = \"tone.wav\"\n\"denied\" = \"no.wav\"\n");
    const auto heard = [&](const std::string& pack) {
        auto sink =
            sinks::OpenALSink::open(std::make_shared<sinks::VoiceChannel>(),
                                    {.output = sinks::OpenALSink::Output::OnDemand, .hrtf = false, .pack = pack});
        EXPECT_TRUE(sink);
        (*sink)->set_sound(settings::Settings{}.sound);
        (*sink)->tick(0.0);
        const auto news = (*sink)->news();
        EXPECT_EQ(news.has_value(), pack != "none");
        if (news) {
            EXPECT_THAT(*news, HasSubstr("no.wav"));
        }
        cues::SoundCue cue;
        cue.kind = SoundKind::Arrived;
        (*sink)->play(cue);
        std::vector<float> left;
        const std::span<const float> mix = (*sink)->render(19200);
        for (std::size_t i = 0; i < mix.size(); i += 2) left.push_back(mix[i]);
        return left;
    };
    const std::vector<float> own = heard(folder.path().string()), usual = heard("none");
    EXPECT_NEAR(pitch_of(own), kTone_hz, 6.0);
    EXPECT_GT(std::abs(pitch_of(usual) - kTone_hz), 20.0);
    EXPECT_NEAR(sinks::momentary_lufs(own), sinks::momentary_lufs(usual), 3.0);
}

}  // namespace sound_pack_test
}  // namespace handrail
