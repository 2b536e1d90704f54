// Runs a program in its own terminal, as a shell runs a job in the foreground. A separate session leader stays when the
// job has ended. So the kernel does not restore the terminal's modes, and the test can see the state in which the job
// left them. in_foreground() continues a stopped job, as `fg` does.
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
    // Runs `run` as the job, in a separate process whose standard input, output and error are the terminal. `run`
    // should end that process; if it returns, the job exits with 0. Returns null if no terminal is available.
    static std::unique_ptr<PtyJob> start(const std::function<void()>& run);
    ~PtyJob();
    PtyJob(const PtyJob&) = delete;
    PtyJob& operator=(const PtyJob&) = delete;

    const termios& before() const { return before_; }  // the terminal's modes when the job received it
    termios modes() const;                             // returns the terminal's present modes
    bool as_before() const;                            // returns true if every flag and character is as in before()
    bool gives_keys() const { return (modes().c_lflag & (ICANON | ECHO)) == 0; }

    void type(const std::string& bytes) const;  // sends bytes as a keyboard does
    // Returns true as soon as the job has written `text` after the position `from`. Returns false after `most_s`, or
    // when the job ends.
    bool says(const std::string& text, std::size_t from = 0, double most_s = kPatience_s);
    const std::string& said();  // returns all output of the job until now

    int waiting_bytes() const;  // returns how many bytes were typed that no program has read yet

    void send(int signal) const;
    void in_foreground() const;
    bool stops(double most_s = kPatience_s);  // returns true if the job has been stopped since it last continued
    // Waits for the job's end and returns its exit status. The result is 128 + the signal's number if a signal ended
    // the job, and -1 if it has not ended after `most_s`.
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

// Checks that the signal `signal` has ended a program. A sanitizer that catches crashes prints its report and exits
// with its own status; that status is accepted too.
void expect_ended_by(int signal, int status);

}  // namespace handrail::test
