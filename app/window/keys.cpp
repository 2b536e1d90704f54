#include "app/window/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace handrail::window {
namespace {

struct NamedKey {
    int glfw_key;
    std::string_view name;
};

constexpr auto kKeys = std::to_array<NamedKey>({
    {GLFW_KEY_A, "A"},
    {GLFW_KEY_B, "B"},
    {GLFW_KEY_C, "C"},
    {GLFW_KEY_D, "D"},
    {GLFW_KEY_E, "E"},
    {GLFW_KEY_F, "F"},
    {GLFW_KEY_G, "G"},
    {GLFW_KEY_H, "H"},
    {GLFW_KEY_I, "I"},
    {GLFW_KEY_J, "J"},
    {GLFW_KEY_K, "K"},
    {GLFW_KEY_L, "L"},
    {GLFW_KEY_M, "M"},
    {GLFW_KEY_N, "N"},
    {GLFW_KEY_O, "O"},
    {GLFW_KEY_P, "P"},
    {GLFW_KEY_Q, "Q"},
    {GLFW_KEY_R, "R"},
    {GLFW_KEY_S, "S"},
    {GLFW_KEY_T, "T"},
    {GLFW_KEY_U, "U"},
    {GLFW_KEY_V, "V"},
    {GLFW_KEY_W, "W"},
    {GLFW_KEY_X, "X"},
    {GLFW_KEY_Y, "Y"},
    {GLFW_KEY_Z, "Z"},
    {GLFW_KEY_0, "0"},
    {GLFW_KEY_1, "1"},
    {GLFW_KEY_2, "2"},
    {GLFW_KEY_3, "3"},
    {GLFW_KEY_4, "4"},
    {GLFW_KEY_5, "5"},
    {GLFW_KEY_6, "6"},
    {GLFW_KEY_7, "7"},
    {GLFW_KEY_8, "8"},
    {GLFW_KEY_9, "9"},
    {GLFW_KEY_F1, "F1"},
    {GLFW_KEY_F2, "F2"},
    {GLFW_KEY_F3, "F3"},
    {GLFW_KEY_F4, "F4"},
    {GLFW_KEY_F5, "F5"},
    {GLFW_KEY_F6, "F6"},
    {GLFW_KEY_F7, "F7"},
    {GLFW_KEY_F8, "F8"},
    {GLFW_KEY_F9, "F9"},
    {GLFW_KEY_F10, "F10"},
    {GLFW_KEY_F11, "F11"},
    {GLFW_KEY_F12, "F12"},
    {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_DOWN, "Down"},
    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_PAGE_UP, "PageUp"},
    {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_END, "End"},
    {GLFW_KEY_INSERT, "Insert"},
    {GLFW_KEY_DELETE, "Delete"},
    {GLFW_KEY_ESCAPE, "Escape"},
    {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_GRAVE_ACCENT, "Grave"},
    {GLFW_KEY_MINUS, "Minus"},
    {GLFW_KEY_EQUAL, "Equal"},
    {GLFW_KEY_LEFT_BRACKET, "LeftBracket"},
    {GLFW_KEY_RIGHT_BRACKET, "RightBracket"},
    {GLFW_KEY_BACKSLASH, "Backslash"},
    {GLFW_KEY_SEMICOLON, "Semicolon"},
    {GLFW_KEY_APOSTROPHE, "Apostrophe"},
    {GLFW_KEY_COMMA, "Comma"},
    {GLFW_KEY_PERIOD, "Period"},
    {GLFW_KEY_SLASH, "Slash"},
    {GLFW_KEY_WORLD_1, "World1"},
    {GLFW_KEY_WORLD_2, "World2"},
    {GLFW_KEY_MENU, "Menu"},
    {GLFW_KEY_PAUSE, "Pause"},
    {GLFW_KEY_PRINT_SCREEN, "PrintScreen"},
    {GLFW_KEY_SCROLL_LOCK, "ScrollLock"},
    {GLFW_KEY_KP_0, "Keypad0"},
    {GLFW_KEY_KP_1, "Keypad1"},
    {GLFW_KEY_KP_2, "Keypad2"},
    {GLFW_KEY_KP_3, "Keypad3"},
    {GLFW_KEY_KP_4, "Keypad4"},
    {GLFW_KEY_KP_5, "Keypad5"},
    {GLFW_KEY_KP_6, "Keypad6"},
    {GLFW_KEY_KP_7, "Keypad7"},
    {GLFW_KEY_KP_8, "Keypad8"},
    {GLFW_KEY_KP_9, "Keypad9"},
    {GLFW_KEY_KP_DECIMAL, "KeypadDecimal"},
    {GLFW_KEY_KP_DIVIDE, "KeypadDivide"},
    {GLFW_KEY_KP_MULTIPLY, "KeypadMultiply"},
    {GLFW_KEY_KP_SUBTRACT, "KeypadSubtract"},
    {GLFW_KEY_KP_ADD, "KeypadAdd"},
    {GLFW_KEY_KP_ENTER, "KeypadEnter"},
    {GLFW_KEY_KP_EQUAL, "KeypadEqual"},
    {GLFW_KEY_LEFT_CONTROL, "Control"},
    {GLFW_KEY_LEFT_SHIFT, "Shift"},
    {GLFW_KEY_LEFT_ALT, "Alt"},
});

// Returns the same token for the left and the right modifier key.
int without_side(int glfw_key) {
    switch (glfw_key) {
        case GLFW_KEY_RIGHT_CONTROL:
            return GLFW_KEY_LEFT_CONTROL;
        case GLFW_KEY_RIGHT_SHIFT:
            return GLFW_KEY_LEFT_SHIFT;
        case GLFW_KEY_RIGHT_ALT:
            return GLFW_KEY_LEFT_ALT;
        default:
            return glfw_key;
    }
}

bool is_modifier(int glfw_key) {
    return glfw_key == GLFW_KEY_LEFT_CONTROL || glfw_key == GLFW_KEY_LEFT_SHIFT || glfw_key == GLFW_KEY_LEFT_ALT;
}

}  // namespace

std::optional<std::string> key_name(int glfw_key, int glfw_modifiers) {
    const int key = without_side(glfw_key);
    const auto row =
        std::find_if(kKeys.begin(), kKeys.end(), [&](const NamedKey& named) { return named.glfw_key == key; });
    if (row == kKeys.end()) return std::nullopt;
    if (is_modifier(key)) return std::string(row->name);
    std::string name;
    if (glfw_modifiers & GLFW_MOD_CONTROL) name += "Control+";
    if (glfw_modifiers & GLFW_MOD_ALT) name += "Alt+";
    if (glfw_modifiers & GLFW_MOD_SHIFT) name += "Shift+";
    return name.append(row->name);
}

std::vector<KeyEvent> KeyTracker::take(int glfw_key, int glfw_action, int glfw_modifiers) {
    const int key = without_side(glfw_key);
    if (is_modifier(key)) {
        if (glfw_action == GLFW_PRESS) lone_modifier_ = lone_modifier_ == 0 ? key : 0;
        if (glfw_action != GLFW_RELEASE || lone_modifier_ != key) return {};
        lone_modifier_ = 0;
        const std::string name = *key_name(key, 0);
        return {{name, KeyAction::Press}, {name, KeyAction::Release}};
    }
    const auto held = std::find_if(held_.begin(), held_.end(), [&](const Held& h) { return h.glfw_key == key; });
    if (glfw_action == GLFW_RELEASE) {
        if (held == held_.end()) return {};
        std::vector<KeyEvent> events{{std::move(held->name), KeyAction::Release}};
        held_.erase(held);
        return events;
    }
    if (held != held_.end()) return {{held->name, KeyAction::Repeat}};
    lone_modifier_ = 0;
    const auto name = key_name(key, glfw_modifiers);
    if (!name) return {};
    held_.push_back({key, *name});
    return {{*name, KeyAction::Press}};
}

std::vector<KeyEvent> KeyTracker::let_go() {
    std::vector<KeyEvent> events;
    for (Held& held : held_) events.push_back({std::move(held.name), KeyAction::Release});
    held_.clear();
    lone_modifier_ = 0;
    return events;
}

}  // namespace handrail::window
