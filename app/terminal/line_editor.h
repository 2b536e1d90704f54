// A line that is typed where keys act at once: what is to be shown for each key, and the line when it is whole. Plain
// text without cursor movement but a step back to delete, as the terminal itself does it, so that screen readers and
// braille displays follow. Pure state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/terminal/key_decoder.h"

namespace handrail {

class LineEditor {
public:
    struct Reply {
        std::string echo;                // to be written to the terminal
        std::vector<std::string> lines;  // whole now; more than one only of pasted text
        bool left = false;               // by Escape: the line is given up
        bool taken = false;              // false: no key of a line
    };

    bool is_open() const { return open_; }
    // Begins a line; `prompt` is what is to be shown before it. Returns that.
    std::string open(std::string_view prompt = {});
    // For an open line.
    Reply take(const TerminalInput& input);
    // Gives the line up unseen, and returns what ends it on the terminal.
    std::string close();

    static constexpr std::size_t kLongest = 4096;  // bytes; what is typed beyond is not taken

private:
    Reply take_text(std::string_view text);

    bool open_ = false;
    std::string text_;
};

}  // namespace handrail
