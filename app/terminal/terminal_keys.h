// Reads the keys of a terminal on a separate thread, so that a key which must not wait is seen at once, whatever the
// app thread is doing.
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

namespace handrail::terminal {

struct TimedInput {
    TerminalInput input;
    double at_s = 0.0;  // time of arrival by the clock
};

class TerminalKeys {
public:
    // How long an Escape waits for bytes that would make it a sequence.
    static constexpr double kEscapeAlone_s = 0.1;
    // A person who holds a key down never fills this; further input is lost.
    static constexpr std::size_t kMostWaiting = 1024;

    // Reads `descriptor`, a terminal that delivers keys at once (RawTerminal); it and the clock outlive this object.
    // `at_once` is called with each key's name as it arrives, on this object's thread. If it returns true, the key has
    // already acted, and all input before it must be dropped.
    TerminalKeys(int descriptor, const TerminalKeyboard& keyboard, Clock& clock,
                 std::function<bool(const std::string&)> at_once);
    ~TerminalKeys();
    TerminalKeys(const TerminalKeys&) = delete;
    TerminalKeys& operator=(const TerminalKeys&) = delete;

    // App thread. Sets `emptied` if input from an earlier call must not be carried out any more.
    std::vector<TimedInput> take(bool& emptied);
    bool ended() const { return ended_.load(std::memory_order_acquire); }  // the terminal has gone

private:
    void run();
    void add(std::vector<TerminalInput> inputs);

    int descriptor_;
    Clock& clock_;
    std::function<bool(const std::string&)> at_once_;
    KeyDecoder decoder_;  // used by this object's thread
    Descriptor wake_;
    std::mutex mutex_;  // guards waiting_ and emptied_
    std::deque<TimedInput> waiting_;
    bool emptied_ = false;
    std::atomic<bool> ended_{false};
    std::thread thread_;  // last: its thread uses the others
};

}  // namespace handrail::terminal
