// What a report says about a session that crashed: the program, settings other than the defaults, and the last
// commands. It is collected while the session runs, because nobody can be asked afterwards. It never contains typed
// text or names of worlds, files, devices or persons. App thread only.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::core {

class CrashNotes {
public:
    static constexpr std::size_t kMost = 40;  // commands that are kept

    // lines: about the program and its settings, one sentence each.
    explicit CrashNotes(std::vector<std::string> lines) : lines_(std::move(lines)) {}

    // Notes a command and its time. `act` is its word, the same in every language ("forward").
    void note(std::string_view act, double now_s);
    // Counts changes of text().
    std::uint64_t changes() const { return changes_; }
    // One sentence a line: the given lines, then the last commands, each with how many seconds it came before the
    // latest one.
    std::string text() const;

private:
    struct Act {
        std::string word;
        double at_s = 0.0;
        int times = 1;  // consecutive repetitions
    };
    std::vector<std::string> lines_;
    std::deque<Act> acts_;
    std::uint64_t changes_ = 1;
};

// True if a setting's value reveals nothing about the person. Numbers, true, false, and words that `range` lists may be
// reported; names of devices, voices, files or keys may not.
bool may_be_reported(std::string_view value, std::string_view range);

// One sentence about the signal that ended a program; 0: no signal was seen.
std::string spoken_end(int signal);

}  // namespace handrail::core
