// What people type when they do not know the words of commands: whole sentences, "where am I", "take me to the
// kitchen", "turn left three times". They stand in settings/languages under typed_sentence, those of a command in one
// text. Pure functions of the language spoken; any thread but the servo's.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/core/dialogue/command.h"

namespace handrail {

struct TypedSentence {
    Command command = Command::Help;
    int times = 1;            // 1 to kMostTimes
    std::string choice = {};  // what is chosen in the list that the command opens, without article; empty: nothing
};

inline constexpr int kMostTimes = 1000;  // that a command may be typed to be done

// None: no sentence of the language spoken, or of English, that is known. Case, stops, question marks and words of
// politeness do not count, umlauts may be written out, small numbers may be words.
std::optional<TypedSentence> typed_sentence(std::string_view line);

// Whether the command opens a list of places that one chooses from by name.
bool takes_choice(Command command);

// What somebody typed to choose a thing by its name, without "to", "the" and the like in front; all of it where nothing
// else is left.
std::string without_fillers(std::string_view typed);

}  // namespace handrail
