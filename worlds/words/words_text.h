// Splits a room description into sentences, and sentences into words and numbers. Pure functions; any thread may call
// them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handrail::words {

struct WordToken {
    enum class Kind { Word, Number, Name, Comma, Colon };  // Name: text in quotation marks
    Kind kind = Kind::Word;
    std::string text;    // spelled as in the text, without quotation marks
    std::string folded;  // the text in lower case, for comparisons
    double number = 0.0;
};

struct WordSentence {
    int line = 0;        // line of the first word, counted from 1
    bool first = false;  // true if the sentence begins a line
    // True if the sentence begins a paragraph, that is, follows an empty line or begins the text.
    bool paragraph = false;
    std::vector<WordToken> tokens;
};

// Turns the letters of Western European languages into lower case and leaves other characters unchanged.
std::string folded(std::string_view text);

// Splits a text into sentences. A sentence ends at a full stop, a semicolon, an exclamation mark, or the end of a line
// that does not end with a comma. Lines that begin with # are ignored. Bytes that are not UTF-8 are read as Latin-1.
// "2,5" is a number if a digit directly follows the comma.
std::vector<WordSentence> sentences_of(std::string_view bytes);

}  // namespace handrail::words
