#include "haptic/drivers/guarded_device.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
extern "C" {  // declared here because glibc 2.36's headers lack it
#include <sys/pidfd.h>
}

#include <array>
#include <cstring>
#include <new>
#include <optional>

#include "haptic/drivers/guard_permissions.h"
#include "haptic/drivers/guard_process.h"
#include "haptic/drivers/hand_guard.h"
#include "haptic/drivers/relief_guard.h"
#include "worlds/base/clock.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/executor.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/confine/confine.h"

namespace handrail::drivers {
namespace fs = std::filesystem;
namespace {

// Lowest number of the file descriptors that a guard inherits.
constexpr int kFirstFd = 3;
constexpr std::string_view kGuardProgram = "handrail-guard";
constexpr std::size_t kLongestSentence = 4096;
constexpr int kGivenUpMs = 50;      // interval in ms at which a waiting open() checks whether give_up() was called
constexpr int kWatchPriority = 71;  // priority of the watch thread: the same as the first guard's, above the servo
// Limits for the second guard, in checks. The second guard adds a beat at each of its own checks. Without a beat for 50
// ms it is treated as frozen, so that a replacement is there within 100 ms. Until its first beat it has 2 s to start.
constexpr int kReliefStillLooks = 5;
constexpr int kReliefLoadLooks = 200;

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
    for (const fs::path& candidate :
         {here / kGuardProgram, here.parent_path() / "libexec" / "handrail" / kGuardProgram})
        if (!ec && ::access(candidate.c_str(), X_OK) == 0) return candidate;
    return {};
}

GuardedDevice::GuardedDevice(const device::DeviceSpec& spec, fs::path guard_program, std::vector<std::string> arguments)
    : spec_(spec), guard_program_(std::move(guard_program)), arguments_(std::move(arguments)) {}

GuardedDevice::~GuardedDevice() { GuardedDevice::close(); }

Result<void> GuardedDevice::start(const char* role, int third_fd, int& life_fd, pid_t& process) {
    const auto problem = [](int error) { return fail(phrase("guard.cannot_start", {{"reason", reason_of(error)}})); };
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return problem(errno);
    Descriptor ours(ends[0]);
    const Descriptor theirs(ends[1]);

    // First moves the descriptors away from the numbers 3, 4 and 5, so that none is overwritten before it is passed on.
    std::array<int, 3> high{};
    const std::array<int, 3> passed{memory_fd_, theirs.get(), third_fd};
    for (std::size_t i = 0; i < passed.size(); ++i) high[i] = ::fcntl(passed[i], F_DUPFD_CLOEXEC, 64);
    const Descriptor high_memory(high[0]), high_life(high[1]), high_third(high[2]);
    if (high[0] < 0 || high[1] < 0 || high[2] < 0) return problem(errno);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (std::size_t i = 0; i < high.size(); ++i)
        posix_spawn_file_actions_adddup2(&actions, high[i], kFirstFd + static_cast<int>(i));
    posix_spawn_file_actions_addclosefrom_np(&actions, kFirstFd + static_cast<int>(high.size()));
    std::vector<std::string> words{guard_program_.string(),          role, "3", "4", "5", spoken_language(),
                                   spoken_language_folder().string()};
    words.insert(words.end(), arguments_.begin(), arguments_.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int status = ::posix_spawn(&process, guard_program_.c_str(), &actions, nullptr, argv.data(),
                                     confine::environment_with(kGuardVariables).data());
    posix_spawn_file_actions_destroy(&actions);
    if (status != 0) {
        process = -1;
        return problem(status);
    }
    life_fd = ours.release();
    return {};
}

// The second guard starts with the first, so that it is ready before there can be any force.
Result<void> GuardedDevice::start_guards() {
    const auto problem = [](int error) { return fail(phrase("guard.cannot_start", {{"reason", reason_of(error)}})); };
    if (guard_program_.empty()) return fail(phrase("guard.no_program", {{"program", kGuardProgram}}));
    memory_fd_ = ::memfd_create("handrail-hand", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (memory_fd_ < 0 || ::ftruncate(memory_fd_, sizeof(HandMailbox)) != 0) return problem(errno);
    // Processes with this descriptor may write the shared memory, but never shrink it. If one could shrink it, the
    // other processes that have mapped it would die of SIGBUS.
    if (::fcntl(memory_fd_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0) return problem(errno);
    void* mapped = ::mmap(nullptr, sizeof(HandMailbox), PROT_READ | PROT_WRITE, MAP_SHARED, memory_fd_, 0);
    if (mapped == MAP_FAILED) return problem(errno);
    mailbox_ = new (mapped) HandMailbox;
    wake_fd_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (wake_fd_ < 0) return problem(errno);
    if (auto started = start(kHoldRole, wake_fd_, life_fd_, guard_); !started) return started;
    guard_fd_ = ::pidfd_open(guard_, 0);
    if (guard_fd_ < 0) return problem(errno);
    return start_relief();
}

Result<void> GuardedDevice::start_relief() {
    if (relief_life_fd_ >= 0) ::close(std::exchange(relief_life_fd_, -1));
    end_process(relief_, 0.0);
    return start(kRelieveRole, guard_fd_, relief_life_fd_, relief_);
}

Result<void> GuardedDevice::wait_for_ready(int life_fd, double deadline_s) {
    const SteadyClock clock;
    for (;;) {
        pollfd watched{life_fd, POLLIN, 0};
        const bool late = clock.now_s() >= deadline_s;
        if (late || given_up_.exchange(false, std::memory_order_acq_rel))
            return fail(late ? phrase("guard.late", {{"device", spec_.spoken_name()}, {"seconds", kOpenS}})
                             : phrase("guard.not_waited_for", {{"device", spec_.spoken_name()}}));
        if (::poll(&watched, 1, kGivenUpMs) <= 0) continue;
        const auto message = receive(life_fd);
        if (!message) return fail(phrase("guard.ended", {{"device", spec_.spoken_name()}}));
        if (message->kind == GuardMessage::Ready) return {};
        if (message->kind == GuardMessage::Failed) return fail(message->sentence);
        if (report_) report_(message->sentence);
        news_.push_back(message->sentence);
    }
}

Result<void> GuardedDevice::open() {
    if (life_fd_ >= 0 && guard_lives()) return {};
    close();
    may_push_ = may_push_reported_ = false;
    reliefs_left_ = kMostReliefs;
    zeroing_since_s_ = SteadyClock().now_s();
    const double deadline_s = SteadyClock().now_s() + kOpenS;
    auto opened = start_guards();
    if (opened) opened = wait_for_ready(life_fd_, deadline_s);
    if (opened) opened = wait_for_ready(relief_life_fd_, deadline_s);
    if (!opened) {
        close();
        return opened;
    }
    last_ = {};
    last_.fresh = false;
    last_.homed = false;
    watch_ = std::jthread([this](const std::stop_token& end) {
        name_this_thread("guard-watch");
        watch_guards(end);
    });
    return {};
}

pid_t GuardedDevice::relief_process() const {
    const std::lock_guard lock(mutex_);
    return relief_;
}

bool GuardedDevice::guard_lives() const noexcept {
    pollfd watched{guard_fd_, POLLIN, 0};
    return ::poll(&watched, 1, 0) == 0;
}

bool GuardedDevice::relief_lives() const noexcept {
    pollfd watched{relief_life_fd_, POLLRDHUP, 0};
    return relief_life_fd_ >= 0 && ::poll(&watched, 1, 0) == 0;
}

bool GuardedDevice::guard_ended() const noexcept {
    if (life_fd_ < 0) return false;
    const ReliefState relief = mailbox_->relief.load(std::memory_order_acquire);
    return (relief == ReliefState::Zero || relief == ReliefState::Failed) && !guard_lives();
}

device::DeviceLoss GuardedDevice::loss() const noexcept {
    if (!mailbox_->holds.load(std::memory_order_acquire)) return device::DeviceLoss::Unplugged;
    return mailbox_->relief.load(std::memory_order_acquire) == ReliefState::Zero ? device::DeviceLoss::ForceOff
                                                                                 : device::DeviceLoss::MayPush;
}

device::DeviceSample GuardedDevice::read(double) noexcept {
    if (!mailbox_) {
        last_.fresh = last_.connected = false;
        return last_;
    }
    const bool relieved = mailbox_->relief.load(std::memory_order_acquire) != ReliefState::Watching;
    if (!relieved && mailbox_->answer.refresh()) {
        last_ = mailbox_->answer.read();
        return last_;
    }
    last_.fresh = false;
    if (relieved || !guard_lives()) {
        last_.connected = false;
        last_.loss = loss();
    }
    return last_;
}

void GuardedDevice::write(const device::ForceCommand& command) noexcept {
    if (!mailbox_) return;
    mailbox_->command.publish(command);
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake_fd_, &one, sizeof one);
}

// Waits at most `seconds` for the process to end, then kills it. If a driver has blocked the process so that even the
// kill does not end it, the process is left behind.
void GuardedDevice::end_process(pid_t& process, double seconds) noexcept {
    if (process <= 0) return;
    SteadyClock clock;
    bool ended = false;
    const auto wait = [&](double wait_s) {
        const double deadline_s = clock.now_s() + wait_s;
        while (!(ended = ::waitpid(process, nullptr, WNOHANG) != 0) && clock.now_s() < deadline_s)
            clock.sleep_until_s(clock.now_s() + 0.002);
    };
    wait(seconds);
    if (!ended) {
        ::kill(process, SIGKILL);
        wait(kEndS);
    }
    process = -1;
}

void GuardedDevice::await_zero() noexcept {
    SteadyClock clock;
    const double deadline_s = clock.now_s() + kZeroS;
    const auto relief = [this] { return mailbox_->relief.load(std::memory_order_acquire); };
    while (relief() != ReliefState::Zero && relief() != ReliefState::Failed && clock.now_s() < deadline_s)
        clock.sleep_until_s(clock.now_s() + 0.002);
    may_push_ = relief() != ReliefState::Zero;
    if (!may_push_) return;
    const std::lock_guard lock(mutex_);
    while (const auto message = receive(relief_life_fd_))
        if (message->kind == GuardMessage::Failed) why_not_zero_ = message->sentence;
}

void GuardedDevice::close() noexcept {
    if (const std::lock_guard lock(mutex_); mailbox_ && guard_fd_ >= 0 && !relief_lives() &&
                                            mailbox_->relief.load(std::memory_order_acquire) == ReliefState::Watching)
        (void)start_relief();
    if (life_fd_ >= 0) ::close(std::exchange(life_fd_, -1));
    // The guard may still be starting a device. It checks whether the program exists only between two steps of the
    // start, and then sets the force to zero. With an open device, each round of the guard may last 100 ms; after that
    // time the second guard ends the guard.
    end_process(guard_, kEndS);
    if (mailbox_ && relief_process() > 0 && mailbox_->holds.load(std::memory_order_acquire)) await_zero();
    watch_ = {};
    if (relief_life_fd_ >= 0) ::close(std::exchange(relief_life_fd_, -1));
    end_process(relief_, kEndS);
    for (int* fd : {&guard_fd_, &wake_fd_, &memory_fd_})
        if (*fd >= 0) ::close(std::exchange(*fd, -1));
    if (mailbox_) ::munmap(mailbox_, sizeof(HandMailbox));
    mailbox_ = nullptr;
}

std::vector<std::string> GuardedDevice::take_news() {
    const std::lock_guard lock(mutex_);
    while (life_fd_ >= 0) {
        const auto message = receive(life_fd_);
        if (!message) break;
        if (!message->sentence.empty()) news_.push_back(message->sentence);
    }
    while (relief_life_fd_ >= 0) {
        const auto message = receive(relief_life_fd_);
        if (!message) break;
        if (message->kind != GuardMessage::Failed) continue;
        why_not_zero_ = message->sentence;
        may_push_ = true;
    }
    notice_long_zeroing();
    if (may_push_ && !std::exchange(may_push_reported_, true))
        news_.push_back(phrase("guard.may_still_push",
                               {{"device", spec_.spoken_name()},
                                {"reason", why_not_zero_.empty() ? phrase("guard.no_answer") : why_not_zero_}}));
    return std::exchange(news_, {});
}

// Sets may_push_ if the zero force is overdue. A second guard that hangs in a driver never reports its failure, and
// neither does the last permitted replacement if it has failed.
void GuardedDevice::notice_long_zeroing() {
    const double now_s = SteadyClock().now_s();
    const auto zero_is_due = [this] {
        const ReliefState relief = mailbox_->relief.load(std::memory_order_acquire);
        return relief == ReliefState::Zeroing ||
               (relief == ReliefState::Watching && mailbox_->holds.load(std::memory_order_acquire) && !guard_lives());
    };
    if (!mailbox_ || !zero_is_due()) zeroing_since_s_ = now_s;
    else if (now_s - zeroing_since_s_ > kZeroS) may_push_ = true;
}

void GuardedDevice::watch_guards(const std::stop_token& end) {
    sched_param scheduling{};
    scheduling.sched_priority = kWatchPriority;
    // If the system refuses, the thread keeps ordinary scheduling, which is less punctual.
    ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &scheduling);
    StillCount guard(mailbox_->beats.load(std::memory_order_acquire));
    StillCount relief(mailbox_->relief_beats.load(std::memory_order_acquire));
    bool relief_beats = true;  // the second guard has beaten since its start
    int looks = 0;
    for (SteadyClock clock; !end.stop_requested(); clock.sleep_until_s(clock.now_s() + kLookMs * 1e-3)) {
        const bool guard_holds = mailbox_->holds.load(std::memory_order_acquire) && guard_lives();
        if (guard.look(mailbox_->beats.load(std::memory_order_acquire), !guard_holds) >= kStillLooks)
            ::pidfd_send_signal(guard_fd_, SIGKILL, nullptr, 0);
        const ReliefState state = mailbox_->relief.load(std::memory_order_acquire);
        if (state == ReliefState::Zero || state == ReliefState::Failed) continue;
        const int still = relief.look(mailbox_->relief_beats.load(std::memory_order_acquire), false);
        relief_beats = relief_beats || still == 0;
        const std::lock_guard lock(mutex_);
        if (++looks >= kProvenLooks) reliefs_left_ = kMostReliefs;
        if (relief_lives() && still < (relief_beats ? kReliefStillLooks : kReliefLoadLooks)) continue;
        replace_relief();
        relief = StillCount(mailbox_->relief_beats.load(std::memory_order_acquire));
        relief_beats = false;
        looks = 0;
    }
}

// Starts a new second guard. Kills the present one first if it still exists, because two processes must never hold the
// device.
void GuardedDevice::replace_relief() {
    if (reliefs_left_ == 0) return;
    --reliefs_left_;
    if (const auto started = start_relief(); !started) news_.push_back(started.error().sentence());
}

std::vector<std::string> GuardedDevice::unprotected() const {
    std::vector<std::string> sentences;
    if (mailbox_ && !mailbox_->memory_locked) sentences.push_back(phrase("guard.memory_not_locked"));
    if (mailbox_ && !mailbox_->spared) sentences.push_back(phrase("guard.not_spared"));
    return sentences;
}

}  // namespace handrail::drivers
