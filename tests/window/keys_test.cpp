#include "app/window/keys.h"

#include <algorithm>

#include "app/core/dialogue/command.h"
#include "settings/key_names.h"
#include "tests/support/names.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <set>

namespace handrail::test {
namespace keys_test {

using Events = std::vector<KeyEvent>;

TEST(KeyName, names_the_physical_key_with_its_modifiers_in_front) {
    EXPECT_EQ(key_name(GLFW_KEY_UP, 0), "Up");
    EXPECT_EQ(key_name(GLFW_KEY_PAGE_DOWN, 0), "PageDown");
    EXPECT_EQ(key_name(GLFW_KEY_F, 0), "F");
    EXPECT_EQ(key_name(GLFW_KEY_F12, 0), "F12");
    EXPECT_EQ(key_name(GLFW_KEY_GRAVE_ACCENT, 0), "Grave");
    EXPECT_EQ(key_name(GLFW_KEY_1, GLFW_MOD_SHIFT), "Shift+1");
    EXPECT_EQ(key_name(GLFW_KEY_LEFT, GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT), "Control+Alt+Shift+Left");
    EXPECT_EQ(key_name(GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL), "Control");
    EXPECT_EQ(key_name(GLFW_KEY_F, GLFW_MOD_CAPS_LOCK | GLFW_MOD_NUM_LOCK), "F") << "locks are no modifiers";
    EXPECT_EQ(key_name(GLFW_KEY_UNKNOWN, 0), std::nullopt);
    EXPECT_EQ(key_name(GLFW_KEY_LEFT_SUPER, 0), std::nullopt) << "the desktop's own key";
}

TEST(KeyNames, are_unique_and_each_belongs_to_some_key) {
    const std::set<std::string_view> names(key_names().begin(), key_names().end());
    EXPECT_EQ(names.size(), key_names().size());
    std::set<std::string> made;
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key)
        if (const auto name = key_name(key, 0)) made.insert(*name);
    EXPECT_EQ(made, std::set<std::string>(names.begin(), names.end()));
}

TEST(KeyTracker, distinguishes_press_repeat_and_release) {
    KeyTracker keys;
    EXPECT_EQ(keys.take(GLFW_KEY_UP, GLFW_PRESS, 0), (Events{{"Up", KeyAction::Press}}));
    EXPECT_EQ(keys.take(GLFW_KEY_UP, GLFW_REPEAT, 0), (Events{{"Up", KeyAction::Repeat}}));
    EXPECT_EQ(keys.take(GLFW_KEY_UP, GLFW_RELEASE, 0), (Events{{"Up", KeyAction::Release}}));
    EXPECT_EQ(keys.take(GLFW_KEY_UP, GLFW_RELEASE, 0), Events{}) << "a release without its press is of no use";
}

TEST(KeyTracker, gives_a_release_the_name_of_its_press) {
    KeyTracker keys;
    keys.take(GLFW_KEY_UP, GLFW_PRESS, 0);
    keys.take(GLFW_KEY_LEFT_SHIFT, GLFW_PRESS, GLFW_MOD_SHIFT);
    EXPECT_EQ(keys.take(GLFW_KEY_UP, GLFW_REPEAT, GLFW_MOD_SHIFT), (Events{{"Up", KeyAction::Repeat}}));
    EXPECT_EQ(keys.take(GLFW_KEY_UP, GLFW_RELEASE, GLFW_MOD_SHIFT), (Events{{"Up", KeyAction::Release}}));
}

TEST(KeyTracker, control_pressed_alone_acts_on_release) {
    KeyTracker keys;
    EXPECT_EQ(keys.take(GLFW_KEY_RIGHT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL), Events{});
    EXPECT_EQ(keys.take(GLFW_KEY_RIGHT_CONTROL, GLFW_REPEAT, GLFW_MOD_CONTROL), Events{});
    EXPECT_EQ(keys.take(GLFW_KEY_RIGHT_CONTROL, GLFW_RELEASE, 0),
              (Events{{"Control", KeyAction::Press}, {"Control", KeyAction::Release}}));
}

TEST(KeyTracker, control_with_another_key_or_the_mouse_does_not_count_as_control_alone) {
    KeyTracker keys;
    keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL);
    EXPECT_EQ(keys.take(GLFW_KEY_C, GLFW_PRESS, GLFW_MOD_CONTROL), (Events{{"Control+C", KeyAction::Press}}));
    EXPECT_EQ(keys.take(GLFW_KEY_C, GLFW_RELEASE, GLFW_MOD_CONTROL), (Events{{"Control+C", KeyAction::Release}}));
    EXPECT_EQ(keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE, 0), Events{});

    keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL);
    keys.other_input();
    EXPECT_EQ(keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE, 0), Events{});

    keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL);
    keys.take(GLFW_KEY_LEFT_SHIFT, GLFW_PRESS, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
    EXPECT_EQ(keys.take(GLFW_KEY_LEFT_SHIFT, GLFW_RELEASE, GLFW_MOD_CONTROL), Events{});
    EXPECT_EQ(keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE, 0), Events{});
}

TEST(KeyTracker, control_silences_speech_while_a_walking_key_is_held) {
    KeyTracker keys;
    keys.take(GLFW_KEY_UP, GLFW_PRESS, 0);
    keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL);
    keys.take(GLFW_KEY_UP, GLFW_REPEAT, GLFW_MOD_CONTROL);
    EXPECT_EQ(keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE, 0).size(), 2U);
}

TEST(KeyTracker, releases_all_keys_when_the_keyboard_is_lost) {
    KeyTracker keys;
    keys.take(GLFW_KEY_UP, GLFW_PRESS, 0);
    keys.take(GLFW_KEY_LEFT, GLFW_PRESS, GLFW_MOD_SHIFT);
    keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL);
    EXPECT_EQ(keys.let_go(), (Events{{"Up", KeyAction::Release}, {"Shift+Left", KeyAction::Release}}));
    EXPECT_EQ(keys.take(GLFW_KEY_UP, GLFW_RELEASE, 0), Events{});
    EXPECT_EQ(keys.take(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE, 0), Events{})
        << "leaving by Control+Alt+arrow must not silence speech";
}

// Every default key must have a name, so that a person can reach each command from the window.
TEST(KeyNames, include_every_key_of_the_command_table) {
    ASSERT_FALSE(command_table().empty());
    for (const CommandInfo& row : command_table()) {
        std::string_view keys = row.key;
        while (!keys.empty()) {
            const std::size_t end = std::min(keys.find(' '), keys.size());
            const std::string_view key = keys.substr(0, end);
            keys.remove_prefix(std::min(end + 1, keys.size()));
            const std::string_view plain = key.substr(key.rfind('+') + 1);  // the key's name without "Shift+"
            EXPECT_NE(std::find(key_names().begin(), key_names().end(), plain), key_names().end())
                << key << " of " << row.word;
        }
    }
}

}  // namespace keys_test
}  // namespace handrail::test
