// Tests that every command and every key has texts in every language, and that the command words for scripts are the
// same in every language.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "app/core/dialogue/key_map.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/text.h"

namespace handrail {
namespace command_texts_test {

TEST(CommandTexts, exist_for_every_command_and_for_nothing_else) {
    std::set<std::string> wanted;
    for (const CommandInfo& row : command_table()) wanted.insert("command." + std::string(row.word));
    for (const LanguageName& language : bundled_languages()) {
        std::set<std::string> found;
        for (const auto& [key, pattern] : bundled_texts(language.code))
            if (key.starts_with("command.")) found.insert(key);
        EXPECT_EQ(found, wanted) << language.code;
    }
}

TEST(CommandTexts, name_only_keys_that_a_window_knows) {
    const std::string names = lower_ascii(test::content_of((test::project_root() / "app/window/keys.cpp").string()));
    std::size_t keys = 0;
    for (const auto& [key, pattern] : bundled_texts("en"))
        if (key.starts_with("key_name.")) {
            ++keys;
            EXPECT_NE(names.find("\"" + key.substr(9) + "\""), std::string::npos) << key;
        }
    EXPECT_GT(keys, 40U);
}

TEST(CommandTexts, are_spoken_in_german_with_german_key_names) {
    const test::InLanguage german("de");
    EXPECT_EQ(info(Command::Forward).help(), "Ein Schritt vorwärts; gehalten: gehen.");
    EXPECT_EQ(find_command("forward")->command, Command::Forward);
    EXPECT_EQ(spoken_key("Control+Alt+PageUp"), "Strg+Alt+Bild auf");
    EXPECT_EQ(spoken_key("Q"), "Q");
    const std::map<std::string, std::string> changes{{"wheer", "F5"}};
    const KeyMap keys(changes);
    EXPECT_EQ(keys.keys_of(Command::Repeat), "Leertaste oder Q");
    EXPECT_EQ(keys.keys_of(Command::ToggleForces), "F oder die Taste links neben der 1");
    EXPECT_EQ(keys.words_of_keys(Command::Repeat), "Space Q");
    EXPECT_EQ(keys.problems().front(),
              "Die Einstellungen geben „wheer“ eine Taste, aber das ist kein Befehl. War „where“ gemeint?");
}

}  // namespace command_texts_test
}  // namespace handrail
