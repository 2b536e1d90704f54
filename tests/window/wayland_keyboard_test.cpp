#include "app/window/wayland_keyboard.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

namespace handrail::test {
namespace wayland_keyboard_test {

constexpr int kKeyOne = 2, kKeyTwo = 3, kKeyEnter = 28, kKeyUp = 103,
              kNoKey = 5000;  // key codes from linux/input-event-codes.h

// Returns a keymap such as a compositor sends.
Keymap keymap_of(const char* layouts) {
    const std::unique_ptr<xkb_context, decltype(&xkb_context_unref)> context(xkb_context_new(XKB_CONTEXT_NO_FLAGS),
                                                                             &xkb_context_unref);
    const xkb_rule_names names{"evdev", "pc105", layouts, "", ""};
    return Keymap(xkb_keymap_new_from_names(context.get(), &names, XKB_KEYMAP_COMPILE_NO_FLAGS));
}

TEST(WaylandKeyboard, names_keys_with_and_without_shift_according_to_their_layout) {
    const Keymap german = keymap_of("de");
    ASSERT_TRUE(german);
    EXPECT_EQ(key_symbol(*german, kKeyTwo, 0, false).name, "2");
    EXPECT_EQ(key_symbol(*german, kKeyTwo, 0, true).name, "quotedbl");
    EXPECT_EQ(key_symbol(*german, kKeyTwo, 0, true).keysym, 0x22U);
    EXPECT_EQ(key_symbol(*german, kKeyEnter, 0, false).name, "Return");
    EXPECT_EQ(key_symbol(*german, kKeyEnter, 0, true).name, "Return") << "the key has no second level";
    EXPECT_EQ(key_symbol(*german, kKeyUp, 0, false).keysym, 0xFF52U);
}

TEST(WaylandKeyboard, uses_the_active_layout_or_the_first_if_a_key_has_fewer_layouts) {
    const Keymap both = keymap_of("us,de");
    ASSERT_TRUE(both);
    EXPECT_EQ(key_symbol(*both, kKeyTwo, 0, true).name, "at");
    EXPECT_EQ(key_symbol(*both, kKeyTwo, 1, true).name, "quotedbl");
    EXPECT_EQ(key_symbol(*both, kKeyOne, 7, true).name, "exclam");
}

TEST(WaylandKeyboard, returns_nothing_for_a_key_unknown_to_the_layout) {
    const Keymap english = keymap_of("us");
    ASSERT_TRUE(english);
    EXPECT_EQ(key_symbol(*english, kNoKey, 0, false).keysym, 0U);
    EXPECT_EQ(key_symbol(*english, kNoKey, 0, false).name, "");
}

TEST(WaylandKeyboard, uses_the_same_key_codes_as_x11) { EXPECT_EQ(x_code_of(kKeyOne), 10U); }

}  // namespace wayland_keyboard_test
}  // namespace handrail::test
