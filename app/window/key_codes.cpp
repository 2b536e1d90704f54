#include "app/window/key_codes.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/window/key_labels.h"

namespace handrail::window {

unsigned modifier_bits(int glfw_modifiers) {
    return ((glfw_modifiers & GLFW_MOD_SHIFT) ? kShiftBit : 0U) |
           ((glfw_modifiers & GLFW_MOD_CONTROL) ? kControlBit : 0U) | ((glfw_modifiers & GLFW_MOD_ALT) ? kAltBit : 0U);
}

int glfw_modifiers(unsigned modifier_bits) {
    return ((modifier_bits & kShiftBit) ? GLFW_MOD_SHIFT : 0) | ((modifier_bits & kControlBit) ? GLFW_MOD_CONTROL : 0) |
           ((modifier_bits & kAltBit) ? GLFW_MOD_ALT : 0);
}

KeysByCode keys_by_code() {
    KeysByCode keys{};
    const std::map<int, int> named = keys_by_label(key_labels());
    for (int key = GLFW_KEY_SPACE; key < GLFW_KEY_LEFT_SHIFT; ++key) {
        const int code = glfwGetKeyScancode(key);
        if (code > 0 && code < static_cast<int>(keys.size())) {
            const auto name = named.find(key);
            keys[static_cast<std::size_t>(code)] = name == named.end() ? key : name->second;
        }
    }
    return keys;
}

}  // namespace handrail::window
