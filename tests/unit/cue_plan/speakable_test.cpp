#include "audio-cues/plan/speakable.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

namespace handrail {
namespace speakable_test {

TEST(Speakable, leaves_clean_text_unchanged) {
    for (const char* text : {"", "north wall, plaster", "Café", "東京", "🚪 door"}) EXPECT_EQ(speakable(text), text);
}

TEST(Speakable, joins_several_lines_into_one) {
    EXPECT_EQ(speakable("  You need\r\nthe\tgold \n\n key\x7f "), "You need the gold key");
    EXPECT_EQ(speakable(std::string_view("a\0b", 3)), "a b");
    EXPECT_EQ(speakable("bell\x1b[2J"), "bell [2J");  // the text keeps no escape sequence for a terminal
    EXPECT_EQ(speakable("next\xc2\x85line"), "next line");
}

TEST(Speakable, reads_invalid_utf8_as_latin_1) {
    EXPECT_EQ(speakable("Caf\xe9"), "Café");
    EXPECT_EQ(speakable("\xc0\xaf"), "À¯");  // an overlong encoding of a slash must not become a slash
    // Truncated sequence: 9d is a control character in Latin-1, so it is dropped.
    EXPECT_EQ(speakable("\xe6\x9d"), "æ");
    // A surrogate is not a character, and 80 is a control character.
    EXPECT_EQ(speakable("\xed\xa0\x80x"), "í\u00a0 x");
}

TEST(Speakable, contains_no_direction_controls_and_no_line_separators) {
    EXPECT_EQ(speakable("a\u202eb \u2066c\u2069"), "ab c");
    EXPECT_EQ(speakable("a\u2028b"), "a b");
    EXPECT_EQ(speakable("\u05d0\u200d\u05d1"), "\u05d0\u200d\u05d1") << "joiners are part of a word";
}

TEST(Speakable, gives_valid_utf8_for_every_pair_of_bytes) {
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) {
            const std::string text{static_cast<char>(a), static_cast<char>(b)};
            const std::string once = speakable(text);
            ASSERT_EQ(speakable(once), once) << a << " " << b;
        }
}

TEST(SentenceCase, capitalises_only_the_first_ascii_letter) {
    EXPECT_EQ(sentence_case("north wall"), "North wall");
    EXPECT_EQ(sentence_case("Table"), "Table");
    EXPECT_EQ(sentence_case("écran"), "Écran");
    EXPECT_EQ(sentence_case(""), "");
}

}  // namespace speakable_test
}  // namespace handrail
