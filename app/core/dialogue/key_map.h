// Which key does what: the built-in table with the person's own keys from the settings laid over it. App thread.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/command.h"
#include "app/core/dialogue/key_sets.h"
#include "worlds/base/result.h"

namespace handrail {

// A key's name as it is said in the language spoken: "Shift+PageUp", "Umschalt+Bild auf". What is typed and stored is
// the name itself.
std::string spoken_key(std::string_view key_name);

class KeyMap {
public:
    // `changes`: command word -> key names separated by blanks, replacing that command's default keys.
    // hand: the set for one hand that lies between the two. The key name "none" takes all keys away.
    explicit KeyMap(const std::map<std::string, std::string>& changes, KeyboardHand hand = KeyboardHand::Both);

    std::optional<Command> find(std::string_view key_name) const;  // ASCII case is ignored
    std::string keys_of(Command command) const;  // "F2 or 1", for help; for who types the command's word
    // The names of those keys, separated by blanks; without one of them.
    std::string words_of_keys(Command command, std::string_view without = {}) const;
    // Those it has where the person changed nothing.
    std::string_view default_keys(Command command) const;
    // A sentence for each unknown command and each key that two commands claim; the built-in meaning then stands.
    const std::vector<std::string>& problems() const { return problems_; }

private:
    std::map<std::string, Command> by_key_;  // lower case
    std::vector<std::vector<std::string>> by_command_;
    KeyboardHand hand_;
    std::vector<std::string> problems_;
};

}  // namespace handrail
