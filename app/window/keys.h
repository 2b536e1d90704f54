// Keys by name. Letters are bound by the label of their key (key_labels.h), all others by their place: GLFW derives the
// key token from the scancode. The names are those of settings files. Plain values; app thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handrail::window {

enum class KeyAction { Press, Repeat, Release };

// `key` is a name of key_names() (settings/key_names.h), with held modifiers before it in this order:
// "Control+Alt+Shift+F1".
struct KeyEvent {
    std::string key;
    KeyAction action = KeyAction::Press;

    bool operator==(const KeyEvent&) const = default;
};

// The name of a GLFW key token with GLFW's modifier bits; nothing for keys without a name here. Lock keys do not count
// as modifiers.
std::optional<std::string> key_name(int glfw_key, int glfw_modifiers);

// Turns the stream of raw keys into events. A release has the same name as its press, even if modifiers changed in
// between. Pressing Control, Shift or Alt reports nothing. When one is released and no other key or mouse button went
// down meanwhile, it becomes a press followed at once by a release. So Control+C never means silence, but Control alone
// does, even while a walking key is held.
class KeyTracker {
public:
    std::vector<KeyEvent> take(int glfw_key, int glfw_action, int glfw_modifiers);
    // Call it when a mouse button or the wheel is used: a held modifier then belonged to that.
    void other_input() { lone_modifier_ = 0; }
    // Call it when the window loses the keyboard. Returns releases for all keys that are down; modifiers that were down
    // no longer count as alone.
    std::vector<KeyEvent> let_go();

private:
    struct Held {
        int glfw_key = 0;
        std::string name;
    };
    std::vector<Held> held_;
    int lone_modifier_ = 0;  // GLFW's token of a modifier that is down with no key after it, or 0
};

}  // namespace handrail::window
