// Finds the command for a word that a person types. Each command has a word in command_table(), which settings, worlds
// and scenarios also use. The language spoken adds its own words and synonyms (settings/languages, command_word). Pure
// functions of the language spoken, which any thread except the servo's may call.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/command.h"

namespace handrail::core {

// Returns the form in which words are compared: in lower case, with umlauts written out.
std::string plain_word(std::string_view word);
// Returns the command that this word means. Case does not matter, and umlauts may be written out ("zurueck"). Every
// word means at most one command.
std::optional<Command> command_of_word(std::string_view word);
// Returns the name of a command in the language spoken, which is the first of its words in that language.
std::string spoken_word(Command command);
// Returns true if the word means leaving the program at once.
bool is_quit_word(std::string_view word);
// Returns the name of each command in the order of command_table(), so that an error can suggest the nearest name. None
// of these names is a word that leaves the program at once.
std::vector<std::string> spoken_words();

// Translates a word that stands for a key in a list, such as "down", from the language spoken to English. Returns any
// other word unchanged.
std::string list_word(std::string_view word);

// Translates a word like list_word(), for any table of the language texts, such as "wizard_word". `words` are the keys
// of the table, which are the English words.
std::string english_word(std::string_view table, std::span<const std::string_view> words, std::string_view typed);
// Returns the spoken name of the English word `word` in the language spoken: the first name that `table` lists for it.
std::string spoken_word(std::string_view table, std::string_view word);

}  // namespace handrail::core
