// Splits a typed line into words, for sentences and for questions. Pure functions, which any thread may call.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handrail::core {

struct TypedWord {
    std::string plain;         // the word in the form in which words are compared; an apostrophe is left out: "whats"
    std::string written;       // the word as the person typed it
    char before = ' ';         // what separates it from the word before: a hyphen or a blank
    bool after_comma = false;  // a comma is between this word and the one before
    bool has_apostrophe_s = false;  // the word ends in an apostrophe with an s after it: "what's", "child's"
};

// Splits the text at blanks and punctuation. No word is empty.
std::vector<TypedWord> typed_words(std::string_view text);

// Splits a text of settings/languages at its bars. Each part is a sequence of words.
std::vector<std::vector<TypedWord>> typed_parts(std::string_view text);

// Returns the words from `first` on, as the person typed them; with `commas`, also the commas between them.
std::string written_from(const std::vector<TypedWord>& words, std::size_t first, bool commas = false);

}  // namespace handrail::core
