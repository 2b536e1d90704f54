#include "tests/support/pty_job.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/support/names.h"
#include "tests/support/scale.h"

namespace handrail::test {
namespace {

using SteadyTime = std::chrono::steady_clock;

struct Report {
    enum Kind : int { Started, Stopped, Ended } kind = Started;
    int value = 0;
};

void write_report(int reports, Report report) {
    [[maybe_unused]] const ssize_t put = ::write(reports, &report, sizeof report);
}

pid_t lead_job = -1;
int lead_terminal = -1;

// Starts the job in the foreground of the terminal and reports when it stops or ends, as a shell does. Runs in the
// session leader's process and never returns.
[[noreturn]] void lead(int slave, int reports, const std::function<void()>& run) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::setsid();
    ::ioctl(slave, TIOCSCTTY, 0);
    ::signal(SIGTTOU, SIG_IGN);
    ::signal(SIGHUP, SIG_IGN);
    const pid_t leader = ::getpid();
    lead_terminal = slave;
    lead_job = ::fork();
    if (lead_job == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::setpgid(0, 0);
        ::tcsetpgrp(slave, ::getpid());
        ::signal(SIGTTOU, SIG_DFL);
        ::signal(SIGHUP, SIG_DFL);
        for (const int standard : {0, 1, 2}) ::dup2(slave, standard);
        ::close(slave);
        ::close(reports);
        run();
        ::exit(0);
    }
    ::setpgid(lead_job, lead_job);
    ::tcsetpgrp(slave, lead_job);
    struct sigaction foreground {};
    foreground.sa_handler = [](int) {
        ::tcsetpgrp(lead_terminal, lead_job);
        ::kill(-lead_job, SIGCONT);
    };
    ::sigaction(SIGUSR1, &foreground, nullptr);
    write_report(reports, {Report::Started, lead_job});
    while (true) {
        int status = 0;
        if (::waitpid(lead_job, &status, WUNTRACED) < 0) {
            if (errno == EINTR) continue;
            break;
        }
        ::tcsetpgrp(slave, leader);
        if (WIFSTOPPED(status)) {
            write_report(reports, {Report::Stopped, WSTOPSIG(status)});
        } else {
            write_report(reports, {Report::Ended, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)});
            break;
        }
    }
    while (true) ::pause();
}

}  // namespace

std::unique_ptr<PtyJob> PtyJob::start(const std::function<void()>& run) {
    std::unique_ptr<PtyJob> job(new PtyJob);
    job->master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (job->master_ < 0 || ::grantpt(job->master_) != 0 || ::unlockpt(job->master_) != 0) return nullptr;
    std::array<char, 128> name{};
    if (::ptsname_r(job->master_, name.data(), name.size()) != 0) return nullptr;
    job->slave_ = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (job->slave_ < 0) return nullptr;
    // Sets modes that no program would set by chance.
    ::tcgetattr(job->slave_, &job->before_);
    job->before_.c_lflag &= ~static_cast<tcflag_t>(ECHOK);
    job->before_.c_cc[VKILL] = 0x19;
    ::tcsetattr(job->slave_, TCSANOW, &job->before_);
    ::tcgetattr(job->slave_, &job->before_);
    std::array<int, 2> reports{-1, -1};
    if (::pipe2(reports.data(), O_CLOEXEC) != 0) return nullptr;
    job->reports_ = reports[0];
    job->leader_ = ::fork();
    if (job->leader_ == 0) lead(job->slave_, reports[1], run);
    ::close(reports[1]);
    if (job->leader_ < 0) return nullptr;
    for (int i = 0; i < 1000 && job->job_ < 0; ++i) job->read_reports(10);
    return job->job_ < 0 ? nullptr : std::move(job);
}

PtyJob::~PtyJob() {
    if (job_ > 0 && ended_ < 0) ::kill(-job_, SIGKILL);
    if (leader_ > 0) {
        ::kill(leader_, SIGKILL);
        ::waitpid(leader_, nullptr, 0);
    }
    for (const int fd : {master_, slave_, reports_})
        if (fd >= 0) ::close(fd);
}

termios PtyJob::modes() const {
    termios now{};
    ::tcgetattr(slave_, &now);
    return now;
}

bool PtyJob::as_before() const {
    const termios now = modes();
    return now.c_iflag == before_.c_iflag && now.c_oflag == before_.c_oflag && now.c_cflag == before_.c_cflag &&
           now.c_lflag == before_.c_lflag && std::memcmp(now.c_cc, before_.c_cc, sizeof now.c_cc) == 0;
}

void PtyJob::type(const std::string& bytes) const {
    [[maybe_unused]] const ssize_t put = ::write(master_, bytes.data(), bytes.size());
}

void PtyJob::read_what_came(int wait_ms) {
    pollfd ready{master_, POLLIN, 0};
    while (::poll(&ready, 1, wait_ms) == 1 && (ready.revents & POLLIN) != 0) {
        std::array<char, 4096> block{};
        const ssize_t got = ::read(master_, block.data(), block.size());
        if (got <= 0) return;
        said_.append(block.data(), static_cast<std::size_t>(got));
        wait_ms = 0;
    }
}

void PtyJob::read_reports(int wait_ms) {
    pollfd ready{reports_, POLLIN, 0};
    while (::poll(&ready, 1, wait_ms) == 1 && (ready.revents & POLLIN) != 0) {
        Report report;
        if (::read(reports_, &report, sizeof report) != static_cast<ssize_t>(sizeof report)) return;
        if (report.kind == Report::Started) job_ = report.value;
        else if (report.kind == Report::Stopped) ++stopped_;
        else ended_ = report.value;
        wait_ms = 0;
    }
}

const std::string& PtyJob::said() {
    read_what_came(0);
    return said_;
}

bool PtyJob::says(const std::string& text, std::size_t from, double most_s) {
    const auto deadline = SteadyTime::now() + std::chrono::duration<double>(most_s);
    while (said_.find(text, std::min(from, said_.size())) == std::string::npos) {
        if (SteadyTime::now() > deadline) return false;
        read_what_came(20);
        read_reports(0);
        if (ended_ >= 0) {
            read_what_came(0);
            return said_.find(text, std::min(from, said_.size())) != std::string::npos;
        }
    }
    return true;
}

int PtyJob::waiting_bytes() const {
    int bytes = -1;
    ::ioctl(slave_, FIONREAD, &bytes);
    return bytes;
}

void PtyJob::send(int signal) const { ::kill(job_, signal); }

void PtyJob::in_foreground() const { ::kill(leader_, SIGUSR1); }

bool PtyJob::stops(double most_s) {
    const auto deadline = SteadyTime::now() + std::chrono::duration<double>(most_s);
    while (stopped_ == 0 && ended_ < 0 && SteadyTime::now() < deadline) {
        read_what_came(0);
        read_reports(20);
    }
    const bool has = stopped_ > 0;
    stopped_ = 0;
    return has;
}

int PtyJob::ends(double most_s) {
    const auto deadline = SteadyTime::now() + std::chrono::duration<double>(most_s);
    while (ended_ < 0 && SteadyTime::now() < deadline) {
        read_what_came(0);  // reads the job's output, because a full terminal would block the job
        read_reports(20);
    }
    read_what_came(0);
    return ended_;
}

void expect_ended_by(int signal, int status) {
    const bool crash =
        signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL || signal == SIGTRAP;
    if (crash && kSanitizerScale < 1.0 && status != 128 + signal) EXPECT_NE(status, 0) << "signal " << signal;
    else EXPECT_EQ(status, 128 + signal);
}

}  // namespace handrail::test
