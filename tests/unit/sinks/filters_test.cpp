// Tests which filters for headphones the sink uses, and from which direction the voice comes.
#include <AL/alc.h>
#include <AL/alext.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "audio-cues/sinks/openal_sink.h"
#include "audio-cues/sinks/sound_outputs.h"
#include "audio-cues/sinks/synth.h"
#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/vec.h"

namespace handrail {
namespace filters_test {

TEST(SetOfFilters, that_is_named_is_used_and_a_missing_one_is_reported) {
    auto voice = std::make_shared<VoiceChannel>();
    for (const auto& [name, there] :
         {std::pair{"auto", true}, std::pair{"default", true}, std::pair{"nobody", false}}) {
        auto sink = OpenALSink::open(voice, {.output = OpenALSink::Output::OnDemand, .hrtf_set = name});
        ASSERT_TRUE(sink) << sink.error().sentence();
        EXPECT_EQ((*sink)->news().has_value(), !there) << name;
    }
}

// A person puts a set of filters into the folder in which OpenAL Soft looks for such files, and names it in the setting
// sound.hrtf.
TEST(SetOfFilters, can_be_a_file_of_the_person_that_the_setting_names) {
    const std::filesystem::path known = "/usr/share/openal/hrtf/default-48000.mhr";
    if (!std::filesystem::exists(known)) GTEST_SKIP() << "this OpenAL Soft has no set of filters as a file";
    const test::TemporaryFolder home;
    const std::filesystem::path folder = home.path() / "openal" / "hrtf";
    std::filesystem::create_directories(folder);
    std::filesystem::copy_file(known, folder / "my ears.mhr");
    const test::WithEnvironment data("XDG_DATA_HOME", home.path().c_str());
    const test::WithEnvironment server("SPEECHD_ADDRESS", "unix_socket:/nonexistent");
    Settings settings;
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (const std::string set : {"default-48000", "my ears"}) {
        settings.sound.hrtf = set;
        const SoundOutputs outputs = open_sound_outputs(settings, nowhere);
        EXPECT_EQ(outputs.audio->news(), std::nullopt);
        const ALCchar* used = alcGetString(alcGetContextsDevice(alcGetCurrentContext()), ALC_HRTF_SPECIFIER_SOFT);
        ASSERT_NE(used, nullptr);
        EXPECT_NE(std::string_view(used).find(set), std::string_view::npos) << used;
    }
    ::close(nowhere);
}

TEST(VoiceFromItsPlace, is_louder_in_the_ear_on_that_side) {
    for (const double side : {-1.0, 1.0}) {
        auto voice = std::make_shared<VoiceChannel>();
        auto sink = OpenALSink::open(voice, {.output = OpenALSink::Output::OnDemand});
        ASSERT_TRUE(sink) << sink.error().sentence();
        std::vector<std::int16_t> speech(9600);
        for (std::size_t i = 0; i < speech.size(); ++i)
            speech[i] = static_cast<std::int16_t>(i % 12 < 6 ? 9000 : -9000);
        const auto ticket = voice->begin(kSampleRate_hz, 1.0, side * 0.5 * kPi);
        voice->append(ticket, speech);
        voice->end(ticket);
        std::vector<float> both;
        for (int i = 0; i < 30; ++i) {
            (*sink)->tick(1.0 + i * 256.0 / kSampleRate_hz);
            const auto mix = (*sink)->render(256);
            both.insert(both.end(), mix.begin(), mix.end());
        }
        std::array<double, 2> all{};
        for (std::size_t i = 0; i < both.size(); ++i)
            all.at(i % 2) += static_cast<double>(both[i]) * static_cast<double>(both[i]);
        const std::size_t near = side > 0.0 ? 1 : 0;
        EXPECT_GE(all.at(near), 2.0 * all.at(1 - near));
    }
}

}  // namespace filters_test
}  // namespace handrail
