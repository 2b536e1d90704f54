// Switches a terminal to raw mode while this object exists: each key arrives at once, without waiting for the end of a
// line and without echo. Ctrl+C, Ctrl+Z and Ctrl+\ still send signals.
//
// However the program ends, the terminal is restored: by the destructor, at exit(), and by a signal that ends the
// program, including a crash. If Ctrl+Z stops the program, the terminal is restored. When the program continues in the
// foreground, the terminal returns to raw mode. The code in signal handlers is async-signal-safe. No program can catch
// SIGKILL; `reset` or `stty sane` then helps.
//
// Only one such object can exist in the process. If the stack of the thread that constructed the object overflows, the
// signal handler runs on a spare stack; other threads have none. App thread.
#pragma once

#include <memory>

namespace handrail::terminal {

class RawTerminal {
public:
    // Returns null if another object exists, if `input` or `output` is no terminal, or if the program is in the
    // background of `input`. Also returns null if the mode of `input` cannot be changed. Writes to `output` only the
    // sequence that makes the terminal mark pasted text.
    static std::unique_ptr<RawTerminal> take(int input, int output);
    ~RawTerminal();
    RawTerminal(const RawTerminal&) = delete;
    RawTerminal& operator=(const RawTerminal&) = delete;

    char erase() const;  // the character that the terminal's Backspace key sends

private:
    RawTerminal();
};

}  // namespace handrail::terminal
