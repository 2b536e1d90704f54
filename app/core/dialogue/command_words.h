// The words that a person may type for a command. Each command has its own word in command_table(), which settings,
// worlds and scenarios also use. The language spoken adds others and plain synonyms (settings/languages, command_word).
// Pure functions of the language spoken; any thread except the servo's.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/command.h"

namespace handrail::core {

// The form in which words are compared: lower case, umlauts written out.
std::string plain_word(std::string_view word);
// Case does not matter, and umlauts may be written out ("zurueck"). Every word means at most one command.
std::optional<Command> command_of_word(std::string_view word);
// The name of a command in the language spoken: the first of its words there.
std::string spoken_word(Command command);
// True if the word leaves at once.
bool is_quit_word(std::string_view word);
// The name of each command in the order of command_table(), for "did you mean". None of them is a word that leaves at
// once.
std::vector<std::string> spoken_words();

// Translates a key of a list typed as a word, such as "down", from the language spoken to the English word. Any other
// word is returned unchanged.
std::string list_word(std::string_view word);

// The same for any table of the languages ("wizard_word"). `words` are the table's keys, which are the English words.
std::string english_word(std::string_view table, std::span<const std::string_view> words, std::string_view typed);
// The name of such a word in the language spoken: the first that its table lists.
std::string spoken_word(std::string_view table, std::string_view word);

}  // namespace handrail::core
