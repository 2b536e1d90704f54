// What a terminal sends, as keys by name and as text: a pure state machine over bytes, without a clock or a terminal.
// It knows the sequences of xterm and what follows it (VTE, kitty, tmux), VT220, the Linux console and rxvt, UTF-8
// text, and bracketed paste. The names are those the window gives (app/window/keys.h): "Control+Up", "Shift+5".
//
// A terminal tells of characters and not of keys. A letter is therefore the key that bears it, whatever its place, and
// the Shift of a digit is known by the sign it makes on the keyboard of a language. No key ever goes up, and lone
// modifiers are seen only where the terminal reports them by the protocol of kitty.
// Sources: ECMA-48; XTerm Control Sequences (T. Dickey), PC-Style Function Keys; console_codes(4); urxvt(7); the
// keyboard protocol of kitty.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace handrail {

// One thing that was done at the terminal.
struct TerminalInput {
    std::string key;      // its name; empty for text that no key of ours types
    std::string text;     // UTF-8 that it typed; empty for arrows and the like
    bool pasted = false;  // text put in by the terminal, at most as much as has come; no key

    bool operator==(const TerminalInput&) const = default;
};

struct TerminalKeyboard {
    // What Shift makes of 0 to 9; empty where that sign has a key of its own.
    std::array<std::string_view, 10> shifted_digits{")", "!", "@", "#", "$", "%", "^", "&", "*", "("};
    char erase = '\x7f';          // what Backspace sends (termios, VERASE)
    bool rxvt_functions = false;  // CSI 25 ~ is Shift+F3, as rxvt has it; else Shift+F1, as the Linux console has it
};

// Of a person who is spoken to in that language ("de"), at a terminal of that kind (TERM), with that erase character.
TerminalKeyboard terminal_keyboard(std::string_view language, std::string_view terminal, char erase);

class KeyDecoder {
public:
    explicit KeyDecoder(const TerminalKeyboard& keyboard = {}) : keyboard_(keyboard) {}

    // What these bytes complete, in order. Sequences nobody knows, and bytes that are no UTF-8, are passed over.
    std::vector<TerminalInput> take(std::string_view bytes);
    // The begin of something is held: an Escape, which is the key of that name if nothing follows it at once.
    bool waits() const { return !held_.empty() && !pasting_; }
    // Nothing has followed: what is held is what it is by itself.
    std::vector<TerminalInput> time_out();

private:
    struct Step {
        std::size_t bytes = 0;  // 0: more is needed to tell
        TerminalInput input;    // empty: nothing that we know
    };
    void take_held(std::vector<TerminalInput>& done, bool nothing_follows);
    Step step(std::string_view bytes, bool nothing_follows) const;
    Step escape_step(std::string_view bytes, bool nothing_follows) const;
    Step control_step(std::string_view bytes) const;
    Step coded_step(std::size_t used, unsigned code, unsigned modifiers) const;
    Step numbered_step(std::size_t used, char last, unsigned number, unsigned modifiers) const;
    static Step named(std::size_t used, std::string_view key, unsigned modifiers);
    Step character_step(std::string_view bytes) const;
    // Of the text between the marks of a paste; false when all that is held may be part of the end mark.
    bool paste_step(std::vector<TerminalInput>& done);

    TerminalKeyboard keyboard_;
    std::string held_;
    bool pasting_ = false;
};

}  // namespace handrail
