#include "app/terminal/terminal_keys.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <future>

#include "tests/support/child_process.h"
#include "tests/support/names.h"

namespace handrail {
namespace terminal_keys_test {

struct Keyboard {
    int ends[2] = {-1, -1};
    SteadyClock clock;
    Keyboard() { EXPECT_EQ(::pipe(ends), 0); }
    ~Keyboard() {
        ::close(ends[0]);
        if (ends[1] >= 0) ::close(ends[1]);
    }
    void type(const std::string& bytes) const {
        EXPECT_EQ(::write(ends[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
};

std::vector<std::string> names(TerminalKeys& keys, std::size_t count) {
    std::vector<std::string> all;
    EXPECT_TRUE(test::eventually([&] {
        bool emptied = false;
        for (const TimedInput& one : keys.take(emptied)) all.push_back(one.input.key);
        return all.size() >= count;
    }));
    return all;
}

TEST(TerminalKeys, arrive_in_order_and_an_escape_after_its_waiting_time) {
    Keyboard board;
    TerminalKeys keys(board.ends[0], {}, board.clock, [](const std::string&) { return false; });
    board.type("\x1b[A");
    EXPECT_EQ(names(keys, 1), std::vector<std::string>{"Up"});
    const double typed_s = board.clock.now_s();
    board.type("\x1b");
    EXPECT_EQ(names(keys, 1), std::vector<std::string>{"Escape"});
    EXPECT_GE(board.clock.now_s() - typed_s, 0.9 * TerminalKeys::kEscapeAlone_s);
    EXPECT_FALSE(keys.ended());
    ::close(std::exchange(board.ends[1], -1));
    EXPECT_TRUE(test::eventually([&] { return keys.ended(); }));
}

// The thread of TerminalKeys must recognise an urgent key, although nobody calls take().
TEST(TerminalKeys, an_urgent_key_is_recognised_at_once_behind_a_flood_and_drops_earlier_ones) {
    Keyboard board;
    std::promise<void> seen;
    TerminalKeys keys(board.ends[0], {}, board.clock, [&](const std::string& key) {
        if (key != "F12") return false;
        seen.set_value();
        return true;
    });
    std::string flood;
    for (int i = 0; i < 50'000; ++i) flood += "\x1b[A";
    for (std::size_t done = 0; done < flood.size();)
        done += static_cast<std::size_t>(::write(board.ends[1], flood.data() + done, flood.size() - done));
    board.type("\x1b[24~");
    ASSERT_EQ(seen.get_future().wait_for(std::chrono::duration<double>(test::kPatience_s)), std::future_status::ready);
    bool emptied = false;
    EXPECT_THAT(keys.take(emptied), testing::IsEmpty());
    EXPECT_TRUE(emptied);
}

}  // namespace terminal_keys_test
}  // namespace handrail
