// Which key does what: the built-in table with the person's own keys from the settings laid over it. App thread.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/command.h"
#include "worlds/base/result.h"

namespace handrail {

class KeyMap {
public:
    // `changes`: command word -> key names separated by blanks, replacing that command's default keys.
    explicit KeyMap(const std::map<std::string, std::string>& changes);

    std::optional<Command> find(std::string_view key_name) const;  // ASCII case is ignored
    std::string keys_of(Command command) const;                    // "F2 or 1", for help
    // A sentence for each unknown command and each key that two commands claim; the built-in meaning then stands.
    const std::vector<std::string>& problems() const { return problems_; }

private:
    std::map<std::string, Command> by_key_;  // lower case
    std::vector<std::vector<std::string>> by_command_;
    std::vector<std::string> problems_;
};

}  // namespace handrail
