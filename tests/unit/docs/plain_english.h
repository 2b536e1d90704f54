// Lists turns of speech that documents and comments must avoid. The rules are in docs/developer/language.md.
#pragma once

#include <regex>
#include <string>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

struct Pattern {
    const char* found;        // a regular expression for whole words
    const char* instead;      // what to write instead
    bool in_comments = true;  // false: allowed in comments, where it is often right ("people stand in rooms")
};

// Expressions that strangers did not understand immediately.
inline constexpr Pattern kEnglishPatterns[]{
    {"where there (is|are) (none|no|one)", "if there is none"},
    {"(is|are|was|were) told", "is reported, is announced, says so"},
    {"tells? (of|that|it|which|what|where|how)", "says, reports, shows", false},
    {"stands? in (the|a|each|every|one|its|docs|its own)", "is in", false},
    {"stands? (there|here|below|above|behind)", "is there, follows", false},
    {"lies? in (the|a|each) (file|folder|table|text|section|list)", "is in"},
    {"beside", "next to, as well as, in the background"},
    {"a \\w+ of (its|one's|their|your|the test's) own", "a separate ..., a custom ...", false},
    {"by (itself|themselves|oneself)", "automatically, alone", false},
    {"likewise", "also"},
    {"to the bit", "bit for bit"},
    {"how manyth", "every nth"},
    {"so many", "this many"},
    {"in force", "effective"},
    {"asked for", "requested"},
    {"anew", "again"},
    {"for who", "if you"},
    {"(and|,) of (it|them|these|those) ", "and one of them, ..."},
    {"held? (equal|against)", "compared with", false},
    {"that persons?", "people who"},
    {"is had", "is available"},
    {"one (wants|likes|needs|hears|feels|walks|stands)", "you"},
    {"nor is", "and is not"},
    {"as long as one", "as long as you"},
    {"callers own", "caller's"},
};

inline constexpr Pattern kGermanPatterns[]{
    {"Klanggerät(e|en|s)?", "Audiogerät"},
    {"Taste vom Anfang", "Standardtaste"},
    {"Tasten vom Anfang", "Standardtasten"},
};

// Returns all patterns as one expression, because most texts match none.
template <std::size_t N>
std::regex any_of_them(const Pattern (&patterns)[N]) {
    std::string any;
    for (const Pattern& pattern : patterns) any += (any.empty() ? "" : "|") + std::string(pattern.found);
    return std::regex("\\b(?:" + any + ")\\b", std::regex::icase | std::regex::optimize);
}

struct Search {
    const Pattern* pattern = nullptr;
    std::regex searched;
};

template <std::size_t N>
std::vector<Search> searches(const Pattern (&patterns)[N]) {
    std::vector<Search> all;
    for (const Pattern& pattern : patterns)
        all.push_back({&pattern, std::regex("\\b" + std::string(pattern.found) + "\\b",
                                            std::regex::icase | std::regex::optimize)});
    return all;
}

}  // namespace handrail::test
