// A line that is typed at a terminal where keys otherwise act at once: what to show for each key, and the line when it
// is complete. It moves the cursor only one step back to delete, as the terminal itself does, so that screen readers
// and braille displays can follow. Pure state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/terminal/key_decoder.h"

namespace handrail::terminal {

class LineEditor {
public:
    struct Reply {
        std::string echo;                // to be written to the terminal
        std::vector<std::string> lines;  // the completed lines; more than one only from pasted text
        bool left = false;               // Escape was pressed: the line is cancelled
        bool taken = false;              // false: the key does not belong to a line
    };

    bool is_open() const { return open_; }
    // Begins a line; returns `prompt`, which is to be shown before it.
    std::string open(std::string_view prompt = {});
    // Call it only while a line is open.
    Reply take(const TerminalInput& input);
    // Cancels the line without carrying it out. Returns what ends it on the terminal.
    std::string close();

    static constexpr std::size_t kLongest = 4096;  // bytes; further typing is ignored

private:
    Reply take_text(std::string_view text);

    bool open_ = false;
    std::string text_;
};

}  // namespace handrail::terminal
