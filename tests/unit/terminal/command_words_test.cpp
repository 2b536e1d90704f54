#include "app/core/dialogue/command_words.h"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

#include "app/core/dialogue/dialogue.h"
#include "app/core/dialogue/key_map.h"
#include "app/core/dialogue/terminal_line.h"
#include "tests/support/names.h"
#include "tests/support/spoken_language.h"
#include "worlds/base/typist.h"

namespace handrail {
namespace command_words_test {

std::vector<std::string> words_in(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

TEST(CommandWords, exist_for_every_command_in_every_language_and_are_unique) {
    std::set<std::string> wanted;
    for (const CommandInfo& row : command_table()) wanted.insert("command_word." + std::string(row.word));
    for (const LanguageName& language : bundled_languages()) {
        const test::InLanguage spoken(language.code);
        std::set<std::string> found;
        std::map<std::string, std::string> owner;
        for (const CommandInfo& row : command_table()) owner[std::string(row.word)] = row.word;
        for (const auto& [key, text] : bundled_texts(language.code)) {
            if (!key.starts_with("command_word.")) continue;
            found.insert(key);
            const std::string command = key.substr(std::string_view("command_word.").size());
            EXPECT_FALSE(words_in(text).empty()) << key;
            for (const std::string& word : words_in(text)) {
                const auto [held, fresh] = owner.emplace(word, command);
                EXPECT_EQ(held->second, command) << language.code << ": " << word;
                ASSERT_TRUE(find_command(command)) << key;
                EXPECT_EQ(command_of_word(word), find_command(command)->command) << word;
                EXPECT_FALSE(is_quit_word(word)) << word;
            }
        }
        EXPECT_EQ(found, wanted) << language.code;
        // In every language, the program must understand the words of the command table and each command's own name.
        for (const CommandInfo& row : command_table()) {
            EXPECT_EQ(command_of_word(row.word), row.command) << row.word;
            EXPECT_EQ(command_of_word(spoken_word(row.command)), row.command) << spoken_word(row.command);
        }
    }
}

TEST(CommandWords, match_the_command_table_in_english_and_include_plain_synonyms) {
    for (const CommandInfo& row : command_table()) EXPECT_EQ(spoken_word(row.command), row.word);
    const std::map<std::string, Command> plain{
        {"up", Command::Forward}, {"down", Command::Back},   {"again", Command::Repeat}, {"tab", Command::Menu},
        {"open", Command::Use},   {"doors", Command::Exits}, {"exit", Command::Leave},   {"UP", Command::Forward}};
    for (const auto& [word, command] : plain) EXPECT_EQ(command_of_word(word), command) << word;
    EXPECT_EQ(command_of_word("vorwärts"), std::nullopt);
    EXPECT_EQ(command_of_word(""), std::nullopt);
}

TEST(CommandWords, are_german_in_a_german_session_with_umlauts_written_out_or_not) {
    const test::InLanguage german("de");
    for (const char* word : {"vorwärts", "VORWÄRTS", "vorwaerts", "Vorwaerts", "vor", "forward"})
        EXPECT_EQ(command_of_word(word), Command::Forward) << word;
    EXPECT_EQ(parse_terminal_line("links 3")->command, Command::TurnLeft);
    EXPECT_EQ(parse_terminal_line("links 3")->times, 3);
    EXPECT_EQ(command_of_word("gebaeude"), Command::ScaleBuilding);
    EXPECT_EQ(command_of_word("beenden"), Command::Leave);
    EXPECT_TRUE(parse_terminal_line("schluss")->leave);
    EXPECT_TRUE(parse_terminal_line("quit")->leave);
    EXPECT_THAT(parse_terminal_line("lincks").error().message, testing::HasSubstr("„links“"));
    speak_to(ActsBy::Lines);
    EXPECT_EQ(KeyMap({}).keys_of(Command::DropMark), "marke");
    speak_to(ActsBy::WindowKeys);
}

// The program must understand the words that its texts tell a person to type.
TEST(CommandWords, that_german_texts_mention_are_understood) {
    const test::InLanguage german("de");
    std::size_t seen = 0;
    for (const auto& [key, text] : bundled_texts("de")) {
        // The set-up by voice has other answers.
        if (!key.ends_with("_typed") || key.starts_with("wizard")) continue;
        for (std::size_t at = text.find("„"); at != std::string::npos; at = text.find("„", at + 1)) {
            const std::size_t begin = at + std::string_view("„").size();
            const std::string word = text.substr(begin, text.find("“", begin) - begin);
            if (word.starts_with('{')) continue;
            ++seen;
            const bool command = parse_terminal_line(word).has_value();
            EXPECT_TRUE(command || list_word(word) != word) << key << ": " << word;
        }
    }
    EXPECT_GT(seen, 40U);
}

TEST(ListWords, act_like_the_keys_of_a_list_and_give_way_to_item_names) {
    const test::InLanguage german("de");
    Dialogue dialogue;
    std::vector<std::size_t> chosen;
    ListSpec list;
    list.title = "Welten";
    list.items = {{"Haus", {}, false}, {"Schule", {}, false}, {"Ende des Flurs", {}, false}};
    list.chosen = [&](std::size_t i) { chosen.push_back(i); };
    list.stays_open = true;
    dialogue.open(list);
    EXPECT_THAT(dialogue.line("runter", 0.0).words, testing::HasSubstr("Schule"));
    EXPECT_THAT(dialogue.line("hoch", 0.0).words, testing::HasSubstr("Haus"));
    EXPECT_THAT(dialogue.line("Down", 0.0).words, testing::HasSubstr("Schule"));
    EXPECT_THAT(dialogue.line("liste", 0.0).words, testing::HasSubstr("3: Ende des Flurs"));
    dialogue.line("wählen", 0.0);
    dialogue.line("waehlen", 0.0);
    dialogue.line("ende", 0.0);
    EXPECT_THAT(chosen, testing::ElementsAre(1U, 1U, 2U)) << "a name that begins so comes before the key of that name";
    dialogue.line("abbrechen", 0.0);
    EXPECT_FALSE(dialogue.is_open());
}

}  // namespace command_words_test
}  // namespace handrail
