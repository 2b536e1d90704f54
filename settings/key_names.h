// Lists and checks the names of keys in a settings file, independent of any keyboard or window. Pure values and
// functions; any thread may use them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace handrail::settings {

// Returns all names without modifiers, in a fixed order: "A", "1", "F1", "Up", "PageUp", "Grave", "Control" ...
std::span<const std::string_view> key_names();

// Returns the first word of `keys` that is not a valid key name; empty if all are valid. Words are separated by blanks.
// Modifiers must be in this order: "Control+Alt+Shift+F1". ASCII case is ignored. "none" means no key.
std::optional<std::string> misnamed_key(std::string_view keys);

// Returns the valid key nearest to a wrong word: "Shift+Control+W" gives "Control+Shift+W", "F99" gives "F9".
std::string nearest_key_name(std::string_view word);

}  // namespace handrail::settings
