// The instructor's desk: a socket for one person, orders to the lesson, and lines about it.
#include "app/teaching/desk.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <sstream>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace handrail {
namespace desk_test {

TEST(Desk, carries_orders_in_and_lines_out_and_ends_with_the_session) {
    const test::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    const std::filesystem::path path = folder.path() / "desk.sock";
    auto desk = DeskServer::open(path);
    ASSERT_TRUE(desk) << desk.error().sentence();
    struct stat made {};
    ASSERT_EQ(::stat(path.c_str(), &made), 0);
    EXPECT_EQ(made.st_mode & 0077U, 0U);
    (*desk)->tell("Entrance hall. 2 of 9 walls done.");
    std::array<int, 2> typed{};
    ASSERT_EQ(::pipe(typed.data()), 0);
    std::ostringstream out, err;
    int status = -1;
    std::thread watching([&] { status = watch_desk(path, typed[0], out, err); });
    const std::string order = "lead Library\nnote held the rail\n";
    ASSERT_EQ(::write(typed[1], order.data(), order.size()), static_cast<ssize_t>(order.size()));
    std::vector<std::string> orders;
    for (int i = 0; i < 500 && orders.size() < 2; ++i) {
        for (std::string& one : (*desk)->take_orders()) orders.push_back(std::move(one));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    (*desk)->tell("Done.");
    desk->reset();
    watching.join();
    ::close(typed[0]);
    ::close(typed[1]);
    EXPECT_EQ(orders, (std::vector<std::string>{"lead Library", "note held the rail"}));
    EXPECT_EQ(status, 0) << err.str();
    EXPECT_NE(out.str().find("2 of 9 walls"), std::string::npos) << out.str();
    EXPECT_NE(out.str().find("Done."), std::string::npos) << out.str();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Desk, is_one_at_a_time_takes_the_place_of_one_left_behind_and_is_private) {
    const test::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    const std::filesystem::path path = folder.path() / "desk.sock";
    folder.write("desk.sock", "left behind");
    auto first = DeskServer::open(path);
    ASSERT_TRUE(first) << first.error().sentence();
    EXPECT_FALSE(DeskServer::open(path));
    first->reset();
    std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
    EXPECT_FALSE(DeskServer::open(path));
    std::ostringstream out, err;
    EXPECT_EQ(watch_desk(folder.path() / "none.sock", STDIN_FILENO, out, err), 1);
    EXPECT_FALSE(err.str().empty());
}

}  // namespace desk_test
}  // namespace handrail
