// The names of keys in a settings file, independent of any keyboard or window. Pure values and functions; any thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace handrail::settings {

// All names without modifiers, in a fixed order: "A", "1", "F1", "Up", "PageUp", "Grave", "Control" ...
std::span<const std::string_view> key_names();

// Returns the first word of `keys` that is no valid key name; empty if all are valid. Words are separated by blanks.
// Modifiers must be in this order: "Control+Alt+Shift+F1". ASCII case is ignored, and "none" means no key.
std::optional<std::string> misnamed_key(std::string_view keys);

// Corrects such a word to the nearest valid key: "Shift+Control+W" to "Control+Shift+W", "F99" to "F9".
std::string nearest_key_name(std::string_view word);

}  // namespace handrail::settings
