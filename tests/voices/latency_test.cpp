// Measures how long a person waits, in wall-clock time. The tests print the times but never judge them, because they
// depend on the machine as much as on the program. Each measurement begins before xdotool starts, so it includes
// xdotool's start and key press. It ends at the voice's first word, or when the voice is silent.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/voices/desktop.h"
#include "tests/voices/exploring.h"

namespace handrail::test {
namespace latency_test {

constexpr int kTimes = 12;

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Presses `key`. Returns the time until the speech server records an entry that `is_it` accepts. Searches from entry
// `from` on, and sets `from` to the entry after the match.
std::optional<double> time_to(const Desktop& desktop, const std::string& key, std::size_t& from,
                              const std::function<bool(const Recorded&)>& is_it) {
    const double pressed_s = now_s();
    if (!desktop.press(key)) return std::nullopt;
    std::optional<double> took_s;
    eventually([&] {
        const auto all = desktop.speech->recorded();
        const auto found =
            std::find_if(all.begin() + static_cast<std::ptrdiff_t>(std::min(from, all.size())), all.end(), is_it);
        if (found == all.end()) return false;
        took_s = found->time_s - pressed_s;
        from = static_cast<std::size_t>(found - all.begin()) + 1;
        return true;
    });
    return took_s;
}

void report(const char* what, std::vector<double> times_s) {
    if (times_s.empty()) return;
    std::sort(times_s.begin(), times_s.end());
    std::printf("%-60s median %5.0f ms, slowest %5.0f ms of %zu\n", what, 1000.0 * times_s[times_s.size() / 2],
                1000.0 * times_s.back(), times_s.size());
}

// Measures two times: from the query for the heading to the first word of the answer, and from another key to silence.
// The answer is long enough for the second key to interrupt it.
void measure(const Desktop& desktop, const char* to_word, const char* to_silence) {
    std::vector<double> word_s, silence_s;
    for (int i = 0; i < kTimes; ++i) {
        std::size_t from = desktop.speech->recorded().size();
        const auto word = time_to(desktop, "c", from, [](const Recorded& entry) {
            return entry.event == "speak" && entry.words.rfind("Facing", 0) == 0;
        });
        ASSERT_TRUE(word) << desktop.everything();
        word_s.push_back(*word);
        bool ended = false;  // the speech ended before a slow machine could press a key
        const auto silence = time_to(desktop, "Control_L", from, [&](const Recorded& entry) {
            ended = entry.event == "end";
            return entry.event == "stop" || ended;
        });
        ASSERT_TRUE(silence) << desktop.everything();
        if (!ended) silence_s.push_back(*silence);
    }
    report(to_word, std::move(word_s));
    report(to_silence, std::move(silence_s));
}

void explore_and_measure(bool orca, int word_ms, const char* to_word, const char* to_silence) {
    const TemporaryFolder folder;
    Desktop desktop(folder.path(), word_ms);
    ASSERT_TRUE(desktop.running());
    if (orca) {
        ASSERT_TRUE(desktop.start_orca()) << desktop.everything();
    }
    Exploring program(folder, desktop.environment(!orca), {"--device", "none"});
    ASSERT_TRUE(desktop.focus_window());
    ASSERT_TRUE(eventually([&] { return desktop.speech->spoke("Handrail."); })) << desktop.everything();
    measure(desktop, to_word, to_silence);
    std::vector<double> xdotool_s;
    for (int i = 0; i < kTimes; ++i) {
        const double began_s = now_s();
        desktop.display->xdotool("getmouselocation >/dev/null");
        xdotool_s.push_back(now_s() - began_s);
    }
    report("of that, the start of xdotool", std::move(xdotool_s));
}

TEST(Latency, of_the_screen_reader_is_reported) {
    if (const std::string why = Desktop::why_not(); !why.empty()) GTEST_SKIP() << why;
    // Orca first says the name of the key, which is as long as two words including the blank. The answer waits for
    // that.
    explore_and_measure(true, 100, "key to the first word, after 200 ms of key echo, by Orca",
                        "key to silence, by Orca");
}

TEST(Latency, of_the_speech_server_is_reported) {
    if (const std::string why = Desktop::why_not(); !why.empty()) GTEST_SKIP() << why;
    explore_and_measure(false, 3000, "key to the first word, by speech-dispatcher",
                        "key to silence, by speech-dispatcher");
}

// When the program sets a gain to zero, OpenAL lowers the gain over the next period that it mixes: 256 samples at 48
// kHz.
constexpr double kMixerRamp_s = 256.0 / 48000.0;

// Returns what the program requested of OpenAL for its own voice: when the speech began, and when it had to be silent.
std::vector<Recorded> own_voice(const std::filesystem::path& file) {
    std::vector<Recorded> all;
    std::istringstream lines(content_of(file));
    for (Recorded entry; lines >> entry.time_s >> entry.event;) all.push_back(entry);
    return all;
}

TEST(Latency, of_the_built_in_voice_is_reported) {
    if (const std::string why = why_no_preload(); !why.empty()) GTEST_SKIP() << why;
    const auto display = VirtualDisplay::start();
    if (!display) GTEST_SKIP() << "Xvfb or xdotool is not installed";
    const TemporaryFolder folder;
    const auto voice = folder.path() / "voice";
    Exploring program(folder,
                      {{"DISPLAY", std::getenv("DISPLAY")},
                       {"LIBGL_ALWAYS_SOFTWARE", "1"},
                       {"LD_PRELOAD", test::built_standin("standin_sound")},
                       {"STANDIN_SOUND_VOICE", voice.string()}},
                      {"--device", "none"});
    ASSERT_TRUE(eventually([&] {
        return display->xdotool("search --onlyvisible --name '^Handrail$' windowfocus --sync >/dev/null 2>&1");
    }));
    ASSERT_TRUE(program.says("facing north")) << program.said();
    const auto time_to = [&](const std::string& key, const std::string& event) {
        const std::size_t before = own_voice(voice).size();
        const double pressed_s = now_s();
        double took_s = -1.0;
        EXPECT_TRUE(display->xdotool("key " + key));
        eventually([&] {
            const auto all = own_voice(voice);
            for (std::size_t i = before; i < all.size() && took_s < 0.0; ++i)
                if (all[i].event == event) took_s = all[i].time_s - pressed_s;
            return took_s >= 0.0;
        });
        return took_s;
    };
    std::vector<double> word_s, silence_s;
    time_to("Control_L", "hush");
    for (int i = 0; i < kTimes; ++i) {
        word_s.push_back(time_to("c", "speak"));
        ASSERT_GE(word_s.back(), 0.0) << program.said();
        silence_s.push_back(time_to("Control_L", "hush"));
        ASSERT_GE(silence_s.back(), 0.0) << program.said();
        silence_s.back() += kMixerRamp_s;
    }
    report("key to the first sample of the program's own voice", std::move(word_s));
    report("key to its silence", std::move(silence_s));
}

}  // namespace latency_test
}  // namespace handrail::test
