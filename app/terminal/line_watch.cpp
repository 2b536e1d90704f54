#include "app/terminal/line_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <algorithm>
#include <iterator>

#include <array>
#include <cerrno>

#include "worlds/base/executor.h"

namespace handrail::terminal {
namespace {

constexpr std::size_t kLongestLine = 4096;

}  // namespace

std::vector<std::string> LineInput::take() {
    std::vector<std::string> lines;
    for (std::size_t bytes = 0; !ended_ && bytes < kBytesAtOnce;) {
        pollfd wait{descriptor_, POLLIN, 0};
        const int ready = ::poll(&wait, 1, 0);
        if (ready == 0 || (ready < 0 && errno == EINTR)) break;
        char block[4096];
        const ssize_t got = ready < 0 ? -1 : ::read(descriptor_, block, sizeof block);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) break;
        if (got <= 0) {
            ended_ = true;
            if (!partial_.empty()) lines.push_back(std::exchange(partial_, {}));
            break;
        }
        bytes += static_cast<std::size_t>(got);
        for (ssize_t i = 0; i < got; ++i) {
            if (block[i] == '\n') lines.push_back(std::exchange(partial_, {}));
            else if (partial_.size() < kLongestLine) partial_ += block[i];
        }
    }
    return lines;
}

LineWatch::LineWatch(int descriptor, WhenFull when_full, std::function<bool(std::string_view)> at_once)
    : input_(descriptor),
      descriptor_(descriptor),
      when_full_(when_full),
      at_once_(std::move(at_once)),
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      thread_([this] {
          name_this_thread("lines");
          run();
      }) {}

LineWatch::~LineWatch() {
    leaving_ = true;
    wake();
    thread_.join();
}

void LineWatch::wake() {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
}

std::vector<std::string> LineWatch::take(bool& emptied, std::size_t most) {
    std::vector<std::string> taken;
    bool made_room = false;
    {
        const std::lock_guard guard(mutex_);
        emptied = std::exchange(emptied_, false);
        const bool was_full = lines_.size() >= kMostWaiting;
        const auto end = lines_.begin() + static_cast<std::ptrdiff_t>(std::min(most, lines_.size()));
        taken.assign(std::make_move_iterator(lines_.begin()), std::make_move_iterator(end));
        lines_.erase(lines_.begin(), end);
        made_room = was_full && lines_.size() < kMostWaiting;
    }
    if (made_room) wake();
    return taken;
}

bool LineWatch::is_full() {
    const std::lock_guard guard(mutex_);
    return lines_.size() >= kMostWaiting;
}

void LineWatch::run() {
    while (!input_.ended()) {
        const bool waits = when_full_ == WhenFull::Waits && is_full();
        std::array<pollfd, 2> watched{pollfd{waits ? -1 : descriptor_, POLLIN, 0}, pollfd{wake_.get(), POLLIN, 0}};
        if (::poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR) break;
        if (leaving_) return;
        if (watched[1].revents != 0) {
            std::uint64_t count = 0;
            [[maybe_unused]] const ssize_t got = ::read(wake_.get(), &count, sizeof count);
        }
        if (waits) continue;
        for (std::string& line : input_.take()) {
            // Keep the mutex locked while `at_once_` carries out the line. Then a caller of take() never receives lines
            // from before that line afterwards.
            const std::lock_guard guard(mutex_);
            if (at_once_(line)) {
                lines_.clear();
                emptied_ = true;
            } else if (when_full_ == WhenFull::Waits || lines_.size() < kMostWaiting) {
                lines_.push_back(std::move(line));
            }
        }
    }
    ended_.store(true, std::memory_order_release);
}

}  // namespace handrail::terminal
