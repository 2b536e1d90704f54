#include "app/terminal/line_watch.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <future>

#include "app/core/dialogue/terminal_line.h"
#include "tests/support/child_process.h"
#include "tests/support/names.h"

namespace handrail {
namespace terminal_test {

TEST(ParseTerminalLine, accepts_every_command_of_the_table_with_an_optional_count_or_list_choice) {
    int choose = 0;
    for (const CommandInfo& row : command_table()) {
        const auto line = parse_terminal_line(std::string(row.word) + " 3\r");
        ASSERT_TRUE(line) << row.word;
        EXPECT_EQ(line->command, row.command);
        choose += !line->choice.empty();
        if (line->choice.empty()) EXPECT_EQ(line->times, 3) << row.word;
        else EXPECT_EQ(line->choice, "3") << row.word;
    }
    EXPECT_EQ(choose, 10) << "describe, storeys, routes, find, places, presets, ways, rooms learnt, learners, label";
    EXPECT_TRUE(parse_terminal_line("QUIT")->leave);
    EXPECT_FALSE(parse_terminal_line("  ")->command);
}

TEST(ParseTerminalLine, suggests_the_nearest_command_for_an_unknown_word) {
    const auto line = parse_terminal_line("wheer");
    ASSERT_FALSE(line);
    EXPECT_THAT(line.error().message, testing::HasSubstr("Did you mean \"where\"?"));
}

TEST(ParseTerminalLine, exits_immediately_only_on_quit_and_never_suggests_it) {
    EXPECT_EQ(parse_terminal_line("exit")->command, Command::Leave) << "which asks first";
    EXPECT_FALSE(parse_terminal_line("exit")->leave);
    for (const char* nearly : {"quti", "qit", "quitt", "exti", "q", "quis"}) {
        const auto line = parse_terminal_line(nearly);
        ASSERT_FALSE(line) << nearly;
        EXPECT_EQ(line.error().message.find("\"quit\""), std::string::npos) << line.error().message;
        EXPECT_EQ(line.error().message.find("\"exit\""), std::string::npos) << line.error().message;
    }
}

TEST(ParseTerminalLine, refuses_impossible_counts) {
    for (const char* bad :
         {"forward 0", "forward -1", "forward 1001", "forward many", "forward 2 3", "forward 99999999999999"})
        EXPECT_FALSE(parse_terminal_line(bad)) << bad;
}

TEST(LineInput, never_blocks_and_keeps_a_last_line_without_a_line_break) {
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

// The thread of LineWatch must recognise an urgent line, although nobody calls take().
TEST(LineWatch, recognises_an_urgent_line_at_once_and_drops_the_lines_before_it) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        std::promise<std::string> seen;
        LineWatch watch(ends[0], LineWatch::WhenFull::Waits, [&](std::string_view line) {
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

// Writes as many lines as the pipe accepts while nobody calls take(). Returns the number of bytes.
std::size_t bytes_taken(int end) {
    const std::string lines = [] {
        std::string text;
        while (text.size() < 4096 - 8) text += "forward\n";
        return text;
    }();
    ::fcntl(end, F_SETFL, O_NONBLOCK);
    std::size_t taken = 0;
    for (int refused = 0; refused < 50 && taken < (std::size_t{64} << 20);) {
        const ssize_t put = ::write(end, lines.data(), lines.size());
        if (put > 0) {
            taken += static_cast<std::size_t>(put);
            refused = 0;
        } else {
            ++refused;
            ::poll(nullptr, 0, 2);
        }
    }
    return taken;
}

TEST(LineWatch, limits_memory_during_a_flood_of_piped_lines_and_loses_none) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        LineWatch watch(ends[0], LineWatch::WhenFull::Waits, [](std::string_view) { return false; });
        const std::size_t bytes = bytes_taken(ends[1]);
        EXPECT_LT(bytes, std::size_t{1} << 18) << "the pipe's 64 KiB and what waits";
        EXPECT_GE(bytes, 8 * LineWatch::kMostWaiting);
        ::close(ends[1]);
        std::size_t lines = 0;
        bool emptied = false;
        for (bool ended = false; !ended;) {
            ended = watch.ended();
            const auto some = watch.take(emptied, 100);
            EXPECT_LE(some.size(), 100U);
            for (const std::string& line : some) lines += line == "forward";
            if (!some.empty()) ended = false;
        }
        EXPECT_EQ(lines, bytes / 8);
    }
    ::close(ends[0]);
}

TEST(LineWatch, drops_lines_during_a_flood_of_typed_lines_but_still_recognises_the_urgent_one) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        std::promise<void> seen;
        LineWatch watch(ends[0], LineWatch::WhenFull::Loses, [&](std::string_view line) {
            if (line != "stop") return false;
            seen.set_value();
            return true;
        });
        const std::string flood = [] {
            std::string text;
            for (int i = 0; i < 100'000; ++i) text += "forward\n";
            return text;
        }();
        for (std::size_t done = 0; done < flood.size();)
            done += static_cast<std::size_t>(::write(ends[1], flood.data() + done, flood.size() - done));
        bool emptied = false;
        ASSERT_EQ(::write(ends[1], "stop\n", 5), 5);
        EXPECT_EQ(seen.get_future().wait_for(std::chrono::duration<double>(test::kPatience_s)),
                  std::future_status::ready);
        EXPECT_TRUE(watch.take(emptied).empty());
        EXPECT_TRUE(emptied);
        ::close(ends[1]);
    }
    ::close(ends[0]);
}

TEST(LineWatch, can_be_stopped_while_it_waits) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        LineWatch watch(ends[0], LineWatch::WhenFull::Waits, [](std::string_view) { return false; });
    }
    ::close(ends[0]);
    ::close(ends[1]);
}

}  // namespace terminal_test
}  // namespace handrail
