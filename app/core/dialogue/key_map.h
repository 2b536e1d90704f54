// Maps keys to commands with the built-in table, which the person's own keys from the settings override. Use it on the
// app thread only.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/command.h"
#include "app/core/dialogue/key_sets.h"
#include "worlds/base/result.h"

namespace handrail::core {

// Returns the name of a key in the language spoken: "Shift+PageUp", "Umschalt+Bild auf". `key_name` is the name that a
// person types and that settings store.
std::string spoken_key(std::string_view key_name);

class KeyMap {
public:
    // `changes` maps the word of a command to key names separated by blanks, which replace the command's default keys.
    // The key name "none" removes all keys. `hand` selects the set of keys for one hand, which overrides the built-in
    // table. `changes` overrides that set.
    explicit KeyMap(const std::map<std::string, std::string>& changes,
                    settings::KeyboardHand hand = settings::KeyboardHand::Both);

    std::optional<Command> find(std::string_view key_name) const;  // ignores ASCII case
    // Returns "F2 or 1" for help; for a person who types commands, it returns the command's word instead.
    std::string keys_of(Command command) const;
    // Returns the names of the command's keys, separated by blanks and without the key `without`.
    std::string words_of_keys(Command command, std::string_view without = {}) const;
    // Returns the keys that the command has if the person has changed nothing.
    std::string_view default_keys(Command command) const;
    // Returns one sentence for each unknown command and for each key that two commands claim. The first command to
    // claim a key keeps it, and the person's own keys come before default keys.
    const std::vector<std::string>& problems() const { return problems_; }

private:
    std::map<std::string, Command> by_key_;  // the key names are in lower case
    std::vector<std::vector<std::string>> by_command_;
    settings::KeyboardHand hand_;
    std::vector<std::string> problems_;
};

}  // namespace handrail::core
