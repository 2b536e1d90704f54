// The keys of a terminal as they come, on a thread of its own, so that a key which must not wait is seen at once,
// whatever the app's thread is doing.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/terminal/key_decoder.h"
#include "worlds/base/clock.h"
#include "worlds/base/descriptor.h"

namespace handrail {

struct TimedInput {
    TerminalInput input;
    double at_s = 0.0;  // by the clock, when it came
};

class TerminalKeys {
public:
    // How long an Escape waits for what would make a sequence of it.
    static constexpr double kEscapeAlone_s = 0.1;
    // A person who holds a key down fills no more than this; what comes beyond is lost.
    static constexpr std::size_t kMostWaiting = 1024;

    // Reads `descriptor`, a terminal that gives keys at once (RawTerminal); it and the clock outlive this object.
    // at_once is asked of each key's name as it arrives, on this object's thread. True: it is done already, and
    // nothing before it is to be done any more.
    TerminalKeys(int descriptor, const TerminalKeyboard& keyboard, Clock& clock,
                 std::function<bool(const std::string&)> at_once);
    ~TerminalKeys();
    TerminalKeys(const TerminalKeys&) = delete;
    TerminalKeys& operator=(const TerminalKeys&) = delete;

    // App thread. `emptied` is set when what an earlier call gave is not to be done any more.
    std::vector<TimedInput> take(bool& emptied);
    bool ended() const { return ended_.load(std::memory_order_acquire); }  // the terminal has gone

private:
    void run();
    void add(std::vector<TerminalInput> inputs);

    int descriptor_;
    Clock& clock_;
    std::function<bool(const std::string&)> at_once_;
    KeyDecoder decoder_;  // the thread's
    Descriptor wake_;
    std::mutex mutex_;  // guards waiting_ and emptied_
    std::deque<TimedInput> waiting_;
    bool emptied_ = false;
    std::atomic<bool> ended_{false};
    std::thread thread_;  // last
};

}  // namespace handrail
