// Rules that everything spoken keeps, whatever made it: faults that a reader overlooks and a listener stumbles over.
#pragma once

#include <string>
#include <vector>

namespace handrail::test {

// What is wrong with a text that is spoken in a language ("en", "de"), a few words each; empty where nothing is.
std::vector<std::string> faults_of(const std::string& text, const std::string& language);

// Sentences, by the stops that blanks follow.
std::vector<std::string> sentences_of(const std::string& text);

inline constexpr std::size_t kLongestSentence_words = 45;

}  // namespace handrail::test
