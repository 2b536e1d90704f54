// A program in a terminal of its own, started as a shell starts a job in the foreground: a session leader of its own
// stays when the job has ended, so that the kernel does not put the terminal's modes back and what the job left can be
// looked at. Stopped jobs go on by in_foreground(), as by `fg`.
#pragma once

#include <sys/types.h>
#include <termios.h>

#include <functional>
#include <memory>
#include <string>

#include "tests/support/child_process.h"

namespace handrail::test {

class PtyJob {
public:
    // `run` is the job: called in a process of its own whose standard input, output and error are the terminal, and
    // ends it; should it return, the job exits with 0. Null when there is no terminal to be had.
    static std::unique_ptr<PtyJob> start(const std::function<void()>& run);
    ~PtyJob();
    PtyJob(const PtyJob&) = delete;
    PtyJob& operator=(const PtyJob&) = delete;

    const termios& before() const { return before_; }  // as the terminal was given to the job
    termios modes() const;                             // now
    bool as_before() const;                            // every flag and character
    bool gives_keys() const { return (modes().c_lflag & (ICANON | ECHO)) == 0; }

    void type(const std::string& bytes) const;  // what a keyboard sends
    // True as soon as the job has written this after `from`; false after `most_s` or at its end.
    bool says(const std::string& text, std::size_t from = 0, double most_s = kPatience_s);
    const std::string& said();  // all that it has written by now

    int waiting_bytes() const;  // typed, and read by nobody

    void send(int signal) const;
    void in_foreground() const;
    bool stops(double most_s = kPatience_s);  // it has been stopped since it last went on
    // 128 + the signal's number when one ended it; -1 when it has not ended after `most_s`.
    int ends(double most_s = kPatience_s);

private:
    PtyJob() = default;
    void read_what_came(int wait_ms);
    void read_reports(int wait_ms);

    int master_ = -1, slave_ = -1, reports_ = -1;
    pid_t leader_ = -1, job_ = -1;
    termios before_{};
    std::string said_;
    int stopped_ = 0, ended_ = -1;
};

// That a program ended by that signal: with its status, or, where a sanitizer looks at crashes, with its report and a
// status of its own.
void expect_ended_by(int signal, int status);

}  // namespace handrail::test
