// What a page must keep to be read by everybody: a small parser of our own and the rules that can be decided without a
// browser. For pages that we make; it knows what they use of HTML and takes everything else for a fault.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handrail::test {

// Each fault in a few words: "no language", "heading h4 after h2". Empty: all rules hold.
std::vector<std::string> page_faults(std::string_view html);

// The page's text as a screen reader goes through it, one element a line; what is hidden from it is left out.
std::string spoken_text(std::string_view html);

// Läsbarhetsindex, Björnsson 1968: words a sentence and the percentage of words of more than six letters. Under 40 is
// easy to read.
double lix_of(const std::string& text);

}  // namespace handrail::test
