#include "audio-cues/sinks/sound_outputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "audio-cues/sinks/voice_router.h"
#include "tests/support/names.h"

namespace handrail {
namespace sound_outputs_test {

TEST(SoundOutputs, write_text_and_play_sound_or_give_the_reason_for_silence) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    ::setenv("SPEECHD_ADDRESS", "unix_socket:/nonexistent", 1);
    SoundOutputs outputs = open_sound_outputs({}, ends[1]);
    ASSERT_TRUE(outputs.audio && outputs.speech);
    const bool silent = outputs.audio->news().has_value();
    EXPECT_EQ(outputs.description.empty(), silent) << "told once, here or in the news";
    outputs.audio->tick(1.0);
    outputs.speech->tick(1.0);
    outputs.speech->tick(1.0 + 1.0);
    outputs.audio->play({.kind = SoundKind::Beep});
    outputs.speech->say({.text = "Welcome"});
    EXPECT_EQ(outputs.speech->speaking(), !silent) << "where nothing is heard, nobody waits for the voice";
    std::array<char, 64> text{};
    const ssize_t got = ::read(ends[0], text.data(), text.size());
    EXPECT_EQ(std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0))), "say: Welcome\n");
    outputs.speech->stop();
    outputs = {};
    ::close(ends[0]);
    ::close(ends[1]);
}

}  // namespace sound_outputs_test
}  // namespace handrail
