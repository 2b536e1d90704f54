#include "haptic/drivers/guarded_device.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <new>
#include <optional>

#include "haptic/drivers/hand_guard.h"
#include "worlds/base/clock.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"

extern "C" char** environ;

namespace handrail {
namespace fs = std::filesystem;
namespace {

// The guard's descriptors begin here.
constexpr int kFirstFd = 3;
constexpr std::string_view kGuardProgram = "handrail-guard";
constexpr std::size_t kLongestSentence = 4096;
constexpr int kLookMs = 50;  // whether the opening was given up

struct Message {
    GuardMessage kind;
    std::string sentence;
};

std::optional<Message> receive(int life_fd) {
    std::array<char, kLongestSentence> bytes;
    const ssize_t size = ::recv(life_fd, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (size <= 0) return std::nullopt;
    return Message{static_cast<GuardMessage>(bytes[0]), std::string(bytes.begin() + 1, bytes.begin() + size)};
}

}  // namespace

fs::path find_guard_program() {
    std::error_code ec;
    const fs::path here = fs::read_symlink("/proc/self/exe", ec).parent_path();
    for (const fs::path& candidate : {here / kGuardProgram, here.parent_path() / "libexec" / "handrail" / kGuardProgram})
        if (!ec && ::access(candidate.c_str(), X_OK) == 0) return candidate;
    return {};
}

GuardedDevice::GuardedDevice(const DeviceSpec& spec, fs::path guard_program, std::vector<std::string> arguments)
    : spec_(spec), guard_program_(std::move(guard_program)), arguments_(std::move(arguments)) {}

GuardedDevice::~GuardedDevice() { GuardedDevice::close(); }

Result<void> GuardedDevice::start_guard() {
    const auto problem = [](int error) { return fail(phrase("guard.cannot_start", {{"reason", reason_of(error)}})); };
    if (guard_program_.empty()) return fail(phrase("guard.no_program", {{"program", kGuardProgram}}));
    const Descriptor memory(::memfd_create("handrail-hand", MFD_CLOEXEC));
    if (memory.get() < 0 || ::ftruncate(memory.get(), sizeof(HandMailbox)) != 0) return problem(errno);
    void* mapped = ::mmap(nullptr, sizeof(HandMailbox), PROT_READ | PROT_WRITE, MAP_SHARED, memory.get(), 0);
    if (mapped == MAP_FAILED) return problem(errno);
    mailbox_ = new (mapped) HandMailbox;

    Descriptor wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
    std::array<int, 2> ends{-1, -1};
    if (wake.get() < 0 || ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return problem(errno);
    Descriptor ours(ends[0]);
    const Descriptor theirs(ends[1]);

    // Numbers out of the way of 3, 4 and 5 first, so that no descriptor is overwritten before it is passed on.
    std::array<int, 3> high{};
    const std::array<int, 3> passed{memory.get(), wake.get(), theirs.get()};
    for (std::size_t i = 0; i < passed.size(); ++i) high[i] = ::fcntl(passed[i], F_DUPFD_CLOEXEC, 64);
    const Descriptor high_memory(high[0]), high_wake(high[1]), high_life(high[2]);
    if (high[0] < 0 || high[1] < 0 || high[2] < 0) return problem(errno);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (std::size_t i = 0; i < high.size(); ++i) posix_spawn_file_actions_adddup2(&actions, high[i], kFirstFd + static_cast<int>(i));
    posix_spawn_file_actions_addclosefrom_np(&actions, kFirstFd + static_cast<int>(high.size()));
    std::vector<std::string> words{guard_program_.string(), "3", "4", "5", spoken_language(), spoken_language_folder().string()};
    words.insert(words.end(), arguments_.begin(), arguments_.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int status = ::posix_spawn(&guard_, guard_program_.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (status != 0) {
        guard_ = -1;
        return problem(status);
    }
    wake_fd_ = wake.release();
    life_fd_ = ours.release();
    return {};
}

Result<void> GuardedDevice::open() {
    if (life_fd_ >= 0 && guard_lives()) return {};
    close();
    if (auto started = start_guard(); !started) {
        close();
        return started;
    }
    const SteadyClock clock;
    const double deadline_s = clock.now_s() + kOpenS;
    for (;;) {
        pollfd watched{life_fd_, POLLIN, 0};
        const bool late = clock.now_s() >= deadline_s;
        if (late || given_up_.exchange(false, std::memory_order_acq_rel)) {
            close();
            return fail(late ? phrase("guard.late", {{"device", spec_.spoken_name()}, {"seconds", kOpenS}})
                             : phrase("guard.not_waited_for", {{"device", spec_.spoken_name()}}));
        }
        if (::poll(&watched, 1, kLookMs) <= 0) continue;
        const auto message = receive(life_fd_);
        if (!message) {
            close();
            return fail(phrase("guard.ended", {{"device", spec_.spoken_name()}}));
        }
        if (message->kind == GuardMessage::Ready) break;
        if (message->kind == GuardMessage::Failed) {
            close();
            return fail(message->sentence);
        }
        if (tell_) tell_(message->sentence);
        news_.push_back(message->sentence);
    }
    last_ = {};
    last_.fresh = false;
    last_.homed = false;
    return {};
}

bool GuardedDevice::guard_lives() const noexcept {
    pollfd watched{life_fd_, POLLRDHUP, 0};
    return ::poll(&watched, 1, 0) == 0 || !(watched.revents & (POLLHUP | POLLRDHUP | POLLERR));
}

DeviceSample GuardedDevice::read(double) noexcept {
    if (!mailbox_) {
        last_.fresh = last_.connected = false;
        return last_;
    }
    if (mailbox_->answer.refresh()) {
        last_ = mailbox_->answer.read();
        return last_;
    }
    last_.fresh = false;
    if (last_.connected && !guard_lives()) last_.connected = false;
    return last_;
}

void GuardedDevice::write(const ForceCommand& command) noexcept {
    if (!mailbox_) return;
    mailbox_->command.publish(command);
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake_fd_, &one, sizeof one);
}

void GuardedDevice::close() noexcept {
    if (life_fd_ >= 0) ::close(life_fd_);
    life_fd_ = -1;
    if (guard_ > 0) {
        // The guard may still be waking a device; it looks at us only between two steps of that, and zeroes the force when it does.
        const SteadyClock clock;
        SteadyClock sleeper;
        const double deadline_s = clock.now_s() + kEndS;
        bool ended = false;
        while (!(ended = ::waitpid(guard_, nullptr, WNOHANG) != 0) && clock.now_s() < deadline_s) sleeper.sleep_until_s(clock.now_s() + 0.002);
        if (!ended) {
            ::kill(guard_, SIGKILL);
            ::waitpid(guard_, nullptr, 0);
        }
        guard_ = -1;
    }
    if (wake_fd_ >= 0) ::close(wake_fd_);
    wake_fd_ = -1;
    if (mailbox_) ::munmap(mailbox_, sizeof(HandMailbox));
    mailbox_ = nullptr;
}

std::vector<std::string> GuardedDevice::take_news() {
    while (life_fd_ >= 0) {
        const auto message = receive(life_fd_);
        if (!message) break;
        if (!message->sentence.empty()) news_.push_back(message->sentence);
    }
    return std::exchange(news_, {});
}

}  // namespace handrail
