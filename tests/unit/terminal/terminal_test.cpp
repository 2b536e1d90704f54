#include "app/terminal/terminal.h"

#include <unistd.h>

#include <future>

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

// Seen by its own thread, with nobody taking lines: what must not wait does not.
TEST(LineWatch, a_line_that_must_not_wait_is_seen_at_once_and_empties_what_came_before) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        std::promise<std::string> seen;
        LineWatch watch(ends[0], [&](std::string_view line) {
            if (line != "stop") return false;
            seen.set_value(std::string(line));
            return true;
        });
        ASSERT_EQ(::write(ends[1], "forward 9\nstop\n", 15), 15);
        EXPECT_EQ(seen.get_future().get(), "stop");
        ASSERT_EQ(::write(ends[1], "where\n", 6), 6);
        std::vector<std::string> lines;
        bool emptied = false;
        while (lines.empty() || lines.back() != "where") {
            bool now = false;
            for (std::string& line : watch.take(now)) lines.push_back(std::move(line));
            emptied = emptied || now;
        }
        EXPECT_TRUE(emptied);
        EXPECT_EQ(lines, std::vector<std::string>{"where"});
        EXPECT_FALSE(watch.ended());
        ::close(ends[1]);
        while (!watch.ended()) {
        }
    }
    ::close(ends[0]);
}

TEST(LineWatch, ends_while_it_waits) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        LineWatch watch(ends[0], [](std::string_view) { return false; });
    }
    ::close(ends[0]);
    ::close(ends[1]);
}

}  // namespace
}  // namespace handrail
