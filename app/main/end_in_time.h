// Ends the program in time once its end is decided. Work on other threads, such as the search for routes through a
// large building, is then given up, but some of it is in a library that cannot be stopped. Construct this object before
// everything that may have to be waited for. App thread. Costs a sleeping thread once armed.
#pragma once

#include <thread>

namespace handrail::program {

class EndInTime {
public:
    // Call it when everything that matters is saved. Unless this object is destroyed within `seconds`, the process ends
    // with `status`.
    void end_within(double seconds, int status);

private:
    std::jthread watch_;
};

}  // namespace handrail::program
