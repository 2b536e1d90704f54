// A foreign program that runs for one test. It has its own process group, which the destructor kills, as does the
// kernel when the test dies.
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

// Set on top of the test's environment; an empty value removes a variable.
using Environment = std::map<std::string, std::string>;

class ChildProcess {
public:
    // Standard output and error go to `output`; standard input is a pipe to which type() writes. Null if the program
    // could not be started.
    static std::unique_ptr<ChildProcess> start(const std::vector<std::string>& words, const Environment& environment,
                                               const std::filesystem::path& output);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    void type(const std::string& text);  // to its standard input
    void end_input();
    void send(int signal) const;  // to the program and all processes that it has started in its group
    void kill();                  // sends SIGKILL and waits for the end
    bool running();
    pid_t pid() const { return pid_; }
    int exit_status();  // waits for the end; 128 + signal number if a signal ended it

private:
    ChildProcess(pid_t pid, int input) : pid_(pid), input_(input) {}

    pid_t pid_;
    int input_;
    int status_ = 0;
    bool ended_ = false;
};

// How long a test waits for an event before it fails. Only failing tests wait that long, so a busy machine has enough
// time.
constexpr double kPatience_s = 300.0;

// Returns true as soon as `holds` is true, which it checks every 2 ms. Returns false after `most_s`, which only a
// failing test reaches.
bool eventually(const std::function<bool()>& holds, double most_s = kPatience_s);

// True if a program of this name is in the usual folders.
bool installed(const std::string& program);

// Why no library can be preloaded into a child (LD_PRELOAD); empty if it can.
std::string why_no_preload();

}  // namespace handrail::test
