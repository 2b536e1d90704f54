#include "app/core/key_map.h"

#include "worlds/base/text.h"

namespace handrail {
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

KeyMap::KeyMap(const std::map<std::string, std::string>& changes) {
    by_command_.resize(command_table().size());
    for (const CommandInfo& row : command_table()) by_command_[static_cast<std::size_t>(row.command)] = words_of(row.key);

    for (const auto& [word, keys] : changes) {
        const CommandInfo* row = find_command(word);
        if (!row) {
            std::vector<std::string> known;
            for (const CommandInfo& candidate : command_table()) known.emplace_back(candidate.word);
            problems_.push_back(fmt::format("The settings give a key to \"{}\", which is no command. Did you mean \"{}\"?", word, nearest_name(word, known)));
            continue;
        }
        by_command_[static_cast<std::size_t>(row->command)] = words_of(keys);
    }
    // The person's own keys come first, so that they win over a default elsewhere.
    const auto claim = [&](const CommandInfo& row) {
        for (const std::string& key : by_command_[static_cast<std::size_t>(row.command)]) {
            const auto [held, fresh] = by_key_.emplace(lower_ascii(key), row.command);
            if (!fresh && held->second != row.command)
                problems_.push_back(
                    fmt::format("The key {} was asked to do both {} and {}. It does {}.", key, info(held->second).word, row.word, info(held->second).word));
        }
    };
    for (const CommandInfo& row : command_table())
        if (changes.contains(std::string(row.word))) claim(row);
    for (const CommandInfo& row : command_table())
        if (!changes.contains(std::string(row.word))) claim(row);
}

std::optional<Command> KeyMap::find(std::string_view key_name) const {
    const auto found = by_key_.find(lower_ascii(key_name));
    if (found == by_key_.end()) return std::nullopt;
    return found->second;
}

std::string KeyMap::keys_of(Command command) const {
    std::string text;
    for (const std::string& key : by_command_[static_cast<std::size_t>(command)]) {
        const auto held = find(key);
        if (held != command) continue;
        if (!text.empty()) text += " or ";
        text += key == "Grave" ? "the grave key" : key;
    }
    return text;
}

}  // namespace handrail
