// A text in words cut into sentences and these into words and numbers. Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handrail {

struct WordToken {
    enum class Kind { Word, Number, Name, Comma, Colon };  // Name: what stood in quotation marks
    Kind kind = Kind::Word;
    std::string text;    // as written, without quotation marks
    std::string folded;  // in lower case, to be compared
    double number = 0.0;
};

struct WordSentence {
    int line = 0;            // of its first word, from 1
    bool first = false;      // of a line
    bool paragraph = false;  // the first after an empty line or at the beginning
    std::vector<WordToken> tokens;
};

// Lower case of what Western European languages write; other characters stay.
std::string folded(std::string_view text);

// Sentences end at a full stop, a semicolon, an exclamation mark or the end of a line that does not end with a comma;
// lines that begin with # are left out. Bytes that are no UTF-8 are taken as Latin-1. "2,5" is a number where a digit
// follows the comma at once.
std::vector<WordSentence> sentences_of(std::string_view bytes);

}  // namespace handrail
