#include "worlds/base/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <ctime>

#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"

namespace handrail {
namespace files_test {
namespace fs = std::filesystem;
using test::content_of;
using test::TemporaryFolder;
using testing::HasSubstr;

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST(ReadWholeFile, returns_every_byte_unchanged) {
    const TemporaryFolder folder;
    const std::string bytes("a\0\r\n\xff", 5);
    EXPECT_EQ(read_whole_file(folder.write("some", bytes)).value(), bytes);
    EXPECT_EQ(read_whole_file(folder.write("empty", "")).value(), "");
    const std::string big(300'001, 'x');
    EXPECT_EQ(read_whole_file(folder.write("big", big)).value(), big);
}

TEST(MapFile, returns_the_same_bytes_and_refuses_the_same_files_as_reading) {
    const TemporaryFolder folder;
    const std::string bytes = "a\0\r\n" + std::string(300'001, '\xff');
    const fs::path some = folder.write("some", bytes);
    const auto mapped_of = [](const fs::path& path, std::size_t most = 1'000'000) -> Result<MappedFile> {
        const Result<OpenFile> file = open_file(path);
        return file ? map_file(*file, most) : tl::unexpected(file.error());
    };
    EXPECT_EQ(mapped_of(some).value().bytes(), bytes);
    EXPECT_EQ(mapped_of(folder.write("empty", "")).value().bytes(), "");
    MappedFile first = std::move(mapped_of(some).value());
    const MappedFile second = std::move(first);
    EXPECT_EQ(second.bytes(), bytes) << "it is taken on whole";
    for (const fs::path& path : {folder.path() / "none.map", folder.path(), fs::path("/dev/zero")}) {
        const auto mapped = mapped_of(path);
        ASSERT_FALSE(mapped.has_value()) << path;
        EXPECT_EQ(mapped.error().sentence(), read_whole_file(path).error().sentence());
    }
    const fs::path is_long = folder.write("long", std::string(6, 'x'));
    EXPECT_EQ(mapped_of(is_long, 5).error().sentence(), read_whole_file(is_long, 5).error().sentence());
    EXPECT_TRUE(mapped_of(is_long, 6).has_value());
}

TEST(ReadWholeFile, names_the_file_and_the_reason_for_a_failure) {
    const TemporaryFolder folder;
    EXPECT_THAT(read_whole_file(folder.path() / "none.map").error().sentence(),
                testing::StartsWith("none.map: This file cannot be opened: No such file"));
    EXPECT_THAT(read_whole_file(folder.path()).error().message, HasSubstr("folder"));
    EXPECT_EQ(read_whole_file(folder.write("long", std::string(5, 'x')), 5).value().size(), 5U);
    EXPECT_THAT(read_whole_file(folder.write("long", std::string(6, 'x')), 5).error().message, HasSubstr("larger"));
}

// Opening a pipe without a writer would block, and reading a device would never end.
TEST(ReadWholeFile, opens_only_ordinary_files_and_never_blocks) {
    const TemporaryFolder folder;
    const fs::path fifo = folder.path() / "fifo.map";
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    const fs::path socket = folder.path() / "socket.map";
    const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::snprintf(address.sun_path, sizeof address.sun_path, "%s", socket.c_str());
    ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    fs::create_symlink(fifo, folder.path() / "link.map");
    for (const fs::path& path :
         {fifo, socket, folder.path() / "link.map", fs::path("/dev/zero"), fs::path("/dev/null")}) {
        const auto content = read_whole_file(path);
        ASSERT_FALSE(content) << path;
        EXPECT_THAT(content.error().sentence(), HasSubstr("not an ordinary file")) << path;
        const auto saved = write_named_file_atomically(path, "x");
        ASSERT_FALSE(saved) << path;
        EXPECT_THAT(saved.error().sentence(), HasSubstr("not an ordinary file")) << path;
    }
    EXPECT_TRUE(fs::is_fifo(fifo)) << "and it is still one";
    ::close(listener);
}

TEST(ReadWholeFile, can_be_cancelled_at_any_point) {
    const TemporaryFolder folder;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(read_whole_file(folder.write("some", "bytes"), 100, stop.get_token()));
}

// Interrupts the writing thread with a signal again and again. The signal's handler does nothing, and the kernel does
// not restart interrupted calls.
TEST(WriteFileAtomically, does_not_treat_an_interruption_as_an_error) {
    struct sigaction action {
    }, before{};
    action.sa_handler = [](int) {};
    ASSERT_EQ(::sigaction(SIGALRM, &action, &before), 0);
    const itimerval often{{0, 200}, {0, 200}}, never{};
    ASSERT_EQ(::setitimer(ITIMER_REAL, &often, nullptr), 0);
    const TemporaryFolder folder;
    const std::string big(4'000'000, 'x');
    for (int i = 0; i < 20; ++i) {
        const auto written = write_file_atomically(folder.path() / "big", big);
        EXPECT_TRUE(written) << written.error().sentence();
        const auto read = read_whole_file(folder.path() / "big");
        EXPECT_TRUE(read && *read == big);
    }
    ::setitimer(ITIMER_REAL, &never, nullptr);
    ::sigaction(SIGALRM, &before, nullptr);
}

TEST(WriteFileAtomically, removes_temporary_files_of_a_program_that_was_killed_while_writing) {
    const TemporaryFolder folder;
    const auto made = [&](const char* name, int seconds_ago) {
        const fs::path file = folder.write(name, "half");
        const timespec then{::time(nullptr) - seconds_ago, 0};
        const timespec times[2]{then, then};
        ::utimensat(AT_FDCWD, file.c_str(), times, 0);
        return file;
    };
    const fs::path stale = made("file.new-AbC123", 3600), young = made("file.new-Zyx987", 0),
                   busy = made("file.new-Busy00", 3600);
    const fs::path others = made("other.new-AbC123", 3600), longer = made("file.new-AbC1234", 3600);
    const int held = ::open(busy.c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(::flock(held, LOCK_EX), 0);
    ASSERT_TRUE(write_file_atomically(folder.path() / "file", "new"));
    EXPECT_FALSE(fs::exists(stale));
    for (const fs::path& file : {young, busy, others, longer}) EXPECT_TRUE(fs::exists(file)) << file;
    ::close(held);
    ASSERT_TRUE(write_file_atomically(folder.path() / "file", "newer"));
    EXPECT_FALSE(fs::exists(busy)) << "whoever held it is gone";
    EXPECT_EQ(content_of(folder.path() / "file"), "newer");
}

TEST(WriteFileAtomically, replaces_the_whole_file_and_leaves_no_temporary_file) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "a much longer old text");
    ASSERT_TRUE(write_file_atomically(file, "new"));
    EXPECT_EQ(content_of(file), "new");
    ASSERT_TRUE(write_file_atomically(file, ""));
    EXPECT_EQ(content_of(file), "");
    EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(WriteFileAtomically, creates_missing_folders) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_file_atomically(folder.path() / "a" / "b" / "file", "x"));
    EXPECT_EQ(content_of(folder.path() / "a" / "b" / "file"), "x");
    const Result<void> through_a_file = write_file_atomically(folder.path() / "a" / "b" / "file" / "below", "x");
    EXPECT_THAT(through_a_file.error().sentence(), HasSubstr("could not be saved"));
}

TEST(WriteFileAtomically, keeps_permission_bits_and_gives_new_files_the_usual_ones) {
    const TemporaryFolder folder;
    const fs::path secret = folder.write("secret", "old");
    fs::permissions(secret, fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_TRUE(write_file_atomically(secret, "new"));
    EXPECT_EQ(fs::status(secret).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_TRUE(write_file_atomically(folder.path() / "fresh", "new"));
    EXPECT_EQ(fs::status(folder.path() / "fresh").permissions() & fs::perms::owner_all,
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST(WriteNamedFileAtomically, follows_a_symbolic_link_and_keeps_it_a_link) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "real");
    const fs::path target = folder.write("real/file", "old");
    fs::create_symlink("real/file", folder.path() / "link");
    fs::create_symlink("link", folder.path() / "link-to-link");
    ASSERT_TRUE(write_named_file_atomically(folder.path() / "link-to-link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link-to-link"));
    EXPECT_EQ(content_of(target), "new");
    fs::create_symlink("real/later", folder.path() / "dangling");
    ASSERT_TRUE(write_named_file_atomically(folder.path() / "dangling", "made"));
    EXPECT_EQ(content_of(folder.path() / "real" / "later"), "made");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "dangling"));
    fs::create_symlink("circle", folder.path() / "circle");
    EXPECT_FALSE(write_named_file_atomically(folder.path() / "circle", "x"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "circle"));
}

// In a folder that another user controls, such a link may lead to any file of the person who runs the program.
TEST(WriteFileAtomically, refuses_a_symbolic_link_and_does_not_change_it_or_its_target) {
    const TemporaryFolder folder;
    const fs::path target = folder.write("diary", "mine");
    fs::create_symlink("diary", folder.path() / "link");
    fs::create_symlink("later", folder.path() / "dangling");
    for (const auto write : {write_file_atomically, write_private_file_atomically})
        for (const char* name : {"link", "dangling"}) {
            const Result<void> written = write(folder.path() / name, "new");
            ASSERT_FALSE(written) << name;
            EXPECT_THAT(written.error().sentence(), testing::StartsWith(std::string(name) + ": This is a link"));
            EXPECT_TRUE(fs::is_symlink(folder.path() / name));
        }
    EXPECT_EQ(content_of(target), "mine");
    EXPECT_FALSE(fs::exists(folder.path() / "later"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 3) << "nothing else";
}

TEST(WritePrivateFileAtomically, makes_new_files_readable_only_by_the_person) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_private_file_atomically(folder.path() / "fresh", "new"));
    EXPECT_EQ(fs::status(folder.path() / "fresh").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

// Runs in a child process without root rights, because root may write anywhere.
TEST(WriteFileAtomically, keeps_the_old_file_and_reports_an_error_if_the_folder_is_read_only) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "old");
    ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(3);
        const Result<void> written = write_file_atomically(file, "new");
        ::_exit(written ? 1 : written.error().message.find("Permission denied") == std::string::npos ? 2 : 0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0) << "1: written all the same, 2: another reason, 3: root could not step down";
    EXPECT_EQ(content_of(file), "old");
    EXPECT_EQ(files_in(folder.path()), 1U);
}

}  // namespace files_test
}  // namespace handrail
