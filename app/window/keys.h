// Keys by name. Letters are bound by what is printed on their keys (key_labels.h), all others by their place: GLFW's
// key token comes from the scancode. Names are those a settings file takes. Pure values; app thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handrail {

enum class KeyAction { Press, Repeat, Release };

// `key` is a name of key_names() (settings/key_names.h), with held modifiers before it in this order:
// "Control+Alt+Shift+F1".
struct KeyEvent {
    std::string key;
    KeyAction action = KeyAction::Press;

    bool operator==(const KeyEvent&) const = default;
};

// The name of a GLFW key token with GLFW's modifier bits, or nothing for keys we have no name for. Lock keys do not
// count as modifiers.
std::optional<std::string> key_name(int glfw_key, int glfw_modifiers);

// Turns the stream of raw keys into events. A release carries the name its press had, whatever happened to the
// modifiers since. Control, Shift and Alt say nothing when pressed: when they come up again and no other key or mouse
// button went down meanwhile, they are one press followed at once by a release. So Control+C never means silence, and
// Control does while a walking key is held.
class KeyTracker {
public:
    std::vector<KeyEvent> take(int glfw_key, int glfw_action, int glfw_modifiers);
    // A mouse button or wheel was used: a held modifier belonged to that.
    void other_input() { lone_modifier_ = 0; }
    // The window lost the keyboard: releases for all that is down. Modifiers that were down no longer count as alone.
    std::vector<KeyEvent> let_go();

private:
    struct Held {
        int glfw_key = 0;
        std::string name;
    };
    std::vector<Held> held_;
    int lone_modifier_ = 0;  // GLFW key of the modifier that is down with nothing after it, or 0
};

}  // namespace handrail
