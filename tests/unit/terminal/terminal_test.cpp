#include "app/terminal/terminal.h"

#include <unistd.h>

namespace handrail {
namespace {

TEST(ParseTerminalLine, takes_every_command_of_the_table_with_an_optional_count) {
    for (const CommandInfo& row : command_table()) {
        const auto line = parse_terminal_line(std::string(row.word) + " 3\r");
        ASSERT_TRUE(line) << row.word;
        EXPECT_EQ(line->command, row.command);
        EXPECT_EQ(line->times, 3);
    }
    EXPECT_TRUE(parse_terminal_line("QUIT")->leave);
    EXPECT_FALSE(parse_terminal_line("  ")->command);
}

TEST(ParseTerminalLine, names_the_nearest_command_for_an_unknown_word) {
    const auto line = parse_terminal_line("wheer");
    ASSERT_FALSE(line);
    EXPECT_THAT(line.error().message, testing::HasSubstr("Did you mean \"where\"?"));
}

TEST(ParseTerminalLine, refuses_counts_that_make_no_sense) {
    for (const char* bad : {"forward 0", "forward -1", "forward 1001", "forward many", "forward 2 3", "forward 99999999999999"})
        EXPECT_FALSE(parse_terminal_line(bad)) << bad;
}

TEST(LineInput, never_blocks_and_keeps_the_last_line_without_an_end) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    LineInput input(ends[0]);
    EXPECT_TRUE(input.take().empty());
    ASSERT_EQ(::write(ends[1], "where\nfor", 9), 9);
    EXPECT_EQ(input.take(), std::vector<std::string>{"where"});
    ASSERT_EQ(::write(ends[1], "ward", 4), 4);
    ::close(ends[1]);
    EXPECT_EQ(input.take(), std::vector<std::string>{"forward"});
    EXPECT_TRUE(input.ended());
    ::close(ends[0]);
}

}  // namespace
}  // namespace handrail
