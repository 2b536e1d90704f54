#include "app/window/key_labels.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace handrail::window {
namespace {

constexpr std::array kSigns{
    std::pair{GLFW_KEY_GRAVE_ACCENT, "`"}, std::pair{GLFW_KEY_MINUS, "-"},         std::pair{GLFW_KEY_EQUAL, "="},
    std::pair{GLFW_KEY_LEFT_BRACKET, "["}, std::pair{GLFW_KEY_RIGHT_BRACKET, "]"}, std::pair{GLFW_KEY_BACKSLASH, "\\"},
    std::pair{GLFW_KEY_SEMICOLON, ";"},    std::pair{GLFW_KEY_APOSTROPHE, "'"},    std::pair{GLFW_KEY_COMMA, ","},
    std::pair{GLFW_KEY_PERIOD, "."},       std::pair{GLFW_KEY_SLASH, "/"},         std::pair{GLFW_KEY_WORLD_1, ""},
    std::pair{GLFW_KEY_WORLD_2, ""}};

bool is_letter(int key) { return key >= GLFW_KEY_A && key <= GLFW_KEY_Z; }

// Returns GLFW's token of a letter. The tokens are the ASCII codes of the letters.
std::optional<int> letter_of(const std::string& label) {
    if (label.size() != 1) return std::nullopt;
    const int key = label[0] >= 'a' && label[0] <= 'z' ? label[0] - 'a' + GLFW_KEY_A : label[0];
    return is_letter(key) ? std::optional(key) : std::nullopt;
}

std::string label_of(const KeyLabels& labels, int key) {
    const auto found = labels.find(key);
    return found == labels.end() ? std::string() : found->second;
}

}  // namespace

KeyLabels key_labels() {
    KeyLabels labels;
    const auto add = [&](int key) {
        const int code = glfwGetKeyScancode(key);
        if (code <= 0) return;
        if (const char* label = glfwGetKeyName(key, code)) labels[key] = label;
    };
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) add(key);
    for (const auto& [key, sign] : kSigns) add(key);
    return labels;
}

std::map<int, int> keys_by_label(const KeyLabels& labels) {
    std::map<int, int> named;
    std::set<int> taken;
    const auto give = [&](int key, int name) {
        if (!named.contains(key) && taken.insert(name).second) named[key] = name;
    };
    // Try letters at their American places first. If two keys have the same label, the key at the letter's American
    // place then gets the letter.
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key)
        if (letter_of(label_of(labels, key)) == key) give(key, key);
    const auto by_label = [&](int key) {
        if (const auto letter = letter_of(label_of(labels, key))) give(key, *letter);
    };
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) by_label(key);
    for (const auto& [key, sign] : kSigns) by_label(key);
    // A key whose label is no letter keeps its place, unless another key has already got that name.
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) give(key, key);
    for (const auto& [key, sign] : kSigns) give(key, key);
    for (const auto& [name, sign] : kSigns)
        for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key)
            if (*sign != '\0' && label_of(labels, key) == sign) give(key, name);
    const auto give_any = [&](int key) {
        for (const auto& [name, sign] : kSigns) give(key, name);
        for (int name = GLFW_KEY_A; name <= GLFW_KEY_Z; ++name) give(key, name);
    };
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) give_any(key);
    for (const auto& [key, sign] : kSigns) give_any(key);
    return named;
}

}  // namespace handrail::window
