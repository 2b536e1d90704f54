#include "haptic/drivers/hand_guard.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace handrail {
namespace {

constexpr int kRealTimePriority = 71;  // just above the servo thread that waits for it
constexpr int kTickMs = 5;

// Ends the process when an exchange does not come back: a vendor's library may block for ever, with the force still on.
class StuckWatch {
public:
    explicit StuckWatch(std::function<void()> stuck) : stuck_(std::move(stuck)), thread_([this] { run(); }) {}
    ~StuckWatch() {
        {
            const std::lock_guard guard(mutex_);
            end_ = true;
        }
        changed_.notify_one();
        thread_.join();
    }
    StuckWatch(const StuckWatch&) = delete;
    StuckWatch& operator=(const StuckWatch&) = delete;

    void begin(double now_s) noexcept { since_s_.store(now_s, std::memory_order_release); }
    void end() noexcept { since_s_.store(kIdle, std::memory_order_release); }

private:
    static constexpr double kIdle = -1.0;

    void run() {
        std::unique_lock guard(mutex_);
        const SteadyClock clock;
        while (!changed_.wait_for(guard, std::chrono::milliseconds(50), [this] { return end_; })) {
            const double since_s = since_s_.load(std::memory_order_acquire);
            if (since_s != kIdle && clock.now_s() - since_s > kStuckS) {
                stuck_();
                return;
            }
        }
    }

    std::function<void()> stuck_;
    std::atomic<double> since_s_{kIdle};
    std::mutex mutex_;
    std::condition_variable changed_;
    bool end_ = false;
    std::thread thread_;  // last: starts when all else stands
};

void send(int life_fd, GuardMessage kind, const std::string& sentence) {
    const std::string message = static_cast<char>(kind) + sentence;
    // A program that does not listen must not hold up the guard.
    [[maybe_unused]] const ssize_t sent = ::send(life_fd, message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

// True when a command waits. `gone` when the program closed its end.
bool wait_for_command(int wake_fd, int life_fd, int timeout_ms, bool& gone) {
    std::array<pollfd, 2> watched{pollfd{wake_fd, POLLIN, 0}, pollfd{life_fd, POLLRDHUP, 0}};
    ::poll(watched.data(), watched.size(), timeout_ms);
    gone = (watched[1].revents & (POLLHUP | POLLRDHUP | POLLERR | POLLNVAL)) != 0;
    if (!(watched[0].revents & POLLIN)) return false;
    std::uint64_t count = 0;
    return ::read(wake_fd, &count, sizeof count) == sizeof count;
}

}  // namespace

int guard_hand(HandMailbox& mailbox, int wake_fd, int life_fd, const OpenDevice& open_device, const std::function<void()>& stuck) {
    const SteadyClock clock;
    const auto tell = [life_fd](const std::string& sentence) { send(life_fd, GuardMessage::News, sentence); };
    auto opened = open_device(tell);
    if (!opened) {
        send(life_fd, GuardMessage::Failed, opened.error().sentence());
        return 1;
    }
    std::unique_ptr<HapticDevice> device = std::move(*opened);
    StuckWatch watch(stuck);
    send(life_fd, GuardMessage::Ready, "");

    DeviceSample answer;
    ForceCommand command;
    double commanded_s = clock.now_s(), exchanged_s = 0.0, looked_s = 0.0;
    bool gone = false;
    while (!gone) {
        const bool woken = wait_for_command(wake_fd, life_fd, kTickMs, gone);
        const double now_s = clock.now_s();
        if (mailbox.command.refresh()) {
            commanded_s = now_s;
            command = mailbox.command.read();
        }
        if (gone) break;
        if (now_s - commanded_s > kZeroAfterS) command = {};
        if (device && (woken || now_s - exchanged_s > kZeroAfterS)) {
            watch.begin(now_s);
            device->write(command);
            answer = device->read(now_s);
            watch.end();
            exchanged_s = now_s;
            mailbox.answer.publish(answer);
            if (!answer.connected) {
                device->close();
                device.reset();
                looked_s = now_s;
            }
        } else if (!device) {
            if (now_s - looked_s >= kLookAgainS) {
                auto again = open_device(tell);
                looked_s = clock.now_s();
                if (again) device = std::move(*again);
            }
        }
    }
    if (device) {
        watch.begin(clock.now_s());
        device->close();
        watch.end();
    }
    return 0;
}

int run_guard_process(int mailbox_fd, int wake_fd, int life_fd, const OpenDevice& open_device) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP, SIGUSR1, SIGUSR2}) ::signal(number, SIG_IGN);
    ::setsid();  // what is sent to the program's group is not for the guard
    struct stat facts {};
    if (::fstat(mailbox_fd, &facts) != 0 || facts.st_size < static_cast<off_t>(sizeof(HandMailbox))) return 2;
    void* memory = ::mmap(nullptr, sizeof(HandMailbox), PROT_READ | PROT_WRITE, MAP_SHARED, mailbox_fd, 0);
    if (memory == MAP_FAILED) return 2;
    auto& mailbox = *static_cast<HandMailbox*>(memory);
    if (mailbox.mark != HandMailbox::kMailboxMark) return 2;
    sched_param wish{};
    wish.sched_priority = kRealTimePriority;
    ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &wish);  // ordinary scheduling does too, less evenly
    return guard_hand(mailbox, wake_fd, life_fd, open_device, [] { ::_exit(3); });
}

}  // namespace handrail
