// Tests the letter keys of every keyboard layout with Latin letters on this system. Each must act by its label.
#include "app/window/key_labels.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>
#include <xkbcommon/xkbcommon.h>

#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace handrail::test {
namespace key_labels_test {

constexpr const char* kLayouts = "/usr/share/X11/xkb/rules/evdev.lst";

// Returns X's key code for each GLFW key. The table below contains the code of the first key of each row, and the row's
// GLFW keys in order.
const std::map<int, int>& codes() {
    static const std::map<int, int> all = [] {
        std::map<int, int> codes{{GLFW_KEY_GRAVE_ACCENT, 49},
                                 {GLFW_KEY_MINUS, 20},
                                 {GLFW_KEY_EQUAL, 21},
                                 {GLFW_KEY_BACKSLASH, 51},
                                 {GLFW_KEY_WORLD_1, 94}};
        for (const auto& [first, row] :
             {std::pair(24, "QWERTYUIOP[]"), std::pair(38, "ASDFGHJKL;'"), std::pair(52, "ZXCVBNM,./")})
            for (int i = 0; row[i] != '\0'; ++i) codes[row[i]] = first + i;
        return codes;
    }();
    return all;
}

KeyLabels american() {
    KeyLabels labels;
    for (const auto& [key, code] : codes())
        if (key != GLFW_KEY_WORLD_1)
            labels[key] = std::string(1, static_cast<char>(key >= 'A' && key <= 'Z' ? key + 32 : key));
    return labels;
}

// Returns pairs of layout and variant, such as "fr" and "bepo", as the system lists them.
std::vector<std::pair<std::string, std::string>> layouts() {
    std::vector<std::pair<std::string, std::string>> all;
    std::ifstream in(kLayouts);
    std::string section;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("!")) section = line.substr(2);
        std::istringstream words(line);
        std::string first, second;
        words >> first >> second;
        if (first.empty() || first == "!") continue;
        if (section.starts_with("layout")) all.emplace_back(first, "");
        if (section.starts_with("variant")) all.emplace_back(second.substr(0, second.find(':')), first);
    }
    return all;
}

KeyLabels labels_of(xkb_context* context, const std::string& layout, const std::string& variant) {
    const xkb_rule_names names{"evdev", "pc105", layout.c_str(), variant.c_str(), ""};
    const std::unique_ptr<xkb_keymap, decltype(&xkb_keymap_unref)> keymap(
        xkb_keymap_new_from_names(context, &names, XKB_KEYMAP_COMPILE_NO_FLAGS), xkb_keymap_unref);
    if (!keymap) return {};
    const std::unique_ptr<xkb_state, decltype(&xkb_state_unref)> state(xkb_state_new(keymap.get()), xkb_state_unref);
    KeyLabels labels;
    for (const auto& [key, code] : codes()) {
        char text[16] = {};
        xkb_state_key_get_utf8(state.get(), static_cast<xkb_keycode_t>(code), text, sizeof text);
        labels[key] = text;
    }
    return labels;
}

bool is_small_letter(const std::string& label) { return label.size() == 1 && label[0] >= 'a' && label[0] <= 'z'; }

// Checks that each letter that is a key's label names that key, and that every name belongs to exactly one key.
void expect_right(const KeyLabels& labels) {
    const std::map<int, int> named = keys_by_label(labels);
    std::set<int> names;
    std::map<int, int> key_of;
    for (const auto& [key, name] : named) {
        EXPECT_TRUE(names.insert(name).second) << static_cast<char>(name) << " is on two keys";
        key_of[name] = key;
    }
    EXPECT_EQ(named.size(), 39U);
    std::map<std::string, int> printed;
    for (const auto& [key, label] : labels) ++printed[label];
    for (int letter = GLFW_KEY_A; letter <= GLFW_KEY_Z; ++letter) {
        const std::string small(1, static_cast<char>(letter + 32));
        ASSERT_TRUE(key_of.contains(letter)) << small;
        const auto label = labels.find(key_of[letter]);
        if (printed.contains(small)) {
            EXPECT_EQ(label == labels.end() ? "" : label->second, small);
        } else if (const auto there = labels.find(letter); there == labels.end() || !is_small_letter(there->second)) {
            EXPECT_EQ(key_of[letter], letter) << small << " is printed nowhere";
        }
    }
}

TEST(KeyLabels, of_an_american_keyboard_match_their_physical_places) {
    expect_right(american());
    for (const auto& [key, name] : keys_by_label(american())) EXPECT_EQ(key, name);
    for (const auto& [key, name] : keys_by_label({})) EXPECT_EQ(key, name) << "nothing is known of the labels";
}

TEST(KeyLabels, of_a_french_keyboard_differ_in_four_letters_and_the_semicolon) {
    KeyLabels french = american();
    french[GLFW_KEY_A] = "q", french[GLFW_KEY_Q] = "a", french[GLFW_KEY_Z] = "w", french[GLFW_KEY_W] = "z";
    french[GLFW_KEY_M] = ",", french[GLFW_KEY_SEMICOLON] = "m", french[GLFW_KEY_COMMA] = ";";
    expect_right(french);
    const std::map<int, int> named = keys_by_label(french);
    EXPECT_EQ(named.at(GLFW_KEY_Q), GLFW_KEY_A);
    EXPECT_EQ(named.at(GLFW_KEY_SEMICOLON), GLFW_KEY_M);
    EXPECT_EQ(named.at(GLFW_KEY_COMMA), GLFW_KEY_COMMA) << "signs act by their place";
    EXPECT_EQ(named.at(GLFW_KEY_M), GLFW_KEY_SEMICOLON) << "the place that is left over";
}

TEST(KeyLabels, are_correct_on_every_layout_with_latin_letters) {
    const auto all = layouts();
    if (all.empty()) GTEST_SKIP() << "needs the keyboard layouts of xkb-data";
    const std::unique_ptr<xkb_context, decltype(&xkb_context_unref)> context(xkb_context_new(XKB_CONTEXT_NO_FLAGS),
                                                                             xkb_context_unref);
    int latin = 0;
    for (const auto& [layout, variant] : all) {
        SCOPED_TRACE(layout + " " + variant);
        const KeyLabels labels = labels_of(context.get(), layout, variant);
        if (std::none_of(labels.begin(), labels.end(), [](const auto& l) { return is_small_letter(l.second); }))
            continue;
        ++latin;
        expect_right(labels);
    }
    EXPECT_GT(latin, 200) << "of " << all.size() << " layouts and variants";
    RecordProperty("latin", latin);
}

}  // namespace key_labels_test
}  // namespace handrail::test
