// Keys on their way to a screen reader and back: the window offers each first, the reader says whether it is its own.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>

#include "app/window/key_gate.h"

namespace handrail {

class ReaderKeys {
public:
    // App thread. 0 where no reader listens, or it has left an earlier key without an answer; now_s: any clock that
    // never goes back.
    std::uint64_t offer(const KeyStroke& stroke, double now_s);
    KeyVerdict verdict(std::uint64_t ticket);

    // Accessibility thread. Whether the window is heard of, so that a reader that listens to keys is asked.
    void set_heard(bool heard);
    // Asks the reader about each key that was offered.
    void ask();

private:
    struct Offered {
        std::uint64_t ticket = 0;
        KeyStroke stroke;
        double since_s = 0.0;
    };

    std::atomic<bool> listened_to_{false};
    std::uint64_t last_ticket_ = 0;  // app thread
    std::mutex mutex_;               // guards all below
    std::deque<Offered> offered_;
    std::map<std::uint64_t, KeyVerdict> verdicts_;
    std::uint64_t answered_ = 0;
};

}  // namespace handrail
