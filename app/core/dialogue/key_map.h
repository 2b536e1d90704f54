// Which key does what: the built-in table, overridden by the person's own keys from the settings. App thread.
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

// The spoken name of a key in the language spoken: "Shift+PageUp", "Umschalt+Bild auf". What is typed and stored is the
// name itself.
std::string spoken_key(std::string_view key_name);

class KeyMap {
public:
    // `changes`: command word -> key names separated by blanks, which replace that command's default keys. The key name
    // "none" removes all keys. hand: the set of keys for one hand, which overrides the built-in table and is overridden
    // by `changes`.
    explicit KeyMap(const std::map<std::string, std::string>& changes,
                    settings::KeyboardHand hand = settings::KeyboardHand::Both);

    std::optional<Command> find(std::string_view key_name) const;  // ASCII case is ignored
    std::string keys_of(Command command) const;  // "F2 or 1" for help; a person who types gets the word instead
    // The names of those keys, separated by blanks; `without` leaves one of them out.
    std::string words_of_keys(Command command, std::string_view without = {}) const;
    // The keys of a command if the person has changed nothing.
    std::string_view default_keys(Command command) const;
    // One sentence for each unknown command and for each key that two commands claim. The command that claimed such a
    // key first has it, and the person's own keys come before default keys.
    const std::vector<std::string>& problems() const { return problems_; }

private:
    std::map<std::string, Command> by_key_;  // lower case
    std::vector<std::vector<std::string>> by_command_;
    settings::KeyboardHand hand_;
    std::vector<std::string> problems_;
};

}  // namespace handrail::core
