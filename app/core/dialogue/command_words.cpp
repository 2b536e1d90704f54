#include "app/core/dialogue/command_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

struct WrittenOut {
    std::string_view letter, as;
};
constexpr std::array kWrittenOut{WrittenOut{"ä", "ae"}, WrittenOut{"ö", "oe"}, WrittenOut{"ü", "ue"},
                                 WrittenOut{"Ä", "ae"}, WrittenOut{"Ö", "oe"}, WrittenOut{"Ü", "ue"},
                                 WrittenOut{"ß", "ss"}};

std::string plain(std::string_view word) {
    std::string text = lower_ascii(word);
    for (const WrittenOut& row : kWrittenOut)
        for (std::size_t at = text.find(row.letter); at != std::string::npos; at = text.find(row.letter, at))
            text.replace(at, row.letter.size(), row.as);
    return text;
}

// Returns true if `word` is one of the blank-separated `words`. `word` must have the form that plain_word() returns.
bool is_among(std::string_view word, const std::string& words) {
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(' ', begin), words.size());
        if (end > begin && plain(std::string_view(words).substr(begin, end - begin)) == word) return true;
        begin = end + 1;
    }
    return false;
}

std::string words_of(const CommandInfo& row) { return phrase("command_word." + std::string(row.word)); }

constexpr std::array<std::string_view, 10> kListWords{"down",   "up",   "home",  "end",  "enter",
                                                      "escape", "left", "right", "list", "space"};

}  // namespace

std::string plain_word(std::string_view word) { return plain(word); }

std::optional<Command> command_of_word(std::string_view word) {
    if (const CommandInfo* row = find_command(word)) return row->command;
    const std::string wanted = plain(word);
    for (const CommandInfo& row : command_table())
        if (is_among(wanted, words_of(row))) return row.command;
    return std::nullopt;
}

std::string spoken_word(Command command) {
    const std::string words = words_of(info(command));
    return words.substr(0, words.find(' '));
}

bool is_quit_word(std::string_view word) {
    const std::string wanted = plain(word);
    return wanted == "quit" || is_among(wanted, phrase("terminal.quit_words"));
}

std::vector<std::string> spoken_words() {
    std::vector<std::string> words;
    for (const CommandInfo& row : command_table()) words.push_back(spoken_word(row.command));
    return words;
}

std::string list_word(std::string_view word) { return english_word("list_word", kListWords, word); }

std::string english_word(std::string_view table, std::span<const std::string_view> words, std::string_view typed) {
    const std::string wanted = plain(typed);
    if (wanted.empty()) return std::string(typed);
    for (const std::string_view key : words)
        if (wanted == key || is_among(wanted, phrase(fmt::format("{}.{}", table, key)))) return std::string(key);
    return std::string(typed);
}

std::string spoken_word(std::string_view table, std::string_view word) {
    const std::string words = phrase(fmt::format("{}.{}", table, word));
    return words.substr(0, words.find(' '));
}

}  // namespace handrail::core
