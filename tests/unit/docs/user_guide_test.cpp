#include "app/core/dialogue/command.h"
#include "audio-cues/plan/sound_table.h"
#include "tests/unit/docs/table_rows.h"

namespace handrail {
namespace user_guide_test {
using test::table_rows;
using testing::UnorderedElementsAreArray;

TEST(UserGuide, lists_every_command_with_its_keys_and_nothing_else) {
    std::vector<std::string> expected;
    for (const CommandInfo& command : command_table()) {
        std::string keys(command.key);
        for (std::size_t at = keys.find(' '); at != std::string::npos; at = keys.find(' ', at + 4))
            keys.replace(at, 1, " or ");
        expected.push_back(fmt::format("| {} | {} | {} |", command.word, keys, command.help()));
    }
    EXPECT_THAT(table_rows("user-guide.md", "| Command | Keys |"), UnorderedElementsAreArray(expected));
}

TEST(Dictionary, lists_every_sound_as_the_spoken_one_tells_it_in_its_order) {
    std::vector<std::string> expected;
    for (const DictionaryEntry& entry : sound_dictionary())
        expected.push_back(fmt::format("| `{}` | {} |", info(entry.kind).name, entry.text));
    EXPECT_EQ(table_rows("dictionary.md", "| Name | What it tells |"), expected);
}

}  // namespace user_guide_test
}  // namespace handrail
