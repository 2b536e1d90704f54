#include "app/core/dialogue/terminal_line.h"

#include <charconv>
#include <utility>

#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/typed_sentences.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

constexpr std::size_t kLongWord = 5;  // in bytes; a word of this length can have two typing mistakes

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// Parses a line that consists of a command's word, perhaps followed by a count or a choice.
Result<TerminalLine> command_line_of(std::string_view line) {
    const std::size_t blank = line.find_first_of(" \t");
    const std::string word = lower_ascii(line.substr(0, blank));
    const std::string_view rest = blank == std::string_view::npos ? std::string_view{} : trimmed(line.substr(blank));
    TerminalLine parsed;
    if (is_quit_word(word)) {
        parsed.leave = true;
    } else if (parsed.command = command_of_word(word); !parsed.command) {
        // A command that differs more from the word is hardly what the person meant.
        const std::string nearest = nearest_name(word, spoken_words(), word.size() < kLongWord ? 1 : 2);
        return fail(phrase("terminal.no_command",
                           {{"word", word}, {"near", nearest.empty() ? "no" : "yes"}, {"nearest", nearest}}));
    }
    if (parsed.command && takes_choice(*parsed.command)) {
        parsed.choice = rest;
    } else if (!rest.empty()) {
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), parsed.times);
        if (error != std::errc{} || end != rest.data() + rest.size() || parsed.times < 1 || parsed.times > kMostTimes)
            return fail(phrase("terminal.only_count", {{"word", word}, {"most", kMostTimes}}));
    }
    return parsed;
}

// Returns true for a line of several words without a number. Such a line cannot be a command with a bad count.
bool is_sentence(std::string_view line) {
    return line.find_first_of(" \t") != std::string_view::npos &&
           line.find_first_of("0123456789") == std::string_view::npos;
}

}  // namespace

Result<TerminalLine> parse_terminal_line(std::string_view line) {
    line = trimmed(line);
    if (line.empty()) return TerminalLine{};
    Result<TerminalLine> parsed = command_line_of(line);
    // The line is tried as a whole sentence before it is tried as a word with a choice: "find my way to the kitchen"
    // must not search for a thing of that name.
    if (!parsed || !parsed->choice.empty())
        if (auto said = typed_sentence(line)) return TerminalLine{said->command, said->times, std::move(said->choice)};
    if (parsed) return parsed;
    if (is_sentence(line)) {
        const std::string_view first = line.substr(0, line.find_first_of(" \t"));
        const auto command = command_of_word(first);
        return fail(command ? phrase("terminal.no_sentence_word", {{"line", line}, {"word", spoken_word(*command)}})
                            : phrase("terminal.no_sentence", {{"line", line}}));
    }
    return parsed;
}

}  // namespace handrail::core
