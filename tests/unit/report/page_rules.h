// Accessibility rules for pages that can be checked without a browser, with a small HTML parser. It is only for pages
// that the program makes. It knows the HTML that they use and treats everything else as a fault.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

// Returns each fault in a few words, such as "no language" or "heading h4 after h2". Empty: the page obeys all rules.
std::vector<std::string> page_faults(std::string_view html);

// The page's text as a screen reader presents it, one element a line, without elements that are hidden from it.
std::string spoken_text(std::string_view html);

// Läsbarhetsindex, Björnsson 1968: words per sentence plus the percentage of words with more than six letters. Below 40
// a text is easy to read.
double lix_of(const std::string& text);

}  // namespace handrail::test
