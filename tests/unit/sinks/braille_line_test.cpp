#include "audio-cues/sinks/braille_line.h"
#include "tests/support/names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace handrail {
namespace braille_line_test {

constexpr double kDegree = std::numbers::pi / 180.0;

std::string narrow(const std::u32string& cells) { return {cells.begin(), cells.end()}; }

TEST(HeadingCells, show_a_direction_or_degrees_in_at_most_three_cells) {
    EXPECT_EQ(heading_cells(0.0), "N");
    EXPECT_EQ(heading_cells(45.0 * kDegree), "NE");
    EXPECT_EQ(heading_cells(-90.0 * kDegree), "W");
    EXPECT_EQ(heading_cells(22.5 * kDegree), "23");
    EXPECT_EQ(heading_cells(359.7 * kDegree), "N");
    for (int degrees = -800; degrees <= 800; ++degrees)
        EXPECT_LE(heading_cells(degrees * kDegree).size(), 3U) << degrees;
}

TEST(BrailleLine, begins_with_the_heading_and_fills_every_cell) {
    BrailleLine line;
    line.set_width(20);
    line.set_heading("NE");
    line.show("North wall");
    EXPECT_EQ(narrow(line.cells()), "NE North wall       ");
    line.set_heading("225");
    EXPECT_EQ(narrow(line.cells()), "225North wall       ");
}

TEST(BrailleLine, on_a_narrow_display_shows_only_the_message) {
    BrailleLine line;
    line.set_width(8);
    line.set_heading("N");
    line.show("North wall");
    EXPECT_EQ(narrow(line.cells()), "North   ");
    EXPECT_TRUE(line.pan_right());
    EXPECT_EQ(narrow(line.cells()), "wall    ");
}

TEST(BrailleLine, counts_letters_rather_than_bytes) {
    BrailleLine line;
    line.set_width(12);
    line.set_heading("S");
    line.show("T\xC3\xBCr zu \xE2\x82\xAC");
    EXPECT_EQ(line.cells(), U"S  T\u00FCr zu \u20AC ");
}

TEST(BrailleLine, of_a_list_shows_the_item_with_its_position_and_pans_to_its_neighbours) {
    BrailleLine line;
    line.set_width(20);
    line.set_heading("N");
    line.show_list("Menu. ", {"What can be done", "Worlds", "Settings"}, 1);
    EXPECT_EQ(narrow(line.cells()), "N  Menu. Worlds 2/3 ");
    EXPECT_TRUE(line.pan_right());
    EXPECT_EQ(narrow(line.cells()), "N  Settings 3/3     ");
    EXPECT_FALSE(line.pan_right());
    line.pan_home();
    EXPECT_EQ(narrow(line.cells()), "N  Menu. Worlds 2/3 ");
    // If the person pans left to an item that is longer than the display, the display must first show the end of the
    // item.
    EXPECT_TRUE(line.pan_left());
    EXPECT_EQ(narrow(line.cells()), "N  1/3              ");
    EXPECT_TRUE(line.pan_left());
    EXPECT_EQ(narrow(line.cells()), "N  What can be done ");
    EXPECT_FALSE(line.pan_left());
    line.show("Left");
    EXPECT_EQ(narrow(line.cells()), "N  Left             ");
    EXPECT_FALSE(line.pan_left() || line.pan_right()) << "of the list nothing is left";
}

TEST(BrailleLine, starts_each_new_message_at_its_first_word) {
    BrailleLine line;
    line.set_width(12);
    line.set_heading("N");
    line.show("one two three four five");
    ASSERT_TRUE(line.pan_right());
    line.show("six seven");
    EXPECT_EQ(narrow(line.cells()), "N  six seven");
}

TEST(BrailleLine, has_no_cells_without_a_display) {
    BrailleLine line;
    line.show("one");
    EXPECT_TRUE(line.cells().empty());
    EXPECT_FALSE(line.pan_right());
    EXPECT_FALSE(line.pan_left());
}

// Panning right to the end must show every letter once and in order. Panning left must show the same pieces in reverse.
TEST(BrailleLine, panning_loses_and_repeats_nothing) {
    std::mt19937 random(5);
    for (int run = 0; run < 500; ++run) {
        std::string message;
        for (int i = std::uniform_int_distribution(0, 200)(random); i > 0; --i)
            message += std::uniform_int_distribution(0, 5)(random) == 0 ? ' ' : 'a';
        const std::size_t width = std::uniform_int_distribution<std::size_t>(1, 40)(random);
        const std::size_t heading = width >= BrailleLine::kLeastForHeading ? BrailleLine::kHeadingCells : 0;
        BrailleLine line;
        line.set_width(width);
        line.show(message);
        std::vector<std::string> pieces;
        do {
            ASSERT_EQ(line.cells().size(), width);
            pieces.push_back(narrow(line.cells()).substr(heading));
        } while (line.pan_right());
        const auto without_blanks = [](std::string text) {
            std::erase(text, ' ');
            return text;
        };
        std::string read;
        for (const std::string& piece : pieces) read += piece;
        EXPECT_EQ(without_blanks(read), without_blanks(message));
        for (std::size_t i = pieces.size(); i-- > 0;) {
            EXPECT_EQ(narrow(line.cells()).substr(heading), pieces[i]);
            EXPECT_EQ(line.pan_left(), i > 0);
        }
    }
}

}  // namespace braille_line_test
}  // namespace handrail
