#include <map>
#include <regex>
#include <sstream>

#include "app/core/dialogue/command.h"
#include "app/core/dialogue/command_words.h"
#include "app/core/dialogue/key_map.h"
#include "audio-cues/plan/sound_table.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/docs/table_rows.h"
#include "worlds/base/text.h"

namespace handrail {
namespace user_guide_test {
using test::list_items;
using test::table_rows;
using testing::UnorderedElementsAreArray;

// Returns a command's keys as a guide lists them, such as "F or Grave". `name` gives the name of a key.
template <typename Name>
std::string keys_of(const CommandInfo& command, const std::string& between, Name&& name) {
    std::istringstream words{std::string(command.key)};
    std::string keys;
    for (std::string key; words >> key;) keys += (keys.empty() ? "" : between) + name(key);
    return keys;
}

// Returns a line of the list of commands: "- `where` (F2 or 1): Say where you are."
std::string command_line(const std::string& word, const std::string& keys, const std::string& help) {
    return fmt::format("- `{}`{}: {}", word, keys.empty() ? "" : " (" + keys + ")", help);
}

TEST(UserGuide, lists_every_command_with_its_keys_and_nothing_else) {
    std::vector<std::string> expected;
    for (const CommandInfo& command : command_table())
        expected.push_back(command_line(std::string(command.word),
                                        keys_of(command, " or ", [](const std::string& key) { return key; }),
                                        command.help()));
    EXPECT_THAT(list_items("user-guide/keys.md", "## Keys"), UnorderedElementsAreArray(expected));
}

TEST(UserGuide, lists_every_command_in_german_with_its_german_word_and_keys) {
    const test::InLanguage german("de");
    std::vector<std::string> expected;
    for (const CommandInfo& command : command_table())
        expected.push_back(
            command_line(spoken_word(command.command), keys_of(command, " oder ", spoken_key), command.help()));
    EXPECT_THAT(list_items("de/benutzerhandbuch/tasten.md", "## Tasten"), UnorderedElementsAreArray(expected));
}

// Counts the parts of a page by kind: titles of each level, table rows, list items and code lines. Counts settings and
// options by their names.
std::map<std::string, int> parts_of(const std::string& page) {
    std::map<std::string, int> parts;
    std::istringstream lines(test::content_of(test::project_root() / "docs" / page));
    for (std::string line; std::getline(lines, line);) {
        static const std::regex kItem(R"(^(#+|\||-|\d\.|    )[ |-].*)");
        if (std::smatch found; std::regex_match(line, found, kItem)) ++parts[found[1]];
        static const std::regex kName(R"(`(-?-?[a-z_]+\.[a-z_]+|--[a-z-]+)( [^`]*)?`)");
        for (auto it = std::sregex_iterator(line.begin(), line.end(), kName); it != std::sregex_iterator(); ++it)
            ++parts[(*it)[1]];
    }
    return parts;
}

TEST(UserGuide, is_complete_in_german) {
    const std::map<std::string, std::string> pages{
        {"user-guide.md", "benutzerhandbuch.md"},
        {"user-guide/setting-up.md", "benutzerhandbuch/einrichten.md"},
        {"user-guide/keys.md", "benutzerhandbuch/tasten.md"},
        {"user-guide/finding.md", "benutzerhandbuch/finden.md"},
        {"user-guide/moving.md", "benutzerhandbuch/bewegen.md"},
        {"user-guide/rooms-and-ways.md", "benutzerhandbuch/raeume-und-wege.md"},
        {"user-guide/things.md", "benutzerhandbuch/dinge.md"},
        {"user-guide/speech-and-sound.md", "benutzerhandbuch/sprache-und-klang.md"},
        {"user-guide/devices.md", "benutzerhandbuch/geraete.md"},
        {"user-guide/worlds.md", "benutzerhandbuch/gebaeude.md"},
        {"user-guide/trouble.md", "benutzerhandbuch/hilfe.md"}};
    const auto docs = test::project_root() / "docs";
    for (const auto& entry : std::filesystem::directory_iterator(docs / "user-guide"))
        EXPECT_TRUE(pages.contains("user-guide/" + entry.path().filename().string())) << entry.path();
    for (const auto& [english, german] : pages) EXPECT_EQ(parts_of(english), parts_of("de/" + german)) << german;
}

TEST(AuthorsGuide, is_complete_in_german) {
    const std::map<std::string, std::string> pages{
        {"map-authors-guide.md", "autorenhandbuch.md"},
        {"map-authors-guide/buildings.md", "autorenhandbuch/gebaeude.md"},
        {"map-authors-guide/furniture.md", "autorenhandbuch/moebel.md"},
        {"map-authors-guide/keys.md", "autorenhandbuch/schluessel.md"},
        {"map-authors-guide/movers.md", "autorenhandbuch/bewegliches.md"},
        {"map-authors-guide/touch.md", "autorenhandbuch/beruehren.md"},
        {"map-authors-guide/words.md", "autorenhandbuch/raeume-in-worten.md"}};
    for (const auto& entry : std::filesystem::directory_iterator(test::project_root() / "docs/map-authors-guide"))
        EXPECT_TRUE(pages.contains("map-authors-guide/" + entry.path().filename().string())) << entry.path();
    for (const auto& [english, german] : pages) EXPECT_EQ(parts_of(english), parts_of("de/" + german)) << german;
    // The tables must have the same keys in both languages, in the same order.
    const auto first_words = [](const std::vector<std::string>& rows) {
        std::vector<std::string> words;
        for (const std::string& row : rows) words.push_back(row.substr(0, row.find(' ', 2)));
        return words;
    };
    const auto numbers_of = [](const std::vector<std::string>& rows) {
        std::vector<std::string> numbers;
        for (std::string row : rows) {
            std::replace(row.begin(), row.end(), ',', '.');
            static const std::regex kNumber(R"(\d+(\.\d+)?)");
            for (auto it = std::sregex_iterator(row.begin(), row.end(), kNumber); it != std::sregex_iterator(); ++it)
                numbers.push_back(it->str());
        }
        return numbers;
    };
    for (const auto& [german, english] : {std::pair("| Material | Steifigkeit |", "| Material | Stiffness |"),
                                          std::pair("| Wirkung | Stärke |", "| Effect | Strength |"),
                                          std::pair("| Klang | Wörter |", "| Sound | Words |")}) {
        const auto rows = table_rows("de/autorenhandbuch/beruehren.md", german),
                   same = table_rows("map-authors-guide/touch.md", english);
        EXPECT_EQ(first_words(rows), first_words(same));
        EXPECT_EQ(numbers_of(rows), numbers_of(same));
    }
    const auto keys = [](std::vector<std::string> items) {
        for (std::string& item : items) item.resize(item.find('('));
        return items;
    };
    EXPECT_EQ(keys(list_items("de/autorenhandbuch/schluessel.md", "## Schlüssel")),
              keys(list_items("map-authors-guide/keys.md", "## Keys")));
    EXPECT_EQ(first_words(table_rows("de/autorenhandbuch/moebel.md", "| Schlüssel | Größe")),
              first_words(table_rows("map-authors-guide/furniture.md", "| Key | Size")));
}

TEST(Dictionary, lists_every_sound_in_the_order_of_the_spoken_dictionary) {
    std::vector<std::string> expected;
    std::string contacts;
    for (const DictionaryEntry& entry : sound_dictionary()) {
        if (entry.kind != SoundKind::Contact) {
            expected.push_back("- " + entry.text);
            // Scenarios name a sound by the words before the colon of its entry, in lower case.
            EXPECT_EQ(lower_ascii(entry.text.substr(0, entry.text.find(':'))), info(entry.kind).name);
        } else {
            contacts += (contacts.empty() ? "" : ", ") + std::string(material_sound_name(entry.material));
        }
    }
    contacts.replace(contacts.rfind(", "), 2, " or ");
    expected.push_back("- Contact with a material: " + contacts + ".");
    EXPECT_EQ(list_items("dictionary.md", "## Sounds"), expected);
}

}  // namespace user_guide_test
}  // namespace handrail
