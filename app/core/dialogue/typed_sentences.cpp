#include "app/core/dialogue/typed_sentences.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "app/core/dialogue/command_words.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

constexpr std::string_view kCount = "<count>", kName = "<name>";
constexpr std::size_t kLongestSentence = 200;  // longer lines are not sentences

struct TypedWord {
    std::string plain;    // used for comparison
    std::string written;  // as typed
};

// Splits at blanks and punctuation. Apostrophes join: "what's" is "whats".
std::vector<TypedWord> typed_words(std::string_view text) {
    constexpr std::string_view kBetween = " \t\r\n,.;:!?\"";
    std::vector<TypedWord> words;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(kBetween, begin), text.size());
        if (end > begin) {
            TypedWord word{plain_word(text.substr(begin, end - begin)), std::string(text.substr(begin, end - begin))};
            for (const std::string_view apostrophe : {"'", "\xe2\x80\x99"})
                for (std::size_t at; (at = word.plain.find(apostrophe)) != std::string::npos;)
                    word.plain.erase(at, apostrophe.size());
            if (!word.plain.empty()) words.push_back(std::move(word));
        }
        begin = end + 1;
    }
    return words;
}

// Words of the language spoken that are not part of a command's sentences.
struct SmallWords {
    std::vector<TypedWord> polite = typed_words(phrase("typed.polite")), fillers = typed_words(phrase("typed.fillers")),
                           numbers = typed_words(phrase("typed.numbers"));  // from one upwards
};

// Its index, from 0.
std::optional<std::size_t> place_among(const std::vector<TypedWord>& words, const std::string& plain) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i].plain == plain) return i;
    return std::nullopt;
}

// Removes polite words at either end.
void drop_politeness(std::vector<TypedWord>& words, const SmallWords& small) {
    while (words.size() > 1 && place_among(small.polite, words.front().plain)) words.erase(words.begin());
    while (words.size() > 1 && place_among(small.polite, words.back().plain)) words.pop_back();
}

// "3" or "three"; 0 if it is not a number from 1 to kMostTimes.
int count_of(const std::string& word, const SmallWords& small) {
    int count = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error == std::errc{} && end == word.data() + word.size()) return count >= 1 && count <= kMostTimes ? count : 0;
    const auto number = place_among(small.numbers, word);
    return number ? static_cast<int>(*number) + 1 : 0;
}

// The words from `first` on, as written, without leading fillers.
std::string name_from(const std::vector<TypedWord>& words, std::size_t first, const SmallWords& small) {
    while (first + 1 < words.size() && place_among(small.fillers, words[first].plain)) ++first;
    std::string text;
    for (; first < words.size(); ++first) text += (text.empty() ? "" : " ") + words[first].written;
    return text;
}

// A name comes last in a pattern and takes all remaining words. Polite words may be anywhere else.
bool fits(const std::vector<TypedWord>& pattern, const std::vector<TypedWord>& words, const SmallWords& small,
          TypedSentence& said) {
    std::size_t at = 0;
    for (const TypedWord& item : pattern) {
        while (at < words.size() && item.plain != words[at].plain && place_among(small.polite, words[at].plain)) ++at;
        if (at == words.size()) return false;
        if (item.plain == kName) {
            said.choice = name_from(words, at, small);
            return !said.choice.empty();
        }
        if (item.plain == kCount) {
            said.times = count_of(words[at].plain, small);
            if (said.times == 0) return false;
        } else if (item.plain != words[at].plain) {
            return false;
        }
        ++at;
    }
    return at == words.size();
}

// Visits each sentence of a command; bars separate them.
template <class Visit>
void each_pattern(const std::string& text, const SmallWords& small, Visit visit) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('|', begin), text.size());
        std::vector<TypedWord> pattern = typed_words(std::string_view(text).substr(begin, end - begin));
        drop_politeness(pattern, small);
        visit(pattern);
        begin = end + 1;
    }
}

// Hyphenated command words, such as "rest-of-way", may be typed as separate words.
std::optional<Command> command_apart(const std::vector<TypedWord>& words) {
    std::string all;
    for (const TypedWord& word : words) all += (all.empty() ? "" : "-") + word.plain;
    return words.size() > 1 ? command_of_word(all) : std::nullopt;
}

}  // namespace

bool takes_choice(Command command) {
    return is_one_of(command, {Command::Describe, Command::Routes, Command::Find, Command::Ways, Command::LearntRooms,
                               Command::Storeys, Command::Learners});
}

std::string without_fillers(std::string_view typed) { return name_from(typed_words(typed), 0, {}); }

std::optional<TypedSentence> typed_sentence(std::string_view line) {
    if (line.size() > kLongestSentence) return std::nullopt;
    const SmallWords small;
    std::vector<TypedWord> words = typed_words(line);
    drop_politeness(words, small);
    if (words.empty()) return std::nullopt;
    // A sentence without a name wins over one with a name, and among the latter the longest pattern wins.
    std::optional<TypedSentence> whole, with_name;
    std::size_t longest = 0;
    for (const CommandInfo& row : command_table()) {
        const std::string key = "typed_sentence." + std::string(row.word);
        if (!has_phrase(key)) continue;
        each_pattern(phrase(key), small, [&](const std::vector<TypedWord>& pattern) {
            TypedSentence said{row.command};
            if (pattern.empty() || !fits(pattern, words, small, said)) return;
            if (said.choice.empty()) {
                if (!whole) whole = std::move(said);
            } else if (pattern.size() > longest) {
                longest = pattern.size();
                with_name = std::move(said);
            }
        });
    }
    if (whole) return whole;
    if (const auto command = command_apart(words)) return TypedSentence{*command};
    return with_name;
}

}  // namespace handrail::core
