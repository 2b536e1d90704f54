// Lines of text as they come from a terminal, a pipe or a file. App thread.
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

namespace handrail {

// Lines from a file descriptor without ever blocking. Owns nothing.
class LineInput {
public:
    explicit LineInput(int descriptor) : descriptor_(descriptor) {}
    // The next lines that have arrived since the last call, without their line ends, of at most kBytesAtOnce; the rest
    // waits where it is. Lines over 4096 bytes are cut there.
    std::vector<std::string> take();
    bool ended() const { return ended_; }  // end of input or an error: no more lines will come

    static constexpr std::size_t kBytesAtOnce = 16384;

private:
    int descriptor_;
    std::string partial_;
    bool ended_ = false;
};

// The same on a thread of its own, so that a line which must not wait is seen at once, whatever the app's thread is
// doing.
class LineWatch {
public:
    // When kMostWaiting lines or more wait to be taken: of a script the rest waits in its pipe or file; of a person who
    // types, or lets a key repeat, the rest is lost, so that the line which must not wait is seen behind it all the
    // same.
    enum class WhenFull { Waits, Loses };
    // at_once is asked of each line as it arrives, on the watch's thread. True: it is done already, and no line before
    // it is to be done any more.
    LineWatch(int descriptor, WhenFull when_full, std::function<bool(std::string_view)> at_once);
    ~LineWatch();
    LineWatch(const LineWatch&) = delete;
    LineWatch& operator=(const LineWatch&) = delete;

    // App thread: at most `most` lines. `emptied` is set when lines that an earlier call gave are not to be done any
    // more.
    std::vector<std::string> take(bool& emptied, std::size_t most = kMostWaiting);
    bool ended() const {
        return ended_.load(std::memory_order_acquire);
    }  // no more lines will come than wait to be taken

    static constexpr std::size_t kMostWaiting = 1024;

private:
    void run();
    void wake();
    bool is_full();

    LineInput input_;  // the watch's thread
    int descriptor_;
    WhenFull when_full_;
    std::function<bool(std::string_view)> at_once_;
    Descriptor wake_;
    std::mutex mutex_;  // guards lines_ and emptied_
    std::deque<std::string> lines_;
    bool emptied_ = false;
    std::atomic<bool> leaving_{false};
    std::atomic<bool> ended_{false};
    std::thread thread_;  // last
};

}  // namespace handrail
