// Reads the keys of a terminal on a separate thread. So a key that must act at once acts even while the app thread is
// busy.
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
    double at_s = 0.0;  // time at which the input arrived
};

class TerminalKeys {
public:
    // How long the thread waits after an Escape for further bytes, which would make it the beginning of a sequence.
    static constexpr double kEscapeAlone_s = 0.1;
    // Most inputs that can wait. A person who holds a key down never reaches this number; further input is lost.
    static constexpr std::size_t kMostWaiting = 1024;

    // Reads `descriptor`, a terminal that delivers keys at once (RawTerminal). The descriptor and the clock must
    // outlive this object. Calls `at_once` on the thread of this object with the name of each key as it arrives. If
    // `at_once` returns true, it has acted on the key, and all input before that key must be dropped.
    TerminalKeys(int descriptor, const TerminalKeyboard& keyboard, Clock& clock,
                 std::function<bool(const std::string&)> at_once);
    ~TerminalKeys();
    TerminalKeys(const TerminalKeys&) = delete;
    TerminalKeys& operator=(const TerminalKeys&) = delete;

    // App thread. Sets `emptied` if input that an earlier call returned must not be carried out any more.
    std::vector<TimedInput> take(bool& emptied);
    bool ended() const { return ended_.load(std::memory_order_acquire); }  // true if the terminal was closed

private:
    void run();
    void add(std::vector<TerminalInput> inputs);

    int descriptor_;
    Clock& clock_;
    std::function<bool(const std::string&)> at_once_;
    KeyDecoder decoder_;  // used only by the thread of this object
    Descriptor wake_;
    std::mutex mutex_;  // guards waiting_ and emptied_
    std::deque<TimedInput> waiting_;
    bool emptied_ = false;
    std::atomic<bool> ended_{false};
    std::thread thread_;  // declared last, because it uses the other members
};

}  // namespace handrail::terminal
