// A foreign program started for a test and gone with it: a group of its own, killed by the destructor, and by the
// kernel when the test dies.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace handrail::test {

using Environment = std::map<std::string, std::string>;  // set on top of the test's own; an empty value removes

class ChildProcess {
public:
    // Standard output and error go to `output`, standard input comes from a pipe that type() writes to. Null when it
    // could not be started.
    static std::unique_ptr<ChildProcess> start(const std::vector<std::string>& words, const Environment& environment,
                                               const std::filesystem::path& output);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    void type(const std::string& text);  // to its standard input
    void end_input();
    void send(int signal) const;  // to it and all that it has started in its group
    void kill();                  // SIGKILL, and waits for its end
    bool running();
    pid_t pid() const { return pid_; }
    int exit_status();  // waits for its end; 128 + signal number when a signal ended it

private:
    ChildProcess(pid_t pid, int input) : pid_(pid), input_(input) {}

    pid_t pid_;
    int input_;
    int status_ = 0;
    bool ended_ = false;
};

// How long a test waits for an event before it fails. Only failing tests wait that long, so a busy machine has time
// enough.
constexpr double kPatience_s = 300.0;

// True as soon as `holds` does, looked at every 2 ms; false after `most_s`, which only a failing test needs.
bool eventually(const std::function<bool()>& holds, double most_s = kPatience_s);

// True if a program of this name lies in the usual folders.
bool installed(const std::string& program);

// Why no library can be laid before those of a child (LD_PRELOAD); empty where it can.
std::string why_no_preload();

}  // namespace handrail::test
