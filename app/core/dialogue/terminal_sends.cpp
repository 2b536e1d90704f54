#include "app/core/dialogue/terminal_sends.h"

#include <algorithm>
#include <array>
#include <string>

#include "worlds/base/text.h"

namespace handrail::core {
namespace {

// The key names are in lower case, because a person may write them in upper or lower case.
constexpr std::array<std::string_view, 11> kSigns{"grave",        "minus",     "equal",     "leftbracket",
                                                  "rightbracket", "backslash", "semicolon", "apostrophe",
                                                  "comma",        "period",    "slash"};
constexpr std::array<std::string_view, 9> kNeverSent{"control",     "shift",      "alt",    "menu",  "pause",
                                                     "printscreen", "scrolllock", "world1", "world2"};
constexpr std::array<std::string_view, 3> kSentPlain{"escape", "enter", "backspace"};

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool terminal_sends(std::string_view key_name) {
    const std::string lower = lower_ascii(key_name);
    std::string_view key = lower;
    const auto held = [&key](std::string_view modifier) {
        if (!key.starts_with(modifier)) return false;
        key.remove_prefix(modifier.size());
        return true;
    };
    const bool control = held("control+");
    held("alt+");
    const bool shift = held("shift+");
    if (is_one_of(kNeverSent, key) || key.starts_with("keypad")) return false;
    if (key.size() == 1 && key[0] >= 'a' && key[0] <= 'z')
        return !control || (!shift && std::string_view("chijmz").find(key) == std::string_view::npos);
    if (key == "space") return !shift;
    if (is_one_of(kSentPlain, key)) return !control && !shift;
    return !control || !(key == "tab" || key.size() == 1 || is_one_of(kSigns, key));
}

}  // namespace handrail::core
