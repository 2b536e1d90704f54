#include "tests/unit/sentences/sentence_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <utility>

#include "app/core/dialogue/brief_words.h"
#include "tests/support/names.h"
#include "worlds/base/text.h"

namespace handrail::test {
namespace {

struct Rule {
    const char* name;
    const char* pattern;  // a regular expression for text that must not occur
};

constexpr std::array kEverywhere{
    Rule{"an unfilled value", R"([{}])"},
    Rule{"brackets, which are not heard", R"([()\[\]<>])"},
    Rule{"two blanks", "  "},
    Rule{"a blank at an end", R"(^ | $)"},
    Rule{"a blank before a stop", R"( [.,;:!?])"},
    Rule{"doubled punctuation", R"([.,;:!?][.,;:])"},
    Rule{"numbers beside numbers", R"((^|[ ,])\d+,? \d+(?![\d.]))"},
    Rule{"no number", R"(\b(nan|inf)\b)"},
    Rule{"minus nothing", R"(-0(?!\.\d*[1-9]))"},
    Rule{"the key of a text", R"(\b[a-z]+_?[a-z_]*\.[a-z][a-z_]+\b(?!\.))"},
    Rule{"a mark of a program", R"([_#*=|\\])"},
};
constexpr std::array kEnglish{
    Rule{"two prepositions", R"(\b(from|to|of|at|with|into) (from|to|of|at|in|with|into)\b)"},
    Rule{"two prepositions", R"(\bdown (from|of|at) (to|from|of)\b)"},
    Rule{"an article before none of its kind", R"(\b(a|an|the) (a|an|the|to|of|at|in|from|with|is|are)\b)"},
    Rule{"a before a vowel", R"(\ba [aeio](?!ne\b))"},
    Rule{"an before a consonant", R"(\ban [bcdfgjklmnpqrstvwxyz])"},
    Rule{"one of several",
         R"((^|[^.\d])1 (steps|metres|exits|rooms|doors|storeys|ways|minutes|seconds|things|degrees)\b)"},
};
constexpr std::array kGerman{
    Rule{"two prepositions",
         R"(\b(von|zu|zum|zur|mit|bei|nach|aus|in|an|auf) (von|zu|zum|zur|mit|bei|nach|aus|in|im|am)\b)"},
    Rule{"two articles", R"(\b(der|die|das|den|dem|ein|eine|einen|einem) (der|das|den|dem|ein|eine|einen|einem)\b)"},
    Rule{"one of several",
         R"((^|[^,\d])1 (Schritte|Räume|Ausgänge|Türen|Stockwerke|Wege|Minuten|Sekunden|Dinge|Stufen)\b)"},
};

// Finds a repeated word, as in "the the", within a clause.
std::string repeated_word(const std::string& text) {
    std::string last, word;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const char c = i < text.size() ? text[i] : ' ';
        const bool letter =
            std::isalpha(static_cast<unsigned char>(c)) != 0 || (static_cast<unsigned char>(c) & 0x80U) != 0;
        if (letter) {
            word += c;
            continue;
        }
        if (!word.empty()) {
            const std::string lower = lower_ascii(word);
            if (lower == last) return word;
            last = lower;
            word.clear();
        }
        if (c != ' ') last.clear();
    }
    return {};
}

// Compiles the patterns. Callers keep the result, because compiling takes longer than searching.
template <std::size_t N>
std::vector<std::pair<std::string, std::regex>> made(const std::array<Rule, N>& rules) {
    std::vector<std::pair<std::string, std::regex>> all;
    for (const Rule& rule : rules) all.emplace_back(rule.name, std::regex(rule.pattern));
    return all;
}

void hold_against(const std::vector<std::pair<std::string, std::regex>>& rules, const std::string& text,
                  std::vector<std::string>& faults) {
    for (const auto& [name, pattern] : rules) {
        std::smatch found;
        if (std::regex_search(text, found, pattern)) faults.push_back(name + ": \"" + found.str() + "\"");
    }
}

}  // namespace

std::vector<std::string> sentences_of(const std::string& text) {
    std::vector<std::string> all;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((text[i] == '.' || text[i] == '?' || text[i] == '!') && (i + 1 == text.size() || text[i + 1] == ' ')) {
            all.push_back(text.substr(begin, i + 1 - begin));
            begin = i + 2;
        }
    if (begin < text.size()) all.push_back(text.substr(begin));
    return all;
}

std::vector<std::string> faults_of(const std::string& text, const std::string& language) {
    std::vector<std::string> faults;
    if (text.empty()) faults.emplace_back("nothing is said");
    static const auto everywhere = made(kEverywhere), german = made(kGerman), english = made(kEnglish);
    hold_against(everywhere, text, faults);
    hold_against(language == "de" ? german : english, text, faults);
    if (const std::string word = repeated_word(text); !word.empty()) faults.push_back("a word twice: \"" + word + "\"");
    for (const std::string& sentence : sentences_of(text))
        if (count_words(sentence) > kLongestSentence_words)
            faults.push_back(std::to_string(count_words(sentence)) + " words in one sentence");
    return faults;
}

}  // namespace handrail::test
