// Runs a foreign program for one test. The program has its own process group. The destructor kills the group; if the
// test dies, the kernel kills the program.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

// Variables that are set in addition to the test's environment. An empty value removes a variable.
using Environment = std::map<std::string, std::string>;

class ChildProcess {
public:
    // Starts a program. Standard output and error go to `output`; standard input is a pipe to which type() writes.
    // Returns null if the program could not be started.
    static std::unique_ptr<ChildProcess> start(const std::vector<std::string>& words, const Environment& environment,
                                               const std::filesystem::path& output);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    void type(const std::string& text);  // writes `text` to the program's standard input
    void end_input();
    void send(int signal) const;  // sends a signal to the program and to all processes in its group
    void kill();                  // sends SIGKILL to the group and waits for the program's end
    bool running();
    pid_t pid() const { return pid_; }
    // Waits for the program's end and returns its exit status, or 128 + signal number if a signal ended the program.
    int exit_status();

private:
    ChildProcess(pid_t pid, int input) : pid_(pid), input_(input) {}

    pid_t pid_;
    int input_;
    int status_ = 0;
    bool ended_ = false;
};

// How long a test waits for an event before it fails. Only failing tests wait that long, so the limit is long enough
// for a busy machine.
constexpr double kPatience_s = 300.0;

// Checks `holds` every 2 ms and returns true as soon as it is true. Returns false after `most_s`, which only a failing
// test reaches.
bool eventually(const std::function<bool()>& holds, double most_s = kPatience_s);

// Returns true if a program of this name is in the usual folders.
bool installed(const std::string& program);

// Returns why no library can be preloaded into a child (LD_PRELOAD), or an empty text if that is possible.
std::string why_no_preload();

}  // namespace handrail::test
