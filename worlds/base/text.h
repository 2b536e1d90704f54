// Small text helpers shared by readers, settings and the command line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handrail {

// The candidate with the smallest edit distance to `word` (ASCII case ignored; ties: the first), for "did you mean ..."
// sentences. Empty when there are no candidates.
std::string nearest_name(std::string_view word, std::span<const std::string> candidates);
// The same of keys with dots, "table.key": among those of its own table where there is such a table, else among all.
std::string nearest_key(std::string_view key, std::span<const std::string> keys);

// ASCII lower case; other bytes stay as they are.
std::string lower_ascii(std::string_view text);

// Well-formed UTF-8: no stray bytes, overlong forms, surrogates or values above U+10FFFF.
bool is_utf8(std::string_view text);

// True if the text begins with a character that only says in which direction others are to be shown (Unicode's
// Bidi_Control, all of three bytes or U+061C of two). Inside a name it could turn round the words that follow.
bool begins_with_direction_control(std::string_view text);

// As one line that can be spoken and printed, whatever a file put into it: control characters and line separators are
// spaces, direction controls go, bytes that are no UTF-8 the replacement character.
std::string one_line(std::string_view text);

// The characters of well-formed UTF-8, one string each; of other text its bytes where they make none.
std::vector<std::string> characters_of(std::string_view text);

// The decimal number at the front of `text`, which it is taken off, independent of the locale; nan and infinity are
// numbers, too. A value beyond what a double holds is the largest double or 0, and not in_range. exponent: "1e3" is one
// number. None if the text begins with no number. All numbers in files and typed words are read by this function.
struct TakenNumber {
    double value = 0.0;
    bool in_range = true;
};
std::optional<TakenNumber> take_number(std::string_view& text, bool exponent = true);
// A whole decimal number; false for anything else, also for nan, infinity and what a double does not hold.
bool parse_finite(std::string_view text, double& value);

}  // namespace handrail
