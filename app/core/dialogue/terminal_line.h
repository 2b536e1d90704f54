// Interprets a typed line. It knows the same commands as the keys, as words, for a console screen reader, a pipe, a
// script or a test. Pure functions; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/core/dialogue/command.h"
#include "worlds/base/result.h"

namespace handrail::core {

// The meaning of one line: a command done `times` times, or leaving.
struct TerminalLine {
    std::optional<Command> command;  // none: an empty line
    int times = 1;                   // "forward 5"
    std::string choice = {};         // "describe library": the item to choose in the list that the command opens
    bool leave = false;              // "quit", or its word in the language spoken: leaves without confirmation
};

// Understands "word", "word count", whole sentences (typed_sentences.h) and, for a command that opens a list of places,
// "word choice". The word may be in English or in the language spoken. An error for an unknown word suggests the
// nearest known word of the language spoken. An error for a bad count gives the valid range. An error for an unknown
// sentence says that it is unknown.
Result<TerminalLine> parse_terminal_line(std::string_view line);

}  // namespace handrail::core
