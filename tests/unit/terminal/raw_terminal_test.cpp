// Tests that a person's terminal is restored however the program ends. Each case runs in a separate terminal, and the
// test then reads the terminal's modes. These tests do not run under the thread sanitizer, which delays signals. Under
// that sanitizer, tests/program ends and stops the whole program instead.
#if !defined(HANDRAIL_SANITIZED_THREAD)
#include "app/terminal/raw_terminal.h"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/support/child_process.h"
#include "tests/support/names.h"
#include "tests/support/pty_job.h"
#include "tests/support/scale.h"

namespace handrail {
namespace raw_terminal_test {

using test::PtyJob;

// Starts a job that puts its terminal into raw mode, reports that, waits for a line end and then calls `then`.
std::unique_ptr<PtyJob> job_that(const std::function<void()>& then) {
    auto job = PtyJob::start([then] {
        const auto terminal = RawTerminal::take(STDIN_FILENO, STDOUT_FILENO);
        [[maybe_unused]] ssize_t put = ::write(STDOUT_FILENO, terminal ? "taken" : "refused", terminal ? 5 : 7);
        char key = 0;
        while (::read(STDIN_FILENO, &key, 1) == 1 && key != '\r') {
        }
        then();
    });
    EXPECT_TRUE(job && job->says("taken")) << (job ? job->said() : std::string());
    return job;
}

TEST(RawTerminal, delivers_each_key_at_once_and_is_restored_at_the_end) {
    const auto job = job_that([] {});
    EXPECT_TRUE(job->gives_keys());
    EXPECT_FALSE(job->as_before());
    EXPECT_NE(job->modes().c_lflag & ISIG, 0U);
    job->type("x\r");
    EXPECT_EQ(job->ends(), 0);
    EXPECT_TRUE(job->as_before());
    EXPECT_TRUE(job->says("\x1b[?2004l")) << "pastes are not marked any more";
}

TEST(RawTerminal, is_restored_by_exit_by_an_uncaught_exception_and_by_a_failed_precondition) {
    struct Way {
        const char* name;
        std::function<void()> then;
        int status;
    };
    const Way ways[] = {
        {"exit", [] { std::exit(3); }, 3},
        {"exit on another thread", [] { std::thread([] { std::exit(4); }).join(); }, 4},
        {"an exception", [] { std::thread([] { throw std::runtime_error("nobody catches this"); }).join(); },
         128 + SIGABRT},
        {"abort", [] { std::abort(); }, 128 + SIGABRT}};
    for (const Way& way : ways) {
        const auto job = job_that(way.then);
        EXPECT_TRUE(job->gives_keys()) << way.name;
        job->type("\r");
        EXPECT_EQ(job->ends(), way.status) << way.name;
        EXPECT_TRUE(job->as_before()) << way.name;
    }
}

TEST(RawTerminal, is_restored_by_each_fatal_signal_which_still_ends_the_program) {
    for (const int number :
         {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGUSR1, SIGALRM, SIGPIPE}) {
        const auto job = job_that([] {});
        EXPECT_TRUE(job->gives_keys()) << number;
        job->send(number);
        test::expect_ended_by(number, job->ends());
        EXPECT_TRUE(job->as_before()) << number;
    }
}

// `depth` is volatile, so that the compiler cannot see where the recursion ends.
int deeper(volatile int* depth) {
    volatile char room[4096];
    room[0] = static_cast<char>(*depth);
    *depth = *depth + 1;
    return *depth < 0 ? 0 : deeper(depth) + room[0];
}

TEST(RawTerminal, is_restored_after_a_crash_and_after_a_stack_overflow) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "a sanitizer ends such a program itself, before there is a signal";
    const auto crash = job_that([] { *static_cast<volatile int*>(nullptr) = 1; });
    crash->type("\r");
    EXPECT_EQ(crash->ends(), 128 + SIGSEGV);
    EXPECT_TRUE(crash->as_before());
    const auto overflow = job_that([] {
        volatile int depth = 0;
        std::exit(deeper(&depth));
    });
    overflow->type("\r");
    EXPECT_EQ(overflow->ends(), 128 + SIGSEGV);
    EXPECT_TRUE(overflow->as_before());
}

TEST(RawTerminal, ctrl_c_and_ctrl_backslash_still_end_the_program) {
    for (const auto& [key, number] : {std::pair{"\x03", SIGINT}, std::pair{"\x1c", SIGQUIT}}) {
        const auto job = job_that([] {});
        job->type(key);
        EXPECT_EQ(job->ends(), 128 + number);
        EXPECT_TRUE(job->as_before());
    }
}

TEST(RawTerminal, is_restored_while_stopped_by_ctrl_z_and_resumed_in_the_foreground_any_number_of_times) {
    const auto job = job_that([] {});
    for (int round = 0; round < 3; ++round) {
        job->type("\x1a");
        ASSERT_TRUE(job->stops()) << round;
        EXPECT_TRUE(job->as_before()) << round;
        job->in_foreground();
        EXPECT_TRUE(test::eventually([&] { return job->gives_keys(); })) << round;
    }
    job->type("\r");
    EXPECT_EQ(job->ends(), 0);
    EXPECT_TRUE(job->as_before());
}

TEST(RawTerminal, of_a_background_job_is_left_to_the_shell) {
    const auto job = job_that([] {});
    job->type("\x1a");
    ASSERT_TRUE(job->stops());
    job->send(SIGCONT);
    // The continued job reads from its terminal in the background, so the kernel stops the job again.
    ASSERT_TRUE(job->stops());
    EXPECT_TRUE(job->as_before());
    job->send(SIGTERM);
    job->send(SIGCONT);
    EXPECT_EQ(job->ends(), 128 + SIGTERM);
    EXPECT_TRUE(job->as_before());
}

TEST(RawTerminal, passes_no_pending_keys_on_to_the_shell) {
    const auto job = job_that([] { ::usleep(300'000); });
    job->type("\r");
    job->type("\x1b[A\r");
    EXPECT_EQ(job->ends(), 0);
    // The shell must find the terminal in line mode, with no bytes waiting.
    termios now = job->modes();
    EXPECT_NE(now.c_lflag & ICANON, 0U);
    EXPECT_EQ(job->waiting_bytes(), 0);
}

TEST(RawTerminal, is_refused_without_a_terminal_and_for_a_second_time) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    EXPECT_FALSE(RawTerminal::take(ends[0], ends[1]));
    ::close(ends[0]);
    ::close(ends[1]);
    const auto job = job_that([] {
        if (RawTerminal::take(STDIN_FILENO, STDOUT_FILENO)) std::exit(1);
    });
    job->type("\r");
    EXPECT_EQ(job->ends(), 0);
}

}  // namespace raw_terminal_test
}  // namespace handrail
#endif
