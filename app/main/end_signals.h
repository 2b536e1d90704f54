// SIGINT, SIGTERM and SIGHUP asked for, not obeyed at once: a session ends by letting go of the hand, saving and saying
// its last words. Construct it before all that may have to be waited for at the end. App thread.
#pragma once

#include <array>
#include <csignal>

#include "app/main/end_in_time.h"

namespace handrail {

// Catches the ending signals for as long as it lives; one at a time.
class EndSignals {
public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    // One of them came since.
    bool asked() const;

    EndInTime in_time;  // of the end that they or the person asked for

private:
    static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

}  // namespace handrail
