// Runs the program with a braille display. While a person explores, the tests end everything that can fail: the
// display, the voices and the sound.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/virtual_display.h"
#include "tests/voices/braille_server.h"
#include "tests/voices/desktop.h"
#include "tests/voices/exploring.h"
#include "tests/voices/speech_server.h"

namespace handrail::test {
namespace braille_test {

using testing::HasSubstr;
using testing::Not;

class Brailled : public testing::Test {
protected:
    // Starts the program in the first room. It has a window with the keyboard focus, a speech server, a braille display
    // and a sound card.
    void explore(const std::vector<std::string>& more = {}) {
        if (const std::string why = BrailleServer::why_not(); !why.empty()) GTEST_SKIP() << why;
        if (!installed("speech-dispatcher")) GTEST_SKIP() << "speech-dispatcher is not installed";
        display = VirtualDisplay::start();
        if (!display) GTEST_SKIP() << "Xvfb or xdotool is not installed";
        speech = SpeechServer::start(folder.path(), 1);
        ASSERT_TRUE(speech->running()) << speech->everything();
        braille = std::make_unique<BrailleServer>(folder.path());
        ASSERT_TRUE(braille->running()) << braille->everything();
        Environment environment = braille->environment();
        environment.merge(speech->environment());
        environment["DISPLAY"] = std::getenv("DISPLAY");
        environment["LIBGL_ALWAYS_SOFTWARE"] = "1";
        environment["LD_PRELOAD"] = test::built_standin("standin_sound");
        environment["STANDIN_SOUND_PULLED"] = pulled();
        std::vector<std::string> arguments{"--device", "none"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        program = std::make_unique<Exploring>(folder, environment, arguments);
        ASSERT_TRUE(eventually([&] {
            return display->xdotool("search --onlyvisible --name '^Handrail$' windowfocus --sync >/dev/null 2>&1");
        }));
        // To its end: a place that a key cuts is said again later, and would take the display from an answer.
        ASSERT_TRUE(eventually([&] {
            const std::vector<Recorded> events = speech->recorded();
            const auto place = std::find_if(events.begin(), events.end(), [](const Recorded& event) {
                return event.event == "speak" && event.words.find("facing north") != std::string::npos;
            });
            return std::any_of(place, events.end(), [](const Recorded& event) { return event.event == "end"; });
        })) << everything();
    }
    std::string pulled() const { return (folder.path() / "pulled").string(); }
    bool press(const std::string& keys) const { return display->xdotool("key " + keys); }
    std::string everything() const {
        return "said:\n" + program->said() + speech->everything() + braille->everything();
    }
    void leave() {
        EXPECT_TRUE(press("Escape"));
        EXPECT_TRUE(program->says("Press Escape again")) << everything();
        EXPECT_TRUE(press("Escape"));
        EXPECT_EQ(program->process().exit_status(), 0) << everything();
    }

    TemporaryFolder folder;
    std::unique_ptr<VirtualDisplay> display;
    std::unique_ptr<SpeechServer> speech;
    std::unique_ptr<BrailleServer> braille;
    std::unique_ptr<Exploring> program;
};

TEST_F(Brailled, session_shows_the_heading_and_the_spoken_text) {
    ASSERT_NO_FATAL_FAILURE(explore());
    if (!program) return;
    ASSERT_TRUE(press("Right"));
    EXPECT_TRUE(braille->shows("North-north-east")) << everything();
    EXPECT_TRUE(eventually([&] { return speech->spoke("North-north-east"); })) << everything();
    ASSERT_TRUE(press("c"));
    EXPECT_TRUE(eventually([&] { return braille->shown() == "23 Facing north-north-east, 22 degrees"; }))
        << everything();
    leave();
}

TEST_F(Brailled, session_pans_with_the_display_keys_and_says_more_on_a_routing_key) {
    ASSERT_NO_FATAL_FAILURE(explore());
    if (!program) return;
    // Repeat the query until the session knows the room, because a background task finds the rooms.
    const auto reported = [&] { return program->said().find("say: Room with") != std::string::npos; };
    ASSERT_TRUE(eventually([&] { return press("F2") && eventually(reported, 2.0); })) << everything();
    ASSERT_TRUE(braille->shows("N  Room with")) << everything();
    // Each displayed piece must consist of words of the message, after the heading. The keys move the display forwards,
    // back, forwards, and to the beginning of the message.
    const std::string first = braille->shown();
    const auto other = [&] { return braille->shown() != first; };
    const auto same = [&] { return braille->shown() == first; };
    EXPECT_THAT(program->said(), HasSubstr(first.substr(3))) << everything();
    braille->press("FWINRT");
    ASSERT_TRUE(eventually(other)) << everything();
    EXPECT_EQ(braille->shown().substr(0, 3), "N  ");
    EXPECT_THAT(program->said(), HasSubstr(first.substr(3) + " " + braille->shown().substr(3))) << everything();
    braille->press("FWINLT");
    ASSERT_TRUE(eventually(same)) << everything();
    braille->press("LNDN");
    ASSERT_TRUE(eventually(other)) << everything();
    braille->press("HOME");
    ASSERT_TRUE(eventually(same)) << everything();
    const std::string before = program->said();
    braille->press("ROUTE 7");
    EXPECT_TRUE(eventually([&] { return program->said().size() > before.size(); })) << everything();
    EXPECT_TRUE(eventually(other)) << everything();
    leave();
}

TEST_F(Brailled, output_is_absent_when_braille_is_switched_off) {
    ASSERT_NO_FATAL_FAILURE(explore({"--set", "speech.braille=false"}));
    if (!program) return;
    ASSERT_TRUE(press("c"));
    EXPECT_TRUE(eventually([&] { return speech->spoke("Facing north, 0 degrees"); })) << everything();
    EXPECT_THAT(braille->shown(), Not(HasSubstr("north"))) << everything();
    leave();
}

TEST_F(Brailled, session_accepts_another_display_of_the_same_server) {
    ASSERT_NO_FATAL_FAILURE(explore());
    if (!program) return;
    ASSERT_TRUE(press("c"));
    ASSERT_TRUE(braille->shows("Facing north")) << everything();
    ASSERT_TRUE(braille->unplug_display_and_plug_in_another()) << everything();
    ASSERT_TRUE(press("Right"));
    EXPECT_TRUE(braille->shows("North-north-east")) << everything();
    leave();
}

// Ends one after the other everything that informs a person. The outputs that remain must announce each loss, and the
// session must continue.
TEST_F(Brailled, session_goes_on_when_braille_sound_and_speech_are_taken_away_in_turn) {
    ASSERT_NO_FATAL_FAILURE(explore());
    if (!program) return;
    ASSERT_TRUE(press("c"));
    ASSERT_TRUE(braille->shows("Facing north")) << everything();

    braille->kill();
    EXPECT_TRUE(program->says("alert: The braille display was disconnected; Handrail is looking for it."))
        << everything();
    EXPECT_TRUE(eventually([&] { return speech->spoke("The braille display was disconnected"); })) << everything();
    ASSERT_TRUE(press("Right"));
    EXPECT_TRUE(eventually([&] { return speech->spoke("North-north-east"); })) << everything();
    ASSERT_TRUE(braille->start_again()) << everything();
    ASSERT_TRUE(press("c"));
    EXPECT_TRUE(braille->shows("Facing north-north-east, 22 degrees")) << everything();

    std::ofstream(pulled()) << "";
    EXPECT_TRUE(program->says("alert: The sound device was lost.")) << everything();
    EXPECT_TRUE(eventually([&] { return speech->spoke("The sound device was lost."); })) << everything();
    EXPECT_TRUE(braille->shows("The sound device was lost.")) << everything();

    speech->kill();
    EXPECT_TRUE(program->says("alert: The speech server is no longer available; there is only text now."))
        << everything();
    EXPECT_TRUE(braille->shows("The speech server is no longer")) << everything();
    ASSERT_TRUE(press("Right Right"));
    ASSERT_TRUE(press("c"));
    EXPECT_TRUE(braille->shows("Facing east-north-east, 68 degrees")) << everything();

    std::filesystem::remove(pulled());
    EXPECT_TRUE(program->says("alert: Sound is back")) << everything();
    EXPECT_TRUE(program->says("Speech now uses the built-in voice.")) << everything();
    leave();
}

}  // namespace braille_test
}  // namespace handrail::test
