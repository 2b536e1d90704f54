// The end of the program when it was told to end: what still runs on other threads, such as the search for routes
// through a large building, is given up, but some of it is in a library that cannot be asked to stop. Construct it
// before all that may have to be waited for. App thread; costs a thread that sleeps, once armed.
#pragma once

#include <thread>

namespace handrail {

class EndInTime {
public:
    // All that matters is saved. Unless this object is destroyed within that time, the process ends with that status.
    void end_within(double seconds, int status);

private:
    std::jthread watch_;
};

}  // namespace handrail
