// Declares small functions on text for the readers, the settings and the command line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handrail {

// Returns the candidate with the smallest edit distance to `word`, for "did you mean ..." sentences. ASCII case is
// ignored. If several candidates are equally near, the first is returned. Empty if no candidate is within `most`
// changes of a byte.
std::string nearest_name(std::string_view word, std::span<const std::string> candidates,
                         std::size_t most = static_cast<std::size_t>(-1));
// Like nearest_name, for keys with a dot, "table.key". If some of `keys` are in the same table as `key`, only they are
// searched, else all keys.
std::string nearest_key(std::string_view key, std::span<const std::string> keys);

// Turns ASCII letters into lower case and leaves other bytes unchanged.
std::string lower_ascii(std::string_view text);

// True if the text is well-formed UTF-8: no stray bytes, overlong forms, surrogates or values above U+10FFFF.
bool is_utf8(std::string_view text);

// True if the text begins with a character that only sets the direction in which other characters are shown (Unicode's
// Bidi_Control). Such a character has three bytes, except U+061C, which has two. Inside a name it could reverse the
// words that follow.
bool begins_with_direction_control(std::string_view text);

// Turns any text from a file into one line that can be spoken and printed. Control characters and line separators
// become spaces, direction controls are removed, and bytes that are not UTF-8 become the replacement character.
std::string one_line(std::string_view text);

// Splits well-formed UTF-8 into its characters, one string for each. Each byte that is part of no character becomes a
// string too.
std::vector<std::string> characters_of(std::string_view text);

// Removes the decimal number at the front of `text` and returns it. The locale has no influence. "nan" and "infinity"
// are numbers too. A value too large or too small for a double becomes the largest double or 0, with in_range false.
// With `exponent`, "1e3" is one number. Returns nothing if the text does not begin with a number. All numbers in files
// and typed commands are read by this function.
struct TakenNumber {
    double value = 0.0;
    bool in_range = true;
};
std::optional<TakenNumber> take_number(std::string_view& text, bool exponent = true);
// Reads a text that consists of one decimal number. Returns false for any other text, and for nan, infinity and values
// that do not fit into a double.
bool parse_finite(std::string_view text, double& value);

}  // namespace handrail
