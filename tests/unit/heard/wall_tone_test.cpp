// Tests the wall tone, which reports a near wall to a person who moves. The tone must fall silent for a person who
// stands, because they have already heard it.
#include <gtest/gtest.h>

#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace wall_tone_test {

TEST(WallTone, is_silent_after_three_seconds_of_standing_and_comes_back_with_a_turn) {
    auto world = read_world(test::bundled_world("first_room.map"));
    ASSERT_TRUE(world) << world.error().sentence();
    RecordingAudio audio;
    RecordingSpeech voice;
    HeadlessSession session(Settings{}, HandFacts{}, audio, voice);
    session.app().apply(WorldEntered{make_ready(std::make_shared<const Scene>(std::move(*world)))}, 0.0);
    const auto wait = [&](double seconds) {
        for (const double until_s = session.now_s() + seconds; session.now_s() < until_s;) session.advance();
    };
    session.press(Command::Forward);
    const auto stands = [&] {
        const Vec3 before_m = session.app().feet_m();
        wait(0.1);
        return session.app().feet_m() == before_m;
    };
    wait(1.0);
    while (!stands()) {
    }
    session.app().apply(CommandUp{Command::Forward}, session.now_s());
    wait(0.5);
    ASSERT_TRUE(audio.loop(SoundKind::WallTone)) << "the walk ends at a wall";
    wait(1.5);
    EXPECT_TRUE(audio.loop(SoundKind::WallTone));
    wait(2.0);
    EXPECT_FALSE(audio.loop(SoundKind::WallTone));
    wait(5.0);
    EXPECT_FALSE(audio.loop(SoundKind::WallTone)) << "it does not come back while nothing moves";
    session.press(Command::TurnRight);
    session.app().apply(CommandUp{Command::TurnRight}, session.now_s());
    wait(0.3);
    EXPECT_TRUE(audio.loop(SoundKind::WallTone));
}

}  // namespace wall_tone_test
}  // namespace handrail
