#include "app/core/dialogue/command.h"

#include <map>
#include <set>
#include <sstream>

#include "app/core/dialogue/key_map.h"
#include "tests/support/names.h"

namespace handrail {
namespace command_test {

TEST(CommandTable, lists_every_command_once_in_order) {
    std::set<std::string_view> words;
    for (std::size_t i = 0; i < command_table().size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(command_table()[i].command), i);
        EXPECT_TRUE(words.insert(command_table()[i].word).second) << command_table()[i].word;
        EXPECT_FALSE(command_table()[i].help().empty());
    }
}

// The keys of the demonstration of the plugin that preceded Handrail keep their meanings for ever.
TEST(KeyMap, keeps_the_key_bindings_of_the_original_program) {
    const KeyMap keys({});
    const std::map<std::string, Command> original{{"Left", Command::TurnLeft},  {"Right", Command::TurnRight},
                                                  {"Up", Command::Forward},     {"Down", Command::Back},
                                                  {"PageUp", Command::TiltUp},  {"PageDown", Command::TiltDown},
                                                  {"F", Command::ToggleForces}, {"Escape", Command::Leave}};
    for (const auto& [key, command] : original) EXPECT_EQ(keys.find(key), command) << key;
}

// Orca and NVDA reserve Insert and the keypad, so no set of keys uses them.
TEST(KeyMap, needs_no_key_that_screen_readers_reserve) {
    for (const KeyboardHand hand : {KeyboardHand::Both, KeyboardHand::Left, KeyboardHand::Right}) {
        const KeyMap keys({}, hand);
        EXPECT_EQ(keys.find("Shift+M"), Command::DropMark);
        for (const CommandInfo& row : command_table()) {
            std::istringstream names(keys.words_of_keys(row.command));
            bool needs = false, other = false;
            for (std::string name; names >> name;) {
                const bool kept = name.find("Insert") != std::string::npos ||
                                  name.find("CapsLock") != std::string::npos || name.starts_with("Keypad");
                needs = needs || kept;
                other = other || !kept;
            }
            EXPECT_TRUE(!needs || other) << row.word;
        }
    }
}

TEST(KeyMap, lets_the_person_change_keys_and_reports_conflicts) {
    const KeyMap keys({{"where", "Alt+W"}, {"wher", "X"}, {"heading", "E"}});
    const std::vector<std::string>& problems = keys.problems();
    EXPECT_EQ(keys.find("alt+w"), Command::WhereAmI);
    EXPECT_EQ(keys.find("F2"), std::nullopt);
    EXPECT_EQ(keys.find("E"), Command::Heading);
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_THAT(problems[0], testing::HasSubstr("Did you mean \"where\"?"));
    EXPECT_THAT(problems[1], testing::HasSubstr("The key E"));
}

}  // namespace command_test
}  // namespace handrail
