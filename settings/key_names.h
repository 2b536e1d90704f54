// The names of keys that a settings file takes, without any keyboard or window. Pure values and functions; any thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace handrail {

// Every name without modifiers, in a fixed order: "A", "1", "F1", "Up", "PageUp", "Grave", "Control" ...
std::span<const std::string_view> key_names();

// The first word of `keys` that names no key that can be pressed; nothing if all do. Words have blanks between them.
// Modifiers come in this order: "Control+Alt+Shift+F1". ASCII case is ignored, and "none" stands for no key.
std::optional<std::string> misnamed_key(std::string_view keys);

// That word as the nearest key that can be pressed: "Shift+Control+W" as "Control+Shift+W", "F99" as "F9".
std::string nearest_key_name(std::string_view word);

}  // namespace handrail
