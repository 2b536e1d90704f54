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

// Reads lines from a file descriptor without ever waiting. It does not own the descriptor.
class LineInput {
public:
    explicit LineInput(int descriptor) : descriptor_(descriptor) {}
    // Returns the lines that have arrived since the last call, without their line ends. Reads at most kBytesAtOnce; the
    // rest can still be read later. A line longer than 4096 bytes is split after that length.
    std::vector<std::string> take();
    bool ended() const { return ended_; }  // true at the end of the input or after an error: no more lines will come

    static constexpr std::size_t kBytesAtOnce = 16384;

private:
    int descriptor_;
    std::string partial_;
    bool ended_ = false;
};

// Reads lines on a separate thread. So a line that must act at once does so, even while the app thread is busy.
class LineWatch {
public:
    // What happens if kMostWaiting or more lines have not been taken yet. `Waits`, for a script: the rest stays in its
    // pipe or file. `Loses`, for a person who types or lets a key repeat: further lines are lost, but lines that must
    // act at once still do.
    enum class WhenFull { Waits, Loses };
    // `at_once` is called on the thread of this object with each line as it arrives. If it returns true, it has carried
    // out the line, and all lines before it must be dropped.
    LineWatch(int descriptor, WhenFull when_full, std::function<bool(std::string_view)> at_once);
    ~LineWatch();
    LineWatch(const LineWatch&) = delete;
    LineWatch& operator=(const LineWatch&) = delete;

    // App thread: returns at most `most` lines. Sets `emptied` if lines that an earlier call returned must not be
    // carried out any more.
    std::vector<std::string> take(bool& emptied, std::size_t most = kMostWaiting);
    // Returns true if no lines will come other than those that still wait to be taken.
    bool ended() const { return ended_.load(std::memory_order_acquire); }

    static constexpr std::size_t kMostWaiting = 1024;

private:
    void run();
    void wake();
    bool is_full();

    LineInput input_;  // only the thread of this object uses it
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
