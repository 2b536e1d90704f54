// What would be told of a session that broke off: the program, settings that are not the usual ones, and the last acts.
// Gathered while the session runs, since nobody is there to ask afterwards. No text that was typed and no name of a
// world, file, device or person gets in. App thread only.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace handrail {

class CrashNotes {
public:
    static constexpr std::size_t kMost = 40;  // acts that are kept

    // lines: of the program and its settings, each a sentence.
    explicit CrashNotes(std::vector<std::string> lines) : lines_(std::move(lines)) {}

    // An act by the word that stands for it in every language ("forward"), when it came.
    void note(std::string_view act, double now_s);
    // As often as the text is another one.
    std::uint64_t changes() const { return changes_; }
    // One sentence a line: what was given, then the last acts with the seconds that they came before the latest one.
    std::string text() const;

private:
    struct Act {
        std::string word;
        double at_s = 0.0;
        int times = 1;  // one after the other
    };
    std::vector<std::string> lines_;
    std::deque<Act> acts_;
    std::uint64_t changes_ = 1;
};

// Of a row of settings: whether its value says nothing of who set it. Numbers, true and false, and words out of a few
// that the range lists; not names of devices, voices, files or keys.
bool may_be_reported(std::string_view value, std::string_view range);

// What a signal that ends a program means, as a sentence; of 0, that none was seen.
std::string spoken_end(int signal);

}  // namespace handrail
