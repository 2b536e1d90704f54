// A terminal that gives each key at once, for as long as this lives: no waiting for line ends, no echo, while Ctrl+C,
// Ctrl+Z and Ctrl+\ stay signals. However the program ends, the terminal is given back as it was: at the end of this
// object, at exit(), and by a signal that ends the program, a crash among them; stopped by Ctrl+Z it is given back and
// taken again when the program goes on in the foreground. What runs in a signal handler is async-signal-safe.
// (SIGKILL cannot be seen by anybody; `reset` or `stty sane` then helps.)
//
// The process has one; a second is refused. A thread whose stack overflows has its handler on the stack set aside by
// the thread that constructed this, if it is that one. App thread.
#pragma once

#include <memory>

namespace handrail {

class RawTerminal {
public:
    // Null unless both are one and the same kind of thing, a terminal, whose modes can be changed.
    // Writes to `output` that pasted text is to be marked; nothing else is ever written.
    static std::unique_ptr<RawTerminal> take(int input, int output);
    ~RawTerminal();
    RawTerminal(const RawTerminal&) = delete;
    RawTerminal& operator=(const RawTerminal&) = delete;

    char erase() const;  // what its Backspace sends

private:
    RawTerminal();
};

}  // namespace handrail
