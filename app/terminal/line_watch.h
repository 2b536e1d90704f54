// Reads lines of text from a terminal, a pipe or a file. App thread.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "worlds/base/descriptor.h"

namespace handrail::terminal {

// Reads lines from a file descriptor without ever waiting. Does not own the descriptor.
class LineInput {
public:
    explicit LineInput(int descriptor) : descriptor_(descriptor) {}
    // Returns the lines that have arrived since the last call, without their line ends. Reads at most kBytesAtOnce; a
    // later call reads the rest. A line longer than 4096 bytes is split after that length.
    std::vector<std::string> take();
    bool ended() const { return ended_; }  // true at the end of the input or after an error: no more lines will come

    static constexpr std::size_t kBytesAtOnce = 16384;

private:
    int descriptor_;
    std::string partial_;
    bool ended_ = false;
};

// Reads lines on a separate thread. So a line that must act at once acts even while the app thread is busy.
class LineWatch {
public:
    // What happens to further lines while kMostWaiting or more lines are waiting. `Waits`, for a script: they stay in
    // the pipe or file. `Loses`, for a person who types or lets a key repeat: they are lost, except that lines that
    // must act at once still act.
    enum class WhenFull { Waits, Loses };
    // Calls `at_once` on the thread of this object with each line as it arrives. If `at_once` returns true, it has
    // carried out the line, and all lines before that line must be dropped.
    LineWatch(int descriptor, WhenFull when_full, std::function<bool(std::string_view)> at_once);
    ~LineWatch();
    LineWatch(const LineWatch&) = delete;
    LineWatch& operator=(const LineWatch&) = delete;

    // App thread: returns at most `most` lines. Sets `emptied` if lines that an earlier call returned must not be
    // carried out any more.
    std::vector<std::string> take(bool& emptied, std::size_t most = kMostWaiting);
    // Returns true if no lines will arrive any more. Some may still be waiting for take().
    bool ended() const { return ended_.load(std::memory_order_acquire); }

    static constexpr std::size_t kMostWaiting = 1024;

private:
    void run();
    void wake();
    bool is_full();

    LineInput input_;  // used only by the thread of this object
    int descriptor_;
    WhenFull when_full_;
    std::function<bool(std::string_view)> at_once_;
    Descriptor wake_;
    std::mutex mutex_;  // guards lines_ and emptied_
    std::deque<std::string> lines_;
    bool emptied_ = false;
    std::atomic<bool> leaving_{false};
    std::atomic<bool> ended_{false};
    std::thread thread_;  // declared last, because it uses the other members
};

}  // namespace handrail::terminal
