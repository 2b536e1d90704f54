// Small text helpers for the readers, the settings and the command line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handrail {

// Returns the candidate with the smallest edit distance to `word`, for "did you mean ..." sentences. ASCII case is
// ignored; of equally near ones the first is taken. Empty if there are no candidates.
std::string nearest_name(std::string_view word, std::span<const std::string> candidates);
// The same for keys with dots, "table.key". If there is a table of that name, only its keys are searched, else all
// keys.
std::string nearest_key(std::string_view key, std::span<const std::string> keys);

// Turns ASCII letters into lower case; other bytes stay.
std::string lower_ascii(std::string_view text);

// True for well-formed UTF-8: no stray bytes, overlong forms, surrogates or values above U+10FFFF.
bool is_utf8(std::string_view text);

// True if the text begins with a character that only sets the direction in which others are shown (Unicode's
// Bidi_Control). These have three bytes, but U+061C has two. Inside a name such a character could reverse the words
// that follow.
bool begins_with_direction_control(std::string_view text);

// Turns any text from a file into one line that can be spoken and printed. Control characters and line separators
// become spaces, direction controls are removed, and bytes that are not UTF-8 become the replacement character.
std::string one_line(std::string_view text);

// The characters of well-formed UTF-8, one string each. Bytes that form no character become a string each.
std::vector<std::string> characters_of(std::string_view text);

// Removes the decimal number at the front of `text` and returns it, independently of the locale. nan and infinity count
// as numbers. A value too large or too small for a double becomes the largest double or 0, with in_range false.
// exponent: "1e3" is one number. Returns nothing if the text begins with no number. All numbers in files and typed
// words are read by this function.
struct TakenNumber {
    double value = 0.0;
    bool in_range = true;
};
std::optional<TakenNumber> take_number(std::string_view& text, bool exponent = true);
// Reads a text that is one decimal number and nothing else. Returns false for anything else, also for nan, infinity and
// values that do not fit into a double.
bool parse_finite(std::string_view text, double& value);

}  // namespace handrail
