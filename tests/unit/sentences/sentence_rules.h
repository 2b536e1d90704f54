// Checks everything that the program announces against rules, whatever part of the program made the text. The rules
// find faults that readers overlook but that disturb listeners.
#pragma once

#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

// Returns the faults of an announced text in a few words each; empty if it has none. `language` is "en" or "de".
std::vector<std::string> faults_of(const std::string& text, const std::string& language);

// Splits a text into sentences. A sentence ends at a stop that a blank follows.
std::vector<std::string> sentences_of(const std::string& text);

inline constexpr std::size_t kLongestSentence_words = 45;

}  // namespace handrail::test
