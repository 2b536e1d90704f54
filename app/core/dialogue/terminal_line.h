// A typed line understood: the same commands that keys give, as words, for a console screen reader, a pipe, a script or
// a test. Pure functions. Any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/core/dialogue/command.h"
#include "worlds/base/result.h"

namespace handrail {

// One line understood: a command done `times` times, or the end.
struct TerminalLine {
    std::optional<Command> command;  // none: an empty line
    int times = 1;                   // "forward 5"
    std::string choice = {};         // "describe library": what is chosen in the list that the command opens
    bool leave = false;              // "quit", or its word in the language spoken: leaves without asking
};

// Understands "word", "word count" or, of a command that opens a list of places, "word choice", the word in English or
// the language spoken, and whole sentences (typed_sentences.h); an unknown word fails naming the nearest of the latter,
// a bad count says what it takes, a sentence that is not known that it is none.
Result<TerminalLine> parse_terminal_line(std::string_view line);

}  // namespace handrail
