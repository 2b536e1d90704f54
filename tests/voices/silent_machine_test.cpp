// Tests that the machine is never silent. From the first second of the first start, the program speaks, or a key
// announces where the person is. The tests run with the program's own voice alone, with a speech server, and with a
// screen reader that also drives a braille display. They print wall-clock times but judge only their order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/times_in.h"
#include "tests/voices/braille_server.h"
#include "tests/voices/desktop.h"
#include "tests/voices/exploring.h"

namespace handrail::test {
namespace silent_machine_test {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kThreeKeys = "Press Enter to begin, Space to hear this again, or Escape to leave.";

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Runs the first start, with a window that has the keyboard focus. The stand-in for the sound card records when the
// program's own voice begins and is interrupted.
class SilentMachineNever : public testing::Test {
protected:
    void launch(Environment environment) {
        environment["LD_PRELOAD"] = test::built_standin("standin_sound");
        environment["STANDIN_SOUND_VOICE"] = (folder.path() / "voice").string();
        launched_s = now_s();
        program = std::make_unique<Exploring>(folder, std::move(environment),
                                              std::vector<std::string>{"--device", "none"}, true);
    }
    std::string own_voice() const { return content_of(folder.path() / "voice"); }
    std::string said() const { return program->said(); }
    // Returns the whole first line that contains these words.
    std::string line_with(const std::string& words) const {
        std::istringstream lines(said());
        for (std::string line; std::getline(lines, line);)
            if (line.find(words) != std::string::npos) return line;
        return {};
    }
    bool says_times(const std::string& words, std::size_t times) const {
        return eventually([&] { return times_in(said(), words) == times; });
    }
    // Checks that Space repeats the welcome, that nothing expires, and that Enter continues. Checks that Space then
    // repeats what Enter announced.
    void go_on(VirtualDisplay& display, const std::string& everything) {
        const std::string welcome = line_with(kThreeKeys);
        ASSERT_THAT(welcome, HasSubstr("Welcome. Handrail is speaking with ")) << everything;
        ASSERT_TRUE(says_times("No touch device", 1)) << said();
        const std::string before = said();
        ::usleep(4000000);  // waits in real time, like a person who hesitates
        EXPECT_EQ(said(), before) << "the prompt stays, and nothing more is said";
        ASSERT_TRUE(display.xdotool("key space"));
        EXPECT_TRUE(says_times(welcome + "\n", 2)) << "word for word\n" << said();
        ASSERT_TRUE(display.xdotool("key Return"));
        ASSERT_TRUE(eventually([&] { return said().find("bell on your left") != std::string::npos; })) << said();
        EXPECT_LT(said().find("First, set up your headphones."), said().find("bell on your left"));
        const std::string question = line_with("bell on your left");
        ASSERT_TRUE(display.xdotool("key space"));
        EXPECT_TRUE(says_times(question + "\n", 2)) << "word for word\n" << said();
    }
    void report(const char* what, double seconds) const { std::printf("%-70s %5.0f ms\n", what, 1000.0 * seconds); }

    TemporaryFolder folder;
    double launched_s = 0.0;
    std::unique_ptr<Exploring> program;
};

TEST_F(SilentMachineNever, speaks_with_the_built_in_voice_if_there_is_nothing_else) {
    if (const std::string why = why_no_preload(); !why.empty()) GTEST_SKIP() << why;
    const auto display = VirtualDisplay::start();
    if (!display) GTEST_SKIP() << "Xvfb or xdotool is not installed";
    launch({{"DISPLAY", std::getenv("DISPLAY")}, {"LIBGL_ALWAYS_SOFTWARE", "1"}});
    ASSERT_TRUE(program->says(kThreeKeys)) << said();
    report("from the launch to the welcome in text", now_s() - launched_s);
    ASSERT_TRUE(eventually([&] { return own_voice().find("speak") != std::string::npos; })) << said();
    report("from the launch to the first sample of the voice", std::strtod(own_voice().c_str(), nullptr) - launched_s);
    ASSERT_TRUE(eventually([&] {
        return display->xdotool("search --onlyvisible --name '^Handrail$' windowfocus --sync >/dev/null 2>&1");
    }));
    // A key must interrupt the welcome.
    const double pressed_s = now_s();
    ASSERT_TRUE(display->xdotool("key Control_L"));
    ASSERT_TRUE(eventually([&] { return own_voice().find("hush") != std::string::npos; })) << own_voice() << said();
    const std::string log = own_voice();
    const std::size_t hush = log.find("hush"), begin = log.rfind('\n', hush) + 1;
    report("from the key to silence, the key's own way from xdotool in it",
           std::strtod(log.c_str() + begin, nullptr) - pressed_s);
    ASSERT_NO_FATAL_FAILURE(go_on(*display, said()));
}

TEST_F(SilentMachineNever, speaks_through_the_speech_server_if_one_runs_and_mutes_the_built_in_voice) {
    if (const std::string why = why_no_preload(); !why.empty()) GTEST_SKIP() << why;
    if (!installed("speech-dispatcher")) GTEST_SKIP() << "speech-dispatcher is not installed";
    const auto display = VirtualDisplay::start();
    if (!display) GTEST_SKIP() << "Xvfb or xdotool is not installed";
    const auto speech = SpeechServer::start(folder.path(), 400);
    ASSERT_TRUE(speech->running()) << speech->everything();
    Environment environment = speech->environment();
    environment["DISPLAY"] = std::getenv("DISPLAY");
    environment["LIBGL_ALWAYS_SOFTWARE"] = "1";
    std::unique_ptr<BrailleServer> braille;
    if (BrailleServer::why_not().empty()) {
        braille = std::make_unique<BrailleServer>(folder.path());
        ASSERT_TRUE(braille->running()) << braille->everything();
        environment.merge(braille->environment());
    }
    launch(std::move(environment));
    ASSERT_TRUE(eventually([&] { return speech->spoke(kThreeKeys); })) << said() << speech->everything();
    report("from the launch to the welcome by the speech server", speech->recorded().front().time_s - launched_s);
    ASSERT_TRUE(eventually([&] {
        return display->xdotool("search --onlyvisible --name '^Handrail$' windowfocus --sync >/dev/null 2>&1");
    }));
    // On a busy machine the welcome is over before the window has the keyboard. Space repeats it.
    const auto speaking = [&] { return speech->recorded().back().event == "speak"; };
    if (!speaking()) {
        ASSERT_TRUE(display->xdotool("key space"));
        ASSERT_TRUE(eventually(speaking)) << speech->everything();
    }
    const double pressed_s = now_s();
    ASSERT_TRUE(display->xdotool("key Control_L"));
    std::optional<double> stopped_s;
    EXPECT_TRUE(eventually([&] {
        for (const Recorded& entry : speech->recorded())
            if (entry.event == "stop" && entry.time_s > pressed_s) stopped_s = entry.time_s;
        return stopped_s.has_value();
    })) << speech->everything();
    if (stopped_s) report("from the key to silence", *stopped_s - pressed_s);
    ASSERT_NO_FATAL_FAILURE(go_on(*display, said() + speech->everything()));
    for (const Recorded& entry : speech->recorded()) {
        if (entry.event != "speak") continue;
        EXPECT_THAT(said(), HasSubstr(": " + entry.words + "\n"));
    }
    EXPECT_EQ(own_voice(), "") << "two voices";
    if (!braille) return;
    // Panning the display must show the whole question, from its first word to its last.
    const std::string question = line_with("bell on your left").substr(std::string("say: ").size());
    std::string read;
    ASSERT_TRUE(eventually([&] {
        return !braille->shown().empty() && question.rfind(braille->shown().substr(3), 0) == 0;
    })) << braille->everything()
        << question;
    for (int piece = 0; piece < 30 && read.size() < question.size(); ++piece) {
        const std::string shown = braille->shown();
        read += (read.empty() ? "" : " ") + shown.substr(3);
        braille->press("FWINRT");
        ASSERT_TRUE(read.size() >= question.size() || eventually([&] { return braille->shown() != shown; })) << read;
    }
    EXPECT_EQ(read, question);
}

TEST_F(SilentMachineNever, speaks_and_brailles_through_orca_if_it_runs_and_mutes_the_built_in_voice) {
    if (const std::string why = Desktop::why_not(); !why.empty()) GTEST_SKIP() << why;
    Desktop desktop(folder.path());
    ASSERT_TRUE(desktop.running());
    std::unique_ptr<BrailleServer> braille;
    if (BrailleServer::why_not().empty()) {
        braille = std::make_unique<BrailleServer>(folder.path());
        ASSERT_TRUE(braille->running()) << braille->everything();
    }
    ASSERT_TRUE(desktop.start_orca(braille ? braille->environment() : Environment{})) << desktop.everything();
    Environment environment = desktop.environment(true);
    if (braille) environment.merge(braille->environment());
    launch(std::move(environment));
    ASSERT_TRUE(desktop.focus_window()) << said();
    ASSERT_TRUE(eventually([&] { return desktop.speech->spoke(kThreeKeys); })) << said() << desktop.everything();
    report("from the launch to the welcome by Orca, the window's focus in it", now_s() - launched_s);
    if (braille) {
        EXPECT_TRUE(braille->shows("Welcome. Handrail is speaking with"))
            << braille->everything() << desktop.everything();
    }
    ASSERT_NO_FATAL_FAILURE(go_on(*desktop.display, said() + desktop.everything()));
    EXPECT_TRUE(eventually([&] { return desktop.speech->spoke("bell on your left"); })) << desktop.everything();
    EXPECT_EQ(own_voice(), "") << "two voices";
}

}  // namespace silent_machine_test
}  // namespace handrail::test
