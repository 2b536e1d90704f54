// Rules for everything spoken, whatever part made it. They find faults that a reader overlooks but that disturb a
// listener.
#pragma once

#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

// The faults of a text that is spoken in a language ("en", "de"), in a few words each; empty if there are none.
std::vector<std::string> faults_of(const std::string& text, const std::string& language);

// Splits a text into sentences, at stops that blanks follow.
std::vector<std::string> sentences_of(const std::string& text);

inline constexpr std::size_t kLongestSentence_words = 45;

}  // namespace handrail::test
