// Interprets whole sentences, which people type if they do not know the words of the commands: "where am I", "take me
// to the kitchen", "turn left three times". settings/languages lists the sentences under typed_sentence, with one text
// for each command. Pure functions of the language spoken, which any thread except the servo's may call.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/core/dialogue/command.h"

namespace handrail::core {

struct TypedSentence {
    Command command = Command::Help;
    int times = 1;  // how often to repeat the command, 1 to kMostTimes
    // The item to choose in the list that the command opens, without article; empty: no choice.
    std::string choice = {};
};

inline constexpr int kMostTimes = 1000;  // most repetitions that a person can type

// Returns the command that a sentence means. Returns no value if the line is not a known sentence in the language
// spoken or in English. Case, punctuation and polite words do not matter, umlauts may be written out, and small numbers
// may be words.
std::optional<TypedSentence> typed_sentence(std::string_view line);

// Returns true if the command opens a list of places in which the person can choose by name, or takes a text.
bool takes_choice(Command command);
// Returns true if what follows the command is a text instead of a name in a list.
bool takes_text(Command command);

// Removes leading words such as "to" and "the" from the name that a person typed to choose a thing. Returns the whole
// text if nothing else would be left.
std::string without_fillers(std::string_view typed);

}  // namespace handrail::core
