// Checks accessibility rules that need no browser, with a small HTML parser. The parser is only for pages that the
// program makes. It knows the HTML that these pages use and reports everything else as a fault.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

// Returns each fault of the page in a few words, such as "no language" or "heading h4 after h2"; empty if the page
// obeys all rules.
std::vector<std::string> page_faults(std::string_view html);

// Returns the page's text as a screen reader presents it, with one element a line. Omits elements that are hidden from
// screen readers.
std::string spoken_text(std::string_view html);

// Returns the Läsbarhetsindex (Björnsson 1968): words per sentence plus the percentage of words with more than six
// letters. A text below 40 is easy to read.
double lix_of(const std::string& text);

}  // namespace handrail::test
