// Interprets a typed line from a console screen reader, a pipe, a script or a test. Every command that has a key can
// also be typed as a word. Pure functions, which any thread may call.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/core/dialogue/command.h"
#include "worlds/base/result.h"

namespace handrail::core {

// The meaning of a line: a command that is to be done `times` times, or the wish to leave.
struct TerminalLine {
    std::optional<Command> command;  // none: an empty line
    int times = 1;                   // 5 for "forward 5"
    std::string choice = {};  // the item to choose in the list that the command opens: "library" for "describe library"
    bool leave = false;       // leave without confirmation: the person typed "quit", or its word in the language spoken
};

// Understands "word", "word count", whole sentences (typed_sentences.h) and, for a command that opens a list of places,
// "word choice". The word may be in English or in the language spoken. Errors:
// - unknown word: suggests the nearest known word of the language spoken;
// - bad count: gives the valid range;
// - unknown sentence: says that it is unknown.
Result<TerminalLine> parse_terminal_line(std::string_view line);

}  // namespace handrail::core
