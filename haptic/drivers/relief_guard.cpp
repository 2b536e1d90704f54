#include "haptic/drivers/relief_guard.h"

#include <poll.h>

#include <array>
#include <chrono>
#include <system_error>
#include <thread>

#include "worlds/base/clock.h"
#include "worlds/base/executor.h"

namespace handrail::drivers {
namespace {

// Time in ms that the kernel may take to end the first guard, which may be in a driver that does not return.
constexpr int kDyingMs = 500;
constexpr auto kBetweenTries = std::chrono::milliseconds(10);
constexpr auto kBetweenLateTries = std::chrono::milliseconds(500);
// If the first guard still runs this long after the program has ended, it hangs. Opening a device takes less time.
constexpr double kOrphanS = 35.0;

// Watches the first guard. Returns true if it has ended. Returns false if it froze while it held a device, or hangs
// after the program has ended.
bool watch(HandMailbox& mailbox, int guard_fd, int life_fd) {
    const SteadyClock clock;
    std::array<pollfd, 2> watched{pollfd{guard_fd, POLLIN, 0}, pollfd{life_fd, POLLRDHUP, 0}};
    StillCount guard(mailbox.beats.load(std::memory_order_acquire));
    double orphaned_s = -1.0;
    for (int still = 0; still < kStillLooks;) {
        const int events = ::poll(watched.data(), watched.size(), kLookMs);
        mailbox.relief_beats.fetch_add(1, std::memory_order_release);
        if (watched[0].revents != 0) return true;
        // The program has ended. The first guard notices that as well, releases the device and ends, so this loop waits
        // for that.
        if (events > 0 && watched[1].revents != 0) {
            watched[1].fd = -1;
            orphaned_s = clock.now_s();
            continue;
        }
        if (events != 0) continue;  // a signal interrupted poll(), so this pass was no check
        if (orphaned_s >= 0.0 && clock.now_s() - orphaned_s > kOrphanS) return false;
        still =
            guard.look(mailbox.beats.load(std::memory_order_acquire), !mailbox.holds.load(std::memory_order_acquire));
    }
    return false;
}

// Increments `relief_beats` on a separate thread, so that the program sees that this process is alive. Meanwhile a
// driver opens the device, zeroes the force and closes the device, which may take seconds.
std::jthread beat_meanwhile(HandMailbox& mailbox) noexcept {
    try {
        return std::jthread([&mailbox](const std::stop_token& end) {
            name_this_thread("beat");
            for (; !end.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(kLookMs)))
                mailbox.relief_beats.fetch_add(1, std::memory_order_release);
        });
    } catch (const std::system_error&) {
        return {};  // Without this thread, the program replaces this process if the driver is too slow.
    }
}

}  // namespace

int relieve_guard(HandMailbox& mailbox, int guard_fd, int life_fd, const ZeroDevice& zero_device,
                  const std::function<void()>& end_guard) {
    send_message(life_fd, GuardMessage::Ready, "");
    const bool ended = watch(mailbox, guard_fd, life_fd);
    if (!mailbox.holds.load(std::memory_order_acquire)) {
        mailbox.relief = ReliefState::Zero;
        if (!ended) end_guard();
        return 0;
    }
    mailbox.relief = ReliefState::Zeroing;
    const std::jthread beating = beat_meanwhile(mailbox);
    if (!ended) {
        end_guard();
        pollfd dying{guard_fd, POLLIN, 0};
        while (::poll(&dying, 1, kDyingMs) < 0 && errno == EINTR) continue;
    }
    const SteadyClock clock;
    const double begun_s = clock.now_s();
    for (bool reported = false;;) {
        const auto zeroed = zero_device();
        if (zeroed) {
            mailbox.relief = ReliefState::Zero;
            return 0;
        }
        const double tried_s = clock.now_s() - begun_s;
        if (tried_s > kZeroTriesS && !std::exchange(reported, true)) {
            // The reason is sent before the state changes, because a reader that sees the new state reads the reason at
            // once.
            send_message(life_fd, GuardMessage::Failed, zeroed.error().sentence());
            mailbox.relief = ReliefState::Failed;
        }
        pollfd program{life_fd, POLLRDHUP, 0};
        const bool program_gone = reported && ::poll(&program, 1, 0) > 0;
        if (tried_s > kZeroKeepsTryingS || program_gone) return 1;
        std::this_thread::sleep_for(reported ? kBetweenLateTries : kBetweenTries);
    }
}

}  // namespace handrail::drivers
