// Collects notes for a report on a crashed session: the program, settings other than the defaults, and the last
// commands. They are collected while the session runs, because a crashed program cannot report them. They never contain
// typed text, or names of worlds, files, devices or persons. Use this class on the app thread only.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::core {

class CrashNotes {
public:
    static constexpr std::size_t kMost = 40;  // number of commands that are kept

    // `lines` describe the program and its settings, one sentence each.
    explicit CrashNotes(std::vector<std::string> lines) : lines_(std::move(lines)) {}

    // Notes a command with its time. `act` is the command's own word, which is the same in every language ("forward").
    void note(std::string_view act, double now_s);
    // Returns how often text() has changed.
    std::uint64_t changes() const { return changes_; }
    // Returns one sentence a line: the lines from the constructor, then the last commands. For each command, the
    // sentence says how many seconds the command came before the latest one.
    std::string text() const;

private:
    struct Act {
        std::string word;
        double at_s = 0.0;
        int times = 1;  // number of consecutive repetitions of the command
    };
    std::vector<std::string> lines_;
    std::deque<Act> acts_;
    std::uint64_t changes_ = 1;
};

// Returns true if the value of a setting reveals nothing about the person. Numbers, true, false and the words listed in
// `range` may be reported. Names of devices, voices, files or keys may not.
bool may_be_reported(std::string_view value, std::string_view range);

// Returns one sentence about the signal that ended a program. 0 means that no signal was noted.
std::string spoken_end(int signal);

}  // namespace handrail::core
