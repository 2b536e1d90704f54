// The words that a person may type for a command: its own of command_table(), which settings, worlds and scenarios know
// too, and beside it those of the language spoken and plain other ones (settings/languages, command_word). Pure
// functions of the language spoken; any thread but the servo's.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/command.h"

namespace handrail {

// As words are compared: in lower case, umlauts written out.
std::string plain_word(std::string_view word);
// Whatever its case; umlauts may be written out ("zurueck"). Every word means one command at most.
std::optional<Command> command_of_word(std::string_view word);
// How it is called in the language spoken: the first of its words there.
std::string spoken_word(Command command);
// Whether it is the word that leaves at once.
bool is_quit_word(std::string_view word);
// Each command as it is called, in the order of command_table(), for "did you mean": no word among them leaves at once.
std::vector<std::string> spoken_words();

// The keys of a list that are typed as words, "down" and the like, in English or the language spoken: the English word,
// or the word itself where it is none of them.
std::string list_word(std::string_view word);

// The same for any table of the languages ("wizard_word"): `words` are its keys, the English words.
std::string english_word(std::string_view table, std::span<const std::string_view> words, std::string_view typed);
// How such a word is called in the language spoken: the first that its table has for it.
std::string spoken_word(std::string_view table, std::string_view word);

}  // namespace handrail
