#include "app/core/dialogue/typed_sentences.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/typed_words.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr std::string_view kCount = "<count>", kName = "<name>";
constexpr std::size_t kLongestSentence = 200;  // a line longer than this is not a sentence

// Words of the language spoken that may surround the sentence of a command.
struct SmallWords {
    std::vector<TypedWord> polite = typed_words(phrase("typed.polite")), fillers = typed_words(phrase("typed.fillers")),
                           numbers = typed_words(phrase("typed.numbers"));  // number words, from "one" upwards
};

// Returns the index of `plain` among `words`, or no value if `words` does not contain it.
std::optional<std::size_t> place_among(const std::vector<TypedWord>& words, const std::string& plain) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i].plain == plain) return i;
    return std::nullopt;
}

// Removes polite words at the beginning and at the end.
void drop_politeness(std::vector<TypedWord>& words, const SmallWords& small) {
    while (words.size() > 1 && place_among(small.polite, words.front().plain)) words.erase(words.begin());
    while (words.size() > 1 && place_among(small.polite, words.back().plain)) words.pop_back();
}

// Returns the value of "3" or "three", or 0 if the word is not a number from 1 to kMostTimes.
int count_of(const std::string& word, const SmallWords& small) {
    int count = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error == std::errc{} && end == word.data() + word.size()) return count >= 1 && count <= kMostTimes ? count : 0;
    const auto number = place_among(small.numbers, word);
    return number ? static_cast<int>(*number) + 1 : 0;
}

// Returns the words from `first` on, as the person typed them, without leading fillers.
std::string name_from(const std::vector<TypedWord>& words, std::size_t first, const SmallWords& small,
                      bool commas = false) {
    while (first + 1 < words.size() && place_among(small.fillers, words[first].plain)) ++first;
    return written_from(words, first, commas);
}

// Returns true if the words fit the pattern. A name is the last element of a pattern and stands for all remaining
// words. Polite words may be anywhere before the name.
bool fits(const std::vector<TypedWord>& pattern, const std::vector<TypedWord>& words, const SmallWords& small,
          TypedSentence& said) {
    std::size_t at = 0;
    for (const TypedWord& item : pattern) {
        while (at < words.size() && item.plain != words[at].plain && place_among(small.polite, words[at].plain)) ++at;
        if (at == words.size()) return false;
        if (item.plain == kName) {
            said.choice = name_from(words, at, small, takes_text(said.command));
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

// Calls `visit` with each pattern of a command. The patterns are separated by bars in `text`.
template <class Visit>
void each_pattern(const std::string& text, const SmallWords& small, Visit visit) {
    for (std::vector<TypedWord> pattern : typed_parts(text)) {
        drop_politeness(pattern, small);
        visit(pattern);
    }
}

// Returns the command whose hyphenated word, such as "rest-of-way", the person typed as separate words.
std::optional<Command> command_apart(const std::vector<TypedWord>& words) {
    std::string all;
    for (const TypedWord& word : words) all += (all.empty() ? "" : "-") + word.plain;
    return words.size() > 1 ? command_of_word(all) : std::nullopt;
}

}  // namespace

bool takes_text(Command command) { return command == Command::Label; }

bool takes_choice(Command command) {
    return takes_text(command) || is_one_of(command, {Command::Describe, Command::Routes, Command::Find,
                                                      Command::KeptRoutes, Command::LearntRooms, Command::Storeys,
                                                      Command::Learners, Command::Presets, Command::Places});
}

std::string without_fillers(std::string_view typed) { return name_from(typed_words(typed), 0, {}); }

std::optional<TypedSentence> typed_sentence(std::string_view line) {
    if (line.size() > kLongestSentence) return std::nullopt;
    const SmallWords small;
    std::vector<TypedWord> words = typed_words(line);
    drop_politeness(words, small);
    if (words.empty()) return std::nullopt;
    // A pattern without a name is preferred to a pattern with a name. Among patterns with a name, the longest is
    // preferred.
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
