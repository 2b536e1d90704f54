// Counts the occurrences of a piece of text in a longer text, including overlapping ones.
#pragma once

#include <string_view>

namespace handrail::test {

inline std::size_t times_in(std::string_view text, std::string_view words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++count;
    return count;
}

}  // namespace handrail::test
