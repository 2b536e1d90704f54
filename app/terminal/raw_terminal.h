// A terminal that delivers each key at once while this object lives: without waiting for line ends and without echo.
// Ctrl+C, Ctrl+Z and Ctrl+\ stay signals.
//
// However the program ends, the terminal is restored: at the end of this object, at exit(), and by a signal that ends
// the program, including a crash. If Ctrl+Z stops the program, the terminal is restored, and taken again when the
// program continues in the foreground. The code in signal handlers is async-signal-safe. No program can catch SIGKILL;
// `reset` or `stty sane` then helps.
//
// The process has one such object; a second is refused. If the stack of the constructing thread overflows, the handler
// runs on a spare stack; other threads have none. App thread.
#pragma once

#include <memory>

namespace handrail::terminal {

class RawTerminal {
public:
    // Null unless both are terminals of the same kind whose modes can be changed. Writes to `output` only the sequence
    // that makes the terminal mark pasted text.
    static std::unique_ptr<RawTerminal> take(int input, int output);
    ~RawTerminal();
    RawTerminal(const RawTerminal&) = delete;
    RawTerminal& operator=(const RawTerminal&) = delete;

    char erase() const;  // the character that its Backspace sends

private:
    RawTerminal();
};

}  // namespace handrail::terminal
