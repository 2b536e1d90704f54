#include "settings/key_names.h"

#include <algorithm>
#include <array>
#include <vector>

#include "worlds/base/text.h"

namespace handrail::settings {
namespace {

constexpr auto kKeyNames = std::to_array<std::string_view>({
    "A",
    "B",
    "C",
    "D",
    "E",
    "F",
    "G",
    "H",
    "I",
    "J",
    "K",
    "L",
    "M",
    "N",
    "O",
    "P",
    "Q",
    "R",
    "S",
    "T",
    "U",
    "V",
    "W",
    "X",
    "Y",
    "Z",
    "0",
    "1",
    "2",
    "3",
    "4",
    "5",
    "6",
    "7",
    "8",
    "9",
    "F1",
    "F2",
    "F3",
    "F4",
    "F5",
    "F6",
    "F7",
    "F8",
    "F9",
    "F10",
    "F11",
    "F12",
    "Up",
    "Down",
    "Left",
    "Right",
    "PageUp",
    "PageDown",
    "Home",
    "End",
    "Insert",
    "Delete",
    "Escape",
    "Enter",
    "Tab",
    "Backspace",
    "Space",
    "Grave",
    "Minus",
    "Equal",
    "LeftBracket",
    "RightBracket",
    "Backslash",
    "Semicolon",
    "Apostrophe",
    "Comma",
    "Period",
    "Slash",
    "World1",
    "World2",
    "Menu",
    "Pause",
    "PrintScreen",
    "ScrollLock",
    "Keypad0",
    "Keypad1",
    "Keypad2",
    "Keypad3",
    "Keypad4",
    "Keypad5",
    "Keypad6",
    "Keypad7",
    "Keypad8",
    "Keypad9",
    "KeypadDecimal",
    "KeypadDivide",
    "KeypadMultiply",
    "KeypadSubtract",
    "KeypadAdd",
    "KeypadEnter",
    "KeypadEqual",
    "Control",
    "Shift",
    "Alt",
});
// The modifiers, in the order in which a key name must list them.
constexpr std::array<std::string_view, 3> kModifiers{"Control", "Alt", "Shift"};

bool same(std::string_view a, std::string_view b) { return lower_ascii(a) == lower_ascii(b); }

bool is_modifier_name(std::string_view name) {
    return std::any_of(kModifiers.begin(), kModifiers.end(), [&](std::string_view m) { return same(m, name); });
}

struct Parts {
    std::array<bool, kModifiers.size()> held{};
    bool in_order = true;
    std::string_view key;
};

Parts parts_of(std::string_view word) {
    Parts parts;
    std::size_t last = 0;
    for (;;) {
        const std::size_t plus = word.find('+');
        if (plus == std::string_view::npos) break;
        const auto modifier = std::find_if(kModifiers.begin(), kModifiers.end(),
                                           [&](std::string_view m) { return same(m, word.substr(0, plus)); });
        if (modifier == kModifiers.end()) break;
        const auto at = static_cast<std::size_t>(modifier - kModifiers.begin());
        parts.in_order = parts.in_order && at >= last && !parts.held[at];
        parts.held[at] = true;
        last = at;
        word.remove_prefix(plus + 1);
    }
    parts.key = word;
    return parts;
}

bool can_be_pressed(std::string_view word) {
    const Parts parts = parts_of(word);
    const bool known =
        std::any_of(kKeyNames.begin(), kKeyNames.end(), [&](std::string_view name) { return same(name, parts.key); });
    // The name of a modifier is a valid key only if it stands alone.
    return known && parts.in_order && (parts.key.size() == word.size() || !is_modifier_name(parts.key));
}

}  // namespace

std::span<const std::string_view> key_names() { return kKeyNames; }

std::optional<std::string> misnamed_key(std::string_view keys) {
    while (!keys.empty()) {
        const std::size_t end = std::min(keys.find(' '), keys.size());
        const std::string_view word = keys.substr(0, end);
        keys.remove_prefix(std::min(end + 1, keys.size()));
        if (!word.empty() && !same(word, "none") && !can_be_pressed(word)) return std::string(word);
    }
    return std::nullopt;
}

std::string nearest_key_name(std::string_view word) {
    const Parts parts = parts_of(word);
    std::vector<std::string> names;
    for (const std::string_view name : kKeyNames)
        if (!is_modifier_name(name)) names.emplace_back(name);
    std::string text;
    for (std::size_t m = 0; m < kModifiers.size(); ++m)
        if (parts.held[m]) text.append(kModifiers[m]).append("+");
    return parts.key.empty() ? text + "F1" : text + nearest_name(parts.key, names);
}

}  // namespace handrail::settings
