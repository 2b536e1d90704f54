// Converts the bytes from a terminal into names of keys and text. It is a pure state machine, without a clock or a
// terminal. It decodes the sequences of xterm and its successors (VTE, kitty, tmux), VT220, the Linux console and rxvt,
// UTF-8 text, and bracketed paste. The names of keys are those of the window (app/window/keys.h): "Control+Up",
// "Shift+5".
//
// A terminal reports characters and not keys. So a letter names a key, wherever that key is on the keyboard. Shift with
// a digit is recognised by the character that it types on the keyboard of a language. Terminals never report that a key
// was released. They report modifiers alone only if they use the kitty protocol.
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
    std::string key;      // name of the key; empty for text that no named key types
    std::string text;     // typed text in UTF-8; empty for keys such as arrows
    bool pasted = false;  // true for pasted text, which has no key; one paste may arrive in several inputs

    bool operator==(const TerminalInput&) const = default;
};

struct TerminalKeyboard {
    // The characters that Shift with the digits 0 to 9 types. An entry is empty if its character is a key of its own.
    std::array<std::string_view, 10> shifted_digits{")", "!", "@", "#", "$", "%", "^", "&", "*", "("};
    char erase = '\x7f';          // the character that Backspace sends (VERASE in termios)
    bool rxvt_functions = false;  // CSI 25 ~ is Shift+F3, as in rxvt; otherwise it is Shift+F1, as on the Linux console
};

// Returns the keyboard of a person to whom the program speaks `language`, such as "de". `terminal` is the kind of
// terminal (TERM), and `erase` its erase character.
TerminalKeyboard terminal_keyboard(std::string_view language, std::string_view terminal, char erase);

class KeyDecoder {
public:
    explicit KeyDecoder(const TerminalKeyboard& keyboard = {}) : keyboard_(keyboard) {}

    // Returns the inputs that these bytes complete, in their order. Skips unknown sequences, and bytes that are not
    // UTF-8.
    std::vector<TerminalInput> take(std::string_view bytes);
    // Returns true while the decoder holds the beginning of an input, such as an Escape. If nothing follows at once,
    // that Escape is the key Escape.
    bool waits() const { return !held_.empty() && !pasting_; }
    // Call this function if no bytes have followed in time. Returns the inputs that the held bytes stand for if nothing
    // follows them.
    std::vector<TerminalInput> time_out();

private:
    struct Step {
        std::size_t bytes = 0;  // number of bytes that were decoded; 0: more bytes are needed to decide
        TerminalInput input;    // the decoded input; empty: unknown sequence
    };
    void take_held(std::vector<TerminalInput>& done, bool nothing_follows);
    Step step(std::string_view bytes, bool nothing_follows) const;
    Step escape_step(std::string_view bytes, bool nothing_follows) const;
    Step control_step(std::string_view bytes) const;
    Step coded_step(std::size_t used, unsigned code, unsigned modifiers) const;
    Step numbered_step(std::size_t used, char last, unsigned number, unsigned modifiers) const;
    static Step named(std::size_t used, std::string_view key, unsigned modifiers);
    Step character_step(std::string_view bytes) const;
    // Decodes the text of a paste. Returns false if more bytes are needed: the held bytes may be the beginning of a
    // character, or of the mark that ends the paste.
    bool paste_step(std::vector<TerminalInput>& done);

    TerminalKeyboard keyboard_;
    std::string held_;
    bool pasting_ = false;
};

}  // namespace handrail::terminal
