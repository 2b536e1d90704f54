// Turns the bytes from a terminal into keys by name and text: a pure state machine, without a clock or a terminal. It
// knows the sequences of xterm and its followers (VTE, kitty, tmux), VT220, the Linux console and rxvt, UTF-8 text, and
// bracketed paste. The names are those of the window (app/window/keys.h): "Control+Up", "Shift+5".
//
// A terminal reports characters and not keys. A letter is therefore the key that bears it, whatever its place. Shift
// with a digit is recognised by the sign that it makes on the keyboard of a language. No key ever goes up, and
// modifiers alone are seen only if the terminal reports them by the kitty protocol.
//
// Sources: ECMA-48; XTerm Control Sequences (T. Dickey), PC-Style Function Keys; console_codes(4); urxvt(7); the
// keyboard protocol of kitty.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::terminal {

// One input at the terminal: a key, typed text, or pasted text.
struct TerminalInput {
    std::string key;      // name of the key; empty for text that none of our keys types
    std::string text;     // typed text in UTF-8; empty for arrows and the like
    bool pasted = false;  // pasted text without a key; one paste may arrive in several inputs

    bool operator==(const TerminalInput&) const = default;
};

struct TerminalKeyboard {
    // What Shift makes of 0 to 9; empty if that sign has its own key.
    std::array<std::string_view, 10> shifted_digits{")", "!", "@", "#", "$", "%", "^", "&", "*", "("};
    char erase = '\x7f';          // what Backspace sends (termios, VERASE)
    bool rxvt_functions = false;  // CSI 25 ~ is Shift+F3, as in rxvt; else Shift+F1, as on the Linux console
};

// The keyboard of a person who is spoken to in `language` ("de"), at a terminal of the kind `terminal` (TERM) with that
// erase character.
TerminalKeyboard terminal_keyboard(std::string_view language, std::string_view terminal, char erase);

class KeyDecoder {
public:
    explicit KeyDecoder(const TerminalKeyboard& keyboard = {}) : keyboard_(keyboard) {}

    // The inputs that these bytes complete, in order. Unknown sequences, and bytes that are not UTF-8, are skipped.
    std::vector<TerminalInput> take(std::string_view bytes);
    // True while the beginning of something is held, such as an Escape, which is the key Escape if nothing follows it
    // at once.
    bool waits() const { return !held_.empty() && !pasting_; }
    // Nothing has followed in time: the held bytes are decoded as they are.
    std::vector<TerminalInput> time_out();

private:
    struct Step {
        std::size_t bytes = 0;  // 0: more bytes are needed to decide
        TerminalInput input;    // empty: unknown
    };
    void take_held(std::vector<TerminalInput>& done, bool nothing_follows);
    Step step(std::string_view bytes, bool nothing_follows) const;
    Step escape_step(std::string_view bytes, bool nothing_follows) const;
    Step control_step(std::string_view bytes) const;
    Step coded_step(std::size_t used, unsigned code, unsigned modifiers) const;
    Step numbered_step(std::size_t used, char last, unsigned number, unsigned modifiers) const;
    static Step named(std::size_t used, std::string_view key, unsigned modifiers);
    Step character_step(std::string_view bytes) const;
    // Decodes the text between the marks of a paste. Returns false if all held bytes may be part of the end mark.
    bool paste_step(std::vector<TerminalInput>& done);

    TerminalKeyboard keyboard_;
    std::string held_;
    bool pasting_ = false;
};

}  // namespace handrail::terminal
