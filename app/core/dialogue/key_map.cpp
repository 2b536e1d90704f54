#include "app/core/dialogue/key_map.h"

#include <algorithm>

#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/terminal_sends.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/base/typist.h"

namespace handrail::core {
namespace {

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (end > begin) words.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

}  // namespace

std::string spoken_key(std::string_view key_name) {
    std::string text;
    for (std::size_t begin = 0; begin < key_name.size();) {
        // A plus sign at the end of a key name is the plus key itself.
        const std::size_t end = std::min(key_name.find('+', begin + 1), key_name.size());
        const std::string part(key_name.substr(begin, end - begin));
        const std::string key = "key_name." + lower_ascii(part);
        text += (begin > 0 ? "+" : "") + (has_phrase(key) ? phrase(key) : part);
        begin = end + 1;
    }
    return text;
}

KeyMap::KeyMap(const std::map<std::string, std::string>& changes, settings::KeyboardHand hand) : hand_(hand) {
    by_command_.resize(command_table().size());
    for (const CommandInfo& row : command_table())
        by_command_[static_cast<std::size_t>(row.command)] = words_of(default_keys(row.command));

    const auto in_set = [&](std::string_view word) {
        const auto set = keys_for(hand);
        return std::any_of(set.begin(), set.end(), [&](const SetKeys& row) { return row.word == word; });
    };
    for (const auto& [word, keys] : changes) {
        const CommandInfo* row = find_command(word);
        if (!row) {
            std::vector<std::string> known;
            for (const CommandInfo& candidate : command_table()) known.emplace_back(candidate.word);
            problems_.push_back(phrase("key.no_command", {{"word", word}, {"nearest", nearest_name(word, known)}}));
            continue;
        }
        by_command_[static_cast<std::size_t>(row->command)] = words_of(keys);
        std::erase(by_command_[static_cast<std::size_t>(row->command)], "none");
    }
    // The person's own keys are claimed first, so they are preferred to the default keys of other commands. The key set
    // for one hand is claimed next, and may replace the keys of other commands.
    const auto claim = [&](const CommandInfo& row) {
        for (const std::string& key : by_command_[static_cast<std::size_t>(row.command)]) {
            const auto [held, fresh] = by_key_.emplace(lower_ascii(key), row.command);
            if (!fresh && held->second != row.command && !in_set(info(held->second).word))
                problems_.push_back(
                    phrase("key.asked_twice",
                           {{"key", spoken_key(key)}, {"first", info(held->second).word}, {"second", row.word}}));
        }
    };
    for (const CommandInfo& row : command_table())
        if (changes.contains(std::string(row.word))) claim(row);
    for (const bool of_set : {true, false})
        for (const CommandInfo& row : command_table())
            if (!changes.contains(std::string(row.word)) && in_set(row.word) == of_set) claim(row);
}

std::string_view KeyMap::default_keys(Command command) const {
    for (const SetKeys& row : keys_for(hand_))
        if (row.word == info(command).word) return row.keys;
    return info(command).key;
}

std::string KeyMap::words_of_keys(Command command, std::string_view without) const {
    std::string text;
    for (const std::string& key : by_command_[static_cast<std::size_t>(command)])
        if (find(key) == command && lower_ascii(key) != lower_ascii(without)) text += (text.empty() ? "" : " ") + key;
    return text;
}

std::optional<Command> KeyMap::find(std::string_view key_name) const {
    const auto found = by_key_.find(lower_ascii(key_name));
    if (found == by_key_.end()) return std::nullopt;
    return found->second;
}

std::string KeyMap::keys_of(Command command) const {
    if (speaks_to_typist()) return spoken_word(command);
    const bool at_terminal = spoken_to() == ActsBy::TerminalKeys;
    std::string text;
    for (const std::string& key : by_command_[static_cast<std::size_t>(command)]) {
        if (find(key) != command || (at_terminal && !terminal_sends(key))) continue;
        const std::string name = key == "Grave" ? phrase("key.the_grave") : spoken_key(key);
        text = text.empty() ? name : phrase("key.or", {{"first", text}, {"second", name}});
    }
    if (at_terminal && text.empty()) return phrase("key.typed_word", {{"word", spoken_word(command)}});
    return text;
}

}  // namespace handrail::core
