// Tests how text becomes braille cells, lines and BRF.
#include "worlds/exports/braille.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

namespace handrail::test {
namespace braille_test {

std::string brf(std::string_view text, BrailleTable table) {
    const Result<BrailleCells> cells = braille_of(text, table);
    EXPECT_TRUE(cells) << cells.error().sentence();
    return cells ? brf_of(*cells) : std::string();
}

TEST(Braille, spells_in_grade_1_and_contracts_in_grade_2) {
    EXPECT_EQ(brf("kitchen", BrailleTable::EnUebG1), "KITCHEN");
    EXPECT_EQ(brf("kitchen", BrailleTable::EnUebG2), "KIT*5") << "ch and en are one cell each";
    EXPECT_EQ(brf("Room 12", BrailleTable::EnUebG1), ",ROOM #AB");
    EXPECT_EQ(brf("buch", BrailleTable::DeG1).size(), 3U) << "German grade 1 has one cell for ch";
    EXPECT_EQ(brf("und", BrailleTable::DeG2).size(), 1U);
    EXPECT_EQ(brf("Küche", BrailleTable::DeG1).size(), brf("Kuche", BrailleTable::DeG1).size());
}

TEST(Braille, for_signs_has_a_cell_for_each_letter_in_every_table) {
    for (const std::string_view word : {"en-ueb-g1", "en-ueb-g2", "de-g1", "de-g2"}) {
        const auto table = braille_table_named(word);
        ASSERT_TRUE(table) << word;
        for (const std::string_view sign : {"ch", "st", "en", "au", "th"}) {
            const Result<BrailleCells> cells = braille_signs(sign, *table);
            ASSERT_TRUE(cells);
            EXPECT_EQ(cells->size(), 2U) << word << " " << sign;
        }
    }
    EXPECT_FALSE(braille_table_named("en-g3"));
    EXPECT_EQ(braille_table_of("de"), BrailleTable::DeG1);
    EXPECT_EQ(braille_table_of("fr"), BrailleTable::EnUebG1);
}

TEST(Braille, accepts_any_bytes) {
    for (const std::string_view text : {"", "\xFF\xFE", "a\xC3", "\xF0\x9F\x98\x80", "\xE2\x82"})
        EXPECT_TRUE(braille_of(text, BrailleTable::EnUebG2)) << text;
    EXPECT_TRUE(braille_of(std::string(5000, 'X'), BrailleTable::DeG2)->size() >= 5000U);
}

TEST(BrailleLines, break_at_blanks_and_indent_continuation_lines) {
    const auto lines = [](std::string_view text, std::size_t width, std::size_t indent) {
        std::string all;
        for (const BrailleCells& line : braille_lines(*braille_of(text, BrailleTable::EnUebG1), width, indent))
            all += brf_of(line) + "|";
        return all;
    };
    EXPECT_EQ(lines("one two three", 7, 2), "ONE TWO|  THREE|");
    EXPECT_EQ(lines("one  two", 8, 0), "ONE  TWO|");
    EXPECT_EQ(lines("abcdefghij", 4, 1), "ABCD| EFG| HIJ|");
    EXPECT_EQ(lines("", 10, 2), "|");
}

}  // namespace braille_test
}  // namespace handrail::test
