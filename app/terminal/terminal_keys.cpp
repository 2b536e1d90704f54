#include "app/terminal/terminal_keys.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <iterator>
#include <utility>

#include "worlds/base/executor.h"

namespace handrail::terminal {

TerminalKeys::TerminalKeys(int descriptor, const TerminalKeyboard& keyboard, Clock& clock,
                           std::function<bool(const std::string&)> at_once)
    : descriptor_(descriptor),
      clock_(clock),
      at_once_(std::move(at_once)),
      decoder_(keyboard),
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      thread_([this] {
          name_this_thread("keys");
          run();
      }) {}

TerminalKeys::~TerminalKeys() {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
    thread_.join();
}

std::vector<TimedInput> TerminalKeys::take(bool& emptied) {
    const std::lock_guard guard(mutex_);
    emptied = std::exchange(emptied_, false);
    std::vector<TimedInput> taken(std::make_move_iterator(waiting_.begin()), std::make_move_iterator(waiting_.end()));
    waiting_.clear();
    return taken;
}

void TerminalKeys::add(std::vector<TerminalInput> inputs) {
    const double now_s = clock_.now_s();
    // Keep the mutex locked while `at_once` acts on a key. Then a caller of take() never receives keys from before that
    // key afterwards.
    const std::lock_guard guard(mutex_);
    for (TerminalInput& input : inputs) {
        if (!input.key.empty() && at_once_(input.key)) {
            waiting_.clear();
            emptied_ = true;
        } else if (waiting_.size() < kMostWaiting) {
            waiting_.push_back({std::move(input), now_s});
        }
    }
}

void TerminalKeys::run() {
    constexpr int kWait_ms = static_cast<int>(1e3 * kEscapeAlone_s);
    while (true) {
        std::array<pollfd, 2> watched{pollfd{descriptor_, POLLIN, 0}, pollfd{wake_.get(), POLLIN, 0}};
        const int ready = ::poll(watched.data(), watched.size(), decoder_.waits() ? kWait_ms : -1);
        if (ready < 0 && errno != EINTR) break;
        if (watched[1].revents != 0 && ready > 0) return;
        if (ready < 0) continue;
        if (ready == 0) {
            add(decoder_.time_out());
            continue;
        }
        std::array<char, 4096> block{};
        const ssize_t got = ::read(descriptor_, block.data(), block.size());
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (got <= 0) break;
        add(decoder_.take({block.data(), static_cast<std::size_t>(got)}));
    }
    ended_.store(true, std::memory_order_release);
}

}  // namespace handrail::terminal
