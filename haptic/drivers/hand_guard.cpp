#include "haptic/drivers/hand_guard.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "worlds/base/executor.h"

namespace handrail::drivers {
namespace {

constexpr int kTickMs = 5;

// Ends the process if an exchange with the device does not return: a maker's library may block for ever with the force
// still on.
class StuckWatch {
public:
    explicit StuckWatch(std::function<void()> stuck)
        : stuck_(std::move(stuck)), thread_([this] {
              name_this_thread("stuck-watch");
              run();
          }) {}
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
    std::thread thread_;  // declared last, so that it starts when all other members are initialised
};

// Returns true if a new command is waiting. Sets `gone` if the program has closed its end of the socket.
bool wait_for_command(int wake_fd, int life_fd, int timeout_ms, bool& gone) {
    std::array<pollfd, 2> watched{pollfd{wake_fd, POLLIN, 0}, pollfd{life_fd, POLLRDHUP, 0}};
    ::poll(watched.data(), watched.size(), timeout_ms);
    gone = (watched[1].revents & (POLLHUP | POLLRDHUP | POLLERR | POLLNVAL)) != 0;
    if (!(watched[0].revents & POLLIN)) return false;
    std::uint64_t count = 0;
    return ::read(wake_fd, &count, sizeof count) == sizeof count;
}

}  // namespace

void send_message(int life_fd, GuardMessage kind, const std::string& sentence) {
    const std::string message = static_cast<char>(kind) + sentence;
    // MSG_DONTWAIT, because a program that does not read its messages must not block the guard.
    [[maybe_unused]] const ssize_t sent = ::send(life_fd, message.data(), message.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
}

int guard_hand(HandMailbox& mailbox, int wake_fd, int life_fd, const OpenDevice& open_device,
               const std::function<void()>& stuck) {
    const SteadyClock clock;
    const auto report = [life_fd](const std::string& sentence) { send_message(life_fd, GuardMessage::News, sentence); };
    auto opened = open_device(report);
    if (!opened) {
        send_message(life_fd, GuardMessage::Failed, opened.error().sentence());
        return 1;
    }
    std::unique_ptr<device::HapticDevice> device = std::move(*opened);
    mailbox.holds = true;
    StuckWatch watch(stuck);
    send_message(life_fd, GuardMessage::Ready, "");

    device::DeviceSample answer;
    device::ForceCommand command;
    double commanded_s = clock.now_s(), exchanged_s = 0.0, looked_s = 0.0;
    bool gone = false;
    while (!gone) {
        const bool woken = wait_for_command(wake_fd, life_fd, kTickMs, gone);
        const double now_s = clock.now_s();
        mailbox.beats.fetch_add(1, std::memory_order_release);
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
            if (!answer.connected) {
                device->close();
                device.reset();
                mailbox.holds = false;
                looked_s = now_s;
            }
            mailbox.answer.publish(answer);
        } else if (!device) {
            if (now_s - looked_s >= kLookAgainS) {
                auto again = open_device(report);
                looked_s = clock.now_s();
                if (again) {
                    device = std::move(*again);
                    mailbox.holds = true;
                }
            }
        }
    }
    if (device) {
        watch.begin(clock.now_s());
        device->close();
        watch.end();
        mailbox.holds = false;
    }
    return 0;
}

}  // namespace handrail::drivers
