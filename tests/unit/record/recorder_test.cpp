// Tests that a recording stays readable, however the program or the disk fails.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <thread>

#include "app/record/recording.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/record/full_disk.h"
#include "worlds/base/clock.h"

namespace handrail {
namespace recorder_test {

namespace fs = std::filesystem;
using test::FullDisk;
using test::TemporaryFolder;

RecordingHead head_now(double now_s) {
    RecordingHead head;
    head.program = "1.0";
    head.language = "en";
    head.begun_s = now_s;
    return head;
}

void sleep_ms(long ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

// Runs in the child process. Records a tick and an event each millisecond, and writes its progress to the pipe before
// each. Never returns.
[[noreturn]] void record_until_killed(const fs::path& folder, int report_fd) {
    SteadyClock clock;
    const double begun_s = clock.now_s();
    auto recorder = Recorder::begin(folder, head_now(begun_s));
    if (!recorder) _exit(3);
    for (;;) {
        const double now_s = clock.now_s();
        HandRow row;
        row.time_s = in_whole_microseconds(now_s);
        (*recorder)->hand(0).push(row);
        (*recorder)->said(now_s, {"Wall.", SpeechClass::Contact}, true);
        const double since_s = now_s - begun_s;
        if (::write(report_fd, &since_s, sizeof since_s) != sizeof since_s) _exit(4);
        clock.sleep_until_s(now_s + 1e-3);
    }
}

TEST(Recorder, that_is_killed_at_any_moment_loses_no_more_than_half_a_second) {
    std::mt19937 draw(std::random_device{}());
    const int kills = test::scaled(6);
    double worst_hand_s = 0.0, worst_events_s = 0.0;
    for (int kill = 0; kill < kills; ++kill) {
        const TemporaryFolder folder;
        int pipe[2];
        ASSERT_EQ(::pipe(pipe), 0);
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) record_until_killed(folder.path(), pipe[1]);
        ::close(pipe[1]);
        sleep_ms(700 + static_cast<long>(draw() % 900));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        double last_s = 0.0, reported_s = 0.0;
        while (::read(pipe[0], &reported_s, sizeof reported_s) == sizeof reported_s) last_s = reported_s;
        ::close(pipe[0]);
        const auto read = read_recording(fs::directory_iterator(folder.path())->path());
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_FALSE(read->ended);
        ASSERT_FALSE(read->hands[0].empty());
        ASSERT_FALSE(read->lines.empty());
        worst_hand_s = std::max(worst_hand_s, last_s - (read->hands[0].back().time_s - read->head.begun_s));
        worst_events_s = std::max(worst_events_s, last_s - read->lines.back().t_s);
    }
    RecordProperty("worst_hand_ms", static_cast<int>(worst_hand_s * 1e3));
    RecordProperty("worst_events_ms", static_cast<int>(worst_events_s * 1e3));
    std::printf("%d kills: at most %.0f ms of the hand and %.0f ms of events lost\n", kills, worst_hand_s * 1e3,
                worst_events_s * 1e3);
    // The limits are far above the usual losses, because other tests may keep the machine busy. docs/results.md
    // contains measurements without load.
    EXPECT_LT(worst_hand_s, 2.0);
    EXPECT_LT(worst_events_s, 2.0);
}

TEST(Recorder, with_a_full_disk_at_any_write_reports_one_sentence_and_the_session_continues) {
    for (const long at : {1L, 2L, 3L, 4L, 5L, 7L}) {
        const TemporaryFolder folder;
        auto recorder = Recorder::begin(folder.path(), head_now(10.0));
        ASSERT_TRUE(recorder);
        std::optional<std::string> problem;
        {
            const FullDisk full(at);
            for (int i = 0; i < 2000 && !problem; ++i) {
                (*recorder)->hand(0).push({});
                (*recorder)->frame({10.0 + i * 1e-3});
                (*recorder)->cue_step({10.0 + i * 1e-3});
                (*recorder)->said(10.0, {"Wall.", SpeechClass::Contact}, true);
                sleep_ms(1);
                problem = (*recorder)->take_problem();
            }
            EXPECT_TRUE(FullDisk::struck());
        }
        ASSERT_TRUE(problem) << at;
        EXPECT_EQ(
            *problem,
            "The recording ends here, because it can no longer be written: No space left on device. Everything else "
            "keeps working.");
        EXPECT_FALSE((*recorder)->take_problem());  // the recorder reports the problem only once
        // After the failure, the recorder accepts no more rows, and no caller must wait for it. Everything written
        // before must be readable.
        (*recorder)->said(11.0, {"Later.", SpeechClass::Answer}, true);
        for (std::size_t i = 0; i < 2 * HandRing::kRows; ++i) (*recorder)->hand(0).push({});
        (*recorder)->end(11.0);
        const auto read = read_recording((*recorder)->folder());
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_FALSE(read->ended);
        for (const SaidLine& line : said_lines(*read)) EXPECT_EQ(line.text, "Wall.");
    }
}

TEST(Recorder, that_cannot_start_gives_the_reason_and_leaves_no_files) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "file");
    const fs::path no_folder = folder.write("text", "x");
    const auto refused = Recorder::begin(no_folder / "recordings", head_now(0.0));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("Nothing is recorded."), std::string::npos) << refused.error().message;
}

TEST(Recorder, reports_how_many_ticks_did_not_fit) {
    const TemporaryFolder folder;
    auto recorder = Recorder::begin(folder.path(), head_now(0.0));
    ASSERT_TRUE(recorder);
    for (std::size_t i = 0; i < 40 * HandRing::kRows; ++i) (*recorder)->hand(0).push({});
    (*recorder)->end(0.0);
    const auto read = read_recording((*recorder)->folder());
    ASSERT_TRUE(read);
    const bool reported = std::any_of(read->lines.begin(), read->lines.end(),
                                      [](const RecordedLine& line) { return line.is == "lost_rows"; });
    EXPECT_EQ(reported, read->hands[0].size() < 40 * HandRing::kRows);
    EXPECT_TRUE(reported);
}

}  // namespace recorder_test
}  // namespace handrail
