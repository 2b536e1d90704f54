// Lines of text from a terminal, a pipe or a file. App thread.
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

// Reads lines from a file descriptor without ever blocking. Owns nothing.
class LineInput {
public:
    explicit LineInput(int descriptor) : descriptor_(descriptor) {}
    // The lines that have arrived since the last call, without their line ends. Reads at most kBytesAtOnce; the rest
    // stays in the descriptor. Lines over 4096 bytes are split there.
    std::vector<std::string> take();
    bool ended() const { return ended_; }  // end of input or an error: no more lines will come

    static constexpr std::size_t kBytesAtOnce = 16384;

private:
    int descriptor_;
    std::string partial_;
    bool ended_ = false;
};

// Reads lines on a separate thread, so that a line which must not wait is seen at once, whatever the app thread is
// doing.
class LineWatch {
public:
    // What happens when kMostWaiting or more lines have not been taken yet. `Waits`: the rest of a script stays in its
    // pipe or file. `Loses`: further lines of a person, who types or lets a key repeat, are lost, so that a line which
    // must not wait is still seen.
    enum class WhenFull { Waits, Loses };
    // `at_once` is called with each line as it arrives, on the watch's thread. If it returns true, the line has already
    // been carried out, and all lines before it must be dropped.
    LineWatch(int descriptor, WhenFull when_full, std::function<bool(std::string_view)> at_once);
    ~LineWatch();
    LineWatch(const LineWatch&) = delete;
    LineWatch& operator=(const LineWatch&) = delete;

    // App thread: returns at most `most` lines. Sets `emptied` if lines from an earlier call must not be carried out
    // any more.
    std::vector<std::string> take(bool& emptied, std::size_t most = kMostWaiting);
    bool ended() const {
        return ended_.load(std::memory_order_acquire);
    }  // No more lines will come than those that wait to be taken.

    static constexpr std::size_t kMostWaiting = 1024;

private:
    void run();
    void wake();
    bool is_full();

    LineInput input_;  // used by the watch's thread
    int descriptor_;
    WhenFull when_full_;
    std::function<bool(std::string_view)> at_once_;
    Descriptor wake_;
    std::mutex mutex_;  // guards lines_ and emptied_
    std::deque<std::string> lines_;
    bool emptied_ = false;
    std::atomic<bool> leaving_{false};
    std::atomic<bool> ended_{false};
    std::thread thread_;  // last: its thread uses the others
};

}  // namespace handrail::terminal
