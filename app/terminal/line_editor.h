// Edits a line that a person types at a terminal where keys otherwise act at once. Returns what to show for each key,
// and the line once it is complete. To delete, it moves the cursor back by one step, as the terminal itself does. It
// never moves the cursor in other ways, so that screen readers and braille displays can follow. Pure state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/terminal/key_decoder.h"

namespace handrail::terminal {

class LineEditor {
public:
    struct Reply {
        std::string echo;                // what to write to the terminal
        std::vector<std::string> lines;  // the completed lines; only pasted text can give more than one
        bool left = false;               // true if Escape cancelled the line
        bool taken = false;              // false: the key has no meaning in a line, so the caller must act on it
    };

    bool is_open() const { return open_; }
    // Begins a line. Returns `prompt`, which the caller shows before the line.
    std::string open(std::string_view prompt = {});
    // Applies an input to the open line. Call it only while a line is open.
    Reply take(const TerminalInput& input);
    // Cancels the line. Returns what the caller must write to the terminal to end the line.
    std::string close();

    static constexpr std::size_t kLongest = 4096;  // longest line in bytes; the editor ignores further typing

private:
    Reply take_text(std::string_view text);

    bool open_ = false;
    std::string text_;
};

}  // namespace handrail::terminal
