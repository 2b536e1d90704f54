// Runs the whole program with the voices of a desktop. The tests end these voices in turn while a person explores.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/voices/exploring.h"
#include "tests/voices/speech_server.h"

namespace handrail::test {
namespace program_test {

using testing::HasSubstr;
using testing::Not;

class ProgramSpeaking : public testing::Test {
protected:
    // Starts the program with a speech server, and waits until it has announced where the person is.
    void explore() {
        if (!installed("speech-dispatcher")) GTEST_SKIP() << "speech-dispatcher is not installed";
        server = SpeechServer::start(folder.path(), 1);
        ASSERT_TRUE(server->running()) << server->everything();
        program = std::make_unique<Exploring>(folder, server->environment());
        ASSERT_TRUE(eventually([&] { return server->spoke("facing north"); }))
            << program->said() << server->everything();
    }
    void leave() {
        program->type("quit\n");
        EXPECT_EQ(program->process().exit_status(), 0) << program->said();
    }

    TemporaryFolder folder;
    std::unique_ptr<SpeechServer> server;
    std::unique_ptr<Exploring> program;
};

TEST_F(ProgramSpeaking, through_the_speech_server_speaks_each_line_of_text_there_and_nowhere_else) {
    ASSERT_NO_FATAL_FAILURE(explore());
    if (!program) return;
    program->type("heading\nwhere\n");
    ASSERT_TRUE(eventually([&] { return server->spoke("Ahead: north wall"); }))
        << program->said() << server->everything();
    leave();
    // Every spoken text must also have been written. The reverse need not be true: if the next key interrupted an
    // answer, that answer may exist only as text.
    for (const Recorded& entry : server->recorded()) {
        if (entry.event != "speak") continue;
        EXPECT_THAT(program->said(), HasSubstr(": " + entry.words + "\n"));
    }
    EXPECT_TRUE(server->spoke("Handrail.")) << server->everything();
    EXPECT_THAT(program->said(), Not(HasSubstr("uses the built-in voice"))) << "the built-in voice was never needed";
}

TEST_F(ProgramSpeaking, continues_when_the_speech_server_is_killed_and_uses_it_again_when_it_returns) {
    // libspeechd cancels its thread. If g++ 12's sanitizer is looking up names for its suppressions at that moment, the
    // thread never ends and blocks all others.
    if (test::kThreadSanitizer) GTEST_SKIP() << "SpeechdVoice.notices_a_killed_server_* runs the same threads";
    ASSERT_NO_FATAL_FAILURE(explore());
    if (!program) return;
    server->kill();
    EXPECT_TRUE(program->says("alert: The speech server is no longer available; speech now uses the built-in voice."))
        << program->said();
    program->type("right 2\n");
    EXPECT_TRUE(program->says("say: North-east")) << program->said();
    ASSERT_TRUE(server->start_again()) << server->everything();
    EXPECT_TRUE(program->says("Speech now uses the speech server.")) << program->said();
    program->type("heading\n");
    EXPECT_TRUE(eventually([&] { return server->spoke("Facing north-east, 45 degrees"); }))
        << program->said() << server->everything();
    leave();
}

TEST_F(ProgramSpeaking, is_not_blocked_by_a_frozen_speech_server_in_its_text_or_next_voice) {
    ASSERT_NO_FATAL_FAILURE(explore());
    if (!program) return;
    server->freeze();
    program->type("heading\n");
    EXPECT_TRUE(program->says("say: Facing north, 0 degrees")) << program->said();
    EXPECT_TRUE(program->says("alert: The speech server is no longer available; speech now uses the built-in voice."))
        << program->said();
    leave();
}

TEST_F(ProgramSpeaking, reports_a_missing_voice_that_the_settings_name) {
    program = std::make_unique<Exploring>(
        folder, Environment{},
        std::vector<std::string>{"--no-window", "--device", "none", "--set", "speech.through=speech-dispatcher"});
    EXPECT_TRUE(program->says("alert: The speech server cannot be reached; speech uses the built-in voice instead."))
        << program->said();
    leave();
}

}  // namespace program_test
}  // namespace handrail::test
