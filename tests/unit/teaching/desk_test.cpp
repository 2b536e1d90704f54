// Tests the instructor's desk: a socket for one person, commands to the lesson, and reports about the lesson.
#include "app/teaching/desk.h"
#include "tests/support/child_process.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <latch>
#include <sstream>
#include <thread>

#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace desk_test {

TEST(Desk, accepts_commands_shows_lines_and_ends_with_the_session) {
    const test::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    auto desk = DeskServer::open(folder.path(), "Three rooms. Learner: Oak Owl.");
    ASSERT_TRUE(desk) << desk.error().sentence();
    const std::filesystem::path path = folder.path() / fmt::format("{}.sock", ::getpid());
    struct stat made {};
    ASSERT_EQ(::stat(path.c_str(), &made), 0);
    EXPECT_EQ(made.st_mode & 0077U, 0U);
    (*desk)->send("Entrance hall. 2 of 9 walls done.");
    std::array<int, 2> typed{};
    ASSERT_EQ(::pipe(typed.data()), 0);
    std::ostringstream out, err;
    int status = -1;
    std::thread watching([&] { status = watch_desk(folder.path(), typed[0], out, err); });
    const std::string order = "lead Library\nnote held the rail\n";
    ASSERT_EQ(::write(typed[1], order.data(), order.size()), static_cast<ssize_t>(order.size()));
    std::vector<std::string> orders;
    test::eventually([&] {
        for (std::string& one : (*desk)->take_orders()) orders.push_back(std::move(one));
        return orders.size() >= 2;
    });
    (*desk)->send("Done.");
    desk->reset();
    watching.join();
    ::close(typed[0]);
    ::close(typed[1]);
    EXPECT_EQ(orders, (std::vector<std::string>{"lead Library", "note held the rail"}));
    EXPECT_EQ(status, 0) << err.str();
    EXPECT_NE(out.str().find("2 of 9 walls"), std::string::npos) << out.str();
    EXPECT_NE(out.str().find("Done."), std::string::npos) << out.str();
    EXPECT_TRUE(out.str().starts_with("Three rooms. Learner: Oak Owl.\n")) << out.str();
    EXPECT_TRUE(out.str().ends_with("The lesson has ended.\n")) << out.str();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Desk, replaces_a_stale_desk_socket_and_is_private) {
    const test::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    folder.write(fmt::format("{}.sock", ::getpid()), "left behind");
    auto first = DeskServer::open(folder.path(), "Lesson");
    ASSERT_TRUE(first) << first.error().sentence();
    first->reset();
    std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
    EXPECT_FALSE(DeskServer::open(folder.path(), "Lesson"));
    std::ostringstream out, err;
    EXPECT_EQ(watch_desk(folder.path() / "none", STDIN_FILENO, out, err), 1);
    EXPECT_FALSE(err.str().empty());
}

// Stands for the desk of another process: a socket in the folder. The desk sends its title and records what it
// receives.
class OtherDesk {
public:
    OtherDesk(const std::filesystem::path& file, const std::string& title)
        : listening_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)), serving_([this, title] { serve(title); }) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(static_cast<char*>(address.sun_path), file.c_str(), sizeof address.sun_path - 1);
        EXPECT_EQ(::bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
        EXPECT_EQ(::listen(listening_, 4), 0);
        ready_.count_down();
    }
    ~OtherDesk() {
        if (serving_.joinable()) serving_.join();
        ::close(listening_);
    }
    // Waits until the other side has disconnected, and returns everything that the other side sent. A test may call
    // this only once.
    const std::string& received() {
        serving_.join();
        return received_;
    }

private:
    void serve(const std::string& title) {
        ready_.wait();
        const int come = ::accept(listening_, nullptr, nullptr);
        EXPECT_EQ(::send(come, title.data(), title.size(), 0), static_cast<ssize_t>(title.size()));
        char byte = 0;
        while (::recv(come, &byte, 1, 0) == 1 && byte != '\n') received_ += byte;
        ::close(come);
    }
    std::latch ready_{1};
    int listening_;
    std::string received_;
    std::thread serving_;
};

TEST(Desk, lessons_can_be_chosen_by_number) {
    const test::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    std::array<int, 2> typed{};
    ASSERT_EQ(::pipe(typed.data()), 0);
    std::ostringstream out, err;
    std::string first_received, second_received;
    {
        OtherDesk first(folder.path() / "1.sock", "Lesson in school\n"),
            second(folder.path() / "2.sock", "Lesson at home\n");
        const std::string lines = "the second\n2\nnext\n";
        ASSERT_EQ(::write(typed[1], lines.data(), lines.size()), static_cast<ssize_t>(lines.size()));
        EXPECT_EQ(watch_desk(folder.path(), typed[0], out, err), 0) << err.str();
        ::close(typed[1]);
        first_received = first.received();
        second_received = second.received();
    }
    ::close(typed[0]);
    EXPECT_EQ(second_received, "next") << out.str();
    EXPECT_EQ(first_received, "");
    EXPECT_TRUE(out.str().starts_with("2 lessons are under way.")) << out.str();
    EXPECT_NE(out.str().find("1. Lesson in school\n2. Lesson at home\n"), std::string::npos) << out.str();
}

}  // namespace desk_test
}  // namespace handrail
