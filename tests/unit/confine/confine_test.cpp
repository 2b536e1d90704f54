// Tests that a confined process cannot perform forbidden operations. Each attempt runs in a separate child process,
// because confinement cannot be undone.
#include "worlds/confine/confine.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <linux/netlink.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <numeric>
#include <thread>

#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/descriptor.h"

namespace handrail {
namespace confine_test {

namespace fs = std::filesystem;

struct Ending {
    int status = -1;  // result of the attempt: 0 if it succeeded, else errno
    int signal = 0;
    bool operator==(const Ending&) const = default;
};
void PrintTo(const Ending& ending, std::ostream* out) {
    *out << "status " << ending.status << " (" << std::strerror(ending.status) << "), signal " << ending.signal;
}

constexpr Ending kWentThrough{0, 0}, kRefused{EPERM, 0}, kNotPermitted{EACCES, 0}, kKilled{-1, SIGSYS};

Ending ending_of(const std::function<int()>& attempt) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(attempt());
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) return {-1, WTERMSIG(status)};
    return {WEXITSTATUS(status), 0};
}
Ending confined(const Permissions& permissions, const std::function<int()>& attempt) {
    return ending_of([&] {
        (void)confine::confine(permissions);
        return attempt();
    });
}

int error_of(long result) { return result < 0 ? errno : 0; }
int open_error(const fs::path& path, int flags = O_RDONLY) {
    const Descriptor file(::open(path.c_str(), flags | O_CLOEXEC, 0600));
    return error_of(file.get());
}
int socket_error(int family, int type, int protocol = 0) {
    const Descriptor opened(::socket(family, type | SOCK_CLOEXEC, protocol));
    return error_of(opened.get());
}
int exec_error() {
    char program[] = "/bin/true";
    char* const arguments[] = {program, nullptr};
    return error_of(::execv(program, arguments));
}
int connect_error(std::uint16_t port) {
    const Descriptor opened(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return error_of(::connect(opened.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to));
}

// These tests need a kernel with seccomp and Landlock. Every system for which Handrail is built has such a kernel.
class Confined : public testing::Test {
protected:
    void SetUp() override {
        if (!confinement_offered().seccomp || confinement_offered().landlock == 0)
            GTEST_SKIP() << "this kernel offers no seccomp or no Landlock";
    }
    test::TemporaryFolder folder_;
    fs::path secret_ = folder_.write("secret", "of the person");
};

class Computing : public Confined {};

TEST_F(Computing, receives_the_protection_that_the_kernel_offers) {
    const Confinement offered = confinement_offered();
    EXPECT_EQ(ending_of([&] { return confine::confine({}) == offered ? 0 : 1; }), kWentThrough);
}

TEST_F(Computing, opens_and_creates_no_file) {
    ASSERT_EQ(ending_of([&] { return open_error(secret_); }), kWentThrough);
    const auto refused = testing::AnyOf(kRefused, kNotPermitted);
    EXPECT_THAT(confined({}, [&] { return open_error(secret_); }), refused);
    EXPECT_THAT(confined({}, [] { return open_error("/etc/passwd"); }), refused);
    EXPECT_THAT(confined({}, [&] { return open_error(folder_.path() / "new", O_WRONLY | O_CREAT); }), refused);
    EXPECT_THAT(confined({}, [&] { return error_of(::unlink(secret_.c_str())); }), refused);
    EXPECT_THAT(confined({}, [&] { return error_of(::truncate(secret_.c_str(), 0)); }), refused);
    EXPECT_EQ(test::content_of(secret_), "of the person");
}

TEST_F(Computing, terminates_on_opening_a_socket_or_starting_a_program) {
    EXPECT_EQ(confined({}, [] { return socket_error(AF_UNIX, SOCK_STREAM); }), kKilled);
    EXPECT_EQ(confined({}, [] { return socket_error(AF_INET, SOCK_STREAM); }), kKilled);
    EXPECT_EQ(confined({}, exec_error), kKilled);
}

TEST_F(Computing, reaches_no_other_process) {
    const auto kill_parent = [] { return error_of(::kill(::getppid(), 0)); };
    ASSERT_EQ(ending_of(kill_parent), kWentThrough);
    EXPECT_EQ(confined({}, kill_parent), kRefused);
#if !defined(HANDRAIL_SANITIZED)
    EXPECT_EQ(confined({}, [] { return error_of(::fork()); }), kRefused);
#endif
}

TEST_F(Computing, can_still_use_memory_threads_exceptions_and_open_descriptors) {
    int ends[2] = {-1, -1};
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const Descriptor from(ends[0]), to(ends[1]), open(::open(secret_.c_str(), O_RDONLY | O_CLOEXEC));
    EXPECT_EQ(confined({},
                       [&] {
                           std::vector<double> many(10'000'000, 1.0);
                           double sum = 0.0;
                           std::thread([&] { sum = std::accumulate(many.begin(), many.end(), 0.0); }).join();
                           bool caught = false;
                           try {
                               throw std::runtime_error("caught below");
                           } catch (const std::exception&) {
                               caught = true;
                           }
                           char bytes[64];
                           const ssize_t read = ::read(open.get(), bytes, sizeof bytes);
                           return sum == 1e7 && caught && read == 13 && ::write(to.get(), bytes, 13) == 13 ? 0 : 1;
                       }),
              kWentThrough);
    EXPECT_EQ(confined({},
                       [] {
                           std::abort();
                           return 0;
                       })
                  .signal,
              SIGABRT);
}

class Driving : public Confined {
protected:
    static Permissions nothing() {
        Permissions permissions;
        permissions.calls = Calls::Drive;
        return permissions;
    }
};

TEST_F(Driving, opens_only_files_permitted_at_the_start_or_later) {
    const test::TemporaryFolder devices, system;
    const fs::path fact = system.write("fact", "1");
    Permissions permissions = nothing();
    permissions.read = {system.path(), "/no/such/folder"};
    permissions.read_and_write = {devices.path()};
    EXPECT_EQ(confined(permissions, [&] { return open_error(secret_); }), kNotPermitted);
    EXPECT_EQ(confined(permissions, [] { return open_error("/etc/passwd"); }), kNotPermitted);
    EXPECT_EQ(confined(permissions, [&] { return open_error(fact); }), kWentThrough);
    EXPECT_EQ(confined(permissions, [&] { return open_error(fact, O_WRONLY); }), kNotPermitted);
    // The child process acts as a guard that tries to open its device until somebody plugs the device in.
    const auto look = [&] { return open_error(devices.path() / "event7", O_RDWR); };
    int guards[2] = {-1, -1}, ours[2] = {-1, -1};
    ASSERT_TRUE(::pipe2(guards, O_CLOEXEC) == 0 && ::pipe2(ours, O_CLOEXEC) == 0);
    const Descriptor missed(guards[0]), misses(guards[1]), plugged(ours[0]), plug(ours[1]);
    const pid_t guard = ::fork();
    char byte = 0;
    if (guard == 0) {
        (void)confine::confine(permissions);
        const bool waits =
            look() == ENOENT && ::write(misses.get(), "", 1) == 1 && ::read(plugged.get(), &byte, 1) == 1;
        ::_exit(waits ? look() : 1);
    }
    ASSERT_EQ(::read(missed.get(), &byte, 1), 1);
    devices.write("event7", "");
    ASSERT_EQ(::write(plug.get(), "", 1), 1);
    int status = -1;
    ::waitpid(guard, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << WEXITSTATUS(status);
    EXPECT_EQ(confined(permissions, [&] { return open_error(devices.path() / "new", O_WRONLY | O_CREAT); }),
              kNotPermitted);
}

TEST_F(Driving, starts_no_other_program) { EXPECT_EQ(confined(nothing(), exec_error), kRefused); }

TEST_F(Driving, gets_only_permitted_sockets) {
    for (const int family : {AF_UNIX, AF_INET, AF_INET6, AF_NETLINK, AF_PACKET})
        EXPECT_EQ(confined(nothing(), [=] { return socket_error(family, SOCK_DGRAM); }), kRefused) << family;
    // The kernel uses only the lower half of the 64-bit argument, so the filter must do the same.
    EXPECT_EQ(
        confined(nothing(), [] { return error_of(::syscall(SYS_socket, (1ULL << 32) | AF_UNIX, SOCK_STREAM, 0)); }),
        kRefused);
    Permissions events = nothing();
    events.device_events = true;
    EXPECT_EQ(confined(events, [] { return socket_error(AF_NETLINK, SOCK_RAW, NETLINK_KOBJECT_UEVENT); }),
              kWentThrough);
    EXPECT_EQ(confined(events, [] { return socket_error(AF_NETLINK, SOCK_RAW, NETLINK_ROUTE); }), kRefused);
    Permissions sockets = nothing();
    sockets.unix_sockets = true;
    EXPECT_EQ(confined(sockets, [] { return socket_error(AF_UNIX, SOCK_STREAM); }), kWentThrough);
    Permissions internet = nothing();
    internet.any_internet = true;
    EXPECT_EQ(confined(internet, [] { return socket_error(AF_INET, SOCK_DGRAM); }), kWentThrough);
}

TEST_F(Driving, connects_only_to_a_permitted_port) {
    if (confinement_offered().landlock < 4) GTEST_SKIP() << "Landlock knows ports since version 4";
    Permissions permissions = nothing();
    permissions.tcp_ports = {1};
    EXPECT_EQ(confined(permissions, [] { return connect_error(1); }), (Ending{ECONNREFUSED, 0})) << "nobody listens";
    EXPECT_EQ(confined(permissions, [] { return connect_error(2); }), kNotPermitted);
    EXPECT_EQ(confined(permissions, [] { return socket_error(AF_INET, SOCK_DGRAM); }), kRefused);
    EXPECT_EQ(confined(permissions, [] { return socket_error(AF_INET6, SOCK_DGRAM | SOCK_NONBLOCK); }), kRefused);
}

TEST_F(Driving, reaches_no_other_process_but_may_end_itself) {
#if defined(HANDRAIL_SANITIZED)
    GTEST_SKIP() << "the search for leaks needs these";
#endif
    EXPECT_EQ(confined(nothing(), [] { return error_of(::kill(::getppid(), 0)); }), kRefused);
    EXPECT_EQ(confined(nothing(), [] { return error_of(::syscall(SYS_ptrace, 16, ::getppid(), 0, 0)); }), kRefused);
    EXPECT_EQ(confined(nothing(), [] { return error_of(::syscall(SYS_io_uring_setup, 1, nullptr)); }), kRefused);
    EXPECT_EQ(confined(nothing(), [] { return error_of(::kill(::getpid(), SIGKILL)); }).signal, SIGKILL);
}

// Simulates a kernel that was built without seccomp and Landlock, or a container that hides them.
TEST(Confinement, that_the_kernel_lacks_is_reported_and_changes_nothing) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.write("file", "");
    EXPECT_EQ(ending_of([&] {
                  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
                  const std::uint32_t missing = SCMP_ACT_ERRNO(ENOSYS);
                  for (const int call : {SCMP_SYS(landlock_create_ruleset), SCMP_SYS(seccomp)})
                      if (seccomp_rule_add(filter, missing, call, 0) != 0) return 10;
                  if (seccomp_rule_add(filter, missing, SCMP_SYS(prctl), 1,
                                       scmp_arg_cmp{0, SCMP_CMP_EQ, PR_SET_SECCOMP, 0}) != 0)
                      return 11;
                  if (seccomp_load(filter) != 0) return 12;
                  if (confinement_offered() != Confinement{}) return 13;
                  if (confine::confine({}) != Confinement{}) return 14;
                  return open_error(file);
              }),
              kWentThrough);
}

TEST(Confinement, is_described_in_one_sentence_for_every_kernel) {
    using testing::AllOf;
    using testing::HasSubstr;
    using testing::Not;
    EXPECT_THAT(confinement_sentence({true, 2}), AllOf(HasSubstr("seccomp and Landlock"), Not(HasSubstr("no "))));
    EXPECT_THAT(confinement_sentence({true, 0}), HasSubstr("Without Landlock"));
    EXPECT_THAT(confinement_sentence({false, 1}), HasSubstr("Without seccomp"));
    EXPECT_THAT(confinement_sentence({false, 0}), HasSubstr("neither seccomp nor Landlock"));
}

}  // namespace confine_test
}  // namespace handrail
