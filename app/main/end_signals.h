// Notes SIGINT, SIGTERM and SIGHUP instead of obeying them at once: a session first lets go of the hand, saves and says
// its last words. Construct it before everything that may have to be waited for at the end. App thread.
#pragma once

#include <array>
#include <csignal>

#include "app/main/end_in_time.h"

namespace handrail::program {

// Catches the ending signals while it lives; only one object at a time.
class EndSignals {
public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    // True if one of the signals has come.
    bool asked() const;

    EndInTime in_time;  // limits how long the end may take, whether signals or the person requested it

private:
    static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

}  // namespace handrail::program
