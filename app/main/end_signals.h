// Catches SIGINT, SIGTERM and SIGHUP, which would otherwise end the program at once. A session first removes the force
// from the hand, saves, and speaks its last words. Construct this object before everything whose destructor may have to
// wait. App thread.
#pragma once

#include <array>
#include <csignal>

#include "app/main/end_in_time.h"

namespace handrail::program {

// Catches these signals while the object exists. Only one object at a time may exist.
class EndSignals {
public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    // Returns true if one of the signals has arrived.
    bool requested() const;

    EndInTime in_time;  // limits how long ending takes, whether a signal or the person requested the end

private:
    static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

}  // namespace handrail::program
