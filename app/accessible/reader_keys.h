// Passes keys to a screen reader, and passes the reader's answers back. The window offers each key to the reader first.
// The reader answers whether it uses the key itself.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>

#include "app/window/key_gate.h"

namespace handrail::accessible {

class ReaderKeys {
public:
    // App thread. Returns a ticket for verdict(). Returns 0 if no reader listens, or if the reader has left an earlier
    // key unanswered. `now_s` may be of any clock that never goes back.
    std::uint64_t offer(const window::KeyStroke& stroke, double now_s);
    window::KeyVerdict verdict(std::uint64_t ticket);

    // Accessibility thread. `heard`: a reader has noticed the window. From then on, the class offers keys to a reader
    // that listens to keys.
    void set_heard(bool heard);
    // Accessibility thread. Asks the screen reader about each offered key.
    void query_reader();

private:
    struct Offered {
        std::uint64_t ticket = 0;
        window::KeyStroke stroke;
        double since_s = 0.0;
    };

    std::atomic<bool> listened_to_{false};
    std::uint64_t last_ticket_ = 0;  // used only by the app thread
    std::mutex mutex_;               // guards all members below
    std::deque<Offered> offered_;
    std::map<std::uint64_t, window::KeyVerdict> verdicts_;
    std::uint64_t answered_ = 0;
};

}  // namespace handrail::accessible
