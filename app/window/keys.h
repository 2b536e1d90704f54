// Defines the names of keys. Letters are found by the label of their key (key_labels.h). All other keys are found by
// their place, because GLFW derives the key token from the scancode. The names are those of settings files. Plain
// values; app thread.
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

// Returns the name of a GLFW key token with GLFW's modifier bits. Returns nothing for a key that has no name. Ignores
// the bits of lock keys.
std::optional<std::string> key_name(int glfw_key, int glfw_modifiers);

// Converts raw keys into events. A release has the same name as its press, even if the modifiers changed in between.
// Pressing Control, Shift or Alt gives no event. Releasing such a key gives a press followed at once by a release,
// unless another key or mouse button went down in the meantime. So Control+C never stops speech, but Control alone
// stops it, even while a walking key is held.
class KeyTracker {
public:
    std::vector<KeyEvent> take(int glfw_key, int glfw_action, int glfw_modifiers);
    // Call this function when the person uses a mouse button or the wheel. A modifier that is held meanwhile then gives
    // no event when it is released.
    void other_input() { lone_modifier_ = 0; }
    // Call this function when the window loses the keyboard. Returns releases for all keys that are down. Modifiers
    // that are down give no events when they are released later.
    std::vector<KeyEvent> let_go();

private:
    struct Held {
        int glfw_key = 0;
        std::string name;
    };
    std::vector<Held> held_;
    int lone_modifier_ = 0;  // GLFW's token of a modifier that is down while no other key was pressed after it; 0: none
};

}  // namespace handrail::window
